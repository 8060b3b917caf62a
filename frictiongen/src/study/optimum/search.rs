//! The friction ratio at which the largest amplitude over a band is smallest.
//!
//! That amplitude is a maximum of smooth branches, one for each peak.  A scan over friction, both ends included, gives its
//! value and slope; where the slope changes from falling to rising there is a minimum between.  It is a crossing of two
//! peaks, found by Newton's method on their difference, or one peak's own minimum, the zero of its slope.

use super::amplitude::Friction;
use super::peaks::{Band, Peak};
use super::scan::{Scanned, closer, scanned, scanned_at, slope, with_slope};

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
/// A minimum in which a higher peak turns up is looked for again so often.
const AGAIN: usize = 4;
/// Where peaks cannot be followed, friction is halved so often.
const HALVINGS: usize = 32;

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
    let scan = closer(band, scanned(band, free_to, locked_from));
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

/// The least between two friction ratios near by, if the amplitude falls from one and rises to the other.
pub(super) fn near(band: &Band<'_>, ends: [f64; 2]) -> Option<Least> {
    let [below, above] = ends.map(|beta| scanned_at(band, beta));
    if !(below.slope < 0.0 && 0.0 <= above.slope) {
        return None;
    }
    let at = minimum(band, below, above)?;
    let (free_to, locked_from) = (0.0, f64::INFINITY);
    let kind = kind(band, &at, locked_from);
    Some(Least {
        at,
        kind,
        scan: Vec::new(),
        locked_from,
        free_to,
    })
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
            // Where the tangents do not meet between, the amplitude is not convex there, and they tell nothing.
            let low = meeting(below, above).map_or(least, |(_, value)| value.max(least));
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
