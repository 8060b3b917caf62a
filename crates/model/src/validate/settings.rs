//! Checks of damping, static friction, provided items and declared accuracy.

use std::collections::HashSet;

use super::checks::{Checks, LARGEST, check_node};
use super::error::SceneError;
use super::path::Path;
use crate::scene::{
    Accuracy, Beyond, Damping, DampingFrom, Excitation, Node, Precision, Provide, Proving, Range,
    Scene, Side,
};
use crate::table::{COARSEST, FINEST, FINEST_PROVEN, FINEST_SINGLE};

/// Largest size of the tables that a scene may declare, in bytes.
const MOST_BYTES: f64 = (1_u64 << 40) as f64;

/// Reports errors in all items except masses, springs, contact and excitation.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    check_damping(scene, checks, errors);
    check_damping_from(scene, checks, errors);
    check_stiction(scene.stiction, errors);
    check_provide(scene, errors);
    check_declared(scene, checks, errors);
}

fn check_damping(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    match &scene.damping {
        Damping::None => {}
        Damping::Uniform(ratio) => check_coefficient(*ratio, 0, "a modal damping ratio", errors),
        Damping::Modal(ratios) => {
            let masses = scene.masses.len();
            if checks.masses && masses > 0 && ratios.len() != masses {
                // If there are too many values, the first surplus value is marked. If there are too few, the whole list
                // is marked.
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

/// Reports `damping_from: base` in a scene whose base does not move.
fn check_damping_from(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let path = Path::DampingFrom;
    if scene.damping_from != DampingFrom::Base || !checks.excitation {
        return;
    }
    if let Excitation::Force(mass) = scene.excitation {
        let load = scene.node_name(Node::Mass(mass)).to_owned();
        errors.push(SceneError::NoMovingBase { path, load });
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
    // The macro emits no self-check of a scene without limits and motion, so no list would cure this error.
    let closed = scene.default_provide().contains(&Provide::Limits);
    if closed && let [Provide::SelfCheck] = scene.provide.as_slice() {
        errors.push(SceneError::ChecksNothing {
            path: Path::Provide(Some(0)),
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

pub(super) fn item_name(item: &Provide) -> &'static str {
    match item {
        Provide::Limits => "limits",
        Provide::Motion(_) => "motion",
        Provide::Stuck => "stuck",
        Provide::Orbit => "orbit",
        Provide::Simulation => "simulation",
        Provide::Stepper => "stepper",
        Provide::SelfCheck => "self_check",
    }
}

/// Reports fields about tables in a scene that cannot have tables. Returns true if the scene can have tables.
fn check_tabled(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) -> bool {
    let cause = if checks.joined(scene) {
        "`contacts`, `dampers`, `stops` or `constant`"
    } else if scene.stiffness.is_some_and(|value| value != f64::INFINITY) {
        "`stiffness`"
    } else {
        return true;
    };
    let declared = &scene.declared;
    let given = [
        (
            declared.accuracy != Accuracy::Exact,
            Path::Accuracy,
            "accuracy",
        ),
        (declared.budget.is_some(), Path::Budget, "budget"),
        (declared.range.is_some(), Path::Range, "range"),
        (declared.side != Side::Near, Path::Side, "side"),
        (declared.beyond != Beyond::Error, Path::Beyond, "beyond"),
        (declared.proof != Proving::Quick, Path::Proof, "proof"),
    ];
    let given: Vec<_> = given.into_iter().filter(|(given, ..)| *given).collect();
    if let Some((_, path, _)) = given.first() {
        let fields = given.iter().map(|(.., field)| format!("`{field}`"));
        errors.push(SceneError::NoTables {
            path: *path,
            cause: cause.to_owned(),
            fields: fields.collect::<Vec<_>>().join(" and "),
        });
    }
    false
}

fn check_declared(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    if !check_tabled(scene, checks, errors) {
        return;
    }
    let declared = &scene.declared;
    let finest = match scene.precision {
        Precision::F64 => FINEST,
        Precision::F32 => FINEST_SINGLE,
    };
    if let Accuracy::Relative(value) = declared.accuracy {
        let path = Path::Accuracy;
        if !(finest <= value && value <= COARSEST) {
            errors.push(SceneError::AccuracyOutside {
                path,
                value,
                finest,
            });
        }
        if declared.budget.is_some() {
            errors.push(SceneError::AccuracyAndBudget { path: Path::Budget });
        }
        if declared.range.is_none() {
            errors.push(SceneError::AccuracyWithoutRange { path });
        }
        if declared.proof == Proving::Whole && finest <= value && value < FINEST_PROVEN {
            errors.push(SceneError::TooFineForProof {
                path: Path::Proof,
                value,
            });
        }
    }
    if let Some(value) = declared.budget {
        let path = Path::Budget;
        if !(value >= 1.0 && value.fract() == 0.0 && value <= MOST_BYTES) {
            errors.push(SceneError::BudgetOutside { path, value });
        }
        if declared.range.is_none() {
            errors.push(SceneError::AccuracyWithoutRange { path });
        }
    }
    let belongs = [
        (declared.range.is_some(), Path::Range, "range"),
        (declared.side != Side::Near, Path::Side, "side"),
        (declared.beyond != Beyond::Error, Path::Beyond, "beyond"),
        (declared.proof != Proving::Quick, Path::Proof, "proof"),
    ];
    for (given, path, field) in belongs {
        if given && !declared.is_tabled() {
            let field = field.to_owned();
            errors.push(SceneError::WithoutAccuracy { path, field });
        }
    }
    if let Some(range) = declared.range {
        check_range(&range, scene.precision, errors);
    }
}

fn check_range(range: &Range, precision: Precision, errors: &mut Vec<SceneError>) {
    let (low, high) = range.r;
    // Outside the normal range of the number type, a number would become 0 or infinite.
    let (least, most) = match precision {
        Precision::F64 => (f64::MIN_POSITIVE, f64::MAX),
        Precision::F32 => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)),
    };
    if !(least <= low && low < high && high <= most) {
        let path = Path::RangeOfRatio;
        errors.push(SceneError::RangeOfRatio { path, low, high });
    }
    let (low, high) = range.beta;
    if !(0.0 <= low && low < high) {
        let path = Path::RangeOfFriction;
        errors.push(SceneError::RangeOfFriction { path, low, high });
    }
}
