//! The friction ratio at which the largest amplitude over a band is smallest.
//!
//! That amplitude is a maximum of smooth branches, one for each peak.  A scan over friction, both ends included, gives its
//! value and slope; where the slope changes from falling to rising there is a minimum between.  It is a crossing of two
//! peaks, found by Newton's method on their difference, or one peak's own minimum, the zero of its slope.

use super::amplitude::Friction;
use super::peaks::{Band, Peak};
use crate::study::system::System;

/// Friction ratios of the scan.
const SCAN: usize = 40;
/// A place between two of the scan is looked into if their tangents meet below this share of the best.
const WORTH: f64 = 1.05;
/// So many of them are looked into, those that promise most.
const MOST_LOOKED_INTO: usize = 8;
/// No minimum is expected below this share of the values beside it.
const SHARE: f64 = 0.7;
/// So many peaks are followed.
const MOST_FOLLOWED: usize = 6;
/// Steps towards a minimum at most.
const STEPS: usize = 40;
/// Peaks that differ by less are equal.
const EQUAL: f64 = 2e-13;
/// Of a moving place a step of a difference.
const DIFFERENCE: f64 = 1e-6;
/// A minimum in which a higher peak turns up is looked for again so often.
const AGAIN: usize = 4;
/// Where peaks cannot be followed, friction is halved so often.
const HALVINGS: usize = 32;
/// How often a scan without an end is made twice as long.
const LONGER: usize = 12;

/// The largest amplitude at one friction ratio.
#[derive(Clone, Debug)]
pub(super) struct Scanned {
    pub beta: f64,
    pub value: f64,
    /// Its derivative with respect to β; NaN where the amplitude is unbounded.
    pub slope: f64,
    pub peaks: Vec<Peak>,
}

/// What kind of a minimum it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Two peaks are equal: one falls with friction, the other rises.
    Crossing,
    /// One peak at its own minimum.
    Smooth,
    /// No friction.
    Without,
    /// The contact stuck at the frequency of the peak, or all over the band.
    Held,
}

/// The friction ratio found.
#[derive(Clone, Debug)]
pub(super) struct Least {
    pub at: Scanned,
    pub kind: Kind,
    pub scan: Vec<Scanned>,
    /// From here on the contact is stuck over the whole band.
    pub locked_from: f64,
    pub free_to: f64,
}

/// The least over all friction, if some friction bounds the amplitude.
pub(super) fn least(band: &Band<'_>) -> Option<Least> {
    let [free_to, locked_from] = band.limits();
    let scan = scanned(band, free_to, locked_from);
    let mut best = scan
        .iter()
        .filter(|scanned| scanned.value.is_finite())
        .min_by(|a, b| a.value.total_cmp(&b.value))?
        .clone();
    // Nothing is less than rest; just below the friction that holds all, motions too small to settle lead there.
    let worth = if best.value == 0.0 {
        Vec::new()
    } else {
        between(&scan, best.value)
    };
    for (below, above) in worth {
        if let Some(found) = minimum(band, below, above)
            && found.value < best.value
        {
            best = found;
        }
    }
    let kind = kind(band, &best, locked_from);
    Some(Least {
        at: best,
        kind,
        scan,
        locked_from,
        free_to,
    })
}

/// Up to this friction ratio the amplitude at an undamped resonance of the band is unbounded; 0 where there is none.
pub(super) fn unbounded_to(system: &System, [from, to]: [f64; 2]) -> f64 {
    let modal = system.modal();
    let modes = modal.damping_ratios.iter().zip(system.resonances());
    let modes = modes.zip(system.resonance_thresholds());
    modes
        .filter(|((zeta, resonance), _)| zeta.is_zero() && from <= **resonance && **resonance <= to)
        .filter_map(|(_, threshold)| threshold)
        .fold(0.0, f64::max)
}

fn scanned(band: &Band<'_>, free_to: f64, locked_from: f64) -> Vec<Scanned> {
    let at = |beta: f64| scanned_at(band, beta);
    let mut top = if locked_from.is_finite() {
        locked_from
    } else {
        let unbounded_to = unbounded_to(band.amplitude.system, band.ends());
        (4.0 * free_to.max(1.0)).max(2.0 * unbounded_to)
    };
    let mut scan: Vec<Scanned> = (0..=SCAN)
        .map(|place| top * (place as f64 / SCAN as f64).powf(1.5))
        .chain([free_to])
        .filter(|beta| *beta < top)
        .map(at)
        .collect();
    if locked_from.is_finite() {
        let peaks = band.peaks(Friction::Locked);
        scan.push(Scanned {
            beta: top,
            value: peaks.first().map_or(f64::INFINITY, |peak| peak.value),
            slope: 0.0,
            peaks,
        });
    } else {
        // Beside a resonance of the stuck chain nothing holds the contact: until friction no longer helps.
        for _ in 0..LONGER {
            for share in [1.0, 1.25, 1.5, 1.75] {
                scan.push(at(top * share));
            }
            top *= 2.0;
            let rising = |scanned: &Scanned| 0.0 < scanned.slope;
            if scan.iter().rev().take(4).all(rising) {
                break;
            }
        }
    }
    scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
    scan.dedup_by(|a, b| a.beta == b.beta);
    scan
}

fn scanned_at(band: &Band<'_>, beta: f64) -> Scanned {
    let peaks = band.peaks(Friction::Ratio(beta));
    with_slope(beta, peaks, |peak| rough_slope(band, beta, peak))
}

fn with_slope(beta: f64, peaks: Vec<Peak>, slope: impl Fn(&Peak) -> f64) -> Scanned {
    let value = peaks.first().map_or(f64::NAN, |peak| peak.value);
    let slope = peaks
        .first()
        .filter(|peak| peak.value.is_finite())
        .map_or(f64::NAN, slope);
    Scanned {
        beta,
        value,
        slope,
        peaks,
    }
}

/// Neighbours of the scan between which there is a minimum that may be the least.
fn between(scan: &[Scanned], best: f64) -> Vec<(Scanned, Scanned)> {
    let pairs = scan.windows(2).filter_map(|pair| match pair {
        [below, above] => Some((below, above)),
        _ => None,
    });
    let mut found: Vec<(f64, (Scanned, Scanned))> = pairs
        .filter_map(|(below, above)| {
            if !(above.value.is_finite() && 0.0 <= above.slope) {
                return None;
            }
            if !below.value.is_finite() {
                // Beyond the friction that bounds a resonance.
                return Some((0.0, (below.clone(), above.clone())));
            }
            let falls = below.slope < 0.0;
            // Where steady states change, a slope of a place says nothing of the next.
            let least = SHARE * below.value.min(above.value);
            let low = meeting(below, above).map_or(above.value, |(_, value)| value.max(least));
            (falls && low <= WORTH * best).then(|| (low, (below.clone(), above.clone())))
        })
        .collect();
    found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    found
        .into_iter()
        .take(MOST_LOOKED_INTO)
        .map(|(_, pair)| pair)
        .collect()
}

/// Where the tangents meet, and at what.
fn meeting(below: &Scanned, above: &Scanned) -> Option<(f64, f64)> {
    let rise = below.slope - above.slope;
    let beta =
        (above.value - below.value + below.slope * below.beta - above.slope * above.beta) / rise;
    let value = below.value + below.slope * (beta - below.beta);
    (below.beta < beta && beta < above.beta).then_some((beta, value))
}

/// The minimum between two friction ratios, looked at once more over the whole band.
fn minimum(band: &Band<'_>, mut below: Scanned, mut above: Scanned) -> Option<Scanned> {
    for _ in 0..AGAIN {
        let Some(found) = crept(band, &below, &above) else {
            break;
        };
        let all = band.peaks(Friction::Ratio(found.beta));
        let top = all.first()?;
        if top.value <= found.value * (1.0 + 1e-10) {
            return Some(found);
        }
        // A peak that neither side has had.
        let scanned = with_slope(found.beta, all, |peak| slope(band, found.beta, peak));
        if scanned.slope < 0.0 {
            below = scanned;
        } else {
            above = scanned;
        }
    }
    halved(band, below, above)
}

/// The same over the whole band at every step, by halves: where steady states come and go, peaks cannot be followed.
fn halved(band: &Band<'_>, mut below: Scanned, mut above: Scanned) -> Option<Scanned> {
    for _ in 0..HALVINGS {
        let here = scanned_at(band, 0.5 * (below.beta + above.beta));
        if here.slope < 0.0 || !here.value.is_finite() {
            below = here;
        } else {
            above = here;
        }
    }
    let best = if below.value < above.value {
        below
    } else {
        above
    };
    best.value.is_finite().then_some(best)
}

/// The minimum of the peaks that either side has.
fn crept(band: &Band<'_>, below: &Scanned, above: &Scanned) -> Option<Scanned> {
    let (mut below, mut above) = (below.clone(), above.clone());
    let mut best: Option<Scanned> = None;
    let mut next = None;
    let mut stale = 0_u32;
    for _ in 0..STEPS {
        let width = above.beta - below.beta;
        if width <= 1e-14 * above.beta {
            break;
        }
        let inside = |beta: &f64| below.beta < *beta && *beta < above.beta;
        let met = meeting(&below, &above);
        // One peak on both sides: the zero of its slope; two: where they are equal.
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
        let peaks = band.followed(Friction::Ratio(beta), &distinct(seeds));
        let here = with_slope(beta, peaks, |peak| slope(band, beta, peak));
        if best.as_ref().is_none_or(|best| here.value < best.value) {
            best = Some(here.clone());
        }
        if here.slope == 0.0 && here.value.is_finite() {
            break;
        }
        let falls = here.slope < 0.0 || !here.value.is_finite();
        // The peak that goes the other way, and where the two are equal.
        let other = if falls { &above } else { &below };
        let partner = other.peaks.first().and_then(|known| {
            let distance = |peak: &&Peak| (peak.r - known.r).abs();
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
                    break;
                }
                next = Some(beta - apart / (here.slope - other_slope));
            }
        } else if one {
            // The slope's zero from this side, once both sides are near.
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
            break;
        }
    }
    best.filter(|best| best.value.is_finite())
}

/// Places of which no two lead to the same peak, as far as they tell.
fn distinct(mut places: Vec<f64>) -> Vec<f64> {
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() <= 1e-3 * a.abs());
    places
}

/// The derivative of a peak's height with respect to β.
pub(super) fn slope(band: &Band<'_>, beta: f64, peak: &Peak) -> f64 {
    if let Some([along_r, along_beta]) = band.amplitude.slopes(peak.r, beta)
        && (peak.edge || is_smooth(band, beta, peak, along_r))
    {
        return along_beta;
    }
    // It moves along a jump: as it is followed.
    let h = DIFFERENCE * beta;
    let at = |beta: f64| {
        let peaks = band.followed(Friction::Ratio(beta), &[peak.r]);
        let distance = |other: &&Peak| (other.r - peak.r).abs();
        peaks
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .map_or(f64::NAN, |peak| peak.value)
    };
    (at(beta + h) - at(beta - h)) / (h + h)
}

/// Whether a maximum is one of a smooth function: beside it the tangent tells nothing.
fn is_smooth(band: &Band<'_>, beta: f64, peak: &Peak, along_r: f64) -> bool {
    if along_r.abs() * peak.r <= 1e-7 * peak.value {
        return true;
    }
    let step = 1e-6 * peak.r;
    let fall = |r: f64| peak.value - band.amplitude.at(r, Friction::Ratio(beta));
    let fallen = fall(peak.r - step).max(fall(peak.r + step));
    along_r.abs() * step <= 0.1 * fallen
}

/// The same by a difference at the peak's place.
fn rough_slope(band: &Band<'_>, beta: f64, peak: &Peak) -> f64 {
    let at = |beta: f64| band.amplitude.at(peak.r, Friction::Ratio(beta));
    if beta == 0.0 {
        let h = 1e-6;
        return (at(h) - peak.value) / h;
    }
    let h = 1e-5 * beta;
    (at(beta + h) - at(beta - h)) / (h + h)
}

fn kind(band: &Band<'_>, least: &Scanned, locked_from: f64) -> Kind {
    let equal: Vec<&Peak> = least
        .peaks
        .iter()
        .filter(|peak| least.value * (1.0 - 1e-9) <= peak.value)
        .collect();
    let stuck = |peak: &&Peak| {
        band.amplitude.regime(peak.r, Friction::Ratio(least.beta)) == crate::Regime::Stuck
    };
    if least.beta == 0.0 {
        Kind::Without
    } else if locked_from <= least.beta || (least.slope == 0.0 && equal.iter().all(stuck)) {
        Kind::Held
    } else if equal.len() > 1 {
        Kind::Crossing
    } else {
        Kind::Smooth
    }
}
