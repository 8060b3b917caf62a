//! Checks of damping, friction, what to provide and how exact.

use std::collections::HashSet;

use super::{Checks, LARGEST, Path, SceneError, check_node};
use crate::scene::{Accuracy, Damping, Node, Provide, Scene};

/// Checks everything that is neither mass, spring, contact nor excitation.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    check_damping(scene, checks, errors);
    check_stiction(scene.stiction, errors);
    check_provide(scene, errors);
    check_accuracy(scene, errors);
}

fn check_damping(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    match &scene.damping {
        Damping::None => {}
        Damping::Uniform(ratio) => check_coefficient(*ratio, 0, "a modal damping ratio", errors),
        Damping::Modal(ratios) => {
            let masses = scene.masses.len();
            if checks.masses && masses > 0 && ratios.len() != masses {
                // A surplus is on the first value too many, a lack on the list.
                let path = Path::Damping((ratios.len() > masses).then_some(masses));
                errors.push(SceneError::DampingCount {
                    path,
                    found: ratios.len(),
                    masses,
                });
            }
            for (index, ratio) in ratios.iter().enumerate() {
                check_coefficient(*ratio, index, "a modal damping ratio", errors);
            }
        }
        Damping::Rayleigh { mass, stiffness } => {
            check_coefficient(*mass, 0, "the factor of the mass matrix", errors);
            check_coefficient(*stiffness, 1, "the factor of the stiffness matrix", errors);
        }
    }
}

fn check_coefficient(value: f64, index: usize, what: &str, errors: &mut Vec<SceneError>) {
    let path = Path::Damping(Some(index));
    let what = what.to_owned();
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value < 0.0 {
        errors.push(SceneError::DampingNegative { path, what, value });
    } else if value > LARGEST {
        errors.push(SceneError::OutOfScale { path, what, value });
    }
}

fn check_stiction(value: f64, errors: &mut Vec<SceneError>) {
    let path = Path::Stiction;
    if !value.is_finite() {
        errors.push(SceneError::NotFinite {
            path,
            what: "μ".to_owned(),
            value,
        });
    } else if value < 1.0 {
        errors.push(SceneError::StictionBelowOne { path, value });
    } else if value > LARGEST {
        errors.push(SceneError::OutOfScale {
            path,
            what: "μ".to_owned(),
            value,
        });
    }
}

fn check_provide(scene: &Scene, errors: &mut Vec<SceneError>) {
    if scene.provide.is_empty() {
        errors.push(SceneError::NothingProvided {
            path: Path::Provide(None),
        });
    }
    let mut kinds = HashSet::new();
    for (index, item) in scene.provide.iter().enumerate() {
        let path = Path::Provide(Some(index));
        if !kinds.insert(core::mem::discriminant(item)) {
            errors.push(SceneError::ProvidedTwice {
                path,
                item: item_name(item).to_owned(),
            });
        }
        if *item == Provide::Stepper {
            errors.push(SceneError::StepperNotBuilt { path });
        }
        if let Provide::Motion(Some(masses)) = item {
            if masses.is_empty() {
                errors.push(SceneError::MotionOfNothing { path });
            }
            for mass in masses {
                check_node(scene, Node::Mass(*mass), path, errors);
            }
        }
    }
}

fn item_name(item: &Provide) -> &'static str {
    match item {
        Provide::Limits => "limits",
        Provide::Motion(_) => "motion",
        Provide::Stuck => "stuck",
        Provide::Orbit => "orbit",
        Provide::Simulation => "simulation",
        Provide::Stepper => "stepper",
    }
}

/// Neither is built yet: whoever asks for it must not believe to have got it.
fn check_accuracy(scene: &Scene, errors: &mut Vec<SceneError>) {
    if scene.accuracy != Accuracy::Exact {
        errors.push(SceneError::AccuracyNotBuilt {
            path: Path::Accuracy,
        });
    }
    if scene.range.is_some() {
        errors.push(SceneError::RangeNotBuilt { path: Path::Range });
    }
}
