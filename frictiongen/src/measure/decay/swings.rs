//! The extremes of a free vibration, and the noise of its recording.

use super::ROUNDING;
use crate::measure::MeasureError;

/// Smallest number of extremes that a decay must have. It is one more than the number of the decay's unknowns.
const FEWEST: usize = 4;
/// A swing is the motion from one extreme to the next. It ends when the mass has moved back by more than this number of
/// standard deviations of the noise. The mass must also have moved back by more than the fraction [`PART`] of the
/// range.
const TURN: f64 = 8.0;
/// A swing ends when the mass has moved back by more than this fraction of the whole range of the samples. The mass
/// must also have moved back by more than [`TURN`] standard deviations of the noise.
const PART: f64 = 0.02;

/// Swings of a free vibration. A swing is the motion from one extreme to the next.
pub(super) struct Swings {
    /// For each extreme of the vibration, the index of the sample and the displacement in m.
    pub(super) turns: Vec<(usize, f64)>,
    /// The first and the last extreme, each as index of the sample and displacement in m.
    pub(super) ends: [(usize, f64); 2],
    /// Distance between the first two extremes of the vibration, in m.
    pub(super) largest: f64,
    /// Friction force F divided by the stiffness k, in m, computed from the linear decrement.
    pub(super) linear_decrement: f64,
}

impl Swings {
    /// Finds the swings (motions from extreme to extreme) in the samples.
    ///
    /// # Errors
    /// [`MeasureError`] for too few extremes above the noise, and for extremes that do not decrease.
    pub(super) fn of(samples: &[f64], noise: f64) -> Result<Self, MeasureError> {
        let range = samples
            .iter()
            .fold((f64::MAX, f64::MIN), |(low, high), value| {
                (low.min(*value), high.max(*value))
            });
        let turns = extremes(samples, (TURN * noise).max(PART * (range.1 - range.0)));
        if turns.len() < FEWEST {
            return Err(MeasureError::FewPeaks(turns.len()));
        }
        let swings: Vec<f64> = turns
            .windows(2)
            .filter_map(|pair| Some((pair.last()?.1 - pair.first()?.1).abs()))
            .collect();
        let (Some(first), Some(last)) = (turns.first(), turns.last()) else {
            return Err(MeasureError::FewPeaks(0));
        };
        let falls = swings
            .windows(2)
            .filter_map(|pair| Some(pair.first()? - pair.last()?));
        let falls: Vec<f64> = falls.collect();
        let linear_decrement = falls.iter().sum::<f64>() / (4.0 * falls.len().max(1) as f64);
        if !(ROUNDING * (range.1 - range.0) < linear_decrement) {
            return Err(MeasureError::NoDecay);
        }
        Ok(Self {
            ends: [*first, *last],
            largest: swings.first().copied().unwrap_or(1.0),
            linear_decrement,
            turns,
        })
    }
}

/// Returns the standard deviation of the noise, estimated from third differences of the samples. A smooth motion
/// contributes little to third differences.
pub(super) fn noise(samples: &[f64]) -> f64 {
    let thirds = samples.windows(4).filter_map(|w| {
        let &[a, b, c, d] = w else { return None };
        Some((d - 3.0 * c + 3.0 * b - a).powi(2))
    });
    let count = samples.len().saturating_sub(3).max(1) as f64;
    (thirds.sum::<f64>() / (20.0 * count)).sqrt()
}

/// Returns the index and the value of each sample at which the motion reverses. The result leaves out the first
/// extreme, which may lie before the release of the mass, and reversals that noise may cause.
fn extremes(samples: &[f64], turn: f64) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    let Some(first) = samples.first() else {
        return found;
    };
    let (mut high, mut low) = ((0, *first), (0, *first));
    let mut rising = None;
    for (place, value) in samples.iter().enumerate() {
        if high.1 < *value {
            high = (place, *value);
        }
        if *value < low.1 {
            low = (place, *value);
        }
        if rising != Some(false) && *value < high.1 - turn {
            found.push(high);
            rising = Some(false);
            low = (place, *value);
        } else if rising != Some(true) && low.1 + turn < *value {
            found.push(low);
            rising = Some(true);
            high = (place, *value);
        }
    }
    // If the mass is held before its release, noise decides at which sample of that interval the first extreme is
    // found.
    if !found.is_empty() {
        found.remove(0);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::noise;
    use rand::SeedableRng;
    use rand::rngs::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};
    use std::f64::consts::TAU;

    /// Checks the estimate of the noise for white noise with a standard deviation of 1, first alone and then added to a
    /// motion of amplitude 100. The estimate from 40,000 samples has a standard deviation of 0.54 %. The tolerance is
    /// five times this percentage. The third differences of the motion are 100 (2π/2000)³, about 3e-6.
    #[test]
    fn white_noise_has_its_deviation() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for size in [0.0, 100.0] {
            let samples: Vec<f64> = (0..40_000)
                .map(|index| {
                    let chance: f64 = StandardNormal.sample(&mut random);
                    chance + size * (TAU * f64::from(index) / 2000.0).cos()
                })
                .collect();
            let found = noise(&samples);
            assert!((found - 1.0).abs() < 0.027, "{size}: {found}");
        }
        // The third differences of a parabola are 0. The rounding errors of values up to 10⁴ remain.
        let parabola: Vec<f64> = (0..100).map(|i| f64::from(i * i)).collect();
        assert!(noise(&parabola) < 1e-10);
        assert_eq!(noise(&[1.0, 2.0]), 0.0);
    }
}
