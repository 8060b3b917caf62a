//! Rounds a double-double number, the sum of two doubles, to another number type in one step.

use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

/// Rounds a double-double to another number type with a single rounding.
#[must_use]
pub fn rounded<S: Float>(value: Dd) -> S {
    // If the high word is exactly halfway between two numbers of a narrower type, the sign of the low word decides
    // the rounding. The code therefore shifts the high word to the next double in the direction of the low word.
    let moved = if value.lo > 0.0 {
        value.hi.next_up()
    } else if value.lo < 0.0 {
        value.hi.next_down()
    } else {
        value.hi
    };
    let plain = S::constant(value.hi);
    if plain.to_f64() == value.hi {
        plain
    } else {
        S::constant(moved)
    }
}
