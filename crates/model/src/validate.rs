//! Checks that a scene makes physical sense. The checks report all errors together. Each error names the item of the
//! scene that causes it.
//!
//! A description read from text and a scene built at run time pass the same checks. The text parser converts each
//! [`Path`] to the place in the text.

mod checks;
mod elastic;
mod error;
mod joints;
mod masses;
mod names;
mod path;
mod reach;
mod scale;
mod settings;
mod springs;
mod stepping;
mod stops;

pub use checks::{Checks, LARGEST, MOST_MASSES, SMALLEST};
pub use error::SceneError;
pub use joints::{MOST_CONTACTS, MOST_JOINED};
pub use names::{is_keyword, is_name, may_name};
pub use path::Path;

use crate::scene::{Excitation, Node, Scene};
use checks::check_node;

/// Checks a complete scene.
///
/// # Errors
/// Returns every error of the scene, in the order of the fields.
pub fn validate(scene: &Scene) -> Result<(), Vec<SceneError>> {
    validate_known(scene, &Checks::default())
}

/// Checks a scene whose description has errors. Only the items that the parser could read are checked.
///
/// # Errors
/// Returns every error of the items that the parser could read, in the order of the fields.
pub fn validate_known(scene: &Scene, checks: &Checks) -> Result<(), Vec<SceneError>> {
    let mut errors = Vec::new();
    masses::check(scene, checks, &mut errors);
    springs::check(scene, checks, &mut errors);
    let joined = checks.joined(scene);
    if checks.contact && scene.joints.contacts.is_empty() {
        check_contact(scene, &mut errors);
    }
    if checks.excitation
        && let Excitation::Force(mass) = scene.excitation
    {
        check_node(scene, Node::Mass(mass), Path::Excitation, &mut errors);
    }
    joints::check_names(scene, checks, &mut errors);
    stops::check_names(scene, checks, &mut errors);
    if joined {
        joints::check(scene, checks, &mut errors);
    } else {
        reach::check(scene, checks, &mut errors);
    }
    settings::check(scene, checks, &mut errors);
    stepping::check(scene, checks, &mut errors);
    if joined {
        elastic::check_value(scene, &mut errors);
    } else {
        elastic::check(scene, checks, &mut errors);
    }
    scale::check(scene, checks, &mut errors);
    let complete = checks.masses && checks.springs && checks.contact && checks.excitation;
    if errors.is_empty() && complete && !joined {
        scale::check_modes(scene, &mut errors);
    }
    if errors.is_empty() {
        Ok(())
    } else {
        Err(errors)
    }
}

/// Returns true if springs hold every mass, and the load can make the single contact slide.
#[must_use]
pub(crate) fn can_be_single(scene: &Scene) -> bool {
    let mut errors = Vec::new();
    reach::check(scene, &Checks::default(), &mut errors);
    errors.is_empty() && !scene.springs.is_empty()
}

/// Checks that the contact joins two different nodes, and that at least one of the two nodes can move.
fn check_contact(scene: &Scene, errors: &mut Vec<SceneError>) {
    let contact = scene.contact;
    check_node(scene, contact.from, Path::ContactFrom, errors);
    check_node(scene, contact.to, Path::ContactTo, errors);
    let is_mass = |node| matches!(node, Node::Mass(_));
    if !is_mass(contact.from) && !is_mass(contact.to) {
        errors.push(SceneError::ContactWithoutMass {
            path: Path::ContactFrom,
        });
    } else if contact.from == contact.to {
        errors.push(SceneError::ContactWithItself {
            path: Path::ContactTo,
            name: scene.node_name(contact.from).to_owned(),
        });
    }
}

#[cfg(test)]
mod tests;
