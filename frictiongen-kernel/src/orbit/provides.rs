//! A scene that provides steady states.

use super::{Known, Start, States};
use crate::contact::regime::check_beta;
use crate::errors::{NoOrbit, OutOfDomain};
use crate::response::{At, Scene};
use crate::table::{Compiled, Tabled};
use core::ops::Deref;

/// A scene that provides `orbit`.
pub trait ProvidesOrbit: Scene {
    /// The steady state, with a method for each mass.
    type Orbit: Deref<Target: Known>;
    /// A number for each mass.
    type State: AsRef<[Self::Scalar]> + ?Sized;

    /// The steady state from `start`; with `last` the last 64 cycles where it does not settle.
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    fn settled(
        at: &At<Self>,
        beta: Self::Scalar,
        start: Start<'_, Self::Scalar>,
        last: bool,
    ) -> Result<Self::Orbit, NoOrbit>;
}

impl<T: ProvidesOrbit> At<T> {
    /// The steady state at β = F/P that motion from rest ends in, in any regime: every mass at x̄ = 0 without velocity where
    /// the excitation is at its maximum.  A base then stands at Y: a contact with it starts at z̄ = −Y, and may stick there.
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    #[inline]
    pub fn orbit(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        T::settled(self, beta, Start::Rest, false)
    }

    /// The steady state as [`orbit`](Self::orbit) gives it.  Where the motion from rest does not settle, its last 64
    /// cycles stand in its place: `is_settled()` is false, and an amplitude is the largest of those cycles.
    ///
    /// # Errors
    /// [`NoOrbit`] if the motion is unbounded, if following it takes too many steps, or if β is negative or not
    /// finite.
    #[inline]
    pub fn orbit_or_last_cycles(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        T::settled(self, beta, Start::Rest, true)
    }

    /// The steady state that is reached from another state at a maximum of the excitation: x̄ and dx̄/dτ of every
    /// mass.
    ///
    /// # Errors
    /// [`NoOrbit`], also for a state that is not finite or not one number for each mass.
    #[inline]
    pub fn orbit_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        let start = Start::State(state.0.as_ref(), state.1.as_ref());
        T::settled(self, beta, start, false)
    }

    /// The steady state as [`orbit_from`](Self::orbit_from) gives it; where the motion does not settle, its last 64 cycles, as
    /// in [`orbit_or_last_cycles`](Self::orbit_or_last_cycles).
    ///
    /// # Errors
    /// Same errors as [`orbit_or_last_cycles`](Self::orbit_or_last_cycles), also for a state that is not finite or not one
    /// number for each mass.
    #[inline]
    pub fn orbit_or_last_cycles_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        let start = Start::State(state.0.as_ref(), state.1.as_ref());
        T::settled(self, beta, start, true)
    }

    /// Every steady state at β that is found from a fixed list of starts, one at a time: rest, the stuck state, the closed
    /// form, and motions at neighbouring friction ratios.  The first is that of [`orbit`](Self::orbit), unless motion from
    /// rest does not settle.  With μ = 1 there is one state, or one continuum.  Unstable states are left out.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn states(&self, beta: T::Scalar) -> Result<States<T>, OutOfDomain> {
        States::new(self.clone(), check_beta(beta)?)
    }
}

/// Steady states of a scene with tables are those of the exact formulas.
impl<T: Tabled + ProvidesOrbit> Compiled<T> {
    /// The steady state at β = F/P that is reached from rest, in any regime.
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    pub fn orbit(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit(beta)
    }

    /// The same, or the last 64 cycles where the motion does not settle, as [`At::orbit_or_last_cycles`] gives it.
    ///
    /// # Errors
    /// [`NoOrbit`], as there.
    pub fn orbit_or_last_cycles(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit_or_last_cycles(beta)
    }

    /// The steady state that is reached from another state, as [`At::orbit_from`] gives it.
    ///
    /// # Errors
    /// [`NoOrbit`], as there.
    pub fn orbit_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit_from(beta, state)
    }

    /// Every steady state that is found from a fixed list of starts, as [`At::states`] gives them.
    ///
    /// # Errors
    /// [`OutOfDomain`], as there.
    pub fn states(&self, beta: T::Scalar) -> Result<States<T>, OutOfDomain> {
        self.exact().states(beta)
    }
}
