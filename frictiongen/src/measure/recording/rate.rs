//! Finds the sampling rate from the times of the samples.

use crate::measure::MeasureError;

/// Largest difference at which two time steps are treated as equal, divided by the mean time step. The rounding of a
/// clock with six digits causes differences of this size.
const EVEN: f64 = 1e-2;

/// Returns the sampling rate, in samples per second, of samples at the given times in s. Fails if the times are not
/// evenly spaced. `place` returns the name of a sample for the error.
pub(super) fn even_rate(
    time: &[f64],
    place: impl Fn(usize) -> String,
) -> Result<f64, MeasureError> {
    let (Some(first), Some(last)) = (time.first(), time.last()) else {
        // One time gives an infinite rate, too. The check of the samples knows how many are needed.
        return Ok(f64::INFINITY);
    };
    let steps = time.len().saturating_sub(1).max(1) as f64;
    // A time step may differ from the first step or from the mean step, but not from both. If the code compared the
    // steps with the mean alone, a change of the step would be reported at the wrong sample.
    let usual = time.get(1).map_or(0.0, |second| second - first);
    let mean = (last - first) / steps;
    let apart = |step: f64, other: f64| !((step - other).abs() <= EVEN * other.abs());
    for (index, pair) in (1..).zip(time.windows(2)) {
        let &[a, b] = pair else { continue };
        if !(a < b) || (apart(b - a, usual) && apart(b - a, mean)) {
            return Err(MeasureError::MixedRates {
                place: place(index),
                before: usual,
                after: b - a,
            });
        }
    }
    if apart(mean, usual) {
        // Rounding of the times makes single steps uneven, but the error of a time does not grow during the record. The
        // code therefore compares the mean of ten steps with the mean of all steps.
        let ten = time.len().min(11) - 1;
        let early = time
            .get(ten)
            .map_or(usual, |t| (t - first) / ten.max(1) as f64);
        if apart(mean, early) {
            return Err(MeasureError::MixedRates {
                place: "its end".to_owned(),
                before: early,
                after: mean,
            });
        }
    }
    Ok(1.0 / mean)
}
