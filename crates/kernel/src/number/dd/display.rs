//! Conversion of a double-double to decimal digits.

use core::fmt;

use super::Dd;

/// Largest number of decimal digits that `write` computes. `write` prints at most one digit less. Digits after the 32nd
/// are not significant.
const MOST: usize = 39;

/// Returns the decimal mantissa of a positive number, at least 1 and below 10, and the exponent of ten.
fn mantissa(value: Dd) -> (Dd, i32) {
    let (mut value, mut exponent) = (value, 0);
    for power in [256, 128, 64, 32, 16, 8, 4, 2, 1] {
        let factor = ten_to(power);
        if value >= factor {
            value = value / factor;
            exponent += power;
        }
        // The loop scales up only numbers below 10/factor, so that the result stays below 10. After the last pass, with
        // power 1, the result is at least 1.
        if value < Dd::from(10.0) / factor {
            value = value * factor;
            exponent -= power;
        }
    }
    // Rounding errors of the divisions may leave the mantissa just outside the range from 1 to 10.
    if value >= Dd::from(10.0) {
        (value / Dd::from(10.0), exponent + 1)
    } else if value < Dd::ONE {
        (value * Dd::from(10.0), exponent - 1)
    } else {
        (value, exponent)
    }
}

fn ten_to(power: i32) -> Dd {
    let (mut result, mut base, mut left) = (Dd::ONE, Dd::from(10.0), power);
    while left > 0 {
        if left & 1 == 1 {
            result = result * base;
        }
        left >>= 1;
        if left > 0 {
            base = base * base;
        }
    }
    result
}

pub(super) fn write(value: Dd, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if !value.hi.is_finite() || value.is_zero() {
        return write!(f, "{:e}", value.hi);
    }
    let decimals = f.precision().unwrap_or(31).min(MOST - 2);
    let mut digits = [0_u8; MOST];
    let (mut rest, mut exponent) = mantissa(value.abs());
    for digit in &mut digits {
        *digit = rest.hi as u8;
        rest = rest - Dd::from(f64::from(*digit));
        if rest < Dd::ZERO {
            *digit = digit.saturating_sub(1);
            rest = rest + Dd::ONE;
        }
        rest = rest * Dd::from(10.0);
    }
    let mut carry = digits
        .iter()
        .skip(decimals + 1)
        .take(1)
        .any(|digit| *digit >= 5);
    for digit in digits.iter_mut().take(decimals + 1).rev() {
        if carry {
            carry = *digit >= 9;
            *digit = if carry { 0 } else { *digit + 1 };
        }
    }
    if carry {
        exponent += 1;
        if let Some(first) = digits.first_mut() {
            *first = 1;
        }
    }
    if value.hi < 0.0 {
        f.write_str("-")?;
    }
    for (place, digit) in digits.iter().take(decimals + 1).enumerate() {
        if place == 1 {
            f.write_str(".")?;
        }
        write!(f, "{digit}")?;
    }
    write!(f, "e{exponent}")
}
