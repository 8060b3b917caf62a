//! Bounds that several checks use, and the list of items that the parser could read from a description.

use super::error::SceneError;
use super::path::Path;
use crate::scene::{Node, Scene};

/// Largest number of masses that a scene built at run time may have.
pub const MOST_MASSES: usize = 1000;

/// Upper bound on masses, stiffnesses, damping and μ. Products of a few numbers of this size must not overflow a
/// double.
pub const LARGEST: f64 = 1e60;

/// Lower bound on masses and stiffnesses. Products of a few numbers of this size must not underflow a double.
pub const SMALLEST: f64 = 1e-60;

/// List of the items of a scene that the parser could read, so that checks may use them.
///
/// A description with errors still gives most of a scene. The code skips a check that needs an unreadable item, because
/// one mistake would otherwise cause two error messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checks {
    /// The largest number of masses that the scene may have.
    pub most_masses: usize,
    /// True if the parser could read every mass.
    pub masses: bool,
    /// True if the parser could read every spring.
    pub springs: bool,
    /// True if the parser could read the contact.
    pub contact: bool,
    /// True if the parser could read the excitation.
    pub excitation: bool,
    /// True if the parser could read every entry of `contacts`, `dampers`, `stops` and `constant`.
    pub joints: bool,
    /// True if the parser could read the whole list `provide`.
    pub provide: bool,
    /// True if the scene is for emitted code. The names of the scene must then be names of methods in Rust, and the
    /// list `provide` must fit the scene. Neither restricts a scene at run time.
    pub emitted: bool,
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
            emitted: false,
        }
    }
}

impl Checks {
    /// Returns true if the description contains `contacts`, `dampers`, `stops` or `constant`, even with errors.
    pub(super) fn joined(&self, scene: &Scene) -> bool {
        scene.is_joined() || !self.joints
    }
}

/// Reports an error if a node names a mass that does not exist. Only a scene built at run time can have a node with
/// this error.
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
