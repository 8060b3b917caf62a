//! Decimal numbers as they were written: a grid of decimals is made of decimals, without the rounding of binary
//! steps.

/// digits·10^exponent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimal {
    digits: i128,
    exponent: i32,
}

/// More digits than this are left to floating point.
const MOST_DIGITS: usize = 30;

impl Decimal {
    /// A number as `f64` reads it, where it is decimal and short enough to be held exactly.
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

    /// The nearest number in double precision.
    pub fn value(self) -> f64 {
        let text = format!("{}e{}", self.digits, self.exponent);
        text.parse().unwrap_or(f64::NAN)
    }

    /// The same with a smaller exponent, where that fits.
    fn scaled(self, exponent: i32) -> Option<i128> {
        let by = u32::try_from(self.exponent.checked_sub(exponent)?).ok()?;
        self.digits.checked_mul(10_i128.checked_pow(by)?)
    }
}

/// A range of decimals: its first point, its step and how many steps lead to its end.
#[derive(Clone, Copy, Debug)]
pub struct Decimals {
    first: i128,
    step: i128,
    exponent: i32,
    /// How many steps there are.
    pub steps: i128,
}

impl Decimals {
    /// The range, where its step is not 0 and leads to its end.
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

    /// A point of it.
    pub fn point(&self, index: i128) -> f64 {
        Decimal {
            digits: self.first + index * self.step,
            exponent: self.exponent,
        }
        .value()
    }
}
