//! Data of a scene that a stepper needs.

use super::cost::{Cost, Extent};
use super::input::Input;
use super::pace::Pace;
use crate::contact::sums::Chain;
use crate::motion::{ContactChain, Dynamics, TERMS};
use crate::number::scalar::Float;

/// Factors that convert a stepper's non-dimensional groups to the units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units<S> {
    /// Stiffness k₁ of the first spring, in the scene's unit of force divided by its unit of length.
    pub stiffness: S,
    /// Reference angular frequency √(k₁/m₁) in rad/s. A frequency ratio times this reference is an angular frequency.
    pub rate: S,
    /// Sum of the stiffnesses of all springs between masses and base, divided by k₁.
    pub support: S,
}

/// Data of a scene that a stepper needs.
#[derive(Clone, Copy, Debug)]
pub struct StepScene<'a, S, K = Chain<S>> {
    /// Modes of the chain, and modes of the chain with its contact stuck.
    pub dynamics: Dynamics<'a, S, K>,
    /// Factors that convert the stepper's non-dimensional groups to the units of the scene.
    pub units: Units<S>,
    /// True if the motion of the base excites the scene.
    pub on_base: bool,
    /// Indices of the masses on which a force acts, counted in the order of the scene description. If a force excites
    /// the scene, the excited mass is the first entry of this list.
    pub forces: &'a [usize],
    /// Interpolation of the stepper's input between two samples.
    pub input: Input,
    /// Points (v, f) of a friction law over the speed (Stribeck), with increasing speed v in the scene's unit. f is
    /// the kinetic friction force at the speed v, divided by the force at speed zero. Straight lines connect the
    /// points, and the first line starts at (0, 1). After the last point, and without points, the kinetic friction is
    /// constant.
    pub law: &'a [[S; 2]],
}

impl<S: Float, K: ContactChain<S>> StepScene<'_, S, K> {
    /// Returns the number of inputs of the stepper. The inputs are the motion of the base, if the base moves, and a
    /// force for each loaded mass. If damping acts relative to the moving base, the velocity of the base is one more
    /// input.
    #[must_use]
    pub fn channels(&self) -> usize {
        usize::from(self.on_base) + usize::from(self.damped_from_base()) + self.forces.len()
    }

    /// Returns true if the damping acts on velocities relative to the moving base. In this case the velocity of the
    /// base is also an input.
    pub(super) fn damped_from_base(&self) -> bool {
        self.on_base && !self.dynamics.quadratures().is_empty()
    }

    /// Returns true if the input with the index `channel` is the velocity of the base.
    pub(super) fn is_base_velocity(&self, channel: usize) -> bool {
        channel == 1 && self.damped_from_base()
    }

    /// Returns 2ζ√λφᵀΓ1, the load on a mode caused by a unit velocity of the base in the non-dimensional time
    /// t√(k₁/m₁). ζ is the damping ratio of the mode, λ its squared frequency ratio, and φᵀΓ1 its participation
    /// factor. φ is the mode shape, Γ the mass matrix divided by m₁, and 1 the vector of ones (docs/derivation.md,
    /// section 1).
    pub(super) fn drag(&self, mode: usize) -> S {
        let zero = S::constant(0.0);
        let loads = self.dynamics.quadratures().get(mode);
        let mode = loads.zip(self.dynamics.modes.get(mode));
        mode.map_or(zero, |([load, _], mode)| *load / mode.resonance)
    }

    /// Returns 1ᵀC̄1, the damping force on the base caused by a unit velocity of the base, if all masses are at rest.
    /// C̄ is the non-dimensional damping matrix, and 1 is the vector of ones. The velocity is the derivative with
    /// respect to the non-dimensional time t√(k₁/m₁).
    pub(super) fn base_drag(&self) -> S {
        let (zero, two) = (S::constant(0.0), S::constant(2.0));
        let modes = self.dynamics.modes.iter().enumerate();
        modes.fold(zero, |sum, (index, mode)| {
            let drag = self.drag(index);
            if drag.is_zero() {
                return sum;
            }
            // `drag` is 2ζ√λg, with the mode's squared frequency ratio λ and participation factor g. The term of the
            // mode is 2ζ√λg², which is the square of `drag` divided by 2ζ√λ.
            sum + drag * drag / (two * mode.zeta * mode.resonance)
        })
    }

    /// Returns the rate of the fastest oscillator, in rad/s. An oscillator is a mode of the chain, or a mode of the
    /// chain with its contact stuck. Its rate is ω(1 + 2ζ), with its natural frequency ω and its damping ratio ζ. The
    /// stepper divides a step dt into n sub-intervals, where n is the largest rate times dt, rounded up.
    #[must_use]
    pub fn fastest(&self) -> S {
        self.turning() * self.units.rate
    }

    /// Returns the rate of the fastest oscillator in the non-dimensional time t√(k₁/m₁), in rad. The rate of an
    /// oscillator is σ(1 + 2ζ). σ is its natural frequency as a frequency ratio, and ζ its damping ratio.
    pub(super) fn turning(&self) -> S {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let turned = |frequency: S, zeta: S| frequency * (one + two * zeta);
        let modes = self.dynamics.modes.iter();
        let modes = modes.map(|mode| turned(mode.resonance, mode.zeta));
        let held = self.dynamics.held.iter();
        let held = held.map(|mode| turned(mode.frequency, mode.zeta));
        modes.chain(held).fold(S::constant(0.0), S::max)
    }

    /// Returns the number of coefficients of the polynomial that describes an input over a step. Emitted tables have
    /// this number of coefficients. The tables of a run-time system may have more.
    fn coefficients(&self) -> usize {
        match (self.input, self.on_base) {
            (Input::Hold, false) => 1,
            (Input::Hold, true) | (Input::Linear, false) => 2,
            (Input::Linear, true) => 4,
        }
    }

    /// Returns the number of terms in the stepper's power series over a sub-interval. `enough` is the number of terms
    /// that the free motion of one oscillator needs: all further terms are smaller than rounding.
    pub(super) fn terms(&self, enough: u32) -> usize {
        let terms = if self.law.is_empty() {
            usize::try_from(enough).unwrap_or(TERMS)
        } else {
            TERMS
        };
        // The last coefficient of an input's polynomial has the order n. This coefficient adds to the motion a power
        // series that begins at the order n. The number of terms therefore increases by the number of coefficients.
        (terms + self.coefficients()).clamp(5, TERMS)
    }

    /// Returns the cost of a step with `parts` sub-intervals, in floating-point operations. `coefficients` is the
    /// number of coefficients of an input's polynomial. `terms` is the number of terms of a power series over a
    /// sub-interval ([`series_terms`](super::series_terms)).
    #[must_use]
    pub fn cost(&self, coefficients: usize, parts: u32, terms: u32) -> Cost {
        Cost::of(&self.extent(coefficients, parts, terms))
    }

    /// Returns the numbers of modes, inputs, coefficients and terms from which the code computes the cost of a step.
    pub(super) fn extent(&self, coefficients: usize, parts: u32, terms: u32) -> Extent {
        let count = |size: usize| u64::try_from(size).unwrap_or(u64::MAX);
        Extent {
            modes: count(self.dynamics.modes.len()),
            driven: count(self.dynamics.in_contact()),
            lost: count(self.dynamics.chain.lost_modes()),
            inputs: count(self.channels()),
            coefficients: count(coefficients),
            terms: count(self.terms(terms)),
            parts: u64::from(parts),
            on_moving_base: self.rubs_on_base(),
            damped_from_base: self.damped_from_base(),
            lines: !self.law.is_empty(),
        }
    }

    /// Returns the load on a mode caused by one unit of an input.
    pub(super) fn load(&self, channel: usize, mode: usize) -> S {
        let zero = S::constant(0.0);
        if self.on_base && channel == 0 {
            let mode = self.dynamics.modes.get(mode);
            return mode.map_or(zero, |mode| mode.load);
        }
        if self.is_base_velocity(channel) {
            return self.drag(mode);
        }
        let place = channel.wrapping_sub(self.channels() - self.forces.len());
        let mass = self.forces.get(place).copied();
        let shape = mass.map_or(&[][..], |mass| self.dynamics.shape(mass));
        shape.get(mode).copied().unwrap_or(zero)
    }

    /// Returns the acceleration of the contact under `force`. The unit of the acceleration is the unit of length
    /// divided by the squared sub-interval.
    pub(super) fn acceleration(&self, pace: &Pace<S>, force: S) -> S {
        self.dynamics.chain().inverse_mass * force * pace.span * pace.span
    }

    /// Returns true if the contact rubs on the moving base.
    pub(super) fn rubs_on_base(&self) -> bool {
        self.on_base && self.dynamics.chain().on_moving_base.is_some()
    }
}
