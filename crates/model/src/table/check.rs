//! Compares tables with the exact values. The frequency ratios of the comparison differ from those of the fit.

use super::errors::{Comparison, or_infinite};
use super::fit::Fitted;
use super::kinks;
use super::product::Product;
use super::split::Landmarks;
use super::worst::Worst;
use frictiongen_kernel::Float;

/// Number of comparison points in each polynomial piece. Neighbouring points are at most 1/46 of the piece's length
/// apart. For a macro without a proof, this comparison is the only evidence of the accuracy.
const POINTS: usize = 64;
/// Number of decades down to which comparison points approach a zero: to 10^−13 of the piece's length.
const DECADES: f64 = 13.0;
/// Number of frequency ratios, spread over the range, at which the check compares a product over zeros and poles with
/// exact values. Additional points are near zeros, resonances, and subharmonics (resonances divided by 3, 5, 7, …).
const PRODUCT_POINTS: usize = 256;
/// Change of r, in rounding units, whose effect is allowed in the comparison. It covers the rounding of r in the
/// computation of an exact value.
pub(super) const ROUNDINGS: f64 = 8.0;
/// The golden section. The fractional parts of its multiples are evenly spread between 0 and 1.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Compares a polynomial piece with exact values. Returns the largest error divided by the allowed error, the r of
/// this error, and the number of compared points.
pub(super) fn piece<S: Float>(
    comparison: &mut Comparison<'_, '_, S>,
    piece: &Fitted<S>,
    (from, to): (f64, f64),
) -> (Worst, usize) {
    let zero = comparison.zero_of(piece);
    let mut worst = Worst {
        error: 0.0,
        at: from,
    };
    let spread = (0..POINTS).map(|k| from + (GOLDEN * (k + 1) as f64).fract() * (to - from));
    let mut places: Vec<f64> = spread.collect();
    if let Some(zero) = zero {
        // Close to a zero the relative error must stay small. Every decade of the distance from the zero therefore
        // has the same number of points.
        let length = if zero.at > from { from - to } else { to - from };
        let towards = (0..POINTS).map(|k| (GOLDEN * (k + 1) as f64).fract() * DECADES);
        places.extend(towards.map(|decades| zero.at + length * 10_f64.powf(-decades)));
    }
    // If the largest velocity constraint belongs to different maxima at two neighbouring points, β_lim has a kink
    // between these points.
    places.sort_by(f64::total_cmp);
    let mut kinks = Vec::new();
    for neighbours in places.windows(2) {
        if let [low, high] = neighbours {
            kinks::between(comparison.exact, *low, *high, &mut kinks);
        }
    }
    places.extend(kinks);
    let mut points = 0;
    for place in places {
        let r = S::constant(place).to_f64();
        if !(from <= r && r < to) {
            continue;
        }
        let error = comparison.error_at(piece, r);
        points += 1;
        if !(error <= worst.error) {
            worst = Worst { error, at: r };
        }
    }
    (worst, points)
}

/// Compares a product over zeros and poles with exact values. Returns the largest relative error, the r of this
/// error, and the number of compared points.
pub(super) fn product<S: Float>(
    product: &Product<S>,
    (low, high): (f64, f64),
    landmarks: &Landmarks,
    exact: impl Fn(f64) -> f64,
) -> (Worst, usize) {
    let mut worst = Worst {
        error: 0.0,
        at: low,
    };
    let spread = (0..PRODUCT_POINTS).map(|k| {
        let share = (GOLDEN * (k + 1) as f64).fract();
        low + share * (high - low)
    });
    let mut points = 0;
    for r in spread.chain(landmarks.closely.iter().copied()) {
        let own = S::constant(r);
        let expected = exact(own.to_f64());
        // At a zero or a pole the exact value is 0 or infinite, so no comparison is possible.
        if !(0.0 < expected && expected.is_finite()) {
            continue;
        }
        let off = (product.quotient().value(own).abs().to_f64() - expected).abs();
        // Near a zero or a pole the function is steep, so a few roundings of r change the exact value noticeably.
        let moved = own.to_f64() * (1.0 + ROUNDINGS * f64::EPSILON);
        let off = (off - (exact(moved) - expected).abs()).max(0.0);
        points += 1;
        let error = or_infinite(off / expected);
        if error > worst.error {
            worst = Worst { error, at: r };
        }
    }
    (worst, points)
}
