//! Finds the minimum of the largest amplitude as a function of friction, in an interval of friction.

use super::amplitude::FrictionAmount;
use super::creep::crept;
use super::look::Closely;
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned_at, slope, with_slope};

/// Bound on the work of a search for an exact minimum, in units of about 10 µs of computing time. If motions settle
/// slowly, the search reaches this bound.
const WORK_OF_A_MINIMUM: usize = 60_000;
/// Largest number of attempts to find one minimum. The search makes a further attempt if an evaluation of the band at
/// the minimum finds a higher peak.
const AGAIN: usize = 4;
/// Largest number of golden-section steps. The steps end earlier if the relative width of the bracket reaches `NARROW`.
const SECTIONS: usize = 40;
/// Relative width of a bracket of friction at which golden sections end.
const NARROW: f64 = 1e-7;
/// Smaller of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// A friction ratio that may be the best, and an interval that contains the minimum.
pub(super) type Minimum = (Scanned, [f64; 2]);

/// Returns the exact minimum between two friction ratios, with an interval that contains it. A further evaluation of the
/// band checks that no other peak is higher. Returns `None` if the amplitude is nowhere below `best`, or if the search
/// needs too much work.
pub(super) fn minimum(
    band: &AmplitudeBand<'_>,
    below: Scanned,
    above: Scanned,
    best: f64,
) -> Option<Minimum> {
    let search = || of_peaks(band, below, above, best);
    band.amplitude.within(WORK_OF_A_MINIMUM, search)
}

/// Returns the exact minimum between two friction ratios, as [`minimum`] does.
fn of_peaks(
    band: &AmplitudeBand<'_>,
    mut below: Scanned,
    mut above: Scanned,
    best: f64,
) -> Option<Minimum> {
    for _ in 0..AGAIN {
        let found = crept(band, &below, &above).filter(|found| found.done)?;
        let (beta, value) = (found.best.beta, found.best.value);
        if best <= value {
            return None;
        }
        let open = band.open(FrictionAmount::Ratio(beta));
        let look = band.look(open, best.max(value) * (1.0 + 1e-6), Closely::First);
        let top = look.peaks.first()?;
        if top.value <= value * (1.0 + 1e-10) {
            let bracket = [found.below.beta, found.above.beta];
            return look.complete.then_some((found.best, bracket));
        }
        // The evaluation found a peak that was not known at the two bounds of the bracket.
        let here = with_slope(beta, look, |peak| slope(band, beta, peak));
        if here.slope < 0.0 {
            below = here;
        } else if 0.0 <= here.slope {
            above = here;
        } else {
            break;
        }
    }
    None
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
) -> Minimum {
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
) -> Minimum {
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
    (best, [a, b])
}
