//! Formats the numbers of the report page with four significant digits and their unit.

use crate::measure::{Measure, PhysicalQuantity};
use crate::number::Lossless as _;
use frictiongen::System;
use frictiongen::study::units;
use frictiongen_plot::desk::Scales;
use serde_json::Value as Json;

/// Units in which the report page shows frequencies, frictions and displacements.
#[derive(Clone, Copy, Debug)]
pub struct PageUnits {
    /// Units of the axes of the page's pictures.
    pub scales: Scales,
    /// True if the page shows frequencies in Hz.
    pub in_hertz: bool,
    /// Load of the report, and the units that follow from it.
    pub measure: Measure,
}

/// Formats a number with four significant digits.
pub fn digits(value: f64) -> String {
    let size = value.abs();
    if value.is_nan() {
        return "none".to_owned();
    }
    if size.is_infinite() {
        return if value < 0.0 { "−∞" } else { "∞" }.to_owned();
    }
    if size == 0.0 {
        return "0".to_owned();
    }
    let text = if (1e-3..1e5).contains(&size) {
        let decimals = (3.0 - size.log10().floor()).clamp(0.0, 7.0) as usize;
        trimmed(&format!("{value:.decimals$}"))
    } else {
        let text = format!("{value:.3e}");
        match text.split_once('e') {
            Some((digits, power)) => format!("{}e{power}", trimmed(digits)),
            None => text,
        }
    };
    text.replace('-', "−")
}

/// Removes trailing zeros after the decimal point.
fn trimmed(text: &str) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text.to_owned()
    }
}

/// Converts a number to JSON. Infinity becomes a string, because JSON has no infinity.
pub fn number(value: f64) -> Json {
    crate::number::Cell::from(value).json()
}

/// Rounds a number to six significant digits, the resolution of a picture.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

impl PageUnits {
    /// Returns the unit in which the page shows displacements.
    pub fn length_unit(&self) -> &'static str {
        match (self.measure.scale(), self.measure.is_base_motion()) {
            (Some(_), _) => "mm",
            (None, true) => "Y",
            (None, _) => "P/k₁",
        }
    }

    /// Formats a displacement with its unit. `ratio` is the displacement divided by P/k₁, or by Y for base motion.
    pub fn length(&self, ratio: f64) -> String {
        let value = digits(self.scales.length(ratio));
        format!("{value} {}", self.length_unit())
    }

    /// Formats a friction with its unit. `beta` is the friction ratio.
    pub fn friction(&self, beta: f64) -> String {
        self.force(self.scales.friction(beta))
    }

    /// Formats a friction that is already in the unit of the page, N under a load and otherwise the ratio β.
    pub fn force(&self, force: f64) -> String {
        let value = digits(force);
        match self.measure.scale() {
            Some(_) => format!("{value} N"),
            None => format!("β = {value}"),
        }
    }

    /// Formats a frequency with its unit. `r` is the frequency ratio.
    pub fn frequency(&self, r: f64) -> String {
        let value = digits(self.scales.frequency(r));
        if self.in_hertz {
            format!("{value} Hz")
        } else {
            format!("r = {value}")
        }
    }

    /// Returns the heading of a table column of frequencies.
    pub fn frequency_title(&self) -> &'static str {
        if self.in_hertz { "f (Hz)" } else { "r" }
    }

    /// Formats an angle in degrees, given in rad.
    pub fn angle(radians: f64) -> String {
        // Readers need no finer resolution than a tenth of a degree.
        format!("{:.1}°", radians.to_degrees() + 0.0).replace('-', "−")
    }

    /// Returns the JSON fields of a frequency.
    pub fn frequency_json(&self, system: &System, r: f64) -> Vec<(&'static str, Json)> {
        let hertz = units::hertz(system.angular_frequency(r));
        let mut fields = vec![("r", number(r))];
        if self.in_hertz {
            fields.push(("frequency_Hz", number(hertz)));
        }
        fields
    }

    /// Returns the JSON fields of a friction or of a limit.
    pub fn friction_json(&self, beta: f64) -> Vec<(&'static str, Json)> {
        let mut fields = vec![("beta", number(beta))];
        if self.measure.scale().is_some() {
            fields.push(("friction_N", number(self.measure.force(beta))));
        }
        fields
    }

    /// Returns the JSON field of an amplitude.
    pub fn length_json(&self, ratio: f64) -> (String, Json) {
        let name = self.measure.name("amplitude", PhysicalQuantity::Length);
        (name, number(self.measure.length(ratio)))
    }
}

/// Returns a JSON object with the given fields.
pub fn object<K: Into<String>>(fields: impl IntoIterator<Item = (K, Json)>) -> Json {
    let fields = fields.into_iter().map(|(name, value)| (name.into(), value));
    Json::Object(fields.collect())
}

#[cfg(test)]
mod tests {
    use super::{digits, rounded};

    #[test]
    fn four_digits() {
        for (value, text) in [
            (0.0, "0"),
            (2.0, "2"),
            (0.123_456, "0.1235"),
            (-12.345_6, "−12.35"),
            (1234.56, "1235"),
            (1e-5, "1e−5"),
            (f64::INFINITY, "∞"),
            (f64::NAN, "none"),
        ] {
            assert_eq!(digits(value), text);
        }
        assert_eq!(rounded(0.123_456_789), 0.123_457);
    }
}
