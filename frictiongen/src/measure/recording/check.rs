//! Checks of the samples, which reject unusable recordings.

use super::Channel;
use super::unit::Dimension;
use crate::measure::MeasureError;
use std::f64::consts::PI;

/// Smallest number of samples in a usable recording.
const FEWEST: usize = 16;
/// Number of equal successive samples that make an interval of a signal flat.
const FLAT: usize = 4;
/// Number of flat intervals at one value that a clipped channel must have. Fewer flat intervals may be due to chance.
const PLACES: i32 = 2;
/// Length of the interval just before a flat interval from which the code computes the slope of the signal, as a
/// fraction of a cycle.
const BEFORE: f64 = 0.02;
/// A channel can be clipped only if the slope just before a flat interval, divided by the largest slope in a cycle, is
/// above this number.
const STEEP: f64 = 0.1;
/// A channel is clipped only if the quotient of two slopes before a flat interval is above this number. The first
/// slope is that over the interval [`BEFORE`] just before the flat interval. The second slope is that over twice this
/// interval. Before a stop of the contact the quotient is 0.5, because the motion is then a parabola. Before clipping
/// it is nearly 1. For a sinusoid clipped at 0.99 of its amplitude it is 0.75.
const STRAIGHT: f64 = 0.7;
/// Largest acceleration next to a flat interval that rounding of the samples can explain, divided by ω²A, for a
/// sinusoid of amplitude A. With this acceleration, the signal approaches the flat interval on a parabola. At the
/// distance g of the next rounded value, the slope divided by ωA is √(2·`HARD`·g/A). Only a larger slope is a sign of
/// clipping.
const HARD: f64 = 10.0;

/// Fails unless the channels are a usable recording: enough finite samples, no constant channel and no clipped channel.
pub(super) fn channels(channels: &[Channel]) -> Result<(), MeasureError> {
    form(channels, FEWEST)?;
    channels.iter().try_for_each(samples)
}

/// Fails unless at least one channel exists, all names are distinct, and all samples are finite. All channels must
/// have the same number of samples, at least `fewest`.
pub(super) fn form(channels: &[Channel], fewest: usize) -> Result<(), MeasureError> {
    let Some(first) = channels.first() else {
        return Err(MeasureError::TooShort {
            found: "it has no channel".to_owned(),
            needed: if fewest == FEWEST { "two" } else { "one" },
        });
    };
    let count = first.samples.len();
    if count < fewest {
        return Err(MeasureError::TooShort {
            found: match count {
                0 => "no samples".to_owned(),
                1 => "1 sample".to_owned(),
                count => format!("{count} samples"),
            },
            needed: if fewest == FEWEST { "16" } else { "2" },
        });
    }
    for (index, channel) in channels.iter().enumerate() {
        let before = channels.iter().take(index);
        if before.into_iter().any(|other| other.name == channel.name) {
            return Err(MeasureError::Twice(channel.name.clone()));
        }
        if channel.unit.dimension() == Dimension::Time {
            return Err(MeasureError::WrongDimension {
                channel: channel.name.clone(),
                unit: channel.unit.name(),
                needed: "a motion or a force; only a column `time` or `t` has the times of the samples",
            });
        }
        if channel.samples.len() != count {
            return Err(MeasureError::Lengths(channel.name.clone()));
        }
        let values = channel.samples.iter();
        if let Some(sample) = values.into_iter().position(|value| !value.is_finite()) {
            return Err(MeasureError::NotFinite {
                channel: channel.name.clone(),
                sample,
            });
        }
    }
    Ok(())
}

fn samples(channel: &Channel) -> Result<(), MeasureError> {
    let values = &channel.samples;
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(*value), high.max(*value))
        });
    if low == high {
        return Err(MeasureError::Constant(channel.name.clone()));
    }
    for value in [high, low] {
        if let Some(share) = clipped(values, value, 0.5 * (low + high)) {
            return Err(MeasureError::Clipped {
                channel: channel.name.clone(),
                value,
                share,
            });
        }
    }
    Ok(())
}

/// Returns the fraction of the samples that are clipped at the value `extreme`. Returns `None` if the channel is not
/// clipped.
///
/// A signal that is not clipped can be flat at an extreme, because of rounding of the samples or a stop of the contact.
/// In these two cases the signal approaches the extreme slowly.
fn clipped(values: &[f64], extreme: f64, middle: f64) -> Option<f64> {
    let crossings = values
        .windows(2)
        .filter(|pair| matches!(pair, [a, b] if (*a < middle) != (*b < middle)))
        .count();
    // A cycle has two crossings of the mean. Noise adds crossings, so that the cycle seems shorter. In a noisy
    // recording, the code therefore detects fewer clipped channels.
    let cycle = 2.0 * values.len() as f64 / crossings.max(1) as f64;
    let reach = ((BEFORE * cycle).ceil() as usize).max(2);
    let largest = (extreme - middle).abs() * 2.0 * PI / cycle;
    let size = (extreme - middle).abs();
    let gaps = values.iter().map(|value| (value - extreme).abs());
    let gap = gaps.filter(|gap| 0.0 < *gap).fold(f64::INFINITY, f64::min);
    let (mut near, mut far, mut places) = (0.0, 0.0, 0);
    let (mut flat, mut start) = (0, 0);
    for group in values.chunk_by(|a, b| a == b) {
        let at = start;
        start += group.len();
        if group.first() != Some(&extreme) || group.len() < FLAT {
            continue;
        }
        flat += group.len();
        // The code computes the slope up to the last sample before the flat interval. At the first flat sample, the
        // true signal may be anywhere beyond the clipped value.
        let slope = |reach: usize| {
            let last = values.get(at.checked_sub(1)?)?;
            let before = values.get(at.checked_sub(1 + reach)?)?;
            Some((last - before).abs() / (reach as f64 * largest))
        };
        if let (Some(one), Some(two)) = (slope(reach), slope(2 * reach)) {
            near += one;
            far += two;
            places += 1;
        }
    }
    let least = STEEP.max((2.0 * HARD * gap / size).sqrt()) * f64::from(places);
    let steep = least < near && STRAIGHT * far < near;
    (PLACES <= places && steep).then(|| flat as f64 / values.len() as f64)
}
