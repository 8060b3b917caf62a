//! Largest velocity and acceleration of a continuous motion, from its closed form.
//!
//! The search samples sixteen instants in a half-turn of the fastest mode, and refines every maximum of the samples. It
//! can miss a maximum only within one sampling step of another one. Two such maxima differ by less than a thousandth of
//! their value.

use super::motion::SystemMotion;
use super::response::Size;
use crate::Of;
use std::f64::consts::PI;

/// Number of samples in a half-turn of the fastest mode.
const PLACES: f64 = 16.0;
/// Upper bound on the number of samples.
const MOST: f64 = 4096.0;
/// Largest number of steps of a refinement. A golden section keeps at most 0.62 of the interval.
const STEPS: usize = 40;
/// Larger of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Last instant of the half period before the contact reverses, in units of π.
const LAST: f64 = 1.0 - f64::EPSILON;

/// Returns the largest |dx̄/dτ| or |d²x̄/dτ²| of a continuous motion. Returns `None` if the scene has no such motion.
///
/// The function searches one half period, because the motion repeats with the opposite sign afterwards.
pub(super) fn largest_rate(motion: &SystemMotion<'_>, of: Of, size: Size) -> Option<f64> {
    let steady = motion.motion_of(of)?;
    let at = |tau: f64| match size {
        Size::Acceleration => steady.acceleration(tau).abs(),
        _ => steady.velocity(tau).abs(),
    };
    let fastest = motion.at().scene().resonances().last().copied();
    let vibrations = fastest.unwrap_or(1.0) * (1.0 / motion.at().frequency_ratio());
    let places = (PLACES * vibrations.max(1.0)).ceil().min(MOST);
    let step = PI / places;
    let instant = |place: f64| (step * place).min(PI * LAST);
    // A maximum next to an end does not lie between three sampled instants.
    let mut best = summit(instant(0.0), instant(1.0), &at);
    best = best.max(summit(instant(places - 1.0), instant(places), &at));
    let (mut before, mut here) = (at(instant(0.0)), at(instant(1.0)));
    best = best.max(before).max(here);
    for place in 2..=places as u32 {
        let place = f64::from(place);
        let next = at(instant(place));
        best = best.max(next);
        if before <= here && next <= here {
            best = best.max(summit(instant(place - 2.0), instant(place), &at));
        }
        (before, here) = (here, next);
    }
    Some(best)
}

/// Returns the largest value between two instants, by golden sections.
fn summit(mut low: f64, mut high: f64, size: &impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
    let (mut at_a, mut at_b) = (size(a), size(b));
    for _ in 0..STEPS {
        // The value is flat at its maximum, so a distance of 10⁻⁸ already gives all its digits.
        if high - low < 1e-8 {
            break;
        }
        if at_a < at_b {
            (low, a, at_a) = (a, b, at_b);
            b = low + (high - low) * GOLDEN;
            at_b = size(b);
        } else {
            (high, b, at_b) = (b, a, at_a);
            a = high - (high - low) * GOLDEN;
            at_a = size(a);
        }
    }
    at_a.max(at_b)
}
