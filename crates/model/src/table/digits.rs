//! Rounds numbers to the digits that matter, because people read the tables. The module also finds the next larger
//! number of a type.

use frictiongen_kernel::Float;

/// Largest number of decimals. A frequency ratio in double precision has no more digits than that.
const MOST_DECIMALS: f64 = 40.0;

/// Returns the smallest number of the type `S` that is larger than a value in double precision.
pub(super) fn above<S: Float>(value: f64) -> S {
    let next = S::constant(value.next_up());
    if next.to_f64() > value {
        return next;
    }
    // The distance to the next number of the type is one rounding unit of the value, or half a unit.
    let further = |roundings: f64| S::constant(value + value.abs() * roundings * S::EPSILON);
    let next = further(0.5);
    if next.to_f64() > value {
        next
    } else {
        further(0.75)
    }
}

/// Rounds a value to a number of decimals. A unit of the last decimal is at most `least`.
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
