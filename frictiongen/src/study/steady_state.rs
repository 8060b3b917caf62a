//! Steady states of a run-time system with a rigid or an elastic contact, and the stuck state of an elastic contact.

use super::orbit::SystemOrbit;
use super::system::System;
use crate::{Complex, Error, NoOrbit, OutOfDomain, StuckResonance};
use frictiongen_kernel::Plain;
use frictiongen_kernel::motion::{AnyContact, MotionSetting, Part};
use frictiongen_kernel::number::complex;
use frictiongen_kernel::orbit::{self, Orbit, OrbitQuestion, Start};

/// The scene at one r and one β, with a rigid or an elastic contact, and the oscillators of its modes.
type StuckSetting<'a, S> = (MotionSetting<'a, S, AnyContact<S>>, Vec<Part<S>>);

impl<S: Plain> System<S> {
    /// Returns the steady state at r and β = F/P in which the motion from rest ends. The contact may be rigid or
    /// elastic.
    ///
    /// An elastic contact starts without force. It sticks after each reversal. Its regime is therefore stick-slip or
    /// stuck. A steady state in which it never slides is marginal, because its slider may rest at other positions.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let braced: frictiongen::System = "struct Braced {
    ///     masses: { floor: 3.25 },
    ///     springs: { base - floor: 2730 },
    ///     contact: floor - wall, stiffness: 16000,
    ///     excitation: floor,
    ///     damping: modal(0.0256),
    ///     provide: [orbit],
    /// }"
    /// .parse()?;
    /// // A load of 20 N at 23.583 rad/s, and a friction force of 10.6 N.
    /// let state = braced.steady_state(braced.frequency_ratio(23.583), 10.6 / 20.0)?;
    /// let amplitude = state.mass("floor")?.amplitude() * 20.0 / 2730.0;
    /// assert!((amplitude - 0.012016107849758763).abs() < 1e-9 * amplitude);
    /// assert_eq!((state.stops(), state.reversals()), (2, 0));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state. [`OutOfDomain`] also for r that is not positive and
    /// finite, and for `friction: stribeck`.
    pub fn steady_state(&self, r: S, beta: S) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        self.steady_state_of(r, beta, Start::Rest)
    }

    /// Returns the steady state that a motion from a given state reaches. The method differs from
    /// [`steady_state`](Self::steady_state) only by the initial state. `state` contains x̄ and dx̄/dτ of every mass at
    /// a maximum of the excitation. An elastic contact starts without force.
    ///
    /// # Errors
    /// Same errors as [`steady_state`](Self::steady_state). [`OutOfDomain`] also if `state` does not have one finite
    /// displacement and one finite velocity for each mass.
    pub fn steady_state_from(
        &self,
        r: S,
        beta: S,
        state: (&[S], &[S]),
    ) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        self.steady_state_of(r, beta, Start::State(state.0, state.1))
    }

    fn steady_state_of(
        &self,
        r: S,
        beta: S,
        start: Start<'_, S>,
    ) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        self.constant_force()?;
        let (setting, parts) = self.stuck_setting(r)?;
        // On an undamped resonance of the chain with its contact stuck, no friction force keeps the contact stuck.
        let limit = setting
            .stuck_force(&parts)
            .map_or(S::constant(f64::INFINITY), |force| self.limit_of(force));
        self.settled_from(r, beta, start, (limit, false))
    }

    /// Returns the limit of sliding β*_lim = |f|/μ, the smallest β = F/P at which a stuck state exists. f is the
    /// complex amplitude of the force in the stuck contact, divided by P. The contact may be rigid or elastic.
    ///
    /// If β is at least this limit, an elastic contact that starts without force never slides. If the contact has slid
    /// earlier, its slider may rest at another position. The contact force then has an additional constant part.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck. [`OutOfDomain`] for r that is
    /// not positive and finite.
    pub fn stuck_limit(&self, r: S) -> Result<S, Error> {
        let (setting, parts) = self.stuck_setting(r)?;
        let force = setting.stuck_force(&parts).ok_or(StuckResonance)?;
        Ok(self.limit_of(force))
    }

    /// Returns the complex amplitude of every mass while the contact never slides, divided by P/k₁ (by Y for base
    /// motion). The contact may be rigid or elastic.
    ///
    /// # Errors
    /// Same errors as [`stuck_limit`](Self::stuck_limit).
    pub fn stuck_amplitudes(&self, r: S) -> Result<Vec<Complex<S>>, Error> {
        let (setting, parts) = self.stuck_setting(r)?;
        let masses = 0..self.scene().masses.len();
        let amplitudes: Option<Vec<_>> = masses
            .map(|mass| setting.stuck_amplitude(&parts, mass))
            .collect();
        Ok(amplitudes.ok_or(StuckResonance)?)
    }

    fn limit_of(&self, force: Complex<S>) -> S {
        complex::modulus(force, true) / self.reduced.chain.stiction
    }

    /// Returns the data of the scene at r and β = 0, and the oscillators of its modes.
    fn stuck_setting(&self, r: S) -> Result<StuckSetting<'_, S>, OutOfDomain> {
        let dynamics = self.dynamics_in_time()?;
        let mut parts = self.parts();
        let setting = MotionSetting::new(dynamics, r, S::constant(0.0), &mut parts)?;
        Ok((setting, parts))
    }

    /// Returns the steady state that a motion from `start` reaches. The initial state of the system, if it has one,
    /// takes the place of rest. `sliding` is β*_lim. If the motion does not settle, the result is a stable steady state
    /// that the search found on the way. If the search found none and `last` is true, the result contains the last
    /// computed cycles.
    pub(super) fn settled_from(
        &self,
        r: S,
        beta: S,
        start: Start<'_, S>,
        (sliding, last): (S, bool),
    ) -> Result<SystemOrbit<'_, S>, NoOrbit> {
        let own = self.start.as_ref().map(|state| state.at(r));
        let start = match (&own, start) {
            (Some((x, v)), Start::Rest) => Start::State(x, v),
            (_, start) => start,
        };
        if let Start::State(displacements, velocities)
        | Start::Cycle(displacements, velocities, _) = start
        {
            self.check_state((displacements, velocities))?;
        }
        let dynamics = self.dynamics_in_time()?;
        let size = dynamics.state_size();
        let numbers = orbit::numbers_of(dynamics.modes.len(), size);
        let zero = S::constant(0.0);
        let question = OrbitQuestion {
            dynamics,
            r,
            beta,
            sliding,
            start,
            last,
        };
        let mut unsettled = None;
        let orbit = Orbit::answer_at_length(
            &question,
            self.parts(),
            vec![zero; numbers],
            vec![Complex::new(zero, zero); size],
            &mut unsettled,
        )?;
        let is_its_own = unsettled.is_none() || !orbit.is_settled();
        Ok(SystemOrbit {
            system: self,
            orbit,
            from_rest: matches!(start, Start::Rest | Start::State(..)) && is_its_own,
            unsettled,
            slides: false,
        })
    }
}
