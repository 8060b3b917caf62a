//! Checks of the friction law and of the stepper settings.

use std::collections::HashSet;

use super::checks::{Checks, LARGEST, SMALLEST, check_node};
use super::error::SceneError;
use super::path::Path;
use super::settings::item_name;
use crate::scene::{Accuracy, Excitation, FrictionLaw, Node, Precision, Provide, Scene, StepInput};

/// Reports errors in the friction law, the step, the input and the loads of the stepper.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    // If `provide` could not be read completely, the description may have asked for the stepper. At run time every
    // scene has a stepper.
    let known = checks.provide && checks.emitted;
    let stepper = scene.provides(&Provide::Stepper) || !known;
    let moves = stepper || scene.provides(&Provide::Simulation);
    if let FrictionLaw::Stribeck(points) = &scene.friction {
        check_points(scene, points, errors);
        // The default of `provide` is `[orbit]`. A message about this item would have no place in the description.
        let none = if scene.is_joined() {
            scene.provide == [Provide::Orbit] && known
        } else {
            !moves
        };
        if none {
            let path = Path::Friction(None);
            errors.push(SceneError::StribeckWithoutMotion { path });
        } else if known && scene.is_joined() {
            check_amplitude(scene, errors);
        } else if known {
            check_constant_level(scene, errors);
        }
    }
    let stepping = &scene.stepping;
    let belongs = [
        (stepping.step.is_some(), Path::Step, "step"),
        (stepping.input != StepInput::Linear, Path::Input, "input"),
        (!stepping.forces.is_empty(), Path::Force(None), "force"),
    ];
    for (given, path, field) in belongs {
        if given && !stepper {
            let field = field.to_owned();
            errors.push(SceneError::WithoutStepper { path, field });
        }
    }
    if known {
        check_tables(scene, errors);
    }
    if let Some(step) = stepping.step {
        check_step(step, scene.precision, errors);
    }
    check_forces(scene, checks, errors);
}

/// Returns a number after rounding to the scene's floating-point type.
fn stored(value: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value,
        #[allow(
            clippy::cast_possible_truncation,
            reason = "what a rounding makes of it"
        )]
        Precision::F32 => f64::from(value as f32),
    }
}

fn check_points(scene: &Scene, points: &[[f64; 2]], errors: &mut Vec<SceneError>) {
    if points.is_empty() {
        let path = Path::Friction(None);
        errors.push(SceneError::StribeckWithoutPoints { path });
    }
    let stiction = least_stiction(scene);
    let mut before = 0.0;
    for (index, [speed, level]) in points.iter().copied().enumerate() {
        let path = Path::Friction(Some(2 * index));
        if check_finite(speed, path, "a speed of `stribeck`", errors) {
            if stored(speed, scene.precision) <= stored(before, scene.precision) {
                errors.push(SceneError::StribeckNotAscending {
                    path,
                    value: speed,
                    before,
                });
            }
            before = speed;
        }
        let path = Path::Friction(Some(2 * index + 1));
        if !check_finite(level, path, "a level of `stribeck`", errors) {
            continue;
        }
        if level < 0.0 {
            errors.push(SceneError::StribeckNegative { path, value: level });
        } else if stiction < level && stiction >= 1.0 {
            // Another check reports a μ that is not at least 1.
            errors.push(SceneError::StribeckAboveStatic {
                path,
                value: level,
                stiction,
            });
        }
    }
}

/// Returns the smallest μ of the contacts on which the friction law acts. The law acts on rigid contacts.
fn least_stiction(scene: &Scene) -> f64 {
    let contacts = scene.joints.contacts.iter();
    let rigid = contacts.filter(|contact| contact.law.stiffness.is_none());
    let stictions = rigid.map(|contact| contact.law.stiction);
    stictions.reduce(f64::min).unwrap_or(scene.stiction)
}

/// Returns true if a number is finite and not too large. Otherwise the function reports an error, and `what` names the
/// number.
fn check_finite(value: f64, path: Path, what: &str, errors: &mut Vec<SceneError>) -> bool {
    let what = what.to_owned();
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if LARGEST < value {
        errors.push(SceneError::OutOfScale { path, what, value });
    } else {
        return true;
    }
    false
}

/// Reports `orbit` in a scene with several contacts and a friction law. Emitted steady states take only the ratios r
/// and β, but the speeds of the friction law need the amplitude of the load.
fn check_amplitude(scene: &Scene, errors: &mut Vec<SceneError>) {
    let orbit = scene
        .provide
        .iter()
        .position(|item| *item == Provide::Orbit);
    if let Some(index) = orbit {
        let path = Path::Provide(Some(index));
        errors.push(SceneError::OrbitNeedsAmplitude { path });
    }
}

/// Reports every provided item that requires constant kinetic friction. Only the stepper and the simulation allow
/// kinetic friction that depends on the speed.
fn check_constant_level(scene: &Scene, errors: &mut Vec<SceneError>) {
    for (index, item) in scene.provide.iter().enumerate() {
        let allowed = [Provide::Stepper, Provide::Simulation, Provide::SelfCheck];
        if !allowed.contains(item) {
            errors.push(SceneError::NeedsConstantLevel {
                path: Path::Provide(Some(index)),
                item: item_name(item).to_owned(),
            });
        }
    }
}

/// Reports a declared accuracy, or a declared size of tables, if the scene provides only motion in time. No table
/// exists for motion in time.
fn check_tables(scene: &Scene, errors: &mut Vec<SceneError>) {
    if scene.needs_frequency() || scene.provide.is_empty() {
        return;
    }
    let declared = &scene.declared;
    let exact = declared.accuracy == Accuracy::Exact;
    let budget = declared.budget.is_some();
    for (given, path, field) in [
        (!exact, Path::Accuracy, "accuracy"),
        (budget, Path::Budget, "budget"),
    ] {
        if given {
            let field = field.to_owned();
            errors.push(SceneError::NothingToTabulate { path, field });
        }
    }
}

fn check_step(value: f64, precision: Precision, errors: &mut Vec<SceneError>) {
    let path = Path::Step;
    let what = "the step".to_owned();
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value <= 0.0 {
        errors.push(SceneError::StepNotPositive { path, value });
    } else {
        let stored = stored(value, precision);
        if !(SMALLEST..=LARGEST).contains(&stored) {
            errors.push(SceneError::OutOfScale { path, what, value });
        }
    }
}

fn check_forces(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let mut seen = HashSet::new();
    for (index, mass) in scene.stepping.forces.iter().copied().enumerate() {
        let path = Path::Force(Some(index));
        check_node(scene, Node::Mass(mass), path, errors);
        // The stepper's input has fields with these names, so a loaded mass must not have them.
        if let Some(taken) = scene.masses.get(mass)
            && checks.emitted
            && ["force", "friction"].contains(&taken.name.as_str())
        {
            let name = taken.name.clone();
            errors.push(SceneError::Reserved { path, name });
        }
        let name = || scene.node_name(Node::Mass(mass)).to_owned();
        if !seen.insert(mass) {
            errors.push(SceneError::ForceTwice { path, name: name() });
        } else if checks.excitation && scene.excitation == Excitation::Force(mass) {
            errors.push(SceneError::ForceOnExcitation { path, name: name() });
        }
    }
}
