//! Trait for the continuous motion of the contact or of a mass.

use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Decay;
use frictiongen_kernel::response::motion::{Largest, Motion};
use frictiongen_kernel::table::{SteadyContact, TabledMotion};

/// Selects a motion or a force of a scene. A motion is that of the contact, of a mass, or of a combination of masses
/// and base. A force is that in a spring, or the base shear.
///
/// Emitted solvers provide the motions of the contact and of masses. A run-time `System` provides all variants. Forces
/// are divided by the load amplitude P, or by k₁Y for base motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Of {
    /// The relative motion of the two sides of the contact. With several contacts it has no meaning of its own, but the
    /// equivalent damping ratio of `Contact` counts the energies of all contacts.
    Contact,
    /// The relative motion in one of several contacts. The number is the index of the contact in the scene description.
    /// Stops follow the contacts.
    ContactAt(usize),
    /// The displacement of a mass. The number is its index in the scene description.
    Mass(usize),
    /// The displacement of one mass minus that of another. The numbers are the indices of the first and the second
    /// mass.
    Relative(usize, usize),
    /// The displacement of a mass minus the displacement of the base. The number is the index of the mass. A base that
    /// is not excited is at rest.
    FromBase(usize),
    /// The force in a spring. The number is the index of the spring in the scene description. The force is positive if
    /// the second end of the spring moves away from the first end.
    Spring(usize),
    /// The base shear. It is the sum of the forces in all springs between a mass and the base.
    Shear,
}

impl Of {
    /// Returns true if the variant selects a force, which is the force in a spring or the base shear.
    #[must_use]
    pub fn is_force(self) -> bool {
        matches!(self, Self::Spring(_) | Self::Shear)
    }
}

/// Continuous motion of the contact or of a mass. Displacements are non-dimensional: x̄ = x/(P/k₁), or x/Y for base
/// motion.
pub trait Steady {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Returns the largest |x̄| and its phase, both from one search, and the number of evaluations in this search.
    fn largest(&self) -> Largest<Self::Scalar>;
    /// Returns the exact maximum of |x̄| in a period of the motion.
    fn amplitude(&self) -> Self::Scalar;
    /// Returns the monoharmonic estimate of the amplitude, from the fundamental harmonic alone (5.50, 7.33).
    fn amplitude_monoharmonic(&self) -> Self::Scalar;
    /// Returns the lag of the maximum of x̄ behind the maximum of the excitation, in rad, in (−π, π].
    fn phase(&self) -> Self::Scalar;
    /// Returns the displacement x̄ at the phase τ in rad. At τ = 0 the contact's relative motion has a maximum.
    fn displacement(&self, tau: Self::Scalar) -> Self::Scalar;
    /// Returns the velocity dx̄/dτ at the phase τ in rad. At τ = 0 the contact's relative motion has a maximum.
    fn velocity(&self, tau: Self::Scalar) -> Self::Scalar;
    /// Returns X_n, the complex amplitude of harmonic n in x̄ = Re Σ X_n e^{inτ_e}. The phase τ_e is 0 at a maximum of
    /// the excitation.
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
