//! Decimal numbers with the digits that the user wrote. The points of a grid are computed exactly from them, without
//! the rounding errors of steps in binary floating point.

/// A decimal number: `digits` times 10 to the power of `exponent`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimal {
    digits: i128,
    exponent: i32,
}

/// Largest number of digits of an exact decimal number. A number with more digits becomes a floating-point number.
const MOST_DIGITS: usize = 30;

impl Decimal {
    /// Parses a number as `f64` does. Returns `None` if the text is not decimal or has too many digits.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (sign, mantissa) = match mantissa.strip_prefix('-') {
            Some(rest) => (-1, rest),
            None => (1, mantissa.strip_prefix('+').unwrap_or(mantissa)),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: String = [whole, fraction].concat();
        let are_digits = digits.bytes().all(|digit| digit.is_ascii_digit());
        if digits.is_empty() || digits.len() > MOST_DIGITS || !are_digits {
            return None;
        }
        let places = i32::try_from(fraction.len()).ok()?;
        Some(Self {
            digits: sign * digits.parse::<i128>().ok()?,
            exponent: exponent.checked_sub(places)?,
        })
    }

    /// Returns the nearest number in double precision to this decimal number.
    pub fn value(self) -> f64 {
        let text = format!("{}e{}", self.digits, self.exponent);
        text.parse().unwrap_or(f64::NAN)
    }

    /// Returns the digits of the same number for another exponent of 10. Returns `None` if `exponent` is larger than
    /// the exponent of this number, or if the digits do not fit into the type.
    fn scaled(self, exponent: i32) -> Option<i128> {
        let by = u32::try_from(self.exponent.checked_sub(exponent)?).ok()?;
        self.digits.checked_mul(10_i128.checked_pow(by)?)
    }
}

/// A range of decimal numbers: first point, step, and number of steps from the first to the last point.
#[derive(Clone, Copy, Debug)]
pub struct Decimals {
    first: i128,
    step: i128,
    exponent: i32,
    /// Number of steps from the first to the last point of the range.
    pub steps: i128,
}

impl Decimals {
    /// Creates a range of decimal numbers. Returns `None` if the step is 0, or if the last point is not a whole number
    /// of steps away from the first.
    pub fn new(first: Decimal, step: Decimal, last: Decimal) -> Option<Self> {
        let exponent = first.exponent.min(step.exponent).min(last.exponent);
        let (first, step, last) = (
            first.scaled(exponent)?,
            step.scaled(exponent)?,
            last.scaled(exponent)?,
        );
        let steps = last.checked_sub(first)?.checked_div(step)?;
        let range = Self {
            first,
            step,
            exponent,
            steps,
        };
        (steps > 0 || (steps == 0 && (last - first).signum() * step.signum() >= 0)).then_some(range)
    }

    /// Creates a range of 100 equal steps. Returns `None` if the points of the range are not exact decimal numbers.
    pub fn hundredths(first: Decimal, last: Decimal) -> Option<Self> {
        let exponent = first.exponent.min(last.exponent);
        let step = Decimal {
            digits: last
                .scaled(exponent)?
                .checked_sub(first.scaled(exponent)?)?,
            exponent: exponent.checked_sub(2)?,
        };
        Self::new(first, step, last)
    }

    /// Returns the point of the range with this index, counted from 0.
    pub fn point(&self, index: i128) -> f64 {
        Decimal {
            digits: self.first + index * self.step,
            exponent: self.exponent,
        }
        .value()
    }
}
