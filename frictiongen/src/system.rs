//! Traits that emitted solvers and the run-time `System` implement. A sweep, map or fit that uses these traits works
//! with emitted solvers and with a `System`.

pub use crate::steady::{Of, Steady};
use crate::targets::{HeldStill, InParts, Limited, Moved};
use crate::{Complex, NotContinuous, OutOfDomain, Regime, StuckResonance};
use core::ops::Deref;
use frictiongen_kernel::Float;
use frictiongen_kernel::contact::regime::{Limits, limits_into};

/// A scene (chain, contact, excitation and damping) that can be evaluated at any frequency ratio.
///
/// ```
/// use frictiongen::{FrictionSystem, LimitsAt, friction_system};
///
/// friction_system! {
///     struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: block,
///     }
/// }
///
/// /// Returns the smallest β_lim over a sweep of frequency ratios, for any system.
/// fn narrowest<F: FrictionSystem<Scalar = f64>>(system: &F, ratios: &[f64]) -> f64 {
///     ratios
///         .iter()
///         .filter_map(|r| system.at(*r).ok())
///         .map(|at| at.continuous_limit())
///         .fold(f64::INFINITY, f64::min)
/// }
///
/// assert!(narrowest(&Block, &[0.8, 1.0, 2.0]) > 0.5);
/// ```
pub trait FrictionSystem {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;
    /// Type of the scene at one frequency ratio.
    type At<'a>: LimitsAt<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Returns the frequency ratios of the undamped resonances, in ascending order.
    fn resonances(&self) -> &[Self::Scalar];
    /// Returns the number of masses in the scene.
    fn masses(&self) -> usize;
    /// Returns the name of a mass, by its index in the scene description.
    fn mass_name(&self, index: usize) -> Option<&str>;
    /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁).
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the scene returns limiting values.
    fn at(&self, r: Self::Scalar) -> Result<Self::At<'_>, OutOfDomain>;
    /// Returns β_lim and β*_lim at the frequency ratio r without a search over time. β_lim is an upper bound. This is
    /// the fastest call if no other result is needed at this r.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the results are the limiting values.
    fn limits_without_search(&self, r: Self::Scalar) -> Result<Limits<Self::Scalar>, OutOfDomain> {
        let at = self.at(r)?;
        Ok(Limits {
            continuous: at.continuous_limit_without_search(),
            sliding: at.sliding_limit(),
        })
    }
    /// Computes [`limits_without_search`](Self::limits_without_search) at each frequency ratio of a slice, and writes
    /// β_lim and β*_lim to two slices of the same length.
    ///
    /// The results are equal to those of single calls, to the last bit. If all modes are undamped, or all are lightly
    /// damped, the call takes less time than single calls, because it computes several frequencies at once.
    ///
    /// ```
    /// use frictiongen::{FrictionSystem, friction_system};
    ///
    /// friction_system! {
    ///     struct Block {
    ///         masses: { block: 1 },
    ///         springs: { base - block: 1 },
    ///         contact: block - wall,
    ///         excitation: block,
    ///     }
    /// }
    ///
    /// let ratios = [0.5, 0.8, 1.25, 2.0, 3.0];
    /// let (mut continuous, mut sliding) = ([0.0; 5], [0.0; 5]);
    /// Block.limits_without_search_into(&ratios, &mut continuous, &mut sliding)?;
    /// assert_eq!(continuous[2], Block.limits_without_search(1.25)?.continuous);
    /// # Ok::<(), frictiongen::OutOfDomain>(())
    /// ```
    ///
    /// # Errors
    /// [`OutOfDomain`] for a slice of another length. Both slices are then unchanged. [`OutOfDomain`] also at the first
    /// NaN or negative r. The call has then written the results for all earlier r.
    fn limits_without_search_into(
        &self,
        rs: &[Self::Scalar],
        continuous: &mut [Self::Scalar],
        sliding: &mut [Self::Scalar],
    ) -> Result<(), OutOfDomain> {
        limits_into(rs, continuous, sliding, |r| self.limits_without_search(r))
    }
}

/// Implements [`FrictionSystem`] for an emitted scene. The macro passes only the names of the masses, because the
/// kernel's types contain all other data.
#[doc(hidden)]
#[macro_export]
macro_rules! emitted_system {
    ($name:ident, $at:ident, $scalar:ty, [$($mass:literal),*]) => {
        impl $crate::FrictionSystem for $name {
            type Scalar = $scalar;
            type At<'a> = $at;

            fn resonances(&self) -> &[$scalar] {
                &Self::RESONANCES
            }
            fn masses(&self) -> ::core::primitive::usize {
                Self::RESONANCES.len()
            }
            fn mass_name(
                &self,
                index: ::core::primitive::usize,
            ) -> ::core::option::Option<&::core::primitive::str> {
                [$($mass),*].get(index).copied()
            }
            fn at(&self, r: $scalar) -> ::core::result::Result<$at, $crate::OutOfDomain> {
                Self::at(r)
            }
            #[inline]
            fn limits_without_search(
                &self,
                r: $scalar,
            ) -> ::core::result::Result<$crate::kernel::contact::regime::Limits<$scalar>, $crate::OutOfDomain> {
                Self::limits_without_search(r)
            }
            #[inline]
            fn limits_without_search_into(
                &self,
                rs: &[$scalar],
                continuous: &mut [$scalar],
                sliding: &mut [$scalar],
            ) -> ::core::result::Result<(), $crate::OutOfDomain> {
                $crate::kernel::response::At::limits_without_search_into(self, rs, continuous, sliding)
            }
        }
    };
}

/// The limits β_lim and β*_lim, and the regimes, at one frequency ratio.
pub trait LimitsAt {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Returns the exact limit of continuous motion β_lim (5.65, 5.80, 5.96, 7.49).
    fn continuous_limit(&self) -> Self::Scalar;
    /// Returns an upper bound on β_lim (5.64). In place of the maximum S of the velocity constraint, the bound uses the
    /// limit of the constraint for τ → 0.
    fn continuous_limit_without_search(&self) -> Self::Scalar;
    /// Returns the lower bound on β_lim that the thesis prints (5.55, 7.37). In the exact limit, the velocity
    /// constraint S is the maximum over time of a sum over the modes. The bound uses the sum of the maxima of the
    /// single modes instead.
    fn continuous_limit_per_mode(&self) -> Self::Scalar;
    /// Returns the limit of sliding β*_lim. A stuck state exists for β ≥ β*_lim (6.11, 6.27, 6.33).
    fn sliding_limit(&self) -> Self::Scalar;
    /// Returns β_lim and β*_lim from one search. The methods of the returned [`Limits`] need no further search.
    fn limits(&self) -> Limits<Self::Scalar> {
        Limits {
            continuous: self.continuous_limit(),
            sliding: self.sliding_limit(),
        }
    }
    /// Returns the regime (continuous, stick-slip, stuck or bistable) at the friction ratio β = F/P.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    fn regime(&self, beta: Self::Scalar) -> Result<Regime, OutOfDomain>;
    /// Returns the margin β/min(β_lim, β*_lim) − 1. If the margin is negative, β is less than β_lim and β*_lim. A
    /// continuous motion then exists, and no stuck state.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    fn margin(&self, beta: Self::Scalar) -> Result<Self::Scalar, OutOfDomain>;
}

/// Implements [`LimitsAt`] for emitted scenes and for a `System`, at one frequency ratio. The types of these scenes
/// deref to the kernel's scene.
impl<A: Deref<Target: Limited>> LimitsAt for A {
    type Scalar = <A::Target as Limited>::Scalar;

    fn continuous_limit(&self) -> Self::Scalar {
        Limited::continuous_limit(&**self)
    }
    fn continuous_limit_without_search(&self) -> Self::Scalar {
        Limited::continuous_limit_without_search(&**self)
    }
    fn continuous_limit_per_mode(&self) -> Self::Scalar {
        Limited::continuous_limit_per_mode(&**self)
    }
    fn sliding_limit(&self) -> Self::Scalar {
        Limited::sliding_limit(&**self)
    }
    fn limits(&self) -> Limits<Self::Scalar> {
        Limited::limits(&**self)
    }
    fn regime(&self, beta: Self::Scalar) -> Result<Regime, OutOfDomain> {
        Limited::regime(&**self, beta)
    }
    fn margin(&self, beta: Self::Scalar) -> Result<Self::Scalar, OutOfDomain> {
        Limited::margin(&**self, beta)
    }
}

/// A scene at one frequency ratio that provides the exact continuous motion in addition to the limits.
#[diagnostic::on_unimplemented(
    message = "`{Self}` gives no motion",
    label = "add `motion` to the scene's `provide: [...]`"
)]
pub trait MotionAt: LimitsAt {
    /// Type of the continuous motion at one friction ratio.
    type Motion: ContinuousMotion<Scalar = Self::Scalar>;

    /// Returns the exact continuous motion at the friction ratio β = F/P.
    ///
    /// # Errors
    /// [`NotContinuous`], which contains the regime at β.
    fn motion(&self, beta: Self::Scalar) -> Result<Self::Motion, NotContinuous>;
}

impl<A: Deref<Target: Moved>> MotionAt for A
where
    <A::Target as Moved>::Motion: ContinuousMotion<Scalar = Self::Scalar>,
{
    type Motion = <A::Target as Moved>::Motion;

    fn motion(&self, beta: Self::Scalar) -> Result<Self::Motion, NotContinuous> {
        Moved::motion(&**self, beta)
    }
}

/// A scene at one frequency ratio that provides the response while the contact is stuck, in addition to the limits.
#[diagnostic::on_unimplemented(
    message = "`{Self}` gives no response of a stuck contact",
    label = "add `stuck` to the scene's `provide: [...]`"
)]
pub trait StuckAt: LimitsAt {
    /// Returns x̄* = V_k − H_kV/H, the complex amplitude of mass k while the contact is stuck. V_k and V are the
    /// motions of mass k and of the contact without friction. H_k and H are their responses to a unit force in the
    /// contact. `index` is the index of the mass in the scene description. Returns `None` if no mass has this index.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck.
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<Self::Scalar>>, StuckResonance>;
}

impl<A: Deref<Target: HeldStill>> StuckAt for A {
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<Self::Scalar>>, StuckResonance> {
        HeldStill::stuck_mass(&**self, index)
    }
}

/// The exact continuous motion at one frequency ratio and one friction ratio.
pub trait ContinuousMotion {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Calls `question` with the motion of the contact or of a mass, and returns the result of `question`. Returns
    /// `None` if the scene does not provide that motion.
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Steady<Scalar = Self::Scalar>) -> T,
    ) -> Option<T>;
}

/// Implements [`ContinuousMotion`] for the motions of emitted scenes and of a `System`. The types of these motions
/// deref to the kernel's motion.
impl<M: Deref<Target: InParts>> ContinuousMotion for M {
    type Scalar = <M::Target as InParts>::Scalar;

    fn ask<A>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Steady<Scalar = Self::Scalar>) -> A,
    ) -> Option<A> {
        InParts::ask(&**self, of, question)
    }
}
