//! Writes CSV. No value contains a comma or a quote, because words are regimes, answers and Rust identifiers.

use crate::number::{Cell, Exact as _};
use std::borrow::Cow;
use std::io::{self, Write};

/// Writes the line with the column names and, if asked for, the line with their units.
pub fn header(out: &mut dyn Write, names: &[String], unit_row: bool) -> io::Result<()> {
    writeln!(out, "{}", names.join(","))?;
    if unit_row {
        let units: Vec<&str> = names.iter().map(|name| unit(name)).collect();
        writeln!(out, "{}", units.join(","))?;
    }
    Ok(())
}

/// Endings of column names with their units. If two endings fit, the longer one comes first.
const UNITS: [(&str, &str); 11] = [
    ("_m_s2", "m/s2"),
    ("_m_s", "m/s"),
    ("_rad_s", "rad/s"),
    ("_Hz", "Hz"),
    ("_deg", "deg"),
    ("_N", "N"),
    ("_W", "W"),
    ("_m", "m"),
    ("_s", "s"),
    (".phase", "rad"),
    (".fundamental_phase", "rad"),
];

/// Returns the unit of a column from its name, or an empty text for ratios, counts and words.
fn unit(name: &str) -> &'static str {
    // The name of a mass may itself end like a unit, so that only the text after it counts.
    let what = name
        .split_once('.')
        .map_or(name, |(part, _)| name.get(part.len()..).unwrap_or(name));
    let of = UNITS.iter().find(|(ending, _)| what.ends_with(ending));
    of.map_or("", |(_, unit)| *unit)
}

/// Writes a line of cells.
pub fn line<'a>(out: &mut dyn Write, cells: impl Iterator<Item = Cow<'a, str>>) -> io::Result<()> {
    for (index, cell) in cells.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}{cell}")?;
    }
    writeln!(out)
}

/// Writes a line of values.
pub fn row(out: &mut dyn Write, values: &[Cell<'_>]) -> io::Result<()> {
    for (index, value) in values.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}{}", value.exact())?;
    }
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::unit;

    #[test]
    fn units_of_names() {
        let cases = [
            ("frequency_Hz", "Hz"),
            ("omega_rad_s", "rad/s"),
            ("upper.amplitude_m", "m"),
            ("upper.velocity_m_s", "m/s"),
            ("upper.acceleration_m_s2", "m/s2"),
            ("upper.phase", "rad"),
            ("upper.phase_deg", "deg"),
            ("contact_force_N", "N"),
            ("friction_power_W", "W"),
            ("time_s", "s"),
            ("mass_m.amplitude", ""),
            ("regime", ""),
            ("stops", ""),
            ("r", ""),
        ];
        for (name, expected) in cases {
            assert_eq!(unit(name), expected, "{name}");
        }
    }
}
