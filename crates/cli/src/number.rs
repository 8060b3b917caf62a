//! Formats the values of table cells, for people and for programs.

pub use frictiongen::study::columns::Cell;
use std::borrow::Cow;

/// Returns the text of a flag (true or false) in printed tables and CSV.
pub fn word(flag: bool) -> &'static str {
    if flag { "true" } else { "false" }
}

/// A value with a text that programs can read without loss.
pub trait Lossless {
    /// Formats a value with as few digits as possible. A program that reads the text gets the same number.
    fn exact(&self) -> Cow<'_, str>;
    /// Converts a value to JSON.
    fn json(&self) -> serde_json::Value;
}

impl Lossless for Cell<'_> {
    fn exact(&self) -> Cow<'_, str> {
        match self {
            Self::Number(value) | Self::Within { value, .. } => Cow::Owned(format!("{value:?}")),
            Self::Count(value) => Cow::Owned(value.to_string()),
            Self::Word(text) => Cow::Borrowed(text),
            Self::Flag(value) => Cow::Borrowed(word(*value)),
            // A list does not fit into a cell of a CSV file.
            Self::Pairs(_) | Self::Missing => Cow::Borrowed(""),
        }
    }

    /// Converts a value to JSON. Infinity becomes the string "inf", because JSON has no infinity.
    fn json(&self) -> serde_json::Value {
        match self {
            Self::Number(value) | Self::Within { value, .. } if value.is_infinite() => {
                if *value < 0.0 { "-inf" } else { "inf" }.into()
            }
            Self::Number(value) | Self::Within { value, .. } => (*value).into(),
            Self::Count(value) => (*value).into(),
            Self::Word(text) => text.as_ref().into(),
            Self::Flag(value) => (*value).into(),
            Self::Pairs(pairs) => {
                let pair = |pair: &[f64; 2]| -> serde_json::Value {
                    pair.iter().map(|value| Cell::from(*value).json()).collect()
                };
                pairs.iter().map(pair).collect()
            }
            Self::Missing => serde_json::Value::Null,
        }
    }
}

/// Returns true if the conversion of `given` to `computed` has neither overflowed nor underflowed. Then either both
/// numbers are 0 or neither number is, and either both are finite or neither is.
pub fn survives(given: f64, computed: f64) -> bool {
    computed.is_finite() == given.is_finite() && (computed == 0.0) == (given == 0.0)
}

/// Formats a computed number for people: with six decimals, or with six significant digits if six decimals are not
/// enough.
pub fn computed(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if size.is_infinite() || (0.01..99_999.0).contains(&size) {
        format!("{value:.6}")
    } else {
        format!("{value:.5e}")
    }
}

/// Formats a computed number whose exact value is known only up to an interval of the width `width`. The format is that
/// of [`computed`], without the digits that are smaller than the width.
pub fn within(value: f64, width: f64) -> String {
    let size = value.abs();
    // The number of decimals follows from the width, because later decimals are not known.
    let decimals = (-width.log10()).ceil();
    if size == 0.0 || size.is_infinite() || !width.is_finite() {
        computed(value)
    } else if (0.01..99_999.0).contains(&size) {
        format!("{value:.*}", decimals.clamp(0.0, 6.0) as usize)
    } else {
        let digits = decimals + size.log10().floor();
        format!("{value:.*e}", digits.clamp(0.0, 5.0) as usize)
    }
}

/// Largest number of decimals for a number that the user gave.
const MOST_DECIMALS: usize = 9;

/// Formats a number that the user gave, for people. All numbers of a grid have the same number of decimals.
pub fn given(value: f64, decimals: usize) -> String {
    let size = value.abs();
    if size == 0.0 || size.is_infinite() || (1e-6..1e9).contains(&size) {
        format!("{value:.decimals$}")
    } else {
        format!("{value:?}")
    }
}

/// Returns the number of decimals that a number needs. Digits that come only from rounding do not count.
pub fn decimals(value: f64) -> usize {
    let text = given(value, MOST_DECIMALS);
    match text.split_once('.') {
        Some((_, decimals)) if !text.contains('e') => decimals.trim_end_matches('0').len(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, Lossless as _, computed, decimals, given, within};

    #[test]
    fn for_people() {
        let cases = [
            (0.0, "0"),
            (f64::INFINITY, "inf"),
            (0.25 * std::f64::consts::PI, "0.785398"),
            (-123.456_789_1, "-123.456789"),
            (0.001_234_567_8, "1.23457e-3"),
            (1e22, "1.00000e22"),
        ];
        for (value, text) in cases {
            assert_eq!(computed(value), text);
        }
        assert_eq!(decimals(0.1 + 0.2), 1);
        assert_eq!(decimals(1e-30), 0);
        assert_eq!(decimals(20.0), 0);
        assert_eq!(decimals(f64::INFINITY), 0);
        assert_eq!(decimals(1.0 / 3.0), 9);
        assert_eq!(given(0.1 + 0.2, 2), "0.30");
        assert_eq!(given(1e-30, 2), "1e-30");
    }

    #[test]
    fn digits_that_hold() {
        for (value, width, text) in [
            (73.013_456, 0.02, "73.01"),
            (73.013_456, 0.1, "73.0"),
            (73.013_456, 3.0, "73"),
            (73.013_456, 1e-12, "73.013456"),
            (0.001_234_567_8, 1e-5, "1.23e-3"),
            (123_456.7, 100.0, "1.235e5"),
            (0.0, 1.0, "0"),
        ] {
            assert_eq!(within(value, width), text);
        }
    }

    #[test]
    fn for_programs() {
        assert_eq!(Cell::from(0.1).exact(), "0.1");
        assert_eq!(Cell::from(-0.0).exact(), "0.0");
        assert_eq!(Cell::from(1e300).exact(), "1e300");
        assert_eq!(Cell::from(f64::INFINITY).exact(), "inf");
        assert_eq!(Cell::from(f64::NAN), Cell::Missing);
        assert_eq!(Cell::from(None::<f64>).exact(), "");
        assert_eq!(Cell::from(f64::INFINITY).json(), "inf");
        assert_eq!(Cell::from(f64::NEG_INFINITY).json(), "-inf");
        assert_eq!(Cell::Missing.json(), serde_json::Value::Null);
    }
}
