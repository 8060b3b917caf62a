//! Whether a scene makes physical sense: every error at once, each with the place it belongs to.
//!
//! A description read from text and a scene built at run time pass through the same checks. The
//! text's parser maps each [`Path`] back to the words that were typed.

mod error;
mod masses;
mod names;
mod reach;
mod scale;
mod settings;
mod springs;
mod stepping;

pub use error::SceneError;
pub use names::{RESERVED, is_keyword, is_name, is_reserved, may_name};

use crate::scene::{Excitation, Node, Scene};

/// The most masses that a scene may have at run time.
pub const MOST_MASSES: usize = 1000;

/// Masses, stiffnesses, damping and μ stay below this: products of a few of them must fit a double.
pub const LARGEST: f64 = 1e60;

/// Masses and stiffnesses stay above this, for the same reason.
pub const SMALLEST: f64 = 1e-60;

/// The part of a scene that an error is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// The scene as a whole.
    Scene,
    /// The list of masses.
    Masses,
    /// The value of a mass.
    Mass(usize),
    /// The name of a mass.
    MassName(usize),
    /// The list of springs.
    Springs,
    /// The stiffness of a spring.
    Spring(usize),
    /// The first end of a spring.
    SpringFrom(usize),
    /// The second end of a spring.
    SpringTo(usize),
    /// The contact as a whole.
    Contact,
    /// The first side of the contact.
    ContactFrom,
    /// The second side of the contact.
    ContactTo,
    /// The excitation.
    Excitation,
    /// The damping as a whole, or one of its numbers.
    Damping(Option<usize>),
    /// The ratio μ of static to kinetic friction.
    Stiction,
    /// The list of what to emit, or one of its items.
    Provide(Option<usize>),
    /// The accuracy.
    Accuracy,
    /// The range over which it is declared.
    Range,
    /// The range of the frequency ratio.
    RangeOfRatio,
    /// The range of the friction ratio.
    RangeOfFriction,
    /// The side of the exact limits.
    Side,
    /// The bytes in place of an accuracy.
    Budget,
    /// What happens outside the range.
    Beyond,
    /// The friction law as a whole, or one of its numbers: speed and level of each point in turn.
    Friction(Option<usize>),
    /// The stepper's step.
    Step,
    /// The stepper's input between samples.
    Input,
    /// The list of masses that the stepper may load, or one of them.
    Force(Option<usize>),
}

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

/// Checks a complete scene.
///
/// # Errors
/// Every error of the scene, in the order of the fields.
pub fn validate(scene: &Scene) -> Result<(), Vec<SceneError>> {
    validate_known(scene, &Checks::default())
}

/// Checks those parts of a scene that are known.
///
/// # Errors
/// Every error of those parts, in the order of the fields.
pub fn validate_known(scene: &Scene, checks: &Checks) -> Result<(), Vec<SceneError>> {
    let mut errors = Vec::new();
    masses::check(scene, checks, &mut errors);
    springs::check(scene, checks, &mut errors);
    if checks.contact {
        check_contact(scene, &mut errors);
    }
    if checks.excitation
        && let Excitation::Force(mass) = scene.excitation
    {
        check_node(scene, Node::Mass(mass), Path::Excitation, &mut errors);
    }
    reach::check(scene, checks, &mut errors);
    settings::check(scene, checks, &mut errors);
    stepping::check(scene, checks, &mut errors);
    scale::check(scene, checks, &mut errors);
    let complete = checks.masses && checks.springs && checks.contact && checks.excitation;
    if errors.is_empty() && complete {
        scale::check_modes(scene, &mut errors);
    }
    if errors.is_empty() {
        Ok(())
    } else {
        Err(errors)
    }
}

/// The contact joins two different nodes, and at least one of them can move on its own.
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

/// A builder can name a mass that does not exist; a text cannot.
fn check_node(scene: &Scene, node: Node, path: Path, errors: &mut Vec<SceneError>) {
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

#[cfg(test)]
mod tests;
