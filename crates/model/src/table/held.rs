//! Responses while the contact is stuck, stored as products over their zeros and poles.

use super::product::Product;
use super::quotients::EXACT_SHARE;
use super::worst::Worst;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::{HeldResponse, Root, Transfer};

/// Response of one mass, or the contact force, while the contact is stuck, in the form that a table stores.
#[derive(Clone, Debug)]
pub enum HeldForm<S> {
    /// Response that does not depend on r.
    Fixed(S),
    /// Response of an undamped chain, which is real.
    Undamped(Product<S>),
    /// Response of a damped chain, which is complex.
    Damped {
        /// Constant factor of the response.
        gain: S,
        /// Factors of the numerator, one for each real zero or pair of complex zeros.
        numerator: Vec<Root<S>>,
        /// Factors of the denominator, one for each real pole or pair of complex poles.
        denominator: Vec<Root<S>>,
    },
}

/// Responses of all masses of a scene, and the contact force, while the contact is stuck.
#[derive(Clone, Debug)]
pub struct Held<S> {
    /// Response x̄* of each mass, in the order of the masses.
    pub masses: Vec<HeldForm<S>>,
    /// V/H, the force that keeps the contact stuck. V and H are the responses of the contact to the load and to a
    /// contact force.
    pub force: HeldForm<S>,
    /// Undamped resonances of the stuck chain within the range that are exactly numbers of the type `S`.
    pub resonances: Vec<S>,
    /// Largest error that the check has found, relative to the modulus of the response.
    pub worst: Worst,
    /// Number of frequency ratios at which the check has compared a response with its exact value.
    pub points: usize,
}

impl<S: Float> HeldForm<S> {
    /// Returns the response as [`HeldResponse`] of the kernel crate.
    #[must_use]
    pub fn response(&self) -> HeldResponse<'_, S> {
        match self {
            Self::Fixed(amplitude) => HeldResponse::Fixed(*amplitude),
            Self::Undamped(product) => HeldResponse::Undamped(product.quotient()),
            Self::Damped {
                gain,
                numerator,
                denominator,
            } => HeldResponse::Damped(Transfer {
                gain: *gain,
                numerator,
                denominator,
            }),
        }
    }

    /// Returns the operations of one evaluation of the response: the number of additions and multiplications, and the
    /// number of divisions.
    #[must_use]
    pub fn operations(&self) -> (usize, usize) {
        match self {
            Self::Fixed(_) => (0, 0),
            Self::Undamped(product) => {
                let (plain, divisions, _) = product.operations();
                (plain, divisions)
            }
            Self::Damped {
                numerator,
                denominator,
                ..
            } => {
                let factors = numerator.iter().chain(denominator);
                let own: usize = factors
                    .map(|factor| match factor {
                        Root::Pair { .. } => 6,
                        Root::Real { .. } => 0,
                    })
                    .sum();
                let products = [numerator, denominator];
                let joined = products.map(|factors| factors.len().saturating_sub(1));
                // A complex product takes six operations, and a product with the gain takes two. The reciprocal of
                // the product of all poles takes eight operations and two divisions.
                let joined: usize = 6 * joined.iter().sum::<usize>() + 2;
                if denominator.is_empty() {
                    (own + joined, 0)
                } else {
                    (own + joined + 6 + 8, 2)
                }
            }
        }
    }

    /// Returns how many numbers the response stores: first for its gain and zeros, then for its poles.
    fn numbers(&self) -> (usize, usize) {
        let of_roots = |roots: &[Root<S>]| -> usize {
            let numbers = roots.iter().map(|root| match root {
                Root::Pair { .. } => 4,
                Root::Real { .. } => 1,
            });
            numbers.sum()
        };
        match self {
            Self::Fixed(_) => (1, 0),
            Self::Undamped(product) => {
                let above = Product {
                    denominator: Vec::new(),
                    ..product.clone()
                };
                (above.numbers(), product.numbers() - above.numbers())
            }
            Self::Damped {
                numerator,
                denominator,
                ..
            } => (1 + of_roots(numerator), of_roots(denominator)),
        }
    }

    /// Returns true if two responses have the same poles.
    #[must_use]
    pub fn shares_poles(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Undamped(a), Self::Undamped(b)) => a.denominator == b.denominator,
            (Self::Damped { denominator: a, .. }, Self::Damped { denominator: b, .. }) => a == b,
            _ => false,
        }
    }
}

impl<S: Float> Held<S> {
    /// Returns the responses of all masses, and then the contact force.
    fn forms(&self) -> impl Iterator<Item = &HeldForm<S>> {
        self.masses.iter().chain([&self.force])
    }

    /// Returns one response for each distinct set of poles.
    #[must_use]
    pub fn pole_sets(&self) -> Vec<&HeldForm<S>> {
        let mut sets: Vec<&HeldForm<S>> = Vec::new();
        for form in self.forms() {
            let is_fixed = matches!(form, HeldForm::Fixed(_));
            if !is_fixed && !sets.iter().any(|set| set.shares_poles(form)) {
                sets.push(form);
            }
        }
        sets
    }

    /// Returns true if the products are accurate enough to replace the exact responses in a table of this accuracy.
    #[must_use]
    pub fn keeps(&self, accuracy: f64) -> bool {
        self.worst.error <= EXACT_SHARE * accuracy
    }

    /// Returns a sentence for the report on how the responses were checked.
    #[must_use]
    pub fn told(&self) -> String {
        if self.worst.error < 0.25 * S::EPSILON {
            return format!(
                "Checked at {} points, not proven: no error exceeds the effect of a change of r by 1.8e-15 r.",
                self.points
            );
        }
        format!(
            "Checked at {} points, not proven: after subtraction of the effect of a change of r by 1.8e-15 r, the largest error is {:.1e} of the modulus, at r = {}.",
            self.points,
            self.worst.error,
            self.worst.place::<S>()
        )
    }

    /// Returns the work for the response of the costliest mass: the number of additions and multiplications, and the
    /// number of divisions.
    #[must_use]
    pub fn most_operations(&self) -> (usize, usize) {
        let operations = self.masses.iter().map(HeldForm::operations);
        operations.fold((0, 0), |(plain, divisions), own| {
            (plain.max(own.0), divisions.max(own.1))
        })
    }

    /// Returns the size of all stored numbers in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.numbers() * core::mem::size_of::<S>()
    }

    /// Returns the number of stored numbers. Poles that several responses share count once.
    #[must_use]
    pub fn numbers(&self) -> usize {
        let forms: Vec<&HeldForm<S>> = self.forms().collect();
        let mut all = self.resonances.len();
        for (place, form) in forms.iter().enumerate() {
            let (above, below) = form.numbers();
            let before = forms.iter().take(place);
            let known = before.into_iter().any(|other| other.shares_poles(form));
            all += above + if known { 0 } else { below };
        }
        all
    }
}
