//! Checks of an elastic contact: its stiffness, and the fields that it excludes.

use super::checks::{Checks, LARGEST, SMALLEST};
use super::error::SceneError;
use super::path::Path;
use super::settings::item_name;
use crate::modal::Modal;
use crate::scene::{FrictionLaw, Precision, Provide, Scene};

/// Largest phase, in rad, of the fastest mode of the stuck chain after one period of the lowest resonance that the
/// contact drives. The rounding of this phase changes the contact force. A phase of 10⁶ rad keeps an accuracy of 10⁻¹⁰
/// in `f64`, and a phase of 10⁴ rad keeps 10⁻³ in `f32`.
fn most_turned(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => 1e6,
        Precision::F32 => 1e4,
    }
}

/// Returns the number of correct digits that the contact force keeps at the phase of [`most_turned`].
fn kept(precision: Precision) -> u32 {
    match precision {
        Precision::F64 => 10,
        Precision::F32 => 3,
    }
}

/// Reports a stiffness that is not a positive number. Returns false if the contact has no finite stiffness.
pub(super) fn check_value(scene: &Scene, errors: &mut Vec<SceneError>) -> bool {
    let Some(value) = scene.stiffness else {
        return false;
    };
    let path = Path::Stiffness;
    if value.is_nan() {
        let what = "the stiffness of the contact".to_owned();
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value == f64::INFINITY {
        // The message recommends to leave out the field. No further check of the stiffness is then useful.
        errors.push(SceneError::StiffnessInfinite { path });
        return false;
    } else if !(0.0 < value) {
        errors.push(SceneError::ContactStiffnessNotPositive { path, value });
    } else if !(SMALLEST..=LARGEST).contains(&value) {
        let what = "the stiffness of the contact".to_owned();
        errors.push(SceneError::OutOfScale { path, what, value });
    }
    true
}

/// Reports a stiffness that is not a positive number, and fields that are incompatible with an elastic contact.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    if !check_value(scene, errors) {
        return;
    }
    let path = Path::Stiffness;
    if scene.friction != FrictionLaw::Coulomb {
        errors.push(SceneError::ElasticStribeck { path });
    }
    if !checks.emitted {
        return;
    }
    let answered = |item: &Provide| {
        matches!(
            item,
            Provide::Orbit | Provide::Simulation | Provide::Stepper | Provide::Stuck
        )
    };
    if !scene.provide.is_empty() && !scene.provide.iter().any(answered) {
        errors.push(SceneError::ElasticWithoutMotion { path });
        return;
    }
    for (index, item) in scene.provide.iter().enumerate() {
        if !answered(item) {
            errors.push(SceneError::NotElastic {
                path: Path::Provide(Some(index)),
                item: item_name(item).to_owned(),
            });
        }
    }
}

/// Rounds a positive number down to two digits, as a message shows it.
fn rounded_down(value: f64) -> f64 {
    let unit = 10_f64.powf(value.log10().floor() - 1.0);
    (value / unit).floor() * unit
}

/// Reports a stiffness with which the contact force would lose digits. All other checks must have passed.
pub(super) fn check_digits(scene: &Scene, modal: &Modal, errors: &mut Vec<SceneError>) {
    let Some(value) = scene.stiffness else {
        return;
    };
    let driven = modal.resonances.iter().zip(&modal.contacts);
    let lowest = driven
        .filter(|(_, contact)| contact.to_f64() != 0.0)
        .map(|(resonance, _)| resonance.to_f64())
        .fold(f64::INFINITY, f64::min);
    // The stiffest motion has about the frequency √(k m*), with m* the inverse effective mass of the contact.
    let turned = most_turned(scene.precision) * lowest / core::f64::consts::TAU;
    let most =
        rounded_down(turned * turned / modal.inverse_mass.to_f64() * scene.first_stiffness());
    if most < value {
        errors.push(SceneError::StiffnessLosesDigits {
            path: Path::Stiffness,
            value,
            most,
            kept: kept(scene.precision),
        });
    }
}
