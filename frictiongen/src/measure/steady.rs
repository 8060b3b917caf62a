//! Finds the interval of a recording in which the motion is steady, and checks that the excitation is steady.

use super::MeasureError;
use super::tone::ToneBasis;
use crate::Complex;
use std::f64::consts::TAU;

/// Smallest number of excitation cycles in a block of samples.
const BLOCK: f64 = 2.0;
/// Largest number of blocks of samples into which the code divides a recording.
const MOST_BLOCKS: usize = 40;
/// Smallest number of blocks of samples from which the code decides that the motion is steady.
const FEWEST_BLOCKS: usize = 4;
/// The frequency is treated as constant if the excitation's phase deviates by at most this angle, in rad, from the
/// phase of a constant frequency. This deviation corresponds to a variation of the frequency by 1/30 of the width of a
/// spectral line.
const STRAY: f64 = 0.05;
/// Largest relative deviation of the excitation's amplitude from its mean at which the excitation is treated as
/// steady.
const SWELL: f64 = 0.05;
/// Largest change of an amplitude that is treated as noise, in standard deviations of the noise.
const SURE: f64 = 6.0;
/// A motion is treated as steady if its fundamental component changes by at most this fraction. The search first tries
/// the smaller fraction. The larger fraction permits a friction force that changes slowly.
const STEADY: [f64; 2] = [2e-3, 2e-2];
/// A motion is treated as steady only if the scatter of its fundamental component, divided by the mean of this
/// component, is at most this number.
const SCATTER: f64 = 0.1;

/// Complex fundamental of a channel in each block of samples. The phases of all blocks refer to the same origin of
/// time.
struct Blocks {
    values: Vec<Complex<f64>>,
    deviation: f64,
}

fn blocks(samples: &[f64], per_sample: f64, length: usize) -> Option<Blocks> {
    let basis = ToneBasis::new(length, per_sample, 3);
    let mut values = Vec::new();
    let mut deviations = Vec::new();
    for (index, part) in samples.chunks_exact(length).enumerate() {
        let tone = basis.tone(part)?;
        let turns = per_sample * (index * length) as f64;
        let (sin, cos) = (TAU * turns.fract()).sin_cos();
        values.push(tone.fundamental() * Complex::new(cos, -sin));
        deviations.push(tone.deviation);
    }
    // The last third of the blocks gives the noise. The first blocks may contain a transient, which would count as
    // noise.
    let last = deviations.len().div_ceil(3);
    let deviation = deviations.iter().rev().take(last).sum::<f64>() / last as f64;
    Some(Blocks { values, deviation })
}

fn mean(values: &[Complex<f64>]) -> Complex<f64> {
    values.iter().sum::<Complex<f64>>() / values.len().max(1) as f64
}

/// Returns the index of the sample from which on the motion in all channels is steady. The first of `channels` is the
/// excitation.
pub(super) fn start(
    channels: &[(&str, &[f64])],
    per_sample: f64,
    rate: f64,
) -> Result<usize, MeasureError> {
    let Some((_, drive)) = channels.first() else {
        return Ok(0);
    };
    let count = drive.len();
    let cycles = per_sample * count as f64;
    let parts = ((cycles / BLOCK).floor() as usize).min(MOST_BLOCKS);
    if parts < FEWEST_BLOCKS {
        return Err(MeasureError::TooShort {
            found: format!("{cycles:.1} cycles of the excitation"),
            needed: "8 cycles",
        });
    }
    let length = count / parts;
    let mut first = 0;
    for (index, (name, samples)) in channels.iter().enumerate() {
        let short = || MeasureError::NotSteady((*name).to_owned());
        let found = blocks(samples, per_sample, length).ok_or_else(short)?;
        if index == 0 {
            steady_drive(name, &found, per_sample * rate, length as f64 / rate)?;
        }
        first = first.max(settled(name, &found)?);
    }
    Ok(first * length)
}

/// Fails unless frequency and amplitude of the excitation are constant. The check ignores the first quarter of the
/// blocks, because the excitation may begin at rest.
fn steady_drive(name: &str, blocks: &Blocks, hertz: f64, seconds: f64) -> Result<(), MeasureError> {
    let skip = blocks.values.len() / 4;
    let kept = blocks.values.get(skip..).unwrap_or(&[]);
    let size = kept.iter().map(|value| value.norm()).sum::<f64>() / kept.len().max(1) as f64;
    if !(5.0 * blocks.deviation < size * (kept.len() as f64).sqrt()) {
        return Err(MeasureError::Silent(name.to_owned()));
    }
    // The loop unwraps the phases, so that they have no jumps of 2π.
    let mut phases: Vec<f64> = Vec::new();
    for value in kept {
        let angle = value.im.atan2(value.re);
        let before = phases.last().copied().unwrap_or(angle);
        phases.push(angle - TAU * ((angle - before) / TAU).round());
    }
    let (slope_early, slope_late, stray) = bend(&phases);
    let noise = SURE * blocks.deviation / size;
    if STRAY.max(noise) < stray {
        let change = |slope: f64| hertz + slope / (TAU * seconds);
        return Err(MeasureError::Drifts {
            from: change(slope_early),
            to: change(slope_late),
        });
    }
    let swell = kept.iter().map(|value| (value.norm() / size - 1.0).abs());
    let swell = swell.fold(0.0, f64::max);
    if SWELL.max(noise) < swell {
        return Err(MeasureError::Swells(swell));
    }
    Ok(())
}

/// Fits straight lines to the phases of the blocks. Returns three numbers: the slope over the first half of the
/// blocks, the slope over the second half, and the largest distance of a phase from the line through all phases.
fn bend(phases: &[f64]) -> (f64, f64, f64) {
    let line = |part: &[f64]| {
        let n = part.len().max(1) as f64;
        let x_mean = 0.5 * (n - 1.0);
        let y_mean = part.iter().sum::<f64>() / n;
        let sums = part.iter().enumerate().fold((0.0, 0.0), |sum, (i, y)| {
            let x = i as f64 - x_mean;
            (sum.0 + x * (y - y_mean), sum.1 + x * x)
        });
        let slope = if sums.1 > 0.0 { sums.0 / sums.1 } else { 0.0 };
        (slope, y_mean - slope * x_mean)
    };
    let (early, late) = phases.split_at(phases.len() / 2);
    let (slope, start) = line(phases);
    let away = phases
        .iter()
        .enumerate()
        .map(|(i, y)| (y - start - slope * i as f64).abs());
    (line(early).0, line(late).0, away.fold(0.0, f64::max))
}

/// Returns the index of the first block from which on the fundamental of a channel is constant.
fn settled(name: &str, blocks: &Blocks) -> Result<usize, MeasureError> {
    let values = &blocks.values;
    let last = values
        .get(values.len() - values.len().div_ceil(3)..)
        .unwrap_or(&[]);
    let middle = mean(last);
    // The code computes the scatter from the differences of neighbouring blocks, after it has subtracted the mean of
    // these differences. A steady growth or decrease therefore does not increase the scatter.
    let pairs = last
        .windows(2)
        .filter_map(|pair| Some(pair.last()? - pair.first()?));
    let steps: Vec<Complex<f64>> = pairs.collect();
    let common = mean(&steps);
    let squares: f64 = steps.iter().map(|step| (step - common).norm_sqr()).sum();
    let freedom = steps.len().saturating_sub(1).max(1);
    let scatter = (0.5 * squares / freedom as f64).sqrt();
    let noise = blocks.deviation * std::f64::consts::SQRT_2;
    // A motion whose changes are within its noise counts as steady.
    if SCATTER * middle.norm() < scatter && SURE * noise < scatter {
        return Err(MeasureError::NotSteady(name.to_owned()));
    }
    for share in STEADY {
        let near = (SURE * scatter.max(noise)).max(share * middle.norm());
        let off = values
            .iter()
            .rposition(|value| near < (value - middle).norm());
        let first = off.map_or(0, |place| place + 1);
        if 3 * first <= 2 * values.len() {
            return Ok(first);
        }
    }
    Err(MeasureError::NotSteady(name.to_owned()))
}
