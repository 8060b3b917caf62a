//! Data for all checks: bounds, and which items of a scene are known.

use super::error::SceneError;
use super::path::Path;
use crate::scene::{Node, Scene};

/// Largest number of masses of a scene at run time.
pub const MOST_MASSES: usize = 1000;

/// Upper bound on masses, stiffnesses, damping and μ. Products of a few of them must fit in a
/// double.
pub const LARGEST: f64 = 1e60;

/// Lower bound on masses and stiffnesses, for the same reason.
pub const SMALLEST: f64 = 1e-60;

/// Items on which the checks may rely.
///
/// A text with errors still gives most of a scene. A check that needs an unread item is skipped, so
/// that one error is not reported as two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checks {
    /// The largest number of masses.
    pub most_masses: usize,
    /// True if every mass was read.
    pub masses: bool,
    /// True if every spring was read.
    pub springs: bool,
    /// True if the contact was read.
    pub contact: bool,
    /// True if the excitation was read.
    pub excitation: bool,
    /// True if the list of items to provide was read.
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

/// Checks that a mass exists. Only a scene built at run time can name one that does not.
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
