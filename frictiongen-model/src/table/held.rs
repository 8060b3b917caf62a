//! The responses while the contact is held as quotients of products.

use super::product::Product;
use super::quotients::EXACT_SHARE;
use super::worst::Worst;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::{HeldResponse, Root, Transfer};

/// A response while the contact is held, as a table keeps it.
#[derive(Clone, Debug)]
pub enum HeldForm<S> {
    /// The same at every r.
    Fixed(S),
    /// Of an undamped chain, real.
    Undamped(Product<S>),
    /// Of a damped chain, complex.
    Damped {
        /// What stands before it.
        gain: S,
        /// The zeros.
        numerator: Vec<Root<S>>,
        /// The poles.
        denominator: Vec<Root<S>>,
    },
}

/// The responses of a scene while its contact is held.
#[derive(Clone, Debug)]
pub struct Held<S> {
    /// x̄* of each mass.
    pub masses: Vec<HeldForm<S>>,
    /// V/H, the force that holds the contact.
    pub force: HeldForm<S>,
    /// The numbers of the scalar within the range on which an undamped resonance lies to the last digit.
    pub resonances: Vec<S>,
    /// The largest error seen, relative to the modulus.
    pub worst: Worst,
    /// At how many points was looked.
    pub points: usize,
}

impl<S: Float> HeldForm<S> {
    /// The same as the kernel reads it.
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

    /// Additions and multiplications, and divisions, of one evaluation.
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
                // A complex product takes six; with the gain two, and one over the poles eight and two divisions.
                let joined: usize = 6 * joined.iter().sum::<usize>() + 2;
                if denominator.is_empty() {
                    (own + joined, 0)
                } else {
                    (own + joined + 6 + 8, 2)
                }
            }
        }
    }

    /// How many numbers its zeros have, with what stands before them; and how many its poles.
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

    /// Whether two have the same poles.
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
    /// All forms: those of the masses, then the force.
    fn forms(&self) -> impl Iterator<Item = &HeldForm<S>> {
        self.masses.iter().chain([&self.force])
    }

    /// One form for each set of poles that forms have in common.
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

    /// Whether it may stand for the exact responses at an accuracy.
    #[must_use]
    pub fn keeps(&self, accuracy: f64) -> bool {
        self.worst.error <= EXACT_SHARE * accuracy
    }

    /// What is known of them, as a sentence.
    #[must_use]
    pub fn told(&self) -> String {
        format!(
            "Checked at {} points, not proven: largest error {:.1e} of the modulus, at r = {}.",
            self.points, self.worst.error, self.worst.at
        )
    }

    /// Additions and multiplications, and divisions, of the mass that takes most.
    #[must_use]
    pub fn most_operations(&self) -> (usize, usize) {
        let operations = self.masses.iter().map(HeldForm::operations);
        operations.fold((0, 0), |(plain, divisions), own| {
            (plain.max(own.0), divisions.max(own.1))
        })
    }

    /// What its numbers take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.numbers() * core::mem::size_of::<S>()
    }

    /// How many numbers all hold; poles that several have in common count once.
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
