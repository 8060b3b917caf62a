//! Motions that combine masses and base: relative displacements, spring forces and the base shear.
//!
//! The force in a spring of stiffness k, divided by P, is k/k₁ times the non-dimensional elongation x̄ of the spring.
//! Every method for displacements can therefore also return forces.

use super::held::{SystemHeld, static_share};
use super::motion::{SystemMotion, SystemSteady, SystemStuck};
use super::orbit::{SystemOrbit, SystemOrbitMotion};
use super::simulation::SystemSimulation;
use super::stepper::SystemStepper;
use super::system::{System, rounded};
use crate::{Complex, Of};
use frictiongen_kernel::combination::Combination;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::Scene as _;
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::scene::{Excitation, Node, Spring};

/// A weighted sum of the displacements of masses and of the moving base.
#[derive(Clone, Debug)]
struct WeightedSum {
    masses: Vec<(usize, Dd)>,
    base: Dd,
}

/// A weighted sum of displacements in modal form: its component in each mode, and the weight of the moving base.
#[derive(Clone, Debug)]
pub(super) struct Combined<S> {
    shape: Vec<S>,
    base: S,
}

/// A motion of a steady state, with the data that its evaluation needs. The motion is that of the contact, of a mass,
/// or of a combination of masses and base.
#[derive(Clone, Debug)]
pub(super) enum InOrbit<S> {
    Contact,
    /// The contact's relative motion with the opposite sign.
    Reversed,
    Mass(usize),
    Combined(Combined<S>),
}

impl<S: Float> InOrbit<S> {
    /// Returns this motion in the steady state `orbit`. The caller must have checked that the scene has this motion.
    pub(super) fn motion<'o, 'a>(
        &'o self,
        orbit: &'o SystemOrbit<'a, S>,
    ) -> SystemOrbitMotion<'o, 'a, S> {
        match self {
            Self::Contact => orbit.orbit.contact(),
            Self::Reversed => orbit.orbit.reversed_contact(),
            Self::Mass(index) => orbit.orbit.mass(*index),
            Self::Combined(combined) => orbit.orbit.combination(combined.combination()),
        }
    }
}

impl<S: Copy> Combined<S> {
    fn combination(&self) -> Combination<'_, S> {
        Combination {
            shape: &self.shape,
            base: self.base,
        }
    }
}

impl WeightedSum {
    fn none() -> Self {
        Self {
            masses: Vec::new(),
            base: Dd::constant(0.0),
        }
    }

    /// Adds the displacement of a mass, of the base or of the wall to the sum, multiplied by a coefficient.
    fn add(&mut self, node: Node, coefficient: Dd) {
        match node {
            Node::Mass(index) => self.masses.push((index, coefficient)),
            Node::Base => self.base = self.base + coefficient,
            Node::Wall => {}
        }
    }

    /// Evaluates Σ c_k x_k + b y for `N` quantities at once, for example displacement and velocity. c_k is the
    /// coefficient of a mass, and b that of the base. `mass` returns the quantities x_k of a mass, and `base` contains
    /// the quantities y of the base. Returns `None` if `mass` returns `None` for one of the masses.
    fn sum<S: Float, const N: usize>(
        &self,
        base: [S; N],
        mass: impl Fn(usize) -> Option<[S; N]>,
    ) -> Option<[S; N]> {
        let of_base = rounded::<S>(self.base);
        let mut sum = base.map(|value| of_base * value);
        for (index, factor) in &self.masses {
            let factor = rounded::<S>(*factor);
            for (sum, value) in sum.iter_mut().zip(mass(*index)?) {
                *sum = *sum + factor * value;
            }
        }
        Some(sum)
    }

    /// Returns the component of the weighted sum in every mode, Σ c_k φ_k over the masses. c_k is the coefficient of a
    /// mass, and φ_k is the component of this mass in the mode.
    fn shape<S: Scalar>(
        &self,
        shapes: &[S],
        modes: usize,
        coefficient: impl Fn(Dd) -> S,
    ) -> Vec<S> {
        let mut sum = vec![S::constant(0.0); modes];
        for (mass, factor) in &self.masses {
            let components = shapes.chunks_exact(modes.max(1)).nth(*mass);
            for (sum, component) in sum.iter_mut().zip(components.unwrap_or_default()) {
                *sum = *sum + *component * coefficient(*factor);
            }
        }
        sum
    }
}

impl<S: Float> System<S> {
    /// Returns true if the scene has the motion `of`. The result is always true for the contact and the base shear.
    #[must_use]
    pub fn has_motion(&self, of: Of) -> bool {
        let mass = |index: usize| index < self.scene.masses.len();
        match of {
            Of::Contact | Of::Shear => true,
            Of::ContactAt(index) => {
                self.scene.is_joined() && index < self.scene.names_of_contacts().len()
            }
            Of::Mass(index) | Of::FromBase(index) => mass(index),
            Of::Relative(of, to) => mass(of) && mass(to) && of != to,
            Of::Spring(index) => index < self.scene.springs.len(),
        }
    }

    /// Returns the simplest description of a motion. If a combination of masses and base moves like the contact or like
    /// a single mass, the result is the contact or this mass.
    pub(super) fn simplest(&self, of: Of) -> Of {
        let contact = self.scene.contact;
        let sides = [contact.from, contact.to];
        let base_moves = self.scene.excitation == Excitation::Base;
        match of {
            // The contact's motion is that of the later mass minus that of the earlier mass, by their order in the
            // scene description.
            Of::Relative(of, to)
                if to < of
                    && [of, to]
                        .iter()
                        .all(|index| sides.contains(&Node::Mass(*index))) =>
            {
                Of::Contact
            }
            Of::FromBase(index) if !base_moves => Of::Mass(index),
            Of::FromBase(index)
                if sides.contains(&Node::Base) && sides.contains(&Node::Mass(index)) =>
            {
                Of::Contact
            }
            other => other,
        }
    }

    /// Returns true if a motion is the contact's relative motion with the opposite sign: the motion of the earlier
    /// mass minus that of the later mass, by their order in the scene description.
    fn is_reversed_contact(&self, of: Of) -> bool {
        matches!(of, Of::Relative(of, to) if self.simplest(Of::Relative(to, of)) == Of::Contact)
    }

    /// Returns true if a motion equals the contact's relative motion or its negative. The result is therefore true for
    /// the mass of a contact with the wall or with a base at rest.
    pub(super) fn moves_as_contact(&self, of: Of) -> bool {
        let ends = [self.scene.contact.from, self.scene.contact.to];
        let base_moves = self.scene.excitation == Excitation::Base;
        let other = |index: usize| match ends {
            [Node::Mass(own), other] | [other, Node::Mass(own)] if own == index => Some(other),
            _ => None,
        };
        let alone = matches!(of, Of::Mass(index) if match other(index) {
            Some(Node::Wall) => true,
            Some(Node::Base) => !base_moves,
            _ => false,
        });
        alone || self.simplest(of) == Of::Contact || self.is_reversed_contact(of)
    }

    fn terms(&self, of: Of) -> WeightedSum {
        let one = Dd::constant(1.0);
        let mut terms = WeightedSum::none();
        match of {
            // A scene of several contacts has no modal sums.
            Of::Contact | Of::ContactAt(_) => {}
            Of::Mass(index) => terms.add(Node::Mass(index), one),
            Of::FromBase(index) => {
                terms.add(Node::Mass(index), one);
                terms.add(Node::Base, -one);
            }
            Of::Relative(of, to) => {
                terms.add(Node::Mass(of), one);
                terms.add(Node::Mass(to), -one);
            }
            Of::Spring(index) => {
                if let Some(spring) = self.scene.springs.get(index) {
                    let stiffness = self.stiffness_ratio(spring);
                    terms.add(spring.to, stiffness);
                    terms.add(spring.from, -stiffness);
                }
            }
            Of::Shear => {
                for spring in &self.scene.springs {
                    let (mass, base) = match (spring.from, spring.to) {
                        (mass @ Node::Mass(_), base @ Node::Base)
                        | (base @ Node::Base, mass @ Node::Mass(_)) => (mass, base),
                        _ => continue,
                    };
                    let stiffness = self.stiffness_ratio(spring);
                    terms.add(mass, stiffness);
                    terms.add(base, -stiffness);
                }
            }
        }
        if self.scene.excitation != Excitation::Base {
            terms.base = Dd::constant(0.0);
        }
        terms
    }

    /// Returns the stiffness k of a spring divided by k₁.
    fn stiffness_ratio(&self, spring: &Spring) -> Dd {
        Dd::constant(spring.stiffness) / Dd::constant(self.scene.first_stiffness())
    }

    /// Returns the motion `of` with its component in each mode of the chain while the contact slides.
    fn in_sliding_modes(&self, of: Of) -> Combined<S> {
        let reduced = &self.reduced;
        let (own, modes) = (&reduced.shapes, reduced.modes.len());
        self.combined(&self.terms(of), own, modes, || self.exact_shapes())
    }

    /// Returns the weighted sum `terms` of the motions of masses and base, with its component in each mode. `own`
    /// contains the components of the first mass in all modes, then those of the second mass, and so on. `exact`
    /// returns the same components to about 30 digits. With these digits, the difference of two nearly equal motions
    /// stays accurate.
    fn combined<'e>(
        &self,
        terms: &WeightedSum,
        own: &[S],
        modes: usize,
        exact: impl FnOnce() -> &'e [Dd],
    ) -> Combined<S> {
        let shape = if S::CARRIES {
            // The components in `own` are numbers with derivatives, and already have about 30 digits.
            terms.shape(own, modes, rounded)
        } else {
            let shape = terms.shape(exact(), modes, |value| value);
            shape.into_iter().map(rounded).collect()
        };
        Combined {
            shape,
            base: rounded(terms.base),
        }
    }
}

impl<'a, S: Float> SystemMotion<'a, S> {
    /// Returns the motion of the contact, of a mass, or of a combination of masses and base. Returns `None` if the
    /// scene does not have the motion `of`.
    #[must_use]
    pub fn motion_of(&self, of: Of) -> Option<SystemSteady<'a, S>> {
        let system = *self.at().scene();
        if !system.has_motion(of) {
            return None;
        }
        match system.simplest(of) {
            Of::Contact => Some(self.contact()),
            Of::Mass(index) => self.mass_at(index),
            of => Some(self.combination(system.in_sliding_modes(of).combination())),
        }
    }
}

impl<'a, S: Float> SystemOrbit<'a, S> {
    /// Calls `question` with the motion of the contact, of a mass, or of a combination of masses and base, and returns
    /// the result of `question`. Returns `None` if the scene does not have the motion `of`.
    pub fn ask_of<A>(
        &self,
        of: Of,
        question: impl FnOnce(&SystemOrbitMotion<'_, 'a, S>) -> A,
    ) -> Option<A> {
        let motion = self.prepared(of)?;
        Some(question(&motion.motion(self)))
    }

    /// Returns a motion with the data that its evaluation needs, or `None` if the scene does not have the motion `of`.
    pub(super) fn prepared(&self, of: Of) -> Option<InOrbit<S>> {
        let system = self.system;
        let known = system.has_motion(of);
        known.then(|| match system.simplest(of) {
            Of::Contact => InOrbit::Contact,
            Of::Mass(index) => InOrbit::Mass(index),
            // If the contact stops at its largest displacement, the lag of the contact belongs to the beginning of the
            // stop. A combination of masses may give another instant of the stop.
            of if system.is_reversed_contact(of) => InOrbit::Reversed,
            of => {
                // The mode shapes of the steady state may have derivatives. Shapes from another source have none.
                let (own, modes) = self.orbit.shapes();
                let terms = system.terms(of);
                InOrbit::Combined(
                    system.combined(&terms, own, modes, || system.exact_shapes_in_time()),
                )
            }
        })
    }
}

impl<S: Float> SystemStuck<'_, S> {
    /// Returns a motion as a complex amplitude and a constant displacement, for a contact that sticks at `middle`.
    /// Returns `None` if the scene does not have the motion `of`.
    pub(super) fn motion_at(&self, of: Of, middle: S) -> Option<(Complex<S>, S)> {
        let (system, zero) = (*self.at().scene(), S::constant(0.0));
        if !system.has_motion(of) {
            return None;
        }
        let one = S::constant(1.0);
        // A contact force f deforms the spring of an elastic contact by ρf, where ρ is the compliance of the spring.
        let contact = match system.compliance() {
            None => Complex::new(zero, zero),
            Some(compliance) => complex::scale(self.contact_force(), compliance),
        };
        if system.simplest(of) == Of::Contact {
            return Some((contact, middle));
        }
        if system.is_reversed_contact(of) {
            return Some((complex::scale(contact, -one), -middle));
        }
        let [re, im, constant] = system.terms(of).sum([one, zero, zero], |mass| {
            let moved = self.mass_at(mass)?;
            Some([moved.re, moved.im, middle * static_share(system, mass)?])
        })?;
        Some((Complex::new(re, im), constant))
    }
}

impl SystemHeld<'_> {
    /// Returns a motion while the contact is stuck: its complex amplitude, and the constant displacement that
    /// the middle of the contact's motion causes. Returns `None` if the scene does not have the motion `of`.
    #[must_use]
    pub fn motion_of(&self, of: Of) -> Option<(Complex<f64>, f64)> {
        self.stuck.motion_at(of, self.middle)
    }
}

impl System {
    /// Returns displacement and velocity of a combination of masses and base, in the scene's units. `base` contains
    /// displacement and velocity of the base, and `masses` those of every mass. If the motion `of` is a force, the
    /// method returns the force and its derivative in time. Returns `None` if the scene does not have the motion `of`,
    /// and for the motion of a contact.
    #[cfg(feature = "measure")]
    #[must_use]
    pub(crate) fn combination_of(
        &self,
        of: Of,
        base: [f64; 2],
        masses: &[[f64; 2]],
    ) -> Option<[f64; 2]> {
        if of == Of::Contact || !self.has_motion(of) {
            return None;
        }
        let sum = self.terms(of).sum(base, |mass| masses.get(mass).copied())?;
        // For a force, the sum contains stiffnesses divided by k₁. The product with k₁ is in the scene's units.
        let unit = match of.is_force() {
            true => self.scene.first_stiffness(),
            false => 1.0,
        };
        Some(sum.map(|value| unit * value))
    }
}

impl SystemStepper<'_> {
    /// Returns the present displacement and velocity of a motion, in the scene's units. If the motion is a force, the
    /// method returns the force and its derivative in time. Returns `None` if the scene does not have the motion `of`.
    #[must_use]
    pub fn motion_of(&self, of: Of) -> Option<(f64, f64)> {
        let system = self.system;
        if !system.has_motion(of) {
            return None;
        }
        if system.simplest(of) == Of::Contact {
            let contact = self.contact();
            return Some((contact.displacement(), contact.velocity()));
        }
        let base = self.base();
        let [value, rate] =
            system
                .terms(of)
                .sum([base.displacement(), base.velocity()], |mass| {
                    let now = self.mass_at(mass);
                    Some([now.displacement(), now.velocity()])
                })?;
        // For a force, the sum contains stiffnesses divided by k₁. The product with k₁ is in the scene's units.
        let unit = match of.is_force() {
            true => system.scene.first_stiffness(),
            false => 1.0,
        };
        Some((unit * value, unit * rate))
    }
}

impl SystemSimulation<'_> {
    /// Returns the present displacement and velocity of a motion, as non-dimensional groups, or `None` if the scene
    /// does not have the motion `of`.
    #[must_use]
    pub fn motion_of(&self, of: Of) -> Option<(f64, f64)> {
        let system = self.system;
        if !system.has_motion(of) {
            return None;
        }
        if system.simplest(of) == Of::Contact {
            return Some(self.relative());
        }
        let base = if self.is_free {
            [0.0; 2]
        } else {
            let (sine, cosine) = self.phase().sin_cos();
            [cosine, -sine]
        };
        let [displacement, velocity] = system.terms(of).sum(base, |mass| {
            let moment = self.run().mass(mass);
            Some([moment.displacement(), moment.velocity()])
        })?;
        Some((displacement, velocity))
    }
}
