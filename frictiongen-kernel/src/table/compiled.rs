//! A scene at one frequency ratio, whose limits come from its tables.

use crate::contact::regime::{self, Limits};
use crate::errors::{OutOfDomain, Ratio, Regime};
use crate::number::scalar::{Float, Scalar};
use crate::response::{At, Scene};

/// Range in which the tables of a scene are valid, and the behaviour beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<S> {
    /// Smallest and largest frequency ratio.
    pub r: (S, S),
    /// Smallest and largest friction ratio that a caller may ask for.
    pub beta: (S, S),
    /// True if the exact formulas answer beyond this range. If false, nothing answers there.
    pub exact_beyond: bool,
    /// True if all these friction ratios are below β_lim at all these frequencies. The closed form is then used without
    /// a comparison with β_lim.
    pub always_continuous: bool,
    /// True if all these friction ratios are below β*_lim, which is then not evaluated.
    pub never_stuck: bool,
}

/// A scene with tables of its limits.
pub trait Tabled: Scene {
    /// Returns the range in which the tables are valid.
    fn domain(&self) -> Domain<Self::Scalar>;
    /// Returns β_lim within the domain.
    fn tabled_limit(&self, r: Self::Scalar) -> Self::Scalar;
    /// Returns β*_lim within the domain; `None` where only the exact formulas reach the declared accuracy.
    fn tabled_sliding_limit(&self, r: Self::Scalar) -> Option<Self::Scalar>;
}

/// A scene at one frequency ratio, whose limits come from tables.
#[derive(Clone, Copy, Debug)]
pub struct Compiled<T: Scene> {
    scene: T,
    /// Frequency ratio, neither NaN nor negative.
    r: T::Scalar,
    /// True if the tables are valid at this r.
    within: bool,
}

impl<T: Tabled> Compiled<T> {
    /// Creates the scene at the frequency ratio r = ω√(m₁/k₁).
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, and beyond the tables' range unless the exact formulas answer there.
    #[inline]
    pub fn new(scene: T, r: T::Scalar) -> Result<Self, OutOfDomain> {
        let Domain {
            r: (low, high),
            exact_beyond,
            ..
        } = scene.domain();
        // A difference of two unequal numbers is never 0, so the sign decides. The lookup needs the same difference.
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

    /// Computes both limits over a slice of frequency ratios, into slices of the same length.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a slice of another length, which leaves both slices unchanged, and at the first r outside
    /// the domain. The values before that r are filled in.
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

    /// Returns the scene.
    #[inline]
    #[must_use]
    pub fn scene(&self) -> &T {
        &self.scene
    }

    /// Returns the frequency ratio r.
    #[inline]
    #[must_use]
    pub fn frequency_ratio(&self) -> T::Scalar {
        self.r
    }

    /// Returns true if the tables are valid at this r. Beyond them the exact formulas answer.
    #[inline]
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.within
    }

    /// Returns the scene at this r with the exact formulas.
    #[must_use]
    pub fn exact(&self) -> At<T> {
        At::known(self.scene.clone(), self.r)
    }

    /// Returns β_lim, the boundary of continuous motion (5.65, 5.80, 5.96, 7.49), to the declared accuracy.
    #[inline]
    #[must_use]
    pub fn continuous_limit(&self) -> T::Scalar {
        if self.within {
            self.scene.tabled_limit(self.r)
        } else {
            self.exact().continuous_limit()
        }
    }

    /// Returns β*_lim = |V|/(μ|H|), from which on a stuck state exists (6.11, 6.27, 6.33), to the declared accuracy.
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

    /// Returns both limits.
    #[inline]
    #[must_use]
    pub fn limits(&self) -> Limits<T::Scalar> {
        Limits {
            continuous: self.continuous_limit(),
            sliding: self.sliding_limit(),
        }
    }

    /// Returns β_lim with S replaced by its limit for τ → 0 (5.64), from the exact formulas.
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> T::Scalar {
        self.exact().continuous_limit_without_search()
    }

    /// Returns a lower bound on β_lim (5.55, 7.37), from the exact formulas. It replaces S, the maximum of a sum over
    /// the modes, by the sum of each mode's own maximum.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> T::Scalar {
        self.exact().continuous_limit_per_mode()
    }

    /// Returns β if it is within the domain.
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

    /// Returns true if β is within the domain and the motion is continuous, with as few comparisons as this needs.
    #[inline]
    pub(super) fn is_admitted(&self, beta: T::Scalar, limit: T::Scalar) -> bool {
        let domain = self.scene.domain();
        let (low, high) = domain.beta;
        // A β below β_lim is finite. An infinite upper bound then needs no comparison.
        let asked = beta >= T::Scalar::constant(0.0)
            && (domain.exact_beyond || (low <= beta && (!high.is_finite() || beta <= high)));
        asked && (domain.always_continuous || beta < limit)
    }

    /// Returns true if β is below β*_lim. The caller has checked that β is within the domain.
    #[inline]
    pub(super) fn slides(&self, beta: T::Scalar) -> bool {
        self.scene.domain().never_stuck || beta < self.sliding_limit()
    }

    /// Returns true if an admitted β is below β*_lim as well. With μ ≤ 1 a contact cannot stick while it can slide all
    /// the time, since the difference of both motions would lose energy for ever. β_lim is then the smaller limit.
    #[inline]
    fn slides_if_admitted(&self, beta: T::Scalar) -> bool {
        let one = T::Scalar::constant(1.0);
        self.scene.numbers().chain.stiction <= one || self.slides(beta)
    }

    /// Returns the regime at β = F/P. It may be wrong only within the declared accuracy of a limit.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β, and beyond the declared range.
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

    /// Returns β/min(β_lim, β*_lim) − 1, which is negative below both limits, where the closed form exists.
    ///
    /// # Errors
    /// Same errors as [`regime`](Self::regime).
    pub fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = self.checked(beta)?;
        self.limits().margin(beta)
    }
}
