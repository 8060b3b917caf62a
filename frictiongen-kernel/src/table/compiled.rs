//! A scene at one frequency ratio, from its tables.

use crate::contact::regime::{self, Limits};
use crate::errors::{OutOfDomain, Regime};
use crate::number::scalar::{Float, Scalar};
use crate::response::{At, Scene};

/// Where the tables of a scene hold, and what happens beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<S> {
    /// Smallest and largest frequency ratio.
    pub r: (S, S),
    /// Smallest and largest friction ratio that may be asked for.
    pub beta: (S, S),
    /// Whether the exact formulas answer beyond; else nothing does.
    pub exact_beyond: bool,
    /// Whether all these friction ratios are below β_lim at all these frequencies: the closed form then answers without a
    /// look at it.
    pub always_continuous: bool,
    /// Whether they are all below β*_lim: it is then not asked.
    pub never_stuck: bool,
}

/// A scene with tables of its limits.
pub trait Tabled: Scene {
    /// Where they hold.
    fn domain(&self) -> Domain<Self::Scalar>;
    /// β_lim within the domain.
    fn tabled_limit(&self, r: Self::Scalar) -> Self::Scalar;
    /// β*_lim within the domain; none where only the exact formulas keep the accuracy.
    fn tabled_sliding_limit(&self, r: Self::Scalar) -> Option<Self::Scalar>;
}

/// A scene at one frequency ratio, whose limits come from tables.
#[derive(Clone, Copy, Debug)]
pub struct Compiled<T: Scene> {
    scene: T,
    /// Neither NaN nor negative.
    r: T::Scalar,
    /// Whether the tables hold at this r.
    within: bool,
}

impl<T: Tabled> Compiled<T> {
    /// The scene at the frequency ratio r = ω√(m₁/k₁).
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
        // The difference is 0 where both are the same alone, and a lookup needs it.
        let within = r - low >= T::Scalar::constant(0.0) && r <= high;
        if !within {
            let allowed = exact_beyond && r >= T::Scalar::constant(0.0);
            if !allowed {
                return Err(OutOfDomain { argument: "r" });
            }
        }
        Ok(Self { scene, r, within })
    }

    /// Both limits over a slice of frequency ratios, into slices of the same length.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a slice of another length, which leaves both as they are, and at the first r out of the
    /// domain; what came before it is filled in.
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

    /// Whether the tables hold at this r; beyond them the exact formulas answer.
    #[inline]
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.within
    }

    /// The same by the exact formulas.
    #[must_use]
    pub fn exact(&self) -> At<T> {
        At::known(self.scene.clone(), self.r)
    }

    /// β_lim, the boundary of continuous motion (5.65, 5.80, 5.96, 7.49), to the declared accuracy.
    #[inline]
    #[must_use]
    pub fn continuous_limit(&self) -> T::Scalar {
        if self.within {
            self.scene.tabled_limit(self.r)
        } else {
            self.exact().continuous_limit()
        }
    }

    /// β*_lim = |V|/(μ|H|), from which on a stuck state exists (6.11, 6.27, 6.33), to the declared accuracy.
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

    /// Both limits.
    #[inline]
    #[must_use]
    pub fn limits(&self) -> Limits<T::Scalar> {
        Limits {
            continuous: self.continuous_limit(),
            sliding: self.sliding_limit(),
        }
    }

    /// β_lim with S replaced by its limit for τ → 0 (5.64), by the exact formulas.
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> T::Scalar {
        self.exact().continuous_limit_without_search()
    }

    /// β_lim with S as the sum of each mode's own maximum (5.55, 7.37), by the exact formulas.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> T::Scalar {
        self.exact().continuous_limit_per_mode()
    }

    /// β, if it is one that may be asked for.
    pub(super) fn checked(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = regime::check_beta(beta)?;
        let domain = self.scene.domain();
        let (low, high) = domain.beta;
        if domain.exact_beyond || (low <= beta && beta <= high) {
            Ok(beta)
        } else {
            Err(OutOfDomain { argument: "beta" })
        }
    }

    /// Whether β may be asked for and the motion is continuous, without more than that takes.
    #[inline]
    pub(super) fn is_admitted(&self, beta: T::Scalar, limit: T::Scalar) -> bool {
        let domain = self.scene.domain();
        let (low, high) = domain.beta;
        // Below β_lim β is finite; a bound that is not there costs nothing.
        let asked = beta >= T::Scalar::constant(0.0)
            && (domain.exact_beyond || (low <= beta && (!high.is_finite() || beta <= high)));
        asked && (domain.always_continuous || beta < limit)
    }

    /// Whether a β that may be asked for is below β*_lim.
    #[inline]
    pub(super) fn slides(&self, beta: T::Scalar) -> bool {
        self.scene.domain().never_stuck || beta < self.sliding_limit()
    }

    /// Whether an admitted β is below β*_lim as well.  A contact that grips no better than it rubs cannot stick while it
    /// can slide all the time: the difference of both motions would lose energy for ever.  β_lim is then the smaller limit.
    #[inline]
    fn slides_if_admitted(&self, beta: T::Scalar) -> bool {
        let one = T::Scalar::constant(1.0);
        self.scene.numbers().chain.stiction <= one || self.slides(beta)
    }

    /// The regime at β = F/P: right except within the declared accuracy of a limit.
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

    /// β/min(β_lim, β*_lim) − 1: negative below both limits, where the closed form exists.
    ///
    /// # Errors
    /// As of [`regime`](Self::regime).
    pub fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
        let beta = self.checked(beta)?;
        self.limits().margin(beta)
    }
}
