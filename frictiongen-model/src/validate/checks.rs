//! What every check knows: bounds, and which parts of a scene are known.

use super::error::SceneError;
use super::path::Path;
use crate::scene::{Node, Scene};

/// The most masses that a scene may have at run time.
pub const MOST_MASSES: usize = 1000;

/// Masses, stiffnesses, damping and μ stay below this: products of a few of them must fit a double.
pub const LARGEST: f64 = 1e60;

/// Masses and stiffnesses stay above this, for the same reason.
pub const SMALLEST: f64 = 1e-60;

/// What the checks may rely on.
///
/// A text with mistakes still yields most of a scene. A check that needs a part which could not
/// be read is left out, so that one mistake does not show up as two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checks {
    /// The most masses allowed.
    pub most_masses: usize,
    /// Every mass was read.
    pub masses: bool,
    /// Every spring was read.
    pub springs: bool,
    /// The contact was read.
    pub contact: bool,
    /// The excitation was read.
    pub excitation: bool,
    /// What to provide was read.
    pub provide: bool,
}

impl Default for Checks {
    fn default() -> Self {
        Self {
            most_masses: MOST_MASSES,
            masses: true,
            springs: true,
            contact: true,
            excitation: true,
            provide: true,
        }
    }
}

/// A builder can name a mass that does not exist; a text cannot.
pub(super) fn check_node(scene: &Scene, node: Node, path: Path, errors: &mut Vec<SceneError>) {
    if let Node::Mass(index) = node
        && index >= scene.masses.len()
    {
        errors.push(SceneError::NoSuchMass {
            path,
            index,
            count: scene.masses.len(),
        });
    }
}
