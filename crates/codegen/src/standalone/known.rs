//! Known answers of an emitted file: reference results with which the self-check of the file compares its own results.

use super::{NumberFormat, Source};
use crate::known::{AnswersRequest, KnownAnswers, MotionKind, known};
use crate::units::domain;
use frictiongen_kernel::Float;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Precision;

/// Allowed error of an answer in addition to the error of the table, in rounding units.
const ROUNDINGS: f64 = 64.0;

/// Returns the allowed error of an answer, and the known answers.
///
/// The allowed error is the accuracy of the tables, plus 64 rounding units for the emitted arithmetic and for r and β.
#[must_use]
pub fn known_answers<S: Float>(source: &Source<'_, S>) -> (f64, Vec<KnownAnswers>) {
    let Source { scene, tables, .. } = source;
    let tolerance = tables.request.accuracy + ROUNDINGS * S::EPSILON;
    let [r, beta] = domain(scene, tables);
    let question = AnswersRequest {
        precision: if S::EPSILON > f64::EPSILON {
            Precision::F32
        } else {
            Precision::F64
        },
        r,
        beta,
        tolerance,
        widest: tolerance,
        motion: tables.moves(),
        stuck: tables.held.is_some(),
    };
    (tolerance, known(&Modal::of(scene), &question))
}

/// Returns the numbers of a known answer, in the order of the emitted structures.
pub(super) fn numbers(known: &KnownAnswers) -> Vec<f64> {
    let mut numbers = vec![known.r, known.continuous, known.sliding];
    if let Some(motion) = &known.motion {
        numbers.push(motion.beta);
        numbers.extend(motion.contact);
    }
    numbers.extend(known.stuck.iter().flatten());
    numbers
}

/// Returns the name of the status of a known answer, as in [`STATUSES`](super::STATUSES).
pub(super) fn status(known: &KnownAnswers) -> &'static str {
    match known.motion.as_ref().map(|motion| motion.outcome) {
        None | Some(MotionKind::Continuous) => "Ok",
        Some(MotionKind::StickSlip) => "StickSlip",
        Some(MotionKind::Stuck) => "Stuck",
    }
}

/// Returns three texts for each known answer: r with the limits, β with the motion of the contact, and the stuck
/// responses.
pub(super) fn rows(numbers: NumberFormat, all: &[KnownAnswers]) -> Vec<[String; 3]> {
    let row = |known: &KnownAnswers| {
        let head = numbers.list([known.r, known.continuous, known.sliding]);
        let motion = known.motion.as_ref().map(|motion| {
            let [amplitude, phase] = motion.contact;
            numbers.list([motion.beta, amplitude, phase])
        });
        let stuck = known.stuck.iter().map(|pair| numbers.list(*pair));
        let (open, close) = match numbers.language {
            super::Language::C => ('{', '}'),
            super::Language::Rust => ('[', ']'),
        };
        let stuck: Vec<String> = stuck.map(|pair| format!("{open}{pair}{close}")).collect();
        [head, motion.unwrap_or_default(), stuck.join(", ")]
    };
    all.iter().map(row).collect()
}
