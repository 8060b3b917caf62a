//! Finds the friction ratio for which the largest amplitude over a range of frequencies is smallest.

use crate::question::Question;
use frictiongen::study::optimum::{
    FrequencyBand, OptimumEnd, OptimumKind, OptimumOptions, OptimumRequest,
};
use frictiongen::study::response::MotionQuantity;
use serde_json::{Value, json};

/// Returns the best friction ratio, and the largest amplitude over the range of frequencies with it.
pub fn answer(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let request = OptimumRequest {
        of: question.motion(),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(question.from, question.to),
        load: None,
    };
    let options = OptimumOptions {
        work: Some(question.work),
        ..OptimumOptions::default()
    };
    let best = system
        .optimum_with(&request, &options)
        .map_err(|error| error.to_string())?;
    let why = match best.kind {
        OptimumKind::EqualPeaks => "two peaks have the same height",
        OptimumKind::SinglePeak => "one peak is at its minimum",
        OptimumKind::NoFriction => "any friction increases the largest amplitude",
        OptimumKind::Stuck => "the contact is stuck, and more friction changes nothing",
        OptimumKind::Trivial => "the contact is stuck over the whole range, and this motion rests",
        OptimumKind::Flat => "the amplitude is the same over an interval of friction",
        OptimumKind::Bounded => "a bound keeps the friction from a smaller amplitude",
        OptimumKind::Balanced => "more friction raises one quantity, less raises another",
    };
    Ok(json!({
        "beta": best.beta,
        "amplitude": best.amplitude,
        "why": why,
        "finished": best.end != OptimumEnd::WorkSpent,
        "r": best.peaks.first().map(|peak| peak.r),
        "without_friction": best.without_friction,
        "stuck": best.with_contact_locked,
    }))
}
