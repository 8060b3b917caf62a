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
use super::bounded::lowest;
use super::look::BandPeak;
use super::minima::{minimum, narrowed};
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned, scanned_at};
use crate::Regime;

/// Largest relative slope at which a peak counts as stationary. The relative slope is the relative change of the
/// amplitude, divided by the relative change of friction.
const STATIONARY: f64 = 1e-4;
/// Bound on the work of a search at one value of a varied number of the scene description, in units of about 10 µs of
/// computing time. The bound corresponds to a few seconds.
pub(super) const WORK_OF_ONE: usize = 300_000;
/// Bound on the work of a search, divided by the bound on the work of the last look at its scan.
const OF_LAST: usize = 6;
/// Largest relative change of a continuous amplitude, divided by the relative change of friction.
const STEEPEST: f64 = 50.0;
/// Number of bisections in the search for the smallest friction ratio with an amplitude of 0.
const HALVINGS: u32 = 12;
/// Largest relative difference of the heights at which two peaks count as equal. Golden sections end at a relative
/// width of 1e-7 of the friction, and a peak may change with friction fifty times as fast.
pub(super) const EQUAL: f64 = 1e-5;
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
    /// Largest amplitude just beyond the jump at which the search ended.
    pub beyond: Option<f64>,
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
    let spent = band.amplitude.is_spent();
    band.amplitude.allow(work);
    let (mut at, bracket) = lowest(band, &scan)?;
    let spent = spent || band.amplitude.is_spent();
    band.amplitude.allow(work / OF_LAST);
    if at.value == 0.0 && 1.0 < band.amplitude.system.scene().stiction {
        at = least_trivial(band, &scan, at);
    }
    raise(band, &mut scan, HIGHEST_TOLERANCE * at.value);
    let kind = kind(band, &at, locked_from);
    let bracket = if kind == MinimumKind::Without {
        [at.beta; 2]
    } else {
        about(bracket, at.beta)
    };
    let least = Least {
        end: SearchEnd::Converged,
        beyond: None,
        at,
        kind,
        bracket,
        scan,
        locked_from,
        free_to,
    };
    Some(ended(band, least, spent))
}

/// Finds the friction ratio at which the largest amplitude over the band is smallest, between two nearby bounds
/// (`ends`). Returns a result only if the amplitude falls at the first bound and rises at the second.
pub(super) fn near(band: &AmplitudeBand<'_>, ends: [f64; 2]) -> Option<Least> {
    band.amplitude.allow(WORK_OF_ONE);
    let [below, above] = ends.map(|beta| scanned_at(band, beta, f64::INFINITY));
    if !(below.slope < 0.0 && 0.0 <= above.slope) {
        return None;
    }
    let ends = [below.clone(), above.clone()];
    let found = minimum(band, below, above, f64::INFINITY);
    let [below, above] = &ends;
    let (at, bracket) = found.unwrap_or_else(|| narrowed(band, (below, above), None));
    let (free_to, locked_from) = (0.0, f64::INFINITY);
    let least = Least {
        end: SearchEnd::Converged,
        beyond: None,
        bracket: about(bracket, at.beta),
        kind: kind(band, &at, locked_from),
        at,
        scan: Vec::new(),
        locked_from,
        free_to,
    };
    Some(ended(band, least, band.amplitude.is_spent()))
}

/// Extends a bracket of friction ratios so that it contains β. If a minimum is flat, the two bounds of the bracket may
/// be closer to each other than the accuracy of β.
fn about([from, to]: [f64; 2], beta: f64) -> [f64; 2] {
    [from.min(beta), to.max(beta)]
}

/// Returns the smallest friction ratio with an amplitude of 0. The amplitude at the friction ratio of `at` is 0.
fn least_trivial(band: &AmplitudeBand<'_>, scan: &[Scanned], at: Scanned) -> Scanned {
    let moves = scan.iter().filter(|other| !(other.value == 0.0));
    let below = moves
        .map(|other| other.beta)
        .filter(|other| *other < at.beta);
    let (mut from, mut to) = (below.fold(0.0, f64::max), at);
    for _ in 0..HALVINGS {
        let here = scanned_at(band, 0.5 * (from + to.beta), 0.0);
        if here.complete && here.value == 0.0 {
            to = here;
        } else {
            from = here.beta;
        }
    }
    to
}

/// Recomputes the amplitude of each scanned friction ratio whose amplitude is at most `level`, and keeps the larger
/// amplitude. The earlier amplitude is only a lower bound. The new evaluation includes the frequencies of the peaks
/// that the checks of the whole band found.
fn raise(band: &AmplitudeBand<'_>, scan: &mut [Scanned], level: f64) {
    if band.learned() == 0 {
        return;
    }
    for seen in scan
        .iter_mut()
        .filter(|seen| seen.complete && seen.value <= level)
    {
        let again = scanned_at(band, seen.beta, level);
        if seen.value < again.value {
            *seen = again;
        }
    }
}

/// Sets the event that ended the search. At a jump, the amplitude at a bound of the bracket exceeds the best amplitude by
/// more than a continuous amplitude can.
fn ended(band: &AmplitudeBand<'_>, least: Least, spent: bool) -> Least {
    let Scanned { beta, value, .. } = least.at;
    let stationary = (least.at.slope * beta).abs() <= STATIONARY * value;
    if spent || stationary || least.kind != MinimumKind::Smooth {
        let end = if spent {
            SearchEnd::Spent
        } else {
            SearchEnd::Converged
        };
        return Least { end, ..least };
    }
    let others = least.bracket.into_iter().filter(|other| *other != beta);
    let beyond = others.map(|other| {
        let steady = value * (1.0 + STEEPEST * (other / beta).ln().abs());
        let there = scanned_at(band, other, f64::INFINITY).value;
        if steady < there { there } else { f64::NAN }
    });
    let beyond = Some(beyond.fold(f64::NAN, f64::max)).filter(|beyond| !beyond.is_nan());
    let end = if beyond.is_some() {
        SearchEnd::Jump
    } else {
        SearchEnd::Converged
    };
    Least {
        end,
        beyond,
        ..least
    }
}

fn kind(band: &AmplitudeBand<'_>, least: &Scanned, locked_from: f64) -> MinimumKind {
    let equal: Vec<&BandPeak> = least
        .peaks
        .iter()
        .filter(|peak| least.value * (1.0 - EQUAL) <= peak.value)
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
