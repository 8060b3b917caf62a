//! Checks of stops and of constant forces.

use super::checks::{Checks, LARGEST, SMALLEST, check_node};
use super::error::SceneError;
use super::joints::{is_mass, told};
use super::names::{is_keyword, is_name, is_reserved};
use super::path::Path;
use crate::scene::{CONTACT, Impact, NamedStop, Node, Scene};

/// Reports errors in the names of the stops.
pub(super) fn check_names(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let stops = &scene.joints.stops;
    let contacts = scene.named_contacts();
    for (index, stop) in stops.iter().enumerate() {
        let (name, path) = (stop.name.clone(), Path::StopName(index));
        if checks.emitted && is_keyword(&name) {
            errors.push(SceneError::StopKeyword { path, name });
        } else if name == CONTACT || is_reserved(&name, checks.emitted) {
            errors.push(SceneError::StopReserved { path, name });
        } else if !is_name(&name) {
            errors.push(SceneError::StopNotAName { path, name });
        } else if scene.masses.iter().any(|mass| mass.name == name) {
            errors.push(SceneError::StopNamedAsMass { path, name });
        } else if contacts.iter().any(|contact| contact.name == name) {
            errors.push(SceneError::StopNamedAsContact { path, name });
        } else if stops.iter().take(index).any(|other| other.name == name) {
            errors.push(SceneError::DuplicateStop { path, name });
        }
    }
}

/// Reports errors in the sides and laws of the stops. Returns true if the sides of all stops are valid.
pub(super) fn check(scene: &Scene, errors: &mut Vec<SceneError>) -> bool {
    let mut sound = true;
    for (index, stop) in scene.joints.stops.iter().enumerate() {
        sound &= check_sides(scene, stop, index, errors);
        check_law(stop, index, errors);
    }
    sound
}

/// Reports errors in the sides of a stop. Returns true if the sides have no errors.
fn check_sides(
    scene: &Scene,
    stop: &NamedStop,
    index: usize,
    errors: &mut Vec<SceneError>,
) -> bool {
    let before = errors.len();
    let (from, to) = (stop.sides.from, stop.sides.to);
    check_node(scene, from, Path::StopFrom(index), errors);
    check_node(scene, to, Path::StopTo(index), errors);
    let name = |node| scene.node_name(node).to_owned();
    let is_rigid = |stop: &NamedStop| matches!(stop.law.impact, Impact::Restitution(_));
    let mut earlier = scene.joints.stops.iter().take(index);
    let path = Path::StopFrom(index);
    if !is_mass(from) && !is_mass(to) {
        errors.push(SceneError::StopWithoutMass { path });
    } else if from == to {
        let (path, name) = (Path::StopTo(index), name(from));
        errors.push(SceneError::StopToItself { path, name });
    } else if is_rigid(stop) && earlier.any(|other| is_rigid(other) && other.sides == stop.sides) {
        let (from, to) = (name(from), name(to));
        errors.push(SceneError::ParallelRigidStops { path, from, to });
    }
    errors.len() == before
}

fn check_law(stop: &NamedStop, index: usize, errors: &mut Vec<SceneError>) {
    let name = &stop.name;
    let what = format!("the gap of the stop `{name}`");
    check_signed(stop.law.gap, Path::StopGap(index), what, errors);
    match stop.law.impact {
        Impact::Spring { stiffness, damping } => {
            let (value, path) = (stiffness, Path::StopStiffness(index));
            let what = format!("the stiffness of the stop `{name}`");
            if !value.is_finite() {
                errors.push(SceneError::NotFinite { path, what, value });
            } else if value <= 0.0 {
                let name = name.clone();
                errors.push(SceneError::StopStiffnessNotPositive { path, name, value });
            } else if !(SMALLEST..=LARGEST).contains(&value) {
                errors.push(SceneError::OutOfScale { path, what, value });
            }
            let (value, path) = (damping, Path::StopDamping(index));
            let what = format!("the damping of the stop `{name}`");
            if value.is_finite() && value < 0.0 {
                errors.push(SceneError::DampingNegative { path, what, value });
            } else {
                check_signed(value, path, what, errors);
            }
        }
        Impact::Restitution(value) => {
            let path = Path::StopRestitution(index);
            if !value.is_finite() {
                let what = format!("the restitution of the stop `{name}`");
                errors.push(SceneError::NotFinite { path, what, value });
            } else if !(0.0..=1.0).contains(&value) {
                let name = name.clone();
                errors.push(SceneError::RestitutionOutside { path, name, value });
            }
        }
    }
}

/// Reports a number of either sign that is not finite, or that is too large or too small. The number may be 0.
pub(super) fn check_signed(value: f64, path: Path, what: String, errors: &mut Vec<SceneError>) {
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value != 0.0 && !(SMALLEST..=LARGEST).contains(&value.abs()) {
        errors.push(SceneError::OutOfScale { path, what, value });
    }
}

/// Reports errors in the constant forces.
pub(super) fn check_constant(scene: &Scene, errors: &mut Vec<SceneError>) {
    let constant = &scene.joints.constant;
    for (index, load) in constant.iter().enumerate() {
        let node = Node::Mass(load.mass);
        let path = Path::ConstantMass(index);
        check_node(scene, node, path, errors);
        let name = scene.node_name(node).to_owned();
        let what = format!("the constant force on the mass `{name}`");
        let earlier = constant.iter().take(index);
        let earlier = earlier.filter(|other| other.mass == load.mass);
        let forces: Vec<f64> = earlier.map(|other| other.force).collect();
        if !forces.is_empty() {
            let sum = told(forces.iter().sum::<f64>() + load.force, " of");
            errors.push(SceneError::ConstantTwice { path, name, sum });
        }
        check_signed(load.force, Path::Constant(index), what, errors);
    }
}
