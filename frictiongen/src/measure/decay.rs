//! Finds friction and damping from a free vibration of one mass (thesis 4.3.2).
//!
//! After its release, a mass swings about two points that are 2F/k apart: one while it moves up, the other while it
//! moves down. Its extremes fall by 4F/k per cycle (4.2). With viscous damping each half cycle also multiplies the
//! distance from the present point by e^{−πζ/√(1−ζ²)} (Feeny and Liang, J. Sound Vib. 195 (1996) 149). The extremes
//! give a first guess. All samples between the first and the last extreme are then fitted, because single peaks of a
//! noisy signal come out too high.

use super::identify::Estimate;
use super::least_squares::{Linearised, minimise};
use super::recording::Dimension;
use super::statistics::student;
use super::{MeasureError, Recording};
use crate::study::System;
use crate::study::scene::Damping;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Smallest number of extremes for a fit: one more than the unknowns of their decrease.
const FEWEST: usize = 4;
/// Smallest motion in the opposite direction that ends a swing, in standard deviations of the noise. [`PART`] is a
/// second lower bound.
const TURN: f64 = 8.0;
/// Smallest motion in the opposite direction that ends a swing, as a fraction of the whole range of the samples.
const PART: f64 = 0.02;
/// Decrease in a half cycle, as a fraction of a swing, below which it counts as rounding error.
const ROUNDING: f64 = 1e-9;
/// Step of a finite difference, relative to the natural scale of the parameter.
const DIFFERENCE: f64 = 1e-6;

/// Friction, damping and natural frequency found in a free vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeDecay {
    /// Friction force F, N.
    pub friction: Estimate,
    /// F/k, m: half the distance between the two points about which the mass swings.
    pub length: Estimate,
    /// Damping ratio ζ. Its interval is a single point if ζ was given.
    pub damping: Estimate,
    /// Undamped natural frequency, Hz.
    pub hertz: Estimate,
    /// F/k by the linear decrement, m: the mean of (x⁽¹⁾ − x⁽²⁾)/4 over the extremes (4.2).
    pub linear_decrement: f64,
    /// Extremes that were used, as pairs: time from the first sample in s, and displacement in m.
    pub extremes: Vec<(f64, f64)>,
    /// Standard deviation of the residuals over that of the noise. If it is well above 1, the mass does not move as the
    /// model says.
    pub misfit: f64,
}

impl FreeDecay {
    /// Returns β for a base motion of amplitude Y in m (4.3).
    #[must_use]
    pub fn friction_ratio(&self, amplitude: f64) -> f64 {
        self.length.value / amplitude
    }
}

impl System {
    /// Returns ζ of the first mode, if the description gives damping ratios. It may serve as the known damping in
    /// [`free_decay`](Self::free_decay).
    #[must_use]
    pub fn described_damping(&self) -> Option<f64> {
        match &self.scene().damping {
            Damping::Uniform(ratio) => Some(*ratio),
            Damping::Modal(ratios) => ratios.first().copied(),
            _ => None,
        }
    }

    /// Finds friction, damping and natural frequency from a free vibration of a scene with one mass.
    ///
    /// `damping` is ζ if it is known; otherwise ζ is fitted with the other unknowns.
    ///
    /// ```
    /// use frictiongen::measure::{Channel, Recording, Unit};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: frictiongen::System = "struct Plate {
    ///     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// // From 20 mm, about ±0.5 mm, at 3 Hz: 2 mm less each cycle.
    /// let at = |t: f64| {
    ///     let half = (6.0 * t).floor();
    ///     let side = if half % 2.0 == 0.0 { 1.0 } else { -1.0 };
    ///     side * (0.5 + (19.5 - half) * (std::f64::consts::PI * (6.0 * t - half)).cos())
    /// };
    /// let samples = (0..2500).map(|i| at(f64::from(i) / 1000.0)).collect();
    /// let channel = Channel { name: "plate".into(), unit: Unit::MILLIMETRE, samples };
    /// let found = plate.free_decay(&Recording::new(1000.0, vec![channel])?, None)?;
    /// assert!((found.length.value - 0.5e-3).abs() < 1e-9 && (found.hertz.value - 3.0).abs() < 1e-6);
    /// assert!((found.friction.value - 0.5e-3 * 752.0).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`] for more than one mass, a channel that is not the displacement of the mass, too few extremes
    /// above the noise, and extremes that do not fall.
    pub fn free_decay(
        &self,
        recording: &Recording,
        damping: Option<f64>,
    ) -> Result<FreeDecay, MeasureError> {
        let scene = self.scene();
        let [mass] = scene.masses.as_slice() else {
            return Err(MeasureError::Asked(
                "a free decay gives the friction force only for a scene with one mass, because several masses beat (thesis 6.4.2)",
            ));
        };
        let stiffness: f64 = scene.springs.iter().map(|spring| spring.stiffness).sum();
        let channel = recording.channel(&mass.name).ok_or(MeasureError::NoMass)?;
        if channel.unit.dimension() != Dimension::Displacement {
            return Err(MeasureError::WrongDimension {
                channel: channel.name.clone(),
                unit: channel.unit.name(),
            });
        }
        let scale = channel.unit.scale();
        let samples: Vec<f64> = channel.samples.iter().map(|value| value * scale).collect();
        of(&samples, recording.rate(), stiffness, damping)
    }
}

/// Returns the standard deviation of the noise, from third differences of the samples. A smooth motion contributes
/// little to third differences.
fn noise(samples: &[f64]) -> f64 {
    let thirds = samples.windows(4).filter_map(|w| {
        let &[a, b, c, d] = w else { return None };
        Some((d - 3.0 * c + 3.0 * b - a).powi(2))
    });
    let count = samples.len().saturating_sub(3).max(1) as f64;
    (thirds.sum::<f64>() / (20.0 * count)).sqrt()
}

/// Returns the index and the value of each sample where the motion changes its direction. The start of the record is
/// left out. So are changes of direction within the noise.
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
    // The mass may be held before its release. Its first extreme is then at an arbitrary sample of that interval, so
    // that it is dropped.
    if !found.is_empty() {
        found.remove(0);
    }
    found
}

/// Parameters of a free decay, in samples and m: position and value of the first extreme, middle, length of a half
/// cycle, logarithmic decrement of a half cycle, F/k.
type Shape = [f64; 6];

/// Computes the displacement at each sample from the first extreme to the last, for these parameters.
fn wave(shape: &[f64], from: usize, count: usize) -> Option<Vec<f64>> {
    let &[start, first, middle, half, decrement, length] = shape else {
        return None;
    };
    let decay = (-decrement).exp();
    let (mut swing, mut extreme) = (0.0, first);
    let centre = |extreme: f64| middle + length * (extreme - middle).signum();
    let values = (0..count).map(|index| {
        let since = ((from + index) as f64 - start) / half;
        while swing + 1.0 <= since {
            let about = centre(extreme);
            extreme = about - (extreme - about) * decay;
            swing += 1.0;
        }
        let about = centre(extreme);
        let part = since - swing;
        let (sin, cos) = (PI * part).sin_cos();
        about + (extreme - about) * (-decrement * part).exp() * (cos + decrement / PI * sin)
    });
    Some(values.collect())
}

fn of(
    samples: &[f64],
    rate: f64,
    stiffness: f64,
    damping: Option<f64>,
) -> Result<FreeDecay, MeasureError> {
    let noise = noise(samples);
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
    let count = last.0 - first.0 + 1;
    let half = (last.0 - first.0) as f64 / (turns.len() - 1) as f64;
    let known = damping.map(|ratio| PI * ratio / (1.0 - ratio * ratio).sqrt());
    let middle = first.1 + 0.5 * (turns.get(1).map_or(first.1, |second| second.1) - first.1);
    let start: Shape = [
        first.0 as f64,
        first.1,
        middle,
        half,
        known.unwrap_or(0.0),
        linear_decrement,
    ];
    let parts = if known.is_some() {
        vec![0, 1, 2, 3, 5]
    } else {
        vec![0, 1, 2, 3, 4, 5]
    };
    let window = samples.get(first.0..first.0 + count).unwrap_or(&[]);
    let whole = |free: &[f64]| {
        let mut shape = start;
        for (part, value) in parts.iter().zip(free) {
            *shape.get_mut(*part)? = *value;
        }
        Some(shape)
    };
    let residuals = |free: &[f64]| {
        let values = wave(&whole(free)?, first.0, count)?;
        Some(DVector::from_iterator(
            count,
            values.iter().zip(window).map(|(a, b)| a - b),
        ))
    };
    // This is the natural scale of each parameter.
    let size = swings.first().copied().unwrap_or(1.0);
    let scales = [half, size, size, half, 1.0, size];
    let scale = |index: usize| {
        parts
            .get(index)
            .and_then(|part| scales.get(*part))
            .copied()
            .unwrap_or(1.0)
    };
    let linearise = |free: &[f64]| {
        let here = residuals(free)?;
        let mut jacobian = DMatrix::zeros(count, free.len());
        for index in 0..free.len() {
            let step = DIFFERENCE * scale(index);
            let moved = |by: f64| {
                let mut moved = free.to_vec();
                *moved.get_mut(index)? += by;
                residuals(&moved)
            };
            jacobian.set_column(index, &((moved(step)? - moved(-step)?) / (2.0 * step)));
        }
        Some(Linearised {
            residuals: here,
            jacobian,
        })
    };
    let free: Vec<f64> = parts
        .iter()
        .filter_map(|part| start.get(*part).copied())
        .collect();
    let bounds: Vec<(f64, f64)> = parts
        .iter()
        .map(|part| match part {
            3 => (0.5 * half, 2.0 * half),
            4 => (-1.0, 10.0),
            5 => (-size, size),
            _ => (f64::MIN, f64::MAX),
        })
        .collect();
    let fit = minimise(&free, &bounds, residuals, linearise);
    let fit = fit.filter(|fit| fit.settled).ok_or(MeasureError::NoFit)?;
    let freedom = count.saturating_sub(fit.rank).max(1);
    let deviation = (fit.squares / freedom as f64).sqrt();
    let quantile = student(freedom);
    let shape = whole(&fit.parameters).ok_or(MeasureError::NoFit)?;
    let estimate = |part: usize| {
        let value = shape.get(part).copied().unwrap_or(f64::NAN);
        let place = parts.iter().position(|free| *free == part);
        let variance = place.map_or(0.0, |at| fit.own_variance(at));
        (value, quantile * deviation * variance.sqrt())
    };
    let ((length, reach), (decrement, wide), (half, slow)) =
        (estimate(5), estimate(4), estimate(3));
    // Sampled extremes may seem to fall although the motion between the samples does not.
    if !(ROUNDING < length / size + decrement) {
        return Err(MeasureError::NoDecay);
    }
    let ratio = |decrement: f64| decrement / PI.hypot(decrement);
    let undamped = |half: f64| rate / (2.0 * half) / (1.0 - ratio(decrement).powi(2)).sqrt();
    let between = |value: f64, reach: f64, of: &dyn Fn(f64) -> f64| {
        let (a, b) = if reach.is_finite() {
            (of(value - reach), of(value + reach))
        } else {
            (f64::NEG_INFINITY, f64::INFINITY)
        };
        Estimate {
            value: of(value),
            from: a.min(b),
            to: a.max(b),
        }
    };
    Ok(FreeDecay {
        friction: between(length, reach, &|length| length * stiffness),
        length: between(length, reach, &|length| length),
        damping: between(decrement, wide, &ratio),
        hertz: between(half, slow, &undamped),
        linear_decrement,
        extremes: turns
            .iter()
            .map(|(place, value)| (*place as f64 / rate, *value))
            .collect(),
        misfit: deviation / noise.max(f64::MIN_POSITIVE),
    })
}

#[cfg(test)]
mod tests {
    use super::noise;
    use rand::SeedableRng;
    use rand::rngs::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};
    use std::f64::consts::TAU;

    /// White noise of standard deviation 1 is estimated as 1, also if a motion a hundred times as large is added. From
    /// 40,000 samples the estimate has a standard deviation of 0.54 %, and the tolerance is five times that. The
    /// motion's own third differences are 100 (2π/2000)³, about 3e-6.
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
        // A parabola has no third difference, so that only the rounding of values up to 10⁴ remains.
        let parabola: Vec<f64> = (0..100).map(|i| f64::from(i * i)).collect();
        assert!(noise(&parabola) < 1e-10);
        assert_eq!(noise(&[1.0, 2.0]), 0.0);
    }
}
