//! Rounds numbers to the digits that matter, because people read the tables. Also finds the neighbours of a number.

use frictiongen_kernel::Float;

/// Largest number of decimals. A frequency ratio in double precision has no digits beyond it.
const MOST_DECIMALS: f64 = 40.0;

/// Returns the smallest number of the scalar above a value, which need not be a number of the scalar.
pub(super) fn above<S: Float>(value: f64) -> S {
    let next = S::constant(value.next_up());
    if next.to_f64() > value {
        return next;
    }
    // The next number, or half the distance to it, is half a rounding away.
    let further = |roundings: f64| S::constant(value + value.abs() * roundings * S::EPSILON);
    let next = further(0.5);
    if next.to_f64() > value {
        next
    } else {
        further(0.75)
    }
}

/// Returns the nearest number whose last decimal is no larger than `least`.
pub(super) fn to_decimals(value: f64, least: f64) -> f64 {
    let decimals = -least.log10().floor();
    if decimals < 0.0 {
        let unit = 10_f64.powf(-decimals);
        let rounded = (value / unit).round() * unit;
        return if rounded.is_finite() { rounded } else { value };
    }
    if !(decimals <= MOST_DECIMALS) {
        return value;
    }
    let text = format!("{value:.*}", decimals as usize);
    text.parse().unwrap_or(value)
}
