//! Finds the minima of the largest amplitude as a function of friction, between points of a scan over friction.

use super::amplitude::FrictionAmount;
use super::candidates::{FrictionCandidate, between, valleys};
use super::creep::crept;
use super::look::Closely;
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned_at, slope, with_slope};

/// Largest number of attempts to find one minimum. The search makes a further attempt if an evaluation of the band at
/// the minimum finds a higher peak.
const AGAIN: usize = 4;
/// Largest number of golden-section steps. The steps end earlier if the relative width of the bracket reaches `NARROW`.
const SECTIONS: usize = 40;
/// Relative width of a bracket of friction at which golden sections end.
const NARROW: f64 = 1e-7;
/// Smaller of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// Returns the minima between those points of the scan over friction between which the amplitude may be below `top`,
/// the best amplitude so far.
pub(super) fn minima(
    band: &AmplitudeBand<'_>,
    scan: &[Scanned],
    mut top: f64,
) -> Vec<FrictionCandidate> {
    // With μ > 1 a later check on a fine grid of the band may find a larger amplitude at this minimum. The present
    // amplitude is only a lower bound, and must not exclude other minima.
    let exact = band.amplitude.system.scene().stiction <= 1.0;
    let mut minima: Vec<FrictionCandidate> = Vec::new();
    // No amplitude is smaller than 0, so that a search would be useless. Just below the friction at which the contact
    // no longer slides, amplitudes are close to 0, and the motions are too small to settle.
    if top <= 0.0 {
        return minima;
    }
    for (below, above) in between(scan, top) {
        let found = minimum(band, below, above, top);
        if exact {
            top = found.iter().fold(top, |top, found| top.min(found.at.value));
        }
        minima.extend(found);
    }
    for (below, at, above) in valleys(scan, top) {
        let inside =
            |found: &FrictionCandidate| below.beta < found.at.beta && found.at.beta < above.beta;
        if !minima.iter().any(inside) {
            minima.push(narrowed(band, (&below, &above), Some(at)));
        }
    }
    minima
}

/// Returns the minimum between two friction ratios. A further evaluation of the band checks that no other peak is
/// higher. Returns `None` if the known peaks show that the amplitude is nowhere below `best`.
pub(super) fn minimum(
    band: &AmplitudeBand<'_>,
    mut below: Scanned,
    mut above: Scanned,
    best: f64,
) -> Option<FrictionCandidate> {
    let mut least = None;
    for _ in 0..AGAIN {
        if band.amplitude.is_spent() {
            return least;
        }
        let Some(found) = crept(band, &below, &above) else {
            break;
        };
        let (beta, value) = (found.best.beta, found.best.value);
        if best <= value && found.done {
            return None;
        }
        let open = band.open(FrictionAmount::Ratio(beta));
        let look = band.look(open, best.max(value) * (1.0 + 1e-6), Closely::First);
        let Some(top) = look.peaks.first().copied() else {
            break;
        };
        if top.value <= value * (1.0 + 1e-10) {
            let bracket = [found.below.beta, found.above.beta];
            if found.done && look.complete {
                return Some(FrictionCandidate {
                    at: found.best,
                    bracket,
                });
            }
            let seen = look.complete.then_some(found.best);
            return Some(narrowed(band, (&found.below, &found.above), seen));
        }
        // The evaluation found a peak that was not known at the two bounds of the bracket.
        let here = with_slope(beta, look, |peak| slope(band, beta, peak));
        if here.complete && here.value < best {
            let candidate = FrictionCandidate {
                at: here.clone(),
                bracket: [below.beta, above.beta],
            };
            let better = |least: &FrictionCandidate| candidate.at.value < least.at.value;
            if least.as_ref().is_none_or(better) {
                least = Some(candidate);
            }
        }
        if here.slope < 0.0 {
            below = here;
        } else {
            above = here;
        }
    }
    let seen = least.map(|least| least.at);
    let found = narrowed(band, (&below, &above), seen);
    found.at.complete.then_some(found)
}

/// Narrows an interval of friction ratios around the best friction ratio by golden sections, and returns the best
/// friction ratio found.
///
/// Golden sections need neither slopes nor tracked peaks. They also work at frictions at which steady states appear or
/// disappear. The search rejects a friction ratio as soon as the amplitude at one frequency shows that this friction
/// ratio is not better.
pub(super) fn narrowed(
    band: &AmplitudeBand<'_>,
    ends: (&Scanned, &Scanned),
    seen: Option<Scanned>,
) -> FrictionCandidate {
    let value = |beta, cutoff| scanned_at(band, beta, cutoff);
    narrowed_by(&value, &|| band.amplitude.is_spent(), ends, seen)
}

/// Narrows an interval of friction ratios as [`narrowed`] does, for any function of friction. `value` returns the
/// function at a friction ratio. `value` may return early if the function exceeds the cutoff. `spent` returns true if
/// the search must end.
pub(super) fn narrowed_by(
    value: &dyn Fn(f64, f64) -> Scanned,
    spent: &dyn Fn() -> bool,
    (below, above): (&Scanned, &Scanned),
    seen: Option<Scanned>,
) -> FrictionCandidate {
    let (mut a, mut b) = (below.beta, above.beta);
    let ends = [below, above].into_iter().filter(|end| end.complete);
    let known = seen.iter().chain(ends);
    let known = known.filter(|known| a <= known.beta && known.beta <= b);
    let mut best = known
        .min_by(|x, y| x.value.total_cmp(&y.value))
        .cloned()
        .unwrap_or_else(|| value(0.5 * (a + b), f64::INFINITY));
    for _ in 0..SECTIONS {
        if b - a <= NARROW * b || spent() {
            break;
        }
        let (left, right) = (best.beta - a, b - best.beta);
        let beta = if right < left {
            best.beta - GOLDEN * left
        } else {
            best.beta + GOLDEN * right
        };
        let cutoff = if best.complete {
            best.value
        } else {
            f64::INFINITY
        };
        let here = value(beta, cutoff);
        if here.complete && (here.value < best.value || !best.complete) {
            if beta < best.beta {
                b = best.beta;
            } else {
                a = best.beta;
            }
            best = here;
        } else if beta < best.beta {
            a = beta;
        } else {
            b = beta;
        }
    }
    FrictionCandidate {
        at: best,
        bracket: [a, b],
    }
}
