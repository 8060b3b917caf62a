//! Response of a scene at one frequency ratio r: the limits β_lim and β*_lim, the regime, and the methods that return
//! motions.

use super::scene::Scene;
use crate::contact::regime::{self, Limits};
use crate::contact::sums::ContactAt;
use crate::errors::{OutOfDomain, Regime};
use crate::modal_sum::search::{self, Effort, Peak, Weight};
use crate::modal_sum::wave::fastest;
use crate::number::scalar::Scalar;

/// A scene at one frequency ratio r. The struct stores the sums over the modes with which the code computes the limits
/// β_lim and β*_lim and every motion.
#[derive(Clone, Debug)]
pub struct At<T: Scene> {
    pub(super) scene: T,
    pub(super) r: T::Scalar,
    pub(super) inverse_r: T::Scalar,
    pub(super) contact: ContactAt<T::Scalar>,
    pub(super) modes: T::Modes,
}

impl<T: Scene + Copy> Copy for At<T> where T::Modes: Copy {}

/// Largest numbers of evaluations of the modal sum in one search. A grid of up to 32 instants counts as two
/// evaluations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct MostEvaluations {
    /// Largest number of evaluations in one search for β_lim, the limit of continuous motion. The methods
    /// `continuous_limit`, `limits`, `regime` and `margin` make one search each. `motion` makes one or two. If β_lim
    /// needs no search, the number is 0.
    pub limit: u32,
    /// Largest number of evaluations in one search for the amplitude and phase of a mass.
    pub amplitude: u32,
}

/// Checks the frequency ratio r, and returns r and 1/r. The code clamps 1/r so that 1/r² stays finite.
#[inline]
fn ratios<T: Scene>(scene: &T, r: T::Scalar) -> Result<(T::Scalar, T::Scalar), OutOfDomain> {
    let r = regime::check_ratio(r)?;
    Ok((r, inverse_ratio(scene, r)))
}

/// Returns 1/r, the inverse of the frequency ratio. The code clamps 1/r so that 1/r² stays finite.
#[inline]
pub(super) fn inverse_ratio<T: Scene>(scene: &T, r: T::Scalar) -> T::Scalar {
    let (low, high) = scene.inverse_ratio_range();
    Scalar::min(Scalar::max(T::Scalar::constant(1.0) / r, low), high)
}

/// Returns β_lim, the limit of continuous motion. At r = 0 and r = ∞ the result is the known limiting value. At every
/// other r it is the computed value `limit`.
#[inline]
fn continuous_with_ends<T: Scene>(scene: &T, r: T::Scalar, limit: T::Scalar) -> T::Scalar {
    let at_infinity = scene.numbers().ends.continuous_at_infinity;
    regime::with_ends(r, limit, T::Scalar::constant(0.0), at_infinity)
}

/// Returns β*_lim, the limit of sliding. At r = 0 and r = ∞ the result is the known limiting value. At every other r it
/// is the computed value `limit`.
#[inline]
fn sliding_with_ends<T: Scene>(scene: &T, r: T::Scalar, limit: T::Scalar) -> T::Scalar {
    let ends = scene.numbers().ends;
    regime::with_ends(r, limit, ends.sliding_at_rest, ends.sliding_at_infinity)
}

impl<T: Scene> At<T> {
    /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁).
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the functions return the limiting values of β_lim and
    /// β*_lim.
    #[inline]
    pub fn new(scene: T, r: T::Scalar) -> Result<Self, OutOfDomain> {
        Ok(Self::known(scene, regime::check_ratio(r)?))
    }

    /// Evaluates the scene at a frequency ratio r that is neither NaN nor negative. The caller has checked r.
    #[inline]
    pub(crate) fn known(scene: T, r: T::Scalar) -> Self {
        let inverse_r = inverse_ratio(&scene, r);
        let (mut contact, modes) = scene.frequency_stage(inverse_r);
        if let Some(compliance) = scene.compliance() {
            contact.h.re = contact.h.re + contact.compliance(compliance, inverse_r);
        }
        Self {
            scene,
            r,
            inverse_r,
            contact,
            modes,
        }
    }

    /// Copies the scene with the functions of its modes at this frequency ratio, so that a motion can own the copy.
    #[inline]
    pub(super) fn kept(&self) -> Self {
        Self {
            scene: self.scene.clone(),
            modes: T::kept(&self.modes),
            ..*self
        }
    }

    /// Returns the limits β_lim and β*_lim without a search. The result for β_lim is an upper bound.
    ///
    /// This function is faster than [`new`](Self::new), because it stores nothing for a motion. Its results have the
    /// same bits as those of [`continuous_limit_without_search`](Self::continuous_limit_without_search) and
    /// [`sliding_limit`](Self::sliding_limit).
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the function returns the limiting values of β_lim and
    /// β*_lim.
    #[inline]
    pub fn limits_without_search(
        scene: &T,
        r: T::Scalar,
    ) -> Result<Limits<T::Scalar>, OutOfDomain> {
        if scene.compliance().is_some() {
            let at = Self::new(scene.clone(), r)?;
            return Ok(Limits {
                continuous: T::Scalar::constant(0.0),
                sliding: at.sliding_limit(),
            });
        }
        let (r, inverse_r) = ratios(scene, r)?;
        let (mut limits, h) = scene.limits_without_search(inverse_r);
        let numbers = scene.numbers();
        if numbers.absorbs && numbers.chain.may_absorb(h) {
            // With an absorber, β*_lim depends on the response functions of each mode, which only `new` computes.
            limits.sliding = Self::new(scene.clone(), r)?.sliding_limit();
        }
        Ok(Limits {
            continuous: continuous_with_ends(scene, r, limits.continuous),
            sliding: sliding_with_ends(scene, r, limits.sliding),
        })
    }

    /// Returns the scene, as it was passed to [`new`](Self::new).
    #[inline]
    #[must_use]
    pub fn scene(&self) -> &T {
        &self.scene
    }

    /// Returns the frequency ratio r = ω√(m₁/k₁) at which the scene is evaluated.
    #[inline]
    #[must_use]
    pub fn frequency_ratio(&self) -> T::Scalar {
        self.r
    }

    /// Returns 1/r, the inverse of the frequency ratio. The code clamps 1/r so that 1/r² stays finite, and uses the
    /// clamped value in all formulas.
    #[inline]
    #[must_use]
    pub fn inverse_ratio(&self) -> T::Scalar {
        self.inverse_r
    }

    /// Returns the sums over the modes for the contact. V is the response of the contact to the load, and H its
    /// receptance. U, G and H_c describe the response of the contact to a square wave of friction. Each sum is
    /// multiplied by r² and by the scale E of [`ContactAt`].
    #[inline]
    #[must_use]
    pub fn contact_sums(&self) -> &ContactAt<T::Scalar> {
        &self.contact
    }

    /// Returns the response and damping functions of each mode at this frequency ratio. The list contains the modes
    /// that the load or the contact drives.
    #[inline]
    #[must_use]
    pub fn modes(&self) -> &T::Modes {
        &self.modes
    }

    /// Searches for max(S, H_c + μm*/r²), on which β_lim depends (5.54, 7.36). The velocity constraint S is the
    /// maximum of F/sin τ in the half period, where F is a sum over the modes. H_c + μm*/r² comes from the break-away
    /// condition at a reversal. The result is multiplied by r² and by the scale E of [`ContactAt`].
    #[must_use]
    pub fn velocity_constraint(&self) -> Peak<T::Scalar> {
        let numbers = self.scene.numbers();
        let modes = self.modes.as_ref();
        self.scene.with_idle(|waves| {
            let chain = numbers.chain;
            chain.velocity_constraint(&self.contact, numbers.modes, modes, waves)
        })
    }

    /// Returns upper bounds on the number of evaluations of the modal sum in one search, at this frequency ratio r and
    /// at every larger r.
    ///
    /// The bounds at the smallest r of a sweep are therefore valid for the whole sweep. For slow modes, the bound is
    /// 256 evaluations for β_lim and 1024 for an amplitude. Fast modes increase each bound by max √λ(1 + 2ζ)/(16r)
    /// evaluations. Without damping, this increase is one evaluation for every 16 half turns of the fastest mode in a
    /// half period. No bound exceeds [`MAX_EVALUATIONS`](search::MAX_EVALUATIONS).
    ///
    /// A search stops before its evaluations would exceed the bound, and then reports [`Effort::Exceeded`]. In an
    /// undamped scene β_lim needs no search for r ≥ √λ_max/2, where √λ_max is the largest resonance. Searches usually
    /// need far fewer evaluations than the bound. `docs/evidence.md` has measured numbers. In random scenes, only
    /// searches with more than 2·10⁴ half turns reached their bound (section 9 of `docs/derivation.md`).
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
        if self.is_elastic() {
            return T::Scalar::constant(0.0);
        }
        let limit = self.scene.continuous_limit(&self.contact, constraint);
        continuous_with_ends(&self.scene, self.r, limit)
    }

    /// Returns true if the contact of the scene is elastic.
    #[inline]
    pub(super) fn is_elastic(&self) -> bool {
        self.scene.compliance().is_some()
    }

    /// Returns the exact β_lim, the limit of continuous motion (5.65, 5.80, 5.96, 7.49). An elastic contact sticks
    /// after each reversal, so that its β_lim is 0.
    ///
    /// The velocity constraint S is the largest value in the half period of F/sin τ, where F is a sum over the modes
    /// (section 4 of `docs/derivation.md`). A search finds S, and proves that no larger value exists. In a scene
    /// without damping, a search is needed only if the excitation is slower than half the natural frequency of some
    /// mode.
    ///
    /// [`most_evaluations`](Self::most_evaluations) returns an upper bound on the evaluations of the modal sum in the
    /// search. [`limits_searched`](Self::limits_searched) returns how many evaluations the search took, and whether
    /// the search is complete.
    #[must_use]
    pub fn continuous_limit(&self) -> T::Scalar {
        if self.is_elastic() {
            return T::Scalar::constant(0.0);
        }
        self.limited(self.velocity_constraint().value)
    }

    /// Returns the limits β_lim and β*_lim, with one search. The result gives the regime and the margin at any β
    /// without another search.
    ///
    /// [`most_evaluations`](Self::most_evaluations) returns an upper bound on the evaluations in this search, at this
    /// r and at every larger r. [`limits_searched`](Self::limits_searched) also returns how many evaluations the
    /// search took.
    #[must_use]
    pub fn limits(&self) -> Limits<T::Scalar> {
        self.limits_searched().0
    }

    /// Returns the limits β_lim and β*_lim, and the number of evaluations that the search for β_lim took. [`Effort`]
    /// also tells whether the search is complete.
    #[must_use]
    pub fn limits_searched(&self) -> (Limits<T::Scalar>, Effort) {
        if self.is_elastic() {
            let limits = Limits {
                continuous: T::Scalar::constant(0.0),
                sliding: self.sliding_limit(),
            };
            return (limits, Effort::Bounded(0));
        }
        let peak = self.velocity_constraint();
        let limits = Limits {
            continuous: self.limited(peak.value),
            sliding: self.sliding_limit(),
        };
        (limits, peak.effort())
    }

    /// Returns an upper bound on β_lim without a search. The formula replaces max(S, H_c + μm*/r²) by the break-away
    /// term H_c + μm*/r² (5.64), where S is the velocity constraint. The bound is equal to β_lim if S does not exceed
    /// the break-away term.
    #[inline]
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> T::Scalar {
        self.limited(self.scene.break_away(&self.contact))
    }

    /// Returns the lower bound on β_lim that the thesis prints (5.55, 7.37). The exact velocity constraint S is the
    /// maximum of a sum over the modes. The printed formula replaces S by the sum of the maxima of the single modes.
    /// The call makes one search for each mode.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> T::Scalar {
        let numbers = self.scene.numbers();
        self.limited(numbers.chain.constraint_per_mode::<T::Decay>(
            &self.contact,
            numbers.modes,
            self.modes.as_ref(),
        ))
    }

    /// Returns β*_lim, the limit of sliding, which is the smallest β at which a stuck state exists (6.11, 6.27, 6.33).
    ///
    /// The formula is |V|/(μ|H|), where V is the response of the contact to the load. H is the receptance of the
    /// contact, including the spring of an elastic contact. With μ > 1, the motion from rest may continue to slide even
    /// for β > β*_lim.
    #[inline]
    #[must_use]
    pub fn sliding_limit(&self) -> T::Scalar {
        let numbers = self.scene.numbers();
        let limit = match self.absorbed_force() {
            _ if self.is_elastic() => numbers.chain.sliding_limit(&self.contact),
            Some(force) => force.abs() / numbers.chain.stiction,
            None => self.scene.sliding_limit(&self.contact),
        };
        sliding_with_ends(&self.scene, self.r, limit)
    }

    /// Returns the amplitude of the contact force in the stuck state, if masses beyond the contact (seen from the
    /// load) act as an absorber. Returns `None` if no mass acts as an absorber.
    #[inline]
    pub(super) fn absorbed_force(&self) -> Option<T::Scalar> {
        let numbers = self.scene.numbers();
        // V and H of an elastic contact are never zero at the same r, because H includes the contact's compliance.
        if !numbers.absorbs || self.is_elastic() {
            return None;
        }
        numbers
            .chain
            .absorbed_force(&self.contact, numbers.modes, self.modes.as_ref())
    }

    /// Returns the regime at the friction ratio β = F/P. Each call searches for β_lim. For many values of β at one r,
    /// call [`limits`](Self::limits) once.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: T::Scalar) -> Result<Regime, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let (continuous, sliding) = (self.continuous_limit(), self.sliding_limit());
        Ok(regime::regime(beta, continuous, sliding))
    }

    /// Returns the margin β/min(β_lim, β*_lim) − 1. If the margin is negative, β is smaller than both β_lim and β*_lim,
    /// and the closed form exists. With μ = 1 the closed form is then the only steady state. With μ > 1 a stick-slip
    /// state may coexist. Each call searches for β_lim, as [`regime`](Self::regime) does.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let (continuous, sliding) = (self.continuous_limit(), self.sliding_limit());
        Ok(regime::margin(beta, continuous, sliding))
    }
}
