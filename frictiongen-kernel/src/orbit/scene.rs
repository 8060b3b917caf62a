//! Trait of a scene that provides steady states, and a comparison of two steady states.

use super::start::Start;
use super::types::Orbit;
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, Part};
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use crate::response::{At, Scene};
use core::ops::Deref;

/// Two steady states count as the same if their amplitudes and stuck fractions differ relatively by less than this
/// value.
const ALIKE: f64 = 1e-6;

/// Numbers of a steady state for a comparison with another steady state.
#[derive(Clone, Copy, Debug)]
pub struct Print<S> {
    sticks: bool,
    counts: (u32, usize, usize),
    sizes: [S; 2],
}

/// Steady state that [`States`](super::States) returns.
pub trait KnownState {
    /// Scalar type of the steady state.
    type Scalar: Float;

    /// Returns the numbers of the steady state for a comparison.
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
    /// Returns true if two steady states are the same.  Two stuck states always count as the same, because the stuck
    /// states form one continuum with different offsets.
    pub(super) fn is_alike(&self, other: &Self) -> bool {
        let near = |(a, b): (&S, &S)| (*a - *b).abs() <= a.abs().max(b.abs()) * S::constant(ALIKE);
        let mut sizes = self.sizes.iter().zip(&other.sizes);
        self.sticks == other.sticks
            && (self.sticks || (self.counts == other.counts && sizes.all(near)))
    }
}

/// Trait of a scene that provides `orbit`, its steady state.
pub trait ProvidesOrbit: Scene {
    /// Type of the steady state, with a method for each mass.
    type Orbit: Deref<Target: KnownState>;
    /// Type of the displacements or velocities of all masses, with one number for each mass.
    type State: AsRef<[Self::Scalar]> + ?Sized;

    /// Returns the steady state that a motion from `start` reaches. If the motion does not settle and `last` is true,
    /// returns its last 64 cycles.
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
