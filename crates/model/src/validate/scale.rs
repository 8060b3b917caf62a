//! Checks whether the numbers of a scene differ too much, or its modes are too close, for meaningful results.

use super::checks::{Checks, LARGEST, SMALLEST};
use super::elastic;
use super::error::SceneError;
use super::path::Path;
use crate::modal::Modal;
use crate::scene::{Precision, Scene};

/// Largest number of masses for which the code checks the modes. Larger scenes exist only at run time, in double
/// precision.
const MOST_ANALYSED: usize = 64;
/// Smallest relative difference of two frequencies that single precision can separate. It is a few rounding units of
/// single precision.
const SINGLE_GAP: f64 = 1e-6;
/// Relative difference of two frequencies below which double-double cannot separate them.
const SAME: f64 = 1e-28;

/// Returns the largest ratio between two masses, or between two stiffnesses, that a scene may have.
fn most_span(precision: Precision) -> f64 {
    match precision {
        // The modal analysis has about 31 digits.
        Precision::F64 => 1e28,
        // The squares of the frequencies must stay within the exponents of single precision.
        Precision::F32 => 1e16,
    }
}

/// Reports ratios of masses or of stiffnesses that are too large.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let span = |values: &mut dyn Iterator<Item = f64>| {
        let (mut least, mut most) = ((f64::INFINITY, 0), (0.0, 0));
        for (index, value) in values.enumerate() {
            if value < least.0 {
                least = (value, index);
            }
            if value > most.0 {
                most = (value, index);
            }
        }
        // Another check has already reported a number that is too large or too small by itself.
        let told = most.0 > LARGEST || least.0 < SMALLEST;
        (if told { 1.0 } else { most.0 / least.0 }, most.1)
    };
    let limit = most_span(scene.precision);
    if checks.masses {
        let (ratio, index) = span(&mut scene.masses.iter().map(|mass| mass.value));
        if ratio > limit {
            errors.push(SceneError::MassesSpan {
                path: Path::Mass(index),
                ratio,
                limit,
            });
        }
    }
    if checks.springs {
        let (ratio, index) = span(&mut scene.springs.iter().map(|spring| spring.stiffness));
        if ratio > limit {
            errors.push(SceneError::StiffnessesSpan {
                path: Path::Spring(index),
                ratio,
                limit,
            });
        }
    }
}

/// Reports modes that single precision cannot separate, and a contact whose stiffness leaves too few digits. All other
/// checks must have passed.
pub(super) fn check_modes(scene: &Scene, errors: &mut Vec<SceneError>) {
    let single = scene.precision == Precision::F32;
    if !(single || scene.stiffness.is_some()) || scene.masses.len() > MOST_ANALYSED {
        return;
    }
    let modal = Modal::of(scene);
    elastic::check_digits(scene, &modal, errors);
    if !single {
        return;
    }
    let pairs = modal.resonances.iter().zip(modal.resonances.iter().skip(1));
    for (index, (lower, upper)) in pairs.enumerate() {
        let gap = ((*upper - *lower) / *upper).to_f64();
        if SAME < gap && gap < SINGLE_GAP {
            errors.push(SceneError::ModesTooClose {
                path: Path::Scene,
                first: index + 1,
                second: index + 2,
                gap,
            });
        }
    }
}
