//! Trait of scenes that provide steady states, and a comparison of two steady states.

use super::start::Start;
use super::types::Orbit;
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, Part};
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use crate::response::{At, Scene};
use core::ops::Deref;

/// Relative difference of the amplitudes and of the stuck fractions below which two steady states are treated as the
/// same.
const ALIKE: f64 = 1e-6;

/// Numbers by which the code recognises a steady state that it has already found.
#[derive(Clone, Copy, Debug)]
pub struct Print<S> {
    sticks: bool,
    counts: (u32, usize, usize),
    sizes: [S; 2],
}

/// Steady state that the iterator [`States`](super::States) returns.
pub trait KnownState {
    /// Scalar type of the numbers of the steady state.
    type Scalar: Float;

    /// Returns the numbers with which the code compares this steady state with another steady state.
    fn print(&self) -> Print<Self::Scalar>;
}

impl<S, P, V, C, K> KnownState for Orbit<'_, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    type Scalar = S;

    fn print(&self) -> Print<S> {
        Print {
            sticks: self.never_slides(),
            counts: (self.period(), self.stops(), self.reversals()),
            sizes: [self.contact().amplitude(), self.stuck_fraction()],
        }
    }
}

impl<S: Float> Print<S> {
    /// Returns true if two steady states agree within the tolerance [`ALIKE`]. The code always treats two stuck states
    /// as the same, because the stuck states form one continuum with different offsets.
    pub(super) fn is_alike(&self, other: &Self) -> bool {
        let near = |(a, b): (&S, &S)| (*a - *b).abs() <= a.abs().max(b.abs()) * S::constant(ALIKE);
        let mut sizes = self.sizes.iter().zip(&other.sizes);
        self.sticks == other.sticks
            && (self.sticks || (self.counts == other.counts && sizes.all(near)))
    }
}

/// Trait of scenes that provide a steady state through the method `orbit`.
pub trait ProvidesOrbit: Scene {
    /// Type of the steady state. In addition to the common methods, it has a method for each mass.
    type Orbit: Deref<Target: KnownState>;
    /// Type of the displacements or the velocities of all masses. It contains one number for each mass.
    type State: AsRef<[Self::Scalar]> + ?Sized;

    /// Returns the steady state that the motion from `start` reaches. If the motion does not settle and `last` is true,
    /// the function returns its last 64 cycles.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state.
    fn settled(
        at: &At<Self>,
        beta: Self::Scalar,
        start: Start<'_, Self::Scalar>,
        last: bool,
    ) -> Result<Self::Orbit, NoOrbit>;
}
