//! Computes the tolerances of an optimum: intervals of friction around it. A wide interval means that the optimum is
//! flat.

use super::amplitude::FrictionAmount;
use super::answer::Tolerance;
use super::peaks::AmplitudeBand;
use super::scan::Scanned;
use super::search::{Least, SearchEnd};

/// Largest number of steps towards one bound of an interval of friction.
const STEPS: usize = 40;
/// Relative tolerance, in β, of the bound of an interval of friction.
const NEAR: f64 = 1e-8;
/// Relative tolerance, in β, of the bound of an interval of friction if the search for the optimum has not converged.
const ROUGHLY: f64 = 1e-3;
/// Largest number of peaks that the search tracks from each friction ratio whose peaks are known.
const MOST_FOLLOWED: usize = 3;
/// Bound on the work of finding one bound of an interval of friction, in units of about 10 µs of computing time.
const WORK: usize = 12_000;

/// Returns an interval of friction around the optimum. In this interval, the largest amplitude exceeds the best
/// amplitude by at most the fraction `excess` of the best amplitude.
pub(super) fn tolerance(band: &AmplitudeBand<'_>, least: &Least, excess: f64) -> Tolerance {
    let level = least.at.value * (1.0 + excess);
    if level == 0.0 {
        // The best amplitude is 0. Any fraction of it is 0 too.
        let (from, to) = (least.at.beta, f64::INFINITY);
        return Tolerance { excess, from, to };
    }
    let within = |scanned: &Scanned| scanned.value <= level;
    let below = least.scan.iter().rev();
    let mut below = below.filter(|scanned| scanned.beta < least.at.beta);
    let near = if least.end == SearchEnd::Converged {
        NEAR
    } else {
        ROUGHLY
    };
    let from = edge(band, &least.at, &mut below, (level, near)).unwrap_or(0.0);
    let above = least.scan.iter();
    let mut above = above.filter(|scanned| least.at.beta < scanned.beta);
    let to = match edge(band, &least.at, &mut above, (level, near)) {
        Some(to) => to,
        // The amplitude is within the tolerance at all further points of the scan, and also if the contact is stuck
        // over the whole band.
        None if least.locked_from.is_finite() => f64::INFINITY,
        None => least
            .scan
            .iter()
            .rev()
            .find(|scanned| within(scanned))
            .map_or(least.at.beta, |scanned| scanned.beta),
    };
    Tolerance { excess, from, to }
}

/// Returns the friction ratio at which the largest amplitude over the band reaches `level`. The search begins at the
/// optimum and moves away from it. Returns `None` if no scanned amplitude exceeds the level.
fn edge<'a>(
    band: &AmplitudeBand<'_>,
    best: &'a Scanned,
    outwards: &mut dyn Iterator<Item = &'a Scanned>,
    (level, near): (f64, f64),
) -> Option<f64> {
    band.amplitude.allow(WORK);
    let mut inside = best;
    let outside = loop {
        let scanned = outwards.next()?;
        if scanned.value <= level {
            inside = scanned;
        } else {
            break scanned;
        }
    };
    let seeds: Vec<f64> = [inside, outside, best]
        .iter()
        .flat_map(|scanned| scanned.peaks.iter().take(MOST_FOLLOWED))
        .map(|peak| peak.r)
        .collect();
    let above = |beta: f64| {
        let peaks = band.followed(FrictionAmount::Ratio(beta), &seeds, level);
        peaks.first().map_or(f64::INFINITY, |peak| peak.value) - level
    };
    let (mut a, mut at_a) = (inside.beta, inside.value - level);
    let (mut b, mut at_b) = (outside.beta, outside.value - level);
    // The search uses regula falsi with the Illinois rule. If the amplitude at one bound is infinite, the search
    // bisects.
    for _ in 0..STEPS {
        if (b - a).abs() <= near * b.abs() || band.amplitude.is_spent() {
            break;
        }
        let mut middle = b - at_b * (b - a) / (at_b - at_a);
        if !(middle.is_finite() && (middle - a) * (middle - b) < 0.0) {
            middle = 0.5 * (a + b);
        }
        let value = above(middle);
        if value <= 0.0 {
            at_b = if at_b.is_finite() { 0.5 * at_b } else { at_b };
            (a, at_a) = (middle, value);
        } else {
            at_a *= 0.5;
            (b, at_b) = (middle, value);
        }
        if value == 0.0 {
            break;
        }
    }
    Some(a)
}
