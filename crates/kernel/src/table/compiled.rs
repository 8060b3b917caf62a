//! A scene at one frequency ratio r whose limits β_lim and β*_lim come from tables of a declared accuracy.

use crate::contact::regime::{self, Limits};
use crate::errors::{OutOfDomain, Ratio, Regime};
use crate::number::scalar::{Float, Scalar};
use crate::response::{At, Scene};

/// Range of the frequency ratio r and the friction ratio β in which the tables of a scene are valid. The struct also
/// states whether the exact formulas apply outside this range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<S> {
    /// Smallest and largest frequency ratio r in the tables.
    pub r: (S, S),
    /// Smallest and largest friction ratio β that a caller may pass to a scene with tables.
    pub beta: (S, S),
    /// True if the exact formulas compute the results outside the range of the tables. If false, a call outside the
    /// range returns an error.
    pub exact_beyond: bool,
    /// True if β_lim exceeds every friction ratio of the range, at every frequency ratio of the range. The code then
    /// uses the closed form of the continuous motion without comparing β with β_lim.
    pub always_continuous: bool,
    /// True if β*_lim, the limit of sliding, exceeds every friction ratio of the range. The code then does not evaluate
    /// β*_lim.
    pub never_stuck: bool,
}

/// A scene that has tables of the limits β_lim and β*_lim.
pub trait Tabled: Scene {
    /// Returns the range of r and β in which the tables of this scene are valid.
    fn domain(&self) -> Domain<Self::Scalar>;
    /// Returns β_lim, the limit of continuous motion, from the table. The frequency ratio r must be within the domain
    /// of the tables.
    fn tabled_limit(&self, r: Self::Scalar) -> Self::Scalar;
    /// Returns β*_lim, the limit of sliding, from the table. Returns `None` if only the exact formulas have the
    /// declared accuracy. The frequency ratio r must be within the domain of the tables.
    fn tabled_sliding_limit(&self, r: Self::Scalar) -> Option<Self::Scalar>;
}

/// A scene at one frequency ratio whose limits β_lim and β*_lim come from tables.
#[derive(Clone, Copy, Debug)]
pub struct Compiled<T: Scene> {
    scene: T,
    /// Frequency ratio r. The value is neither NaN nor negative.
    r: T::Scalar,
    /// True if the tables are valid at this frequency ratio.
    within: bool,
}

impl<T: Tabled> Compiled<T> {
    /// Creates the scene at the frequency ratio r = ω√(m₁/k₁), and checks whether its tables are valid at r.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r, and for an r outside the range of the tables unless `exact_beyond` is
    /// true in the domain.
    #[inline]
    pub fn new(scene: T, r: T::Scalar) -> Result<Self, OutOfDomain> {
        let Domain {
            r: (low, high),
            exact_beyond,
            ..
        } = scene.domain();
        // The difference of two unequal floating-point numbers is never 0, so that its sign is always correct. The
        // lookup in the table needs the same difference.
        let within = r - low >= T::Scalar::constant(0.0) && r <= high;
        if !within {
            let allowed = exact_beyond && r >= T::Scalar::constant(0.0);
            if !allowed {
                regime::check_ratio(r)?;
                return Err(OutOfDomain::OutsideTables(Ratio::Frequency));
            }
        }
        Ok(Self { scene, r, within })
    }

    /// Computes the limits β_lim and β*_lim at every frequency ratio of a slice. Writes the limits to two slices of the
    /// same length.
    ///
    /// # Errors
    /// [`OutOfDomain`] if the slices have different lengths. Both result slices are then unchanged. [`OutOfDomain`]
    /// also at the first r outside the domain, where the function stops. The result slices then contain the limits for
    /// the frequency ratios before that r.
    pub fn limits_into(
        scene: T,
        rs: &[T::Scalar],
        continuous: &mut [T::Scalar],
        sliding: &mut [T::Scalar],
    ) -> Result<(), OutOfDomain> {
        regime::limits_into(rs, continuous, sliding, |r| {
            Ok(Self::new(scene.clone(), r)?.limits())
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

    /// Returns true if the tables are valid at this frequency ratio. If false, the exact formulas compute all results.
    #[inline]
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.within
    }

    /// Returns the scene at the same frequency ratio without its tables. All results then come from the exact formulas.
    #[must_use]
    pub fn exact(&self) -> At<T> {
        At::known(self.scene.clone(), self.r)
    }

    /// Returns β_lim, the limit of continuous motion, with the declared accuracy (5.65, 5.80, 5.96, 7.49).
    #[inline]
    #[must_use]
    pub fn continuous_limit(&self) -> T::Scalar {
        if self.within {
            self.scene.tabled_limit(self.r)
        } else {
            self.exact().continuous_limit()
        }
    }

    /// Returns β*_lim, the limit of sliding, with the declared accuracy. β*_lim is the smallest β at which a stuck
    /// state exists (6.11, 6.27, 6.33).
    #[inline]
    #[must_use]
    pub fn sliding_limit(&self) -> T::Scalar {
        let tabled = if self.within {
            self.scene.tabled_sliding_limit(self.r)
        } else {
            None
        };
        match tabled {
            Some(limit) => limit,
            None => self.exact().sliding_limit(),
        }
    }

    /// Returns the limits β_lim and β*_lim with the declared accuracy.
    #[inline]
    #[must_use]
    pub fn limits(&self) -> Limits<T::Scalar> {
        Limits {
            continuous: self.continuous_limit(),
            sliding: self.sliding_limit(),
        }
    }

    /// Returns an upper bound on β_lim from the exact formulas, without a search. The formula replaces max(S, H_c +
    /// μm*/r²) by the break-away term H_c + μm*/r² (5.64), where S is the velocity constraint.
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> T::Scalar {
        self.exact().continuous_limit_without_search()
    }

    /// Returns a lower bound on β_lim from the exact formulas (5.55, 7.37). The exact velocity constraint S is the
    /// maximum of a sum over the modes. The formula replaces S by the sum of the modes' own maxima.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> T::Scalar {
        self.exact().continuous_limit_per_mode()
    }

    /// Checks that the friction ratio β is valid and within the domain of the tables. Returns β.
    pub(super) fn checked(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let domain = self.scene.domain();
        let (low, high) = domain.beta;
        if domain.exact_beyond || (low <= beta && beta <= high) {
            Ok(beta)
        } else {
            Err(OutOfDomain::OutsideTables(Ratio::Friction))
        }
    }

    /// Returns true if β is within the domain of the tables and below β_lim, so that the motion is continuous. The
    /// argument `limit` is β_lim. The method makes as few comparisons as possible.
    #[inline]
    pub(super) fn is_admitted(&self, beta: T::Scalar, limit: T::Scalar) -> bool {
        let domain = self.scene.domain();
        let (low, high) = domain.beta;
        // β is below β_lim, which is finite. An infinite upper bound of the domain therefore needs no comparison.
        let asked = beta >= T::Scalar::constant(0.0)
            && (domain.exact_beyond || (low <= beta && (!high.is_finite() || beta <= high)));
        asked && (domain.always_continuous || beta < limit)
    }

    /// Returns true if β is below β*_lim, the limit of sliding. β must be within the domain of the tables.
    #[inline]
    pub(super) fn slides(&self, beta: T::Scalar) -> bool {
        self.scene.domain().never_stuck || beta < self.sliding_limit()
    }

    /// Returns true if β is below β*_lim. The caller has checked that β is below β_lim. With μ = 1 the result is
    /// always true, because β_lim is then the smaller limit. The reason is that, with μ = 1, a stuck state and a
    /// motion that slides all the time cannot both exist. The difference of the two motions would lose energy for
    /// ever.
    #[inline]
    fn slides_if_admitted(&self, beta: T::Scalar) -> bool {
        let one = T::Scalar::constant(1.0);
        self.scene.numbers().chain.stiction <= one || self.slides(beta)
    }

    /// Returns the regime at the friction ratio β = F/P. If the distance of β from a limit is within the declared
    /// accuracy, the result may be the regime on the other side of this limit.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β, and for a β outside the declared range.
    pub fn regime(&self, beta: T::Scalar) -> Result<Regime, OutOfDomain> {
        let beta = self.checked(beta)?;
        if !self.within {
            return self.limits().regime(beta);
        }
        let always = self.scene.domain().always_continuous;
        let admitted = always || self.is_admitted(beta, self.continuous_limit());
        let slides = if admitted {
            self.slides_if_admitted(beta)
        } else {
            self.slides(beta)
        };
        Ok(regime::regime_of(admitted, slides))
    }

    /// Returns the margin β/min(β_lim, β*_lim) − 1. If the margin is negative, β is smaller than both β_lim and β*_lim,
    /// and the closed form of the continuous motion exists.
    ///
    /// # Errors
    /// The errors of [`regime`](Self::regime).
    pub fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = self.checked(beta)?;
        self.limits().margin(beta)
    }
}
