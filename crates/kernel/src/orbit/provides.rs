//! Methods of a scene that return its steady states.

use super::scene::ProvidesOrbit;
use super::start::Start;
use super::states::States;
use crate::contact::regime::check_beta;
use crate::errors::{NoOrbit, OutOfDomain};
use crate::response::At;
use crate::table::{Compiled, Tabled};

impl<T: ProvidesOrbit> At<T> {
    /// Returns the steady state at the friction ratio β = F/P that the motion from rest reaches, in any regime.
    ///
    /// At the start the excitation is at its maximum, and every mass has the displacement x̄ = 0 and no velocity. A
    /// moving base is then at its amplitude Y. A contact with the moving base therefore starts at the relative
    /// displacement z = −Y.
    ///
    /// If the contact never slides, the contact may rest at any place within an interval. The steady state is then the
    /// one in the middle of this interval. Its contact force has no constant part. `offset()` returns the place at which
    /// the motion from rest leaves the contact, and [`orbit_from`](Self::orbit_from) the steady state at that place.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state.
    #[inline]
    pub fn orbit(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        T::settled(self, beta, Start::Rest, false)
    }

    /// Returns the steady state that the motion from rest reaches ([`orbit`](Self::orbit)). If this motion does not
    /// settle, the function returns its last 64 cycles. In this case `is_settled()` is false, and an amplitude is the
    /// largest amplitude in the last 64 cycles.
    ///
    /// # Errors
    /// [`NoOrbit`] if β is negative or not finite, if the motion is unbounded, or if an undamped mode never settles.
    /// The function also returns an error if a cycle has too many events, or if the search for the motion needs too
    /// many steps.
    #[inline]
    pub fn orbit_or_last_cycles(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        T::settled(self, beta, Start::Rest, true)
    }

    /// Returns the steady state that the motion from a given state reaches. The state consists of the displacement x̄
    /// and the velocity dx̄/dτ of every mass, at a maximum of the excitation. A contact that never slides stays at the
    /// place at which this motion leaves it.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state. The function also returns an error if the state does
    /// not have one finite number for each mass.
    #[inline]
    pub fn orbit_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        let start = Start::State(state.0.as_ref(), state.1.as_ref());
        T::settled(self, beta, start, false)
    }

    /// Returns the steady state that the motion from a given state reaches ([`orbit_from`](Self::orbit_from)). If this
    /// motion does not settle, the function returns its last 64 cycles, as
    /// [`orbit_or_last_cycles`](Self::orbit_or_last_cycles) does.
    ///
    /// # Errors
    /// The errors of [`orbit_or_last_cycles`](Self::orbit_or_last_cycles). The function also returns an error if the
    /// state does not have one finite number for each mass.
    #[inline]
    pub fn orbit_or_last_cycles_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        let start = Start::State(state.0.as_ref(), state.1.as_ref());
        T::settled(self, beta, start, true)
    }

    /// Returns the stable steady states that a search finds at the friction ratio β, one at a time. The search starts
    /// from a fixed list of initial states, so that it may miss other steady states.
    ///
    /// The initial states are rest, the stuck state, the closed form, and motions at neighbouring friction ratios. If
    /// the motion from rest settles, the first result is the state that [`orbit`](Self::orbit) returns. The search
    /// looks neither for unstable states nor for the mirror image of an asymmetric state. With μ = 1 only one steady
    /// state, or one continuum of steady states, exists, and the search starts from rest only.
    ///
    /// The list may be empty. [`States::reason`] then returns the reason.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn states(&self, beta: T::Scalar) -> Result<States<T>, OutOfDomain> {
        States::new(self.clone(), check_beta(beta)?)
    }
}

/// Methods that return the steady states of a scene with tables. The methods use the exact formulas, not the tables.
impl<T: Tabled + ProvidesOrbit> Compiled<T> {
    /// Returns the steady state at the friction ratio β = F/P that the motion from rest reaches, in any regime.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state.
    pub fn orbit(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit(beta)
    }

    /// Returns the steady state that the motion from rest reaches. If this motion does not settle, the function returns
    /// its last 64 cycles, as [`At::orbit_or_last_cycles`] does.
    ///
    /// # Errors
    /// The errors of [`At::orbit_or_last_cycles`].
    pub fn orbit_or_last_cycles(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit_or_last_cycles(beta)
    }

    /// Returns the steady state that the motion from a given state reaches, as [`At::orbit_from`] does.
    ///
    /// # Errors
    /// The errors of [`At::orbit_from`].
    pub fn orbit_from(
        &self,
        beta: T::Scalar,
        state: (&T::State, &T::State),
    ) -> Result<T::Orbit, NoOrbit> {
        self.exact().orbit_from(beta, state)
    }

    /// Returns stable steady states at the friction ratio β, one at a time, as [`At::states`] does.
    ///
    /// # Errors
    /// The errors of [`At::states`].
    pub fn states(&self, beta: T::Scalar) -> Result<States<T>, OutOfDomain> {
        self.exact().states(beta)
    }
}
