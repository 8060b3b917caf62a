//! Steady states of a run-time system in any regime.

use super::at::SystemAt;
use super::error::UnknownMass;
use super::system::System;
use crate::{Complex, NoOrbit, Of, OrbitAt, Periodic, SteadyState};
use frictiongen_kernel::orbit::{self, Orbit, OrbitMotion};
use frictiongen_kernel::simulation::Part;
use frictiongen_kernel::{Float, Plain};

/// A steady state of a system, as the kernel holds it.
pub type SystemOrbitState<'a, S = f64> = Orbit<'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>>;

/// The steady motion of the contact or of a mass.
pub type SystemOrbitMotion<'o, 'a, S = f64> =
    OrbitMotion<'o, 'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>>;

/// The steady state of a system at one frequency ratio and one friction ratio, in any regime.
#[derive(Clone, Debug)]
pub struct SystemOrbit<'a, S = f64> {
    system: &'a System<S>,
    state: SystemOrbitState<'a, S>,
}

impl<'a, S: Plain> SystemAt<'a, S> {
    /// The steady state at β = F/P that is reached from rest, in any regime.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let system: frictiongen::System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let orbit = system.at(0.3)?.orbit(0.4)?;
    /// assert_eq!((orbit.stops(), orbit.reversals()), (2, 0));
    /// assert!((orbit.mass("block")?.amplitude() - 0.8567297780578).abs() < 1e-12);
    /// assert!(orbit.is_symmetric() && orbit.is_stable() && !orbit.is_marginal());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    pub fn orbit(&self, beta: S) -> Result<SystemOrbit<'a, S>, NoOrbit> {
        self.orbit_started(beta, None, false)
    }

    /// The steady state as [`orbit`](Self::orbit) gives it.  Where the motion from rest does not settle, its last 64
    /// cycles stand in its place: [`SystemOrbit::is_settled`] is false, and an amplitude is the largest of those cycles.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let system: frictiongen::System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    ///     stiction: 3,
    /// }"
    /// .parse()?;
    /// let at = system.at(1.0 / 3.0)?;
    /// assert!(at.orbit(0.01395).is_err());
    /// let seen = at.orbit_or_last_cycles(0.01395)?;
    /// assert!(!seen.is_settled() && !seen.is_stable() && seen.multipliers().is_empty());
    /// assert!(seen.mass("block")?.amplitude() > 1.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoOrbit`] if the motion is unbounded, if following it takes too many steps, or if β is negative or not finite.
    pub fn orbit_or_last_cycles(&self, beta: S) -> Result<SystemOrbit<'a, S>, NoOrbit> {
        self.orbit_started(beta, None, true)
    }

    /// The steady state that is reached from another state at a maximum of the excitation: x̄ and dx̄/dτ of every
    /// mass.
    ///
    /// # Errors
    /// [`NoOrbit`], also for a state that is not finite or not one number for each mass.
    pub fn orbit_from(&self, beta: S, state: (&[S], &[S])) -> Result<SystemOrbit<'a, S>, NoOrbit> {
        self.system.check_state(state)?;
        self.orbit_started(beta, Some(state), false)
    }

    fn orbit_started(
        &self,
        beta: S,
        start: Option<(&[S], &[S])>,
        last: bool,
    ) -> Result<SystemOrbit<'a, S>, NoOrbit> {
        let system = self.system;
        let dynamics = system.dynamics();
        let (modes, driven) = (dynamics.modes.len(), dynamics.in_contact());
        let zero = S::constant(0.0);
        let state = Orbit::new(
            dynamics,
            self.r,
            beta,
            self.sliding_limit(),
            start,
            last,
            system.parts(),
            vec![zero; orbit::numbers(modes, driven)],
            vec![Complex::new(zero, zero); 2 * driven],
        )?;
        Ok(SystemOrbit { system, state })
    }
}

impl<'a, S: Float> SystemOrbit<'a, S> {
    /// The motion of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<SystemOrbitMotion<'_, 'a, S>, UnknownMass> {
        let index = self.system.mass_index(name)?;
        self.mass_at(index).ok_or_else(|| self.system.unknown(name))
    }

    /// The motion of a mass, by its place in the description.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> Option<SystemOrbitMotion<'_, 'a, S>> {
        if !self.system.modal.on_moving_base && self.system.modal.contact == (index, None) {
            return Some(self.contact());
        }
        (index < self.system.scene().masses.len()).then(|| self.state.mass(index))
    }

    /// The relative motion in the contact.
    #[must_use]
    pub fn contact(&self) -> SystemOrbitMotion<'_, 'a, S> {
        self.state.contact()
    }

    /// After how many cycles of the excitation it repeats: 1, or up to 64 for a subharmonic state.
    #[must_use]
    pub fn period(&self) -> u32 {
        self.state.period()
    }

    /// Whether the motion repeats; otherwise this is what it does in its last 64 cycles.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.state.is_settled()
    }

    /// How often the contact stops in a period.
    #[must_use]
    pub fn stops(&self) -> usize {
        self.state.stops()
    }

    /// How often the direction of sliding changes in a period without a stop.
    #[must_use]
    pub fn reversals(&self) -> usize {
        self.state.reversals()
    }

    /// The part of the period for which the contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> S {
        self.state.stuck_fraction()
    }

    /// Whether every motion repeats with the opposite sign after half a period.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.state.is_symmetric()
    }

    /// The Floquet multipliers.
    #[must_use]
    pub fn multipliers(&self) -> &[Complex<S>] {
        self.state.multipliers()
    }

    /// Whether no small deviation grows.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.state.is_stable()
    }

    /// Whether the state is a member of a continuum, or at its end.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        self.state.is_marginal()
    }

    /// The excitation's angle at τ = 0, and the sticking intervals.
    #[must_use]
    pub fn state(&self) -> &SystemOrbitState<'a, S> {
        &self.state
    }
}

impl<S: Plain> OrbitAt for SystemAt<'_, S> {
    type Orbit<'o>
        = SystemOrbit<'o, S>
    where
        Self: 'o;

    fn orbit(&self, beta: S) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        SystemAt::orbit(self, beta)
    }

    fn orbit_or_last_cycles(&self, beta: S) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        SystemAt::orbit_or_last_cycles(self, beta)
    }
}

impl<S: Float> SteadyState for SystemOrbit<'_, S> {
    type Scalar = S;

    fn period(&self) -> u32 {
        Self::period(self)
    }
    fn is_settled(&self) -> bool {
        Self::is_settled(self)
    }
    fn stops(&self) -> usize {
        Self::stops(self)
    }
    fn reversals(&self) -> usize {
        Self::reversals(self)
    }
    fn stuck_fraction(&self) -> S {
        Self::stuck_fraction(self)
    }
    fn is_symmetric(&self) -> bool {
        Self::is_symmetric(self)
    }
    fn is_stable(&self) -> bool {
        Self::is_stable(self)
    }
    fn is_marginal(&self) -> bool {
        Self::is_marginal(self)
    }
    fn multipliers(&self) -> &[Complex<S>] {
        Self::multipliers(self)
    }
    fn ask<T>(&self, of: Of, question: impl FnOnce(&dyn Periodic<Scalar = S>) -> T) -> Option<T> {
        match of {
            Of::Contact => Some(question(&self.contact())),
            Of::Mass(index) => self.mass_at(index).map(|motion| question(&motion)),
        }
    }
}
