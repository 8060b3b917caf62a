//! A run-time system at one frequency ratio: limits and regime.

use super::motion::{SystemMotion, SystemStuck};
use super::system::System;
use crate::system::{LimitsAt, MotionAt};
use crate::{NotContinuous, OutOfDomain, Regime, StuckResonance};
use frictiongen_kernel::chain::{ContactAt, ModeAt};
use frictiongen_kernel::decay::{Damped, Decay};
use frictiongen_kernel::regime::Limits;
use frictiongen_kernel::search::Effort;
use frictiongen_kernel::wave::Wave;
use frictiongen_kernel::{Float, regime};
use frictiongen_model::modal::Reduced;

/// A system at one frequency ratio.
#[derive(Clone, Debug)]
pub struct SystemAt<'a, S = f64> {
    pub(super) system: &'a System<S>,
    pub(super) r: S,
    pub(super) inverse_r: S,
    pub(super) contact: ContactAt<S>,
    pub(super) modes: Vec<ModeAt<S>>,
}

impl<'a, S: Float> SystemAt<'a, S> {
    fn waves(&self) -> Vec<Wave<S, Damped<S>>> {
        let zip = self.system.reduced.modes.iter().zip(&self.modes);
        zip.map(|(mode, at)| Wave::rest(at.x, Damped::of(mode)))
            .collect()
    }

    fn continuous(&self, constraint: S) -> S {
        let Reduced { chain, ends, .. } = &self.system.reduced;
        let limit = chain.continuous_limit(&self.contact, constraint);
        regime::with_ends(self.r, limit, S::constant(0.0), ends.continuous_at_infinity)
    }

    /// β_lim, exact, and how often the search evaluated the velocity constraint for it.
    #[must_use]
    pub fn continuous_limit_counted(&self) -> (S, u32) {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        let peak = chain.velocity_constraint(&self.contact, modes, &self.modes, &mut self.waves());
        (self.continuous(peak.value), peak.evaluations)
    }

    /// Both limits, by one search: what is asked of them needs no other.
    #[must_use]
    pub fn limits(&self) -> Limits<S> {
        self.limits_searched().0
    }

    /// Both limits, and what the search took.
    #[must_use]
    pub fn limits_searched(&self) -> (Limits<S>, Effort) {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        let peak = chain.velocity_constraint(&self.contact, modes, &self.modes, &mut self.waves());
        let limits = Limits {
            continuous: self.continuous(peak.value),
            sliding: self.sliding_limit(),
        };
        (limits, peak.effort())
    }

    /// β_lim, the exact boundary of continuous motion (5.65, 5.80, 5.96, 7.49).  The search takes at most
    /// [`MAX_EVALUATIONS`](frictiongen_kernel::search::MAX_EVALUATIONS) evaluations of a sum over the modes.
    #[must_use]
    pub fn continuous_limit(&self) -> S {
        self.continuous_limit_counted().0
    }

    /// β_lim with S replaced by its limit for τ → 0 (5.64).
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> S {
        self.continuous(self.system.reduced.chain.break_away(&self.contact))
    }

    /// β_lim with S as the sum of each mode's own maximum (5.55, 7.37), as the thesis prints it.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> S {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        self.continuous(chain.constraint_per_mode::<Damped<S>>(&self.contact, modes, &self.modes))
    }

    /// β*_lim, beyond which the contact never slides (6.11, 6.27, 6.33).
    #[must_use]
    pub fn sliding_limit(&self) -> S {
        let Reduced {
            modes, chain, ends, ..
        } = &self.system.reduced;
        let limit = match chain.absorbed_force(&self.contact, modes, &self.modes) {
            Some(force) => force.abs() / chain.stiction,
            None => chain.sliding_limit(&self.contact),
        };
        regime::with_ends(
            self.r,
            limit,
            ends.sliding_at_rest,
            ends.sliding_at_infinity,
        )
    }

    /// The regime at β = F/P.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        Ok(regime::regime(
            beta,
            self.continuous_limit(),
            self.sliding_limit(),
        ))
    }

    /// β/min(β_lim, β*_lim) − 1: negative in the continuous regime.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        Ok(regime::margin(
            beta,
            self.continuous_limit(),
            self.sliding_limit(),
        ))
    }

    /// The exact continuous motion at β = F/P.
    ///
    /// # Errors
    /// [`NotContinuous`] says which regime it is instead.
    pub fn motion(&self, beta: S) -> Result<SystemMotion<'a, S>, NotContinuous> {
        let Self {
            system,
            r,
            contact,
            modes,
            ..
        } = self;
        let Reduced {
            modes: constants,
            chain,
            ..
        } = &system.reduced;
        let beta = chain.admitted(
            *r,
            beta,
            self.sliding_limit(),
            system.reduced.ends.continuous_at_infinity,
            &system.unbounded,
            contact,
            constants,
            modes,
            &mut self.waves(),
        )?;
        Ok(SystemMotion {
            at: self.clone(),
            friction: chain.friction(&self.contact, self.inverse_r, beta),
        })
    }

    /// The response while the contact is stuck.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck.
    pub fn stuck(&self) -> Result<SystemStuck<'a, S>, StuckResonance> {
        let Self {
            system, r, contact, ..
        } = self;
        system
            .reduced
            .chain
            .stuck_admitted(*r, contact, &system.invisible)?;
        Ok(SystemStuck { at: self.clone() })
    }
}

impl<S: Float> LimitsAt for SystemAt<'_, S> {
    type Scalar = S;

    fn continuous_limit(&self) -> S {
        Self::continuous_limit(self)
    }
    fn continuous_limit_without_search(&self) -> S {
        Self::continuous_limit_without_search(self)
    }
    fn continuous_limit_per_mode(&self) -> S {
        Self::continuous_limit_per_mode(self)
    }
    fn sliding_limit(&self) -> S {
        Self::sliding_limit(self)
    }
    fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        Self::regime(self, beta)
    }
    fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        Self::margin(self, beta)
    }
}

impl<'a, S: Float> MotionAt for SystemAt<'a, S> {
    type Motion = SystemMotion<'a, S>;

    fn motion(&self, beta: S) -> Result<SystemMotion<'a, S>, NotContinuous> {
        Self::motion(self, beta)
    }
}
