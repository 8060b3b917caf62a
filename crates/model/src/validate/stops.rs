//! Checks of stops and constant forces.

use super::checks::{LARGEST, SMALLEST, check_node};
use super::error::SceneError;
use super::path::Path;
use crate::scene::{Impact, NamedStop, Node, Scene};

/// Reports errors in the stops. Returns true if the sides of all stops are valid.
pub(super) fn check(scene: &Scene, errors: &mut Vec<SceneError>) -> bool {
    let mut sound = true;
    for (index, stop) in scene.joints.stops.iter().enumerate() {
        let before = errors.len();
        check_sides(scene, stop, index, errors);
        sound &= errors.len() == before;
        check_law(stop, index, errors);
        let is_impact = |own: &NamedStop| matches!(own.law.impact, Impact::Restitution(_));
        let mut earlier = scene.joints.stops.iter().take(index);
        let other = earlier.find(|other| other.sides == stop.sides && is_impact(other));
        if let Some(other) = other.filter(|_| is_impact(stop)) {
            let (path, name) = (Path::StopFrom(index), other.name.clone());
            errors.push(SceneError::ImpactsTwice { path, name });
        }
    }
    sound
}

fn check_sides(scene: &Scene, stop: &NamedStop, index: usize, errors: &mut Vec<SceneError>) {
    let (from, to) = (stop.sides.from, stop.sides.to);
    check_node(scene, from, Path::StopFrom(index), errors);
    check_node(scene, to, Path::StopTo(index), errors);
    let is_mass = |node| matches!(node, Node::Mass(_));
    if !is_mass(from) && !is_mass(to) {
        let path = Path::StopFrom(index);
        errors.push(SceneError::StopWithoutMass { path });
    } else if from == to {
        let (path, name) = (Path::StopTo(index), scene.node_name(from).to_owned());
        errors.push(SceneError::StopWithItself { path, name });
    }
}

fn check_law(stop: &NamedStop, index: usize, errors: &mut Vec<SceneError>) {
    let name = || stop.name.clone();
    number(
        stop.law.gap,
        (Path::StopGap(index), "gap", &stop.name),
        errors,
    );
    match stop.law.impact {
        Impact::Spring { stiffness, damping } => {
            let path = Path::StopStiffness(index);
            if number(stiffness, (path, "stiffness", &stop.name), errors) && stiffness <= 0.0 {
                let (name, value) = (name(), stiffness);
                errors.push(SceneError::StopStiffnessNotPositive { path, name, value });
            }
            let path = Path::StopDamping(index);
            if number(damping, (path, "damping", &stop.name), errors) && damping < 0.0 {
                let (name, value) = (name(), damping);
                errors.push(SceneError::StopDampingNegative { path, name, value });
            }
        }
        Impact::Restitution(value) => {
            let path = Path::StopRestitution(index);
            if number(value, (path, "restitution", &stop.name), errors)
                && !(0.0..=1.0).contains(&value)
            {
                let name = name();
                errors.push(SceneError::RestitutionOutside { path, name, value });
            }
        }
    }
}

/// Reports a number that is not finite, or whose size no other number of a scene can have. Returns true if the number has
/// no such error.
fn number(
    value: f64,
    (path, what, name): (Path, &str, &str),
    errors: &mut Vec<SceneError>,
) -> bool {
    let what = format!("the {what} of the stop `{name}`");
    sized(value, path, what, errors)
}

fn sized(value: f64, path: Path, what: String, errors: &mut Vec<SceneError>) -> bool {
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
        return false;
    }
    let has_size = value == 0.0 || (SMALLEST..=LARGEST).contains(&value.abs());
    if !has_size {
        errors.push(SceneError::OutOfScale { path, what, value });
    }
    has_size
}

/// Reports errors in the constant forces.
pub(super) fn check_constant(scene: &Scene, errors: &mut Vec<SceneError>) {
    for (index, own) in scene.joints.constant.iter().enumerate() {
        check_node(
            scene,
            Node::Mass(own.mass),
            Path::ConstantMass(index),
            errors,
        );
        let name = scene.node_name(Node::Mass(own.mass)).to_owned();
        let what = format!("the constant force on `{name}`");
        sized(own.force, Path::Constant(index), what, errors);
        let mut earlier = scene.joints.constant.iter().take(index);
        if earlier.any(|other| other.mass == own.mass) {
            let path = Path::ConstantMass(index);
            errors.push(SceneError::ConstantTwice { path, name });
        }
    }
}
