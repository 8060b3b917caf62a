//! Advice for the user about a text that is not a number. The text may have a decimal comma, or a unit after the
//! number.

/// Units that users write after numbers, each with its power of ten in m, N, s, Hz or kg.
const UNITS: [(&str, i32); 15] = [
    ("m", 0),
    ("mm", -3),
    ("cm", -2),
    ("um", -6),
    ("µm", -6),
    ("μm", -6),
    ("N", 0),
    ("mN", -3),
    ("kN", 3),
    ("s", 0),
    ("ms", -3),
    ("Hz", 0),
    ("kHz", 3),
    ("rad/s", 0),
    ("%", -2),
];

/// Returns advice about a number with a decimal comma, for the end of a message. For any other text the advice is
/// empty.
pub fn decimal(text: &str) -> String {
    let text = text.trim();
    let Some((whole, fraction)) = text.split_once(',') else {
        return String::new();
    };
    let meant = format!("{whole}.{fraction}");
    match meant.parse::<f64>() {
        Ok(number) if number.is_finite() => {
            format!("; write `{meant}`, because a decimal fraction has a point")
        }
        _ => String::new(),
    }
}

/// Returns advice about a text that is not a number, for the end of an error message. The advice is empty if the text
/// does not resemble a number.
pub fn of(text: &str) -> String {
    let text = text.trim();
    if text.contains(',') {
        return decimal(text);
    }
    for (unit, power) in UNITS {
        let number = text.strip_suffix(unit).map(str::trim_end);
        let Some(number) = number.filter(|number| number.parse::<f64>().is_ok()) else {
            continue;
        };
        // The code appends the power of ten to the digits of the number, so that 1.2 mm becomes 1.2e-3 without
        // rounding.
        let scaled = format!("{number}e{power}").parse::<f64>();
        let scaled = scaled.map_or_else(|_| number.to_owned(), |scaled| scaled.to_string());
        return format!(
            "; write `{scaled}`, because numbers here are in N, m, s, Hz or rad/s, without a unit"
        );
    }
    String::new()
}
