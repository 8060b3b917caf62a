//! The steady motion of the contact or of a mass.

use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Decay;
use frictiongen_kernel::response::motion::{Largest, Motion};
use frictiongen_kernel::table::{SteadyContact, TabledMotion};

/// Which motion is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Of {
    /// The relative motion in the contact.
    Contact,
    /// A mass, by its place in the description.
    Mass(usize),
}

/// The steady motion of the contact or of a mass.
pub trait Steady {
    /// The scene's scalar.
    type Scalar: Float;

    /// Amplitude and phase by one search, and what that took.
    fn largest(&self) -> Largest<Self::Scalar>;
    /// The exact maximum of |x̄|.
    fn amplitude(&self) -> Self::Scalar;
    /// The estimate 5.50, 7.33.
    fn amplitude_monoharmonic(&self) -> Self::Scalar;
    /// Lag of its maximum behind the excitation's, rad, in (−π, π].
    fn phase(&self) -> Self::Scalar;
    /// x̄ at τ, from a maximum of the contact's relative motion.
    fn displacement(&self, tau: Self::Scalar) -> Self::Scalar;
    /// dx̄/dτ at τ, from a maximum of the contact's relative motion.
    fn velocity(&self, tau: Self::Scalar) -> Self::Scalar;
    /// X_n with x̄ = Re Σ X_n e^{inτ_e}, τ_e from a maximum of the excitation.
    fn harmonic(&self, n: u32) -> Complex<Self::Scalar>;
}

macro_rules! steady {
    ($type:ident<$($of:ident),+>, $scalar:ty, [$($bounds:tt)+]) => {
        impl<$($bounds)+> Steady for $type<$($of),+> {
            type Scalar = $scalar;

            fn largest(&self) -> Largest<$scalar> {
                $type::largest(self)
            }
            fn amplitude(&self) -> $scalar {
                $type::amplitude(self)
            }
            fn amplitude_monoharmonic(&self) -> $scalar {
                $type::amplitude_monoharmonic(self)
            }
            fn phase(&self) -> $scalar {
                $type::phase(self)
            }
            fn displacement(&self, tau: $scalar) -> $scalar {
                $type::displacement(self, tau)
            }
            fn velocity(&self, tau: $scalar) -> $scalar {
                $type::velocity(self, tau)
            }
            fn harmonic(&self, n: u32) -> Complex<$scalar> {
                $type::harmonic(self, n)
            }
        }
    };
}

steady!(Motion<S, D, W>, S, [S: Float, D: Decay<S>, W: AsRef<[Wave<S, D>]>]);
steady!(SteadyContact<T>, T::Scalar, [T: TabledMotion]);
