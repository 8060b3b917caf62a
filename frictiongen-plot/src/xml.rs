//! Numbers, paths and text in the form of XML.

use crate::geometry::Point;
use std::fmt::Write as _;

/// Returns the data of a path.
pub(crate) fn data(lines: &[Vec<Point>], end: &str) -> String {
    let mut data = String::new();
    for line in lines.iter().filter(|line| 1 < line.len()) {
        let mut last = None;
        for (x, y) in line.iter().filter(|(x, y)| x.is_finite() && y.is_finite()) {
            let (x, y) = (number(*x), number(*y));
            if last.as_ref() == Some(&(x.clone(), y.clone())) {
                continue;
            }
            // Pairs of coordinates after the first one are lines.
            let _ = write!(data, "{}{x} {y}", if last.is_none() { "M" } else { " " });
            last = Some((x, y));
        }
        data.push_str(end);
    }
    data
}

/// Formats a finite number with at most two decimals and without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    let value = if value.is_finite() { value } else { 0.0 };
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// Escapes text for XML. Control characters, which XML forbids, become spaces.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            _ if character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}') => {
                safe.push(' ')
            }
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::{escaped, number};

    #[test]
    fn numbers_are_short_and_finite() {
        let said = [1.0, -0.001, 0.125, 1e7, 10.5, f64::NAN, f64::INFINITY].map(number);
        assert_eq!(said, ["1", "0", "0.12", "10000000", "10.5", "0", "0"]);
    }

    #[test]
    fn text_is_text() {
        assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
    }
}
