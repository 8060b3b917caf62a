//! Bounds that the checks share, and the list of items that could be read from a description.

use super::error::SceneError;
use super::path::Path;
use crate::scene::{Node, Scene};

/// Largest number of masses that a scene built at run time may have.
pub const MOST_MASSES: usize = 1000;

/// Upper bound on masses, stiffnesses, damping and μ. Products of a few such numbers must fit in a double.
pub const LARGEST: f64 = 1e60;

/// Lower bound on masses and stiffnesses. Products of a few such numbers must fit in a double.
pub const SMALLEST: f64 = 1e-60;

/// Items of a scene that could be read from its description, and on which the checks may rely.
///
/// A description with errors still gives most of a scene. A check is skipped if it needs an item that could not be
/// read. Otherwise one mistake would cause two error messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checks {
    /// The largest number of masses that the scene may have.
    pub most_masses: usize,
    /// True if every mass could be read from the description.
    pub masses: bool,
    /// True if every spring could be read from the description.
    pub springs: bool,
    /// True if the contact could be read from the description.
    pub contact: bool,
    /// True if the excitation could be read from the description.
    pub excitation: bool,
    /// True if every entry of `contacts` and `dampers` could be read from the description.
    pub joints: bool,
    /// True if the list `provide` could be read completely from the description.
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
            joints: true,
            provide: true,
        }
    }
}

impl Checks {
    /// Returns true if the scene has several contacts or dashpots, or if its description tries to.
    pub(super) fn joined(&self, scene: &Scene) -> bool {
        scene.is_joined() || !self.joints
    }
}

/// Reports an error if a node names a mass that does not exist. Only a scene built at run time can have such a node.
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
