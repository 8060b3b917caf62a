//! Largest velocity and acceleration of a continuous motion, from its closed form.
//!
//! The search samples sixteen instants in a half period of the fastest mode, and refines every maximum of the samples.
//! If two maxima are within one sampling step, the search can miss one of the two. The two maxima then differ by less
//! than a thousandth of their value.

use super::golden::smallest;
use super::motion::SystemMotion;
use super::quantity::MotionQuantity;
use crate::Of;
use std::convert::Infallible;
use std::f64::consts::PI;

/// Number of samples in a half period of the fastest mode.
const PLACES: f64 = 16.0;
/// Upper bound on the number of samples in a half period of the excitation.
const MOST: f64 = 4096.0;
/// Largest number of golden sections in the refinement of a maximum. Each one shortens the interval to 0.62 of its
/// length.
const STEPS: usize = 40;
/// Length of the interval of τ, in rad, at which the refinement of a maximum ends. Because the function is flat at its
/// maximum, this length already gives all digits of the maximum.
const WIDTH: f64 = 1e-8;
/// Last sampled instant τ of the half period, divided by π. It lies just before the contact reverses.
const LAST: f64 = 1.0 - f64::EPSILON;

/// Returns the largest |dx̄/dτ| or |d²x̄/dτ²| of a continuous motion, or `None` if the scene does not have the motion
/// `of`.
///
/// The function searches one half period, because the motion repeats with the opposite sign afterwards.
pub(super) fn largest_rate(motion: &SystemMotion<'_>, of: Of, size: MotionQuantity) -> Option<f64> {
    let steady = motion.motion_of(of)?;
    let at = |tau: f64| match size {
        MotionQuantity::Acceleration => steady.acceleration(tau).abs(),
        _ => steady.velocity(tau).abs(),
    };
    let fastest = motion.at().scene().resonances().last().copied();
    let vibrations = fastest.unwrap_or(1.0) * (1.0 / motion.at().frequency_ratio());
    let places = (PLACES * vibrations.max(1.0)).ceil().min(MOST);
    let step = PI / places;
    let instant = |place: f64| (step * place).min(PI * LAST);
    // The loop below needs three samples around a maximum. It can miss a maximum in the first and in the last interval
    // of the half period.
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

/// Returns the largest value of the function `size` between the two instants `low` and `high`, by golden sections.
fn summit(low: f64, high: f64, size: &impl Fn(f64) -> f64) -> f64 {
    let Ok((_, least)) = smallest((low, high), (STEPS, WIDTH), |tau| {
        Ok::<f64, Infallible>(-size(tau))
    });
    -least
}
