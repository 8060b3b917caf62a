//! A scene that provides steady states.

use crate::errors::NoOrbit;
use crate::response::{At, Scene};

/// Displacements, then velocities, of every mass.
pub type Start<'s, S> = (&'s [S], &'s [S]);

/// A scene that provides `orbit`.
pub trait ProvidesOrbit: Scene {
    /// The steady state, with a method for each mass.
    type Orbit;
    /// A number for each mass.
    type State: AsRef<[Self::Scalar]> + ?Sized;

    /// The steady state from `start` or from rest; with `last` the last 64 cycles where it does not settle.
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    fn settled(
        at: &At<Self>,
        beta: Self::Scalar,
        start: Option<Start<'_, Self::Scalar>>,
        last: bool,
    ) -> Result<Self::Orbit, NoOrbit>;
}
