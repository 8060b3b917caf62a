//! Checks friction ratios on a fine grid of the band, for scenes with μ > 1.
//!
//! With μ > 1 motion from rest may reach stick-slip states in narrow ranges of frequency. The first comparison of
//! friction ratios can miss such a range, so that its amplitudes are lower bounds. The check starts with the friction
//! ratio of the lowest bound. It evaluates the band on the grid at one friction ratio after another, and stores the
//! lowest result.

use super::amplitude::FrictionAmount;
use super::candidates::FrictionCandidate;
use super::look::Closely;
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned_at, slope, with_slope};
use super::search::narrowed;

/// Largest number of friction ratios that the code checks on the grid.
const MOST: usize = 14;
/// Relative distance from a checked friction ratio below which another friction ratio needs no check.
const NEAR: f64 = 0.01;
/// Fraction of the lowest checked amplitude. The code checks a friction ratio only if its lower bound is below this
/// value.
const BETTER: f64 = 0.999;

/// Returns the friction ratio with the lowest amplitude on the grid. If the work ends before the first ratio is
/// checked, returns the ratio with the lowest lower bound.
pub(super) fn verified(
    band: &AmplitudeBand<'_>,
    mut open: Vec<FrictionCandidate>,
) -> Option<FrictionCandidate> {
    open.retain(|candidate| candidate.at.value.is_finite());
    open.sort_by(|a, b| a.at.value.total_cmp(&b.at.value));
    let mut best: Option<FrictionCandidate> = None;
    let mut seen: Vec<f64> = Vec::new();
    for candidate in &open {
        let beta = candidate.at.beta;
        let cutoff = best.as_ref().map_or(f64::INFINITY, |best| best.at.value);
        if seen.len() == MOST || band.amplitude.is_spent() || BETTER * cutoff < candidate.at.value {
            break;
        }
        if seen.iter().any(|other| (other - beta).abs() <= NEAR * beta) {
            continue;
        }
        seen.push(beta);
        if let Some(at) = evaluated(band, beta, cutoff) {
            best = Some(FrictionCandidate {
                at,
                ..candidate.clone()
            });
        }
    }
    let Some(best) = best else {
        return open.into_iter().next();
    };
    Some(refined(band, best))
}

/// Evaluates the points of the scan again whose amplitude is at most `level`, including the peaks from the grids. The
/// former amplitudes of these points were lower bounds.
pub(super) fn raise(band: &AmplitudeBand<'_>, scan: &mut [Scanned], level: f64) {
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

/// Evaluates the whole band on the grid at one friction ratio. Returns `None` if the largest amplitude is not below the
/// cutoff, or if the work ends first.
fn evaluated(band: &AmplitudeBand<'_>, beta: f64, cutoff: f64) -> Option<Scanned> {
    // The peaks of earlier grids reject most friction ratios.
    if cutoff.is_finite() && !scanned_at(band, beta, cutoff).complete {
        return None;
    }
    let friction = FrictionAmount::Ratio(beta);
    let mut look = band.look(band.open(friction), f64::INFINITY, Closely::Whole);
    band.add_grid(&mut look, friction);
    for peak in &look.peaks {
        band.learn_around(peak.r);
    }
    let found = with_slope(beta, look, |peak| slope(band, beta, peak));
    (found.complete && found.value < cutoff).then_some(Scanned {
        whole: true,
        ..found
    })
}

/// Searches the bracket of the best friction ratio by golden sections, and checks the result on the grid.
fn refined(band: &AmplitudeBand<'_>, best: FrictionCandidate) -> FrictionCandidate {
    let [from, to] = best.bracket;
    if !(from < to) {
        return best;
    }
    let side = |beta: f64| Scanned {
        beta,
        complete: false,
        ..best.at.clone()
    };
    let found = narrowed(band, (&side(from), &side(to)), Some(best.at.clone()));
    if found.at.beta != best.at.beta
        && let Some(at) = evaluated(band, found.at.beta, best.at.value)
    {
        return FrictionCandidate { at, ..found };
    }
    best
}
