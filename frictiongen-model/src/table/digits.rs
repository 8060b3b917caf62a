//! Numbers with no more digits than count, as tables are read by people; and neighbours of a number.

use frictiongen_kernel::Float;

/// Beyond so many decimals nothing in double precision of the size of a frequency ratio has digits to lose.
const MOST_DECIMALS: f64 = 40.0;

/// The smallest number of a scalar above one that it need not hold.
pub(super) fn above<S: Float>(value: f64) -> S {
    let next = S::constant(value.next_up());
    if next.to_f64() > value {
        return next;
    }
    // Half a rounding further lies the next number, or half way to it.
    let further = |roundings: f64| S::constant(value + value.abs() * roundings * S::EPSILON);
    let next = further(0.5);
    if next.to_f64() > value {
        next
    } else {
        further(0.75)
    }
}

/// The nearest number whose last decimal is no larger than `least`.
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
