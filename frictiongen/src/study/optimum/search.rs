//! Finds the friction ratio with which the largest amplitude over a band is smallest.
//!
//! The largest amplitude, as a function of friction, is the maximum of smooth branches. There is one branch for each
//! peak. The largest amplitude jumps at frictions at which the motion reaches another steady state. A scan over
//! friction gives the amplitude and its slope. If the slope is negative at one point and positive at the next, a
//! minimum lies between the two points.
//!
//! A minimum is either a crossing of two peaks or the minimum of one peak. Newton's method on the difference of the two
//! heights finds a crossing. The zero of the slope gives the minimum of one peak. If the search finds neither, golden
//! sections narrow the bracket around the best friction ratio. Golden sections need no slopes.

use super::amplitude::FrictionAmount;
use super::candidates::{FrictionCandidate, HOLDS, before, of_scan, stays};
use super::look::{BandPeak, Closely};
use super::minima::{minima, minimum, narrowed};
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, add, best, closer, scanned, scanned_at, slope, with_slope};
use super::verified::{raise, verified};
use crate::Regime;

/// Largest number of checks of the best friction ratio over the whole band. The search makes a further check if the
/// last check has found a higher peak.
const CHECKS: usize = 6;
/// Largest relative slope at which a peak counts as stationary. The relative slope is the relative change of the
/// amplitude, divided by the relative change of friction.
const STATIONARY: f64 = 1e-4;
/// Bound on the work of a search at one value of a varied number of the scene description, in units of about 10 µs of
/// computing time. The bound corresponds to a few seconds.
pub(super) const WORK_OF_ONE: usize = 300_000;
/// Bound on the work of a search, divided by the bound on the work of its final check.
const OF_A_CHECK: usize = 6;
/// Largest amplitude of a scanned friction that the search evaluates a second time, divided by the best amplitude. The
/// widest tolerance of the friction depends on all amplitudes up to 10 % above the best.
const HIGHEST_TOLERANCE: f64 = 1.12;

/// The type of a minimum of the largest amplitude as a function of friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MinimumKind {
    /// At this minimum two peaks have equal height. With more friction one peak falls, and the other peak rises.
    Crossing,
    /// At this minimum one peak is at its own minimum over friction, or at a jump of its height.
    Smooth,
    /// The largest amplitude is smallest at zero friction.
    Without,
    /// At this minimum the contact is stuck, either at the frequency of the peak or over the whole band.
    Held,
}

/// The event that ended the search: convergence, a jump, or the bound on work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SearchEnd {
    Converged,
    Jump,
    Spent,
}

/// The best friction ratio that a search has found, with its scan over friction.
#[derive(Clone, Debug)]
pub(super) struct Least {
    pub at: Scanned,
    pub kind: MinimumKind,
    pub end: SearchEnd,
    /// Interval of β that contains the best friction ratio. It is the narrowest interval that the search has found.
    pub bracket: [f64; 2],
    pub scan: Vec<Scanned>,
    /// Smallest friction ratio at which a stuck state exists at every frequency of the band.
    pub locked_from: f64,
    pub free_to: f64,
}

/// Finds the friction with which the largest amplitude over the band is smallest. Returns `None` if no friction bounds
/// the amplitude.
pub(super) fn least(band: &AmplitudeBand<'_>, work: usize) -> Option<Least> {
    band.amplitude.allow(work);
    let [free_to, locked_from] = band.limits();
    let mut scan = scanned(band, free_to, locked_from);
    closer(band, &mut scan);
    let spent = band.amplitude.is_spent();
    let best = if 1.0 < band.amplitude.system.scene().stiction {
        band.amplitude.follow_from_rest();
        band.amplitude.allow(work);
        let best = verified(band, &mut scan, locked_from)?;
        band.amplitude.allow(work / OF_A_CHECK);
        raise(band, &mut scan, HIGHEST_TOLERANCE * best.at.value);
        best
    } else {
        let mut candidates = of_scan(&scan);
        candidates.extend(minima(band, &scan, best(&scan)));
        let spent = band.amplitude.is_spent();
        band.amplitude.allow(work / OF_A_CHECK);
        checked(band, &mut scan, candidates, spent)?
    };
    let spent = spent || band.amplitude.is_spent();
    let kind = kind(band, &best.at, locked_from);
    Some(Least {
        end: end(&best.at, kind, spent),
        bracket: if kind == MinimumKind::Without {
            [best.at.beta; 2]
        } else {
            about(best.bracket, best.at.beta)
        },
        at: best.at,
        kind,
        scan,
        locked_from,
        free_to,
    })
}

/// Finds the friction ratio at which the largest amplitude over the band is smallest, between two nearby bounds
/// (`ends`). Returns a result only if the amplitude falls at the first bound and rises at the second.
pub(super) fn near(band: &AmplitudeBand<'_>, ends: [f64; 2]) -> Option<Least> {
    band.amplitude.allow(WORK_OF_ONE);
    let [below, above] = ends.map(|beta| scanned_at(band, beta, f64::INFINITY));
    if !(below.slope < 0.0 && 0.0 <= above.slope) {
        return None;
    }
    let found = minimum(band, below, above, f64::INFINITY)?;
    let (free_to, locked_from) = (0.0, f64::INFINITY);
    let kind = kind(band, &found.at, locked_from);
    Some(Least {
        end: end(&found.at, kind, band.amplitude.is_spent()),
        bracket: about(found.bracket, found.at.beta),
        at: found.at,
        kind,
        scan: Vec::new(),
        locked_from,
        free_to,
    })
}

/// Extends a bracket of friction ratios so that it contains β. If a minimum is flat, the two bounds of the bracket may
/// be closer to each other than the accuracy of β.
fn about([from, to]: [f64; 2], beta: f64) -> [f64; 2] {
    [from.min(beta), to.max(beta)]
}

/// Evaluates the candidates at all frequencies of the band, and returns the best candidate.
fn checked(
    band: &AmplitudeBand<'_>,
    scan: &mut Vec<Scanned>,
    mut candidates: Vec<FrictionCandidate>,
    spent: bool,
) -> Option<FrictionCandidate> {
    let locked = stays(scan);
    for _ in 0..CHECKS {
        let least = candidates.iter_mut().min_by(|a, b| before(a, b, locked))?;
        if least.at.whole || band.amplitude.is_spent() {
            return Some(least.clone());
        }
        let beta = least.at.beta;
        let open = band.open(FrictionAmount::Ratio(beta));
        let look = band.look(open, f64::INFINITY, Closely::Whole);
        let found = with_slope(beta, look, |peak| slope(band, beta, peak));
        let holds = found.value <= least.at.value * (1.0 + HOLDS);
        if !found.complete {
            least.at.value = least.at.value.max(found.value);
            least.at.whole = true;
            continue;
        }
        let bracket = least.bracket;
        least.at = Scanned {
            whole: true,
            ..found
        };
        if holds || spent {
            continue;
        }
        // The first evaluation, at only some frequencies, has missed a peak. Later evaluations therefore include the
        // frequencies of all peaks at this friction ratio.
        for peak in &least.at.peaks {
            band.learn(peak.r);
        }
        let from = least.at.clone();
        scan.retain(|scanned| !bracket.contains(&scanned.beta) && scanned.beta != beta);
        add(band, scan, bracket.into_iter().chain([beta]));
        let beside = |wanted: f64| scan.iter().find(|scanned| scanned.beta == wanted).cloned();
        let [below, above] = bracket.map(|beta| beside(beta).unwrap_or_else(|| from.clone()));
        if below.beta < above.beta {
            candidates.push(narrowed(band, (&below, &above), Some(from)));
        }
    }
    let least = candidates.into_iter().min_by(|a, b| before(a, b, locked));
    least.filter(|least| least.at.value.is_finite())
}

fn end(least: &Scanned, kind: MinimumKind, spent: bool) -> SearchEnd {
    let stationary = (least.slope * least.beta).abs() <= STATIONARY * least.value;
    match kind {
        _ if spent => SearchEnd::Spent,
        MinimumKind::Smooth if !stationary => SearchEnd::Jump,
        _ => SearchEnd::Converged,
    }
}

fn kind(band: &AmplitudeBand<'_>, least: &Scanned, locked_from: f64) -> MinimumKind {
    let equal: Vec<&BandPeak> = least
        .peaks
        .iter()
        .filter(|peak| least.value * (1.0 - 1e-9) <= peak.value)
        .collect();
    let stuck = |peak: &&BandPeak| {
        band.amplitude
            .regime(peak.r, FrictionAmount::Ratio(least.beta))
            == Regime::Stuck
    };
    if least.beta == 0.0 {
        MinimumKind::Without
    } else if (band.amplitude.locks() && locked_from <= least.beta)
        || (least.slope == 0.0 && equal.iter().all(stuck))
    {
        MinimumKind::Held
    } else if equal.len() > 1 {
        MinimumKind::Crossing
    } else {
        MinimumKind::Smooth
    }
}
