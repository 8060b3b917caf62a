//! Parses texts of loads with units, such as `0.2g`.

use super::measure::PhysicalQuantity;
use crate::study::units::Load;

/// Standard acceleration of gravity, in m/s².
const GRAVITY: f64 = 9.80665;

/// Units of motions that a text can contain, each with its dimension and its size in SI units.
const UNITS: [(&str, PhysicalQuantity, f64); 14] = [
    ("m", PhysicalQuantity::Length, 1.0),
    ("cm", PhysicalQuantity::Length, 1e-2),
    ("mm", PhysicalQuantity::Length, 1e-3),
    ("um", PhysicalQuantity::Length, 1e-6),
    ("µm", PhysicalQuantity::Length, 1e-6),
    ("m/s", PhysicalQuantity::Velocity, 1.0),
    ("mm/s", PhysicalQuantity::Velocity, 1e-3),
    ("cm/s", PhysicalQuantity::Velocity, 1e-2),
    ("m/s2", PhysicalQuantity::Acceleration, 1.0),
    ("m/s²", PhysicalQuantity::Acceleration, 1.0),
    ("m/s^2", PhysicalQuantity::Acceleration, 1.0),
    ("mm/s2", PhysicalQuantity::Acceleration, 1e-3),
    ("g", PhysicalQuantity::Acceleration, GRAVITY),
    ("mg", PhysicalQuantity::Acceleration, 1e-3 * GRAVITY),
];

/// Units of forces and energies that a text can contain, each with its dimension and its size in SI units.
const OTHERS: [(&str, PhysicalQuantity, f64); 5] = [
    ("N", PhysicalQuantity::Force, 1.0),
    ("kN", PhysicalQuantity::Force, 1e3),
    ("MN", PhysicalQuantity::Force, 1e6),
    ("J", PhysicalQuantity::Energy, 1.0),
    ("kJ", PhysicalQuantity::Energy, 1e3),
];

/// Splits a text into a number and its unit. The number is `None` if the text does not begin with a number.
fn number_and_unit(text: &str) -> (Option<f64>, &str) {
    let text = text.trim();
    // The number is the longest beginning of the text that can be read as a number. The rest is the unit.
    let ends = text
        .char_indices()
        .map(|(index, _)| index)
        .chain([text.len()]);
    let mut found = (None, text);
    for end in ends {
        let (number, unit) = text.split_at_checked(end).unwrap_or((text, ""));
        if let Ok(value) = number.trim().parse::<f64>()
            && !number.trim_end().ends_with(char::is_alphabetic)
        {
            found = (Some(value), unit.trim());
        }
    }
    found
}

/// Parses a text about the motion of the base as a load. Examples are `0.003` or `3 mm`, `0.1 m/s`, `2 m/s2` and
/// `0.2g`.
///
/// # Errors
/// The reason in words. A message prints it after the text.
pub fn base_load(text: &str) -> Result<Load, String> {
    // A number alone may also be infinite or NaN, which the units of a load refuse.
    let (number, unit) = match text.trim().parse() {
        Ok(number) => (Some(number), ""),
        Err(_) => number_and_unit(text),
    };
    // A decimal comma ends the number, and is no unit.
    let number = number.filter(|_| !unit.starts_with(','));
    let number = number.ok_or_else(|| "it is not a number".to_owned())?;
    if unit.is_empty() {
        return Ok(Load::Base(number));
    }
    let known = UNITS.iter().find(|(name, ..)| *name == unit);
    let wrong = || {
        format!(
            "the unit of a base motion is m, mm, m/s, m/s2 or g, not `{unit}`; a number without a unit is in m"
        )
    };
    let (_, dimension, factor) = known.ok_or_else(wrong)?;
    match dimension {
        PhysicalQuantity::Length => Ok(Load::Base(number * factor)),
        PhysicalQuantity::Velocity => Ok(Load::BaseVelocity(number * factor)),
        PhysicalQuantity::Acceleration => Ok(Load::BaseAcceleration(number * factor)),
        _ => Err(wrong()),
    }
}

/// Returns the bound that a text sets on a quantity, in SI units. Examples of the text are `5mm`, `2 m/s2` and `12 kN`.
/// A number without a unit is in the SI unit.
///
/// # Errors
/// The reason in words. A message prints it after the text.
pub fn bound(text: &str, dimension: PhysicalQuantity) -> Result<f64, String> {
    let (number, unit) = number_and_unit(text);
    let number = number.filter(|number| 0.0 <= *number && number.is_finite());
    let number = number.ok_or_else(|| "a bound that is not negative is needed".to_owned())?;
    if unit.is_empty() {
        return Ok(number);
    }
    let mut units = UNITS.iter().chain(&OTHERS);
    match units.find(|(name, of, _)| *name == unit && *of == dimension) {
        Some((_, _, factor)) => Ok(number * factor),
        None => {
            let units = UNITS.iter().chain(&OTHERS);
            let known: Vec<&str> = units
                .filter(|(_, of, _)| *of == dimension)
                .map(|(name, ..)| *name)
                .collect();
            Err(format!(
                "the unit `{unit}` does not fit this quantity, whose units are {}",
                known.join(", ")
            ))
        }
    }
}

/// Parses a text about the unbalance of a rotor, mass times eccentricity, as a load. Examples are `0.02` and `0.02 kg
/// m`.
///
/// # Errors
/// The reason in words. A message prints it after the text.
pub fn unbalance(text: &str) -> Result<Load, String> {
    match number_and_unit(text) {
        (Some(number), "" | "kg m" | "kg*m" | "kg·m") => Ok(Load::Unbalance(number)),
        (Some(number), "g mm" | "g*mm" | "g·mm") => Ok(Load::Unbalance(1e-6 * number)),
        (Some(_), unit) => Err(format!(
            "the unit of an unbalance is kg m or g mm, not `{unit}`; a number without a unit is in kg m"
        )),
        (None, _) => Err("it is not a number".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::{base_load, bound, number_and_unit};
    use crate::study::columns::PhysicalQuantity;
    use crate::study::units::Load;

    #[test]
    fn texts_of_bounds() {
        assert_eq!(bound("5mm", PhysicalQuantity::Length), Ok(0.005));
        assert_eq!(bound("0.2 g", PhysicalQuantity::Acceleration), Ok(1.96133));
        assert_eq!(bound("12 kN", PhysicalQuantity::Force), Ok(12e3));
        assert_eq!(bound("3", PhysicalQuantity::Energy), Ok(3.0));
        assert!(
            bound("5 mm", PhysicalQuantity::Force)
                .unwrap_err()
                .contains("N, kN, MN")
        );
        for wrong in ["", "-1 mm", "inf"] {
            assert!(bound(wrong, PhysicalQuantity::Length).is_err(), "{wrong}");
        }
    }

    #[test]
    fn texts_of_loads() {
        let cases = [
            ("0.003", Load::Base(0.003)),
            ("3 mm", Load::Base(0.003)),
            ("3mm", Load::Base(0.003)),
            ("1e-3", Load::Base(0.001)),
            ("1e-1 m/s", Load::BaseVelocity(0.1)),
            ("2 m/s2", Load::BaseAcceleration(2.0)),
            ("2 m/s²", Load::BaseAcceleration(2.0)),
            ("0.5g", Load::BaseAcceleration(4.903325)),
        ];
        for (text, load) in cases {
            assert_eq!(base_load(text), Ok(load), "{text}");
        }
        for wrong in ["", "mm", "0,003", "3 N", "3 furlongs", "inf m/s3", "nan kg"] {
            assert!(base_load(wrong).is_err(), "{wrong}");
        }
        assert_eq!(number_and_unit(" 5 mm "), (Some(5.0), "mm"));
        assert_eq!(number_and_unit("-2e3N"), (Some(-2000.0), "N"));
    }
}
