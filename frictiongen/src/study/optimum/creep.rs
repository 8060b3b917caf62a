//! Finds the friction ratio at which the highest peak of the amplitude is lowest, within a given interval of friction
//! ratios. The search tracks each peak while friction changes.

use super::amplitude::FrictionAmount;
use super::look::{BandPeak, Look};
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, slope, with_slope};

/// Largest number of peaks that the search tracks from each of the two friction ratios that enclose the minimum.
const MOST_FOLLOWED: usize = 6;
/// Largest number of steps of the search towards one minimum.
const STEPS: usize = 40;
/// Largest relative difference of the heights at which two peaks are treated as equally high.
const EQUAL: f64 = 2e-13;

/// Returns the friction ratio at which the tangents at two points of the amplitude curve over friction meet, and the
/// amplitude at this friction ratio.
pub(super) fn meeting(below: &Scanned, above: &Scanned) -> Option<(f64, f64)> {
    let rise = below.slope - above.slope;
    let beta =
        (above.value - below.value + below.slope * below.beta - above.slope * above.beta) / rise;
    let value = below.value + below.slope * (beta - below.beta);
    (below.beta < beta && beta < above.beta).then_some((beta, value))
}

/// Result of a search that tracks the peaks from both sides of a minimum.
pub(super) struct Crept {
    pub best: Scanned,
    /// The two friction ratios that enclose the minimum: at `below` the amplitude falls with friction, and at `above`
    /// it rises.
    pub below: Scanned,
    pub above: Scanned,
    /// True if the search has reached the minimum of the tracked peaks.
    pub done: bool,
}

/// Searches the interval from `below.beta` to `above.beta` for the friction ratio at which the highest peak of the
/// amplitude is lowest. The search tracks the peaks that exist at the two ends of the interval.
pub(super) fn crept(band: &AmplitudeBand<'_>, below: &Scanned, above: &Scanned) -> Option<Crept> {
    let (mut below, mut above) = (below.clone(), above.clone());
    let mut best: Option<Scanned> = None;
    let mut next = None;
    let (mut stale, mut done) = (0_u32, false);
    for _ in 0..STEPS {
        let width = above.beta - below.beta;
        if width <= 1e-14 * above.beta || band.amplitude.is_spent() {
            break;
        }
        let inside = |beta: &f64| below.beta < *beta && *beta < above.beta;
        let met = meeting(&below, &above);
        // If the two friction ratios have the same highest peak, the minimum is at the zero of the slope of this peak.
        // If the highest peaks are different, the minimum is where the two peaks have equal heights.
        let (a, b) = (below.peaks.first(), above.peaks.first());
        let one = matches!((a, b), (Some(a), Some(b)) if (a.r - b.r).abs() <= 0.02 * a.r);
        let zero = below.beta - below.slope * width / (above.slope - below.slope);
        let guess = if one {
            Some(zero)
        } else {
            met.map(|(beta, _)| beta)
        };
        let middle = 0.5 * (below.beta + above.beta);
        let beta = next
            .take()
            .or(guess)
            .filter(|_| stale < 4)
            .filter(inside)
            .unwrap_or(middle);
        let seeds: Vec<f64> = below
            .peaks
            .iter()
            .take(MOST_FOLLOWED)
            .chain(above.peaks.iter().take(MOST_FOLLOWED))
            .filter(|peak| peak.value.is_finite())
            .map(|peak| peak.r)
            .collect();
        let peaks = band.followed(FrictionAmount::Ratio(beta), &distinct(seeds), f64::INFINITY);
        let look = Look {
            peaks,
            complete: !band.amplitude.is_spent(),
        };
        let here = with_slope(beta, look, |peak| slope(band, beta, peak));
        if best.as_ref().is_none_or(|best| here.value < best.value) {
            best = Some(here.clone());
        }
        if here.slope == 0.0 && here.value.is_finite() {
            done = true;
            break;
        }
        let falls = here.slope < 0.0 || !here.value.is_finite();
        // The second peak grows while the highest peak falls. At the minimum the two peaks have the same height.
        let other = if falls { &above } else { &below };
        let partner = other.peaks.first().and_then(|known| {
            let distance = |peak: &&BandPeak| (peak.r - known.r).abs();
            let others = here.peaks.iter().skip(1);
            others.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        });
        if let (Some(top), Some(partner)) = (here.peaks.first(), partner)
            && 0.5 * top.value < partner.value
        {
            let other_slope = slope(band, beta, partner);
            if here.slope * other_slope < 0.0 {
                let apart = top.value - partner.value;
                if apart <= EQUAL * top.value {
                    best = Some(here);
                    done = true;
                    break;
                }
                next = Some(beta - apart / (here.slope - other_slope));
            }
        } else if one {
            // No suitable second peak is more than half as high as the highest peak. The next step therefore uses the
            // friction ratio at which the slope of the highest peak is zero.
            next = None;
        }
        let before = width;
        if falls {
            below = here;
        } else {
            above = here;
        }
        stale = if above.beta - below.beta < 0.5 * before {
            0
        } else {
            stale + 1
        };
        if stale > 4 {
            stale = 0;
        }
        if one && (above.beta - below.beta) <= 1e-9 * above.beta {
            done = true;
            break;
        }
    }
    let best = best.filter(|best| best.value.is_finite())?;
    Some(Crept {
        best,
        below,
        above,
        done,
    })
}

/// Removes each frequency ratio that is too close to another one. Searches from two close frequency ratios would
/// probably lead to the same peak.
fn distinct(mut places: Vec<f64>) -> Vec<f64> {
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() <= 1e-3 * a.abs());
    places
}
