//! A scene at one frequency ratio: limits, regime, and the way to motions.

use super::scene::Scene;
use crate::contact::regime::{self, Limits};
use crate::contact::sums::ContactAt;
use crate::errors::{OutOfDomain, Regime};
use crate::modal_sum::search::{self, Effort, Peak, Weight};
use crate::modal_sum::wave::fastest;
use crate::number::scalar::Scalar;

/// A scene at one frequency ratio: what both limits and every motion share.
#[derive(Clone, Debug)]
pub struct At<T: Scene> {
    pub(super) scene: T,
    pub(super) r: T::Scalar,
    pub(super) inverse_r: T::Scalar,
    pub(super) contact: ContactAt<T::Scalar>,
    pub(super) modes: T::Modes,
}

impl<T: Scene + Copy> Copy for At<T> where T::Modes: Copy {}

/// How often a search may evaluate its sum over the modes at most; a grid of up to 32 instants counts as two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct MostEvaluations {
    /// A search for β_lim: one in `continuous_limit`, `limits`, `regime` and `margin`, one or two in `motion`.  0 where
    /// none is needed.
    pub limit: u32,
    /// A search for the amplitude and phase of a mass.
    pub amplitude: u32,
}

/// r, checked, and 1/r within what the formulas can square.
#[inline]
fn ratios<T: Scene>(scene: &T, r: T::Scalar) -> Result<(T::Scalar, T::Scalar), OutOfDomain> {
    let r = regime::check_ratio(r, "r")?;
    Ok((r, inverse_ratio(scene, r)))
}

/// 1/r within what the formulas can square.
#[inline]
pub(super) fn inverse_ratio<T: Scene>(scene: &T, r: T::Scalar) -> T::Scalar {
    let (low, high) = scene.inverse_ratio_range();
    Scalar::min(Scalar::max(T::Scalar::constant(1.0) / r, low), high)
}

/// β_lim with its values at the ends of the frequency range.
#[inline]
fn continuous_with_ends<T: Scene>(scene: &T, r: T::Scalar, limit: T::Scalar) -> T::Scalar {
    let at_infinity = scene.numbers().ends.continuous_at_infinity;
    regime::with_ends(r, limit, T::Scalar::constant(0.0), at_infinity)
}

/// β*_lim with its values at the ends of the frequency range.
#[inline]
fn sliding_with_ends<T: Scene>(scene: &T, r: T::Scalar, limit: T::Scalar) -> T::Scalar {
    let ends = scene.numbers().ends;
    regime::with_ends(r, limit, ends.sliding_at_rest, ends.sliding_at_infinity)
}

impl<T: Scene> At<T> {
    /// The scene at the frequency ratio r = ω√(m₁/k₁).
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r; 0 and ∞ answer with the limits.
    #[inline]
    pub fn new(scene: T, r: T::Scalar) -> Result<Self, OutOfDomain> {
        Ok(Self::known(scene, regime::check_ratio(r, "r")?))
    }

    /// The same at an r that is known to be neither NaN nor negative.
    #[inline]
    pub(crate) fn known(scene: T, r: T::Scalar) -> Self {
        let inverse_r = inverse_ratio(&scene, r);
        let (contact, modes) = scene.frequency_stage(inverse_r);
        Self {
            scene,
            r,
            inverse_r,
            contact,
            modes,
        }
    }

    /// The same once more, for a motion to keep.
    #[inline]
    pub(super) fn kept(&self) -> Self {
        Self {
            scene: self.scene.clone(),
            modes: T::kept(&self.modes),
            ..*self
        }
    }

    /// Both limits without search: the same bits as
    /// [`continuous_limit_without_search`](Self::continuous_limit_without_search) and
    /// [`sliding_limit`](Self::sliding_limit), in less time, as nothing is kept for a motion.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r; 0 and ∞ answer with the limits.
    #[inline]
    pub fn limits_without_search(
        scene: &T,
        r: T::Scalar,
    ) -> Result<Limits<T::Scalar>, OutOfDomain> {
        let (r, inverse_r) = ratios(scene, r)?;
        let (mut limits, h) = scene.limits_without_search(inverse_r);
        let numbers = scene.numbers();
        if numbers.absorbs && numbers.chain.may_absorb(h) {
            // The holding force takes the modes' functions.
            limits.sliding = Self::new(scene.clone(), r)?.sliding_limit();
        }
        Ok(Limits {
            continuous: continuous_with_ends(scene, r, limits.continuous),
            sliding: sliding_with_ends(scene, r, limits.sliding),
        })
    }

    /// The scene.
    #[inline]
    #[must_use]
    pub fn scene(&self) -> &T {
        &self.scene
    }

    /// r.
    #[inline]
    #[must_use]
    pub fn frequency_ratio(&self) -> T::Scalar {
        self.r
    }

    /// 1/r as the formulas take it, within what a scalar can square.
    #[inline]
    #[must_use]
    pub fn inverse_ratio(&self) -> T::Scalar {
        self.inverse_r
    }

    /// V, U, G, H and H_c of the contact, each times r²E.
    #[inline]
    #[must_use]
    pub fn contact_sums(&self) -> &ContactAt<T::Scalar> {
        &self.contact
    }

    /// The functions of the modes that load or contact drive.
    #[inline]
    #[must_use]
    pub fn modes(&self) -> &T::Modes {
        &self.modes
    }

    /// The search for r²E·max(S, H_c + μm*/r²), the velocity constraint (5.54, 7.36).
    #[must_use]
    pub fn velocity_constraint(&self) -> Peak<T::Scalar> {
        let numbers = self.scene.numbers();
        let modes = self.modes.as_ref();
        self.scene.with_idle(|waves| {
            let chain = numbers.chain;
            chain.velocity_constraint(&self.contact, numbers.modes, modes, waves)
        })
    }

    /// What searches may take at this r, and at every larger one: the scene's own bound from the least r on that it
    /// meets.
    ///
    /// It is 256 evaluations for β_lim and 1024 for an amplitude, both more by the fastest mode's half turns in a half
    /// period over 16, max √λ(1 + 2ζ)/16r, and never more than [`MAX_EVALUATIONS`](search::MAX_EVALUATIONS).  No search
    /// exceeds it: it counts, and where it would need more it stops and [tells](Effort::Exceeded).  Of undamped scenes
    /// β_lim takes no search from r = √λ_max/2 on.
    ///
    /// What searches do take is far less.  In 2·10⁴ random scenes of up to 16 masses, on and beside resonances and
    /// subharmonics and in sweeps as slow as 2·10⁴ half turns of a mode, half took 2 for β_lim and 5 for an amplitude, 99 of
    /// 100 at most 80 and 30, and the worst 217 and 318, less than a third of its bound.  None was
    /// stopped where the fastest mode makes fewer than 2·10⁴ half turns in a half period; beyond, 153 searches for β_lim were.
    #[must_use]
    pub fn most_evaluations(&self) -> MostEvaluations {
        let numbers = self.scene.numbers();
        let modes = numbers.modes.iter();
        let ratios = modes.map(|mode| (mode.resonance * self.inverse_r, mode.zeta));
        let most = fastest(ratios.clone());
        let decided = numbers.chain.start_decides(ratios.map(|(x, _)| x));
        let limit = search::most_evaluations(Weight::Sine, most);
        MostEvaluations {
            limit: if decided { 0 } else { limit },
            amplitude: search::most_evaluations(Weight::One, most),
        }
    }

    #[inline]
    fn limited(&self, constraint: T::Scalar) -> T::Scalar {
        let limit = self.scene.continuous_limit(&self.contact, constraint);
        continuous_with_ends(&self.scene, self.r, limit)
    }

    /// β_lim, exact: the boundary of continuous motion (5.65, 5.80, 5.96, 7.49), with S from a guaranteed search
    /// over the half period.  Without damping the search is needed only where some R < 1/2.
    ///
    /// The search takes no more evaluations of a sum over the modes than [`most_evaluations`](Self::most_evaluations)
    /// says; [`limits_searched`](Self::limits_searched) tells how many, and whether it came to its end.
    #[must_use]
    pub fn continuous_limit(&self) -> T::Scalar {
        self.limited(self.velocity_constraint().value)
    }

    /// Both limits, by one search: what is asked of them needs no other.
    ///
    /// [`most_evaluations`](Self::most_evaluations) bounds the search for a scene and all r from one on;
    /// [`limits_searched`](Self::limits_searched) tells what it took.
    #[must_use]
    pub fn limits(&self) -> Limits<T::Scalar> {
        self.limits_searched().0
    }

    /// Both limits, and what the search took.
    #[must_use]
    pub fn limits_searched(&self) -> (Limits<T::Scalar>, Effort) {
        let peak = self.velocity_constraint();
        let limits = Limits {
            continuous: self.limited(peak.value),
            sliding: self.sliding_limit(),
        };
        (limits, peak.effort())
    }

    /// β_lim with S replaced by its limit for τ → 0 (5.64): an upper bound, exact wherever the start of the half
    /// period decides.
    #[inline]
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> T::Scalar {
        self.limited(self.scene.break_away(&self.contact))
    }

    /// β_lim with S as the sum of each mode's own maximum, as the thesis prints it (5.55, 7.37): a lower bound on
    /// β_lim.  A search for each mode.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> T::Scalar {
        let numbers = self.scene.numbers();
        self.limited(numbers.chain.constraint_per_mode::<T::Decay>(
            &self.contact,
            numbers.modes,
            self.modes.as_ref(),
        ))
    }

    /// β*_lim = |V|/(μ|H|), from which on a stuck state exists (6.11, 6.27, 6.33).  With μ > 1 motion from rest may go on
    /// sliding above it.
    #[inline]
    #[must_use]
    pub fn sliding_limit(&self) -> T::Scalar {
        let numbers = self.scene.numbers();
        let limit = match self.absorbed_force() {
            Some(force) => force.abs() / numbers.chain.stiction,
            None => self.scene.sliding_limit(&self.contact),
        };
        sliding_with_ends(&self.scene, self.r, limit)
    }

    /// The force that holds a stuck contact, where masses beyond it absorb.
    #[inline]
    pub(super) fn absorbed_force(&self) -> Option<T::Scalar> {
        let numbers = self.scene.numbers();
        if !numbers.absorbs {
            return None;
        }
        numbers
            .chain
            .absorbed_force(&self.contact, numbers.modes, self.modes.as_ref())
    }

    /// The regime at the friction ratio β = F/P.  It searches for β_lim: for many β at one r, ask
    /// [`limits`](Self::limits) once.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: T::Scalar) -> Result<Regime, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let (continuous, sliding) = (self.continuous_limit(), self.sliding_limit());
        Ok(regime::regime(beta, continuous, sliding))
    }

    /// β/min(β_lim, β*_lim) − 1: negative below both limits, where the closed form exists.  With μ = 1 it is the only state
    /// there; with μ > 1 stick-slip may exist beside it.  It searches as [`regime`](Self::regime) does.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let (continuous, sliding) = (self.continuous_limit(), self.sliding_limit());
        Ok(regime::margin(beta, continuous, sliding))
    }
}
