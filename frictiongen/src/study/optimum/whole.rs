//! Evaluates a quantity over the whole band at one friction ratio, within a bound on work.

use super::amplitude::FrictionAmount;
use super::look::Closely;
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, slope, with_slope};
use std::cell::Cell;

/// Bound on the work of one check of the whole band for one quantity, in units of about 10 µs of computing time.
const WORK_OF_A_CHECK: usize = super::WORK / 2;
/// Bound on the work of all checks of one search, divided by the bound on the work of a search over all frictions.
pub(super) const OF_ALL_CHECKS: usize = 2;
/// Bound on the work of all checks of one search, in units of about 10 µs of computing time.
pub(super) const WORK_OF_ALL_CHECKS: usize = OF_ALL_CHECKS * super::WORK;

/// Evaluates the whole band, within a bound on work. All later evaluations of the band include the frequencies of the
/// largest peaks. `left` is the work that remains for all checks together, in units of about 10 µs of computing time.
pub(super) fn whole(band: &AmplitudeBand<'_>, beta: f64, left: &Cell<usize>) -> Scanned {
    let friction = FrictionAmount::Ratio(beta);
    let several = 1.0 < band.amplitude.system.scene().stiction;
    let before = band.amplitude.spent();
    band.amplitude.allow(WORK_OF_A_CHECK.min(left.get()));
    if several {
        band.amplitude.follow_from_rest();
    }
    let mut look = band.look(band.open(friction), f64::INFINITY, Closely::Whole);
    if several {
        band.add_grid(&mut look, friction, f64::INFINITY);
    }
    band.learn_largest(&look);
    let spent = band.amplitude.spent() - before;
    left.set(left.get().saturating_sub(spent));
    with_slope(beta, look, |peak| slope(band, beta, peak))
}
