//! Formats numbers, paths and text for XML documents.

use crate::geometry::Point;
use std::fmt::Write as _;

/// Returns the SVG path data of lines, as steps from point to point. The text is half as long as with absolute
/// coordinates. `end` follows each line, such as `Z` to close it.
pub(crate) fn data(lines: &[Vec<Point>], end: &str) -> String {
    let mut data = String::new();
    for line in lines.iter().filter(|line| 1 < line.len()) {
        let mut last = None;
        for (x, y) in line.iter().filter(|(x, y)| x.is_finite() && y.is_finite()) {
            // The steps connect points that are already rounded. The rounding errors of the steps therefore do not add
            // up.
            let (x, y) = (hundredths(*x), hundredths(*y));
            match last {
                None => {
                    let _ = write!(data, "M{} {}", number(x / 100.0), number(y / 100.0));
                }
                Some((last, _)) if last == (x, y) => continue,
                Some(((last_x, last_y), first)) => {
                    // Before a negative number no blank is needed, because the minus sign separates the numbers.
                    let back = if x < last_x { "" } else { " " };
                    data.push_str(if first { "l" } else { back });
                    step(&mut data, (x - last_x) / 100.0);
                    data.push_str(if y < last_y { "" } else { " " });
                    step(&mut data, (y - last_y) / 100.0);
                }
            }
            last = Some(((x, y), last.is_none()));
        }
        data.push_str(end);
    }
    data
}

/// Appends a number to SVG path data, without the zero before the decimal point.
fn step(data: &mut String, value: f64) {
    let text = number(value);
    match text.split_once("0.") {
        Some((sign @ ("" | "-"), rest)) => {
            let _ = write!(data, "{sign}.{rest}");
        }
        _ => data.push_str(&text),
    }
}

/// Rounds a length to hundredths of a pixel, and returns the number of hundredths.
fn hundredths(value: f64) -> f64 {
    (value * 100.0).round()
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
    use super::{data, escaped, number};

    /// Returns the points of a path, adding up the steps as a reader of SVG does.
    fn read(path: &str) -> Vec<(f64, f64)> {
        let (start, steps) = path.split_once('l').expect("steps");
        let spaced = steps.replace('-', " -");
        let numbers = |text: &str| -> Vec<f64> {
            let words = text.trim_start_matches('M').split_whitespace();
            words.map(|word| word.parse().expect("a number")).collect()
        };
        let mut place = (0.0, 0.0);
        let pairs = [numbers(start), numbers(&spaced)].concat();
        let add = |pair: &[f64]| {
            place = (place.0 + pair[0], place.1 + pair[1]);
            place
        };
        pairs.chunks(2).map(add).collect()
    }

    #[test]
    fn a_path_leads_through_its_points() {
        let wave = |i: i32| {
            (
                0.31 * f64::from(i),
                90.0 + 70.0 * (0.1 * f64::from(i)).sin(),
            )
        };
        let line: Vec<_> = (0..500).map(wave).collect();
        let path = data(std::slice::from_ref(&line), "");
        let found = read(&path);
        assert_eq!(found.len(), line.len());
        for (found, point) in found.iter().zip(&line) {
            // Rounding to hundredths moves each coordinate by at most 0.005 pixels. This bound is the same at any
            // position in the path.
            let off = (found.0 - point.0).abs().max((found.1 - point.1).abs());
            assert!(off <= 0.005 + 1e-9, "{found:?} {point:?}");
        }
        // Points that round to the same position make no line.
        assert_eq!(data(&[vec![(1.0, 2.0), (1.001, 2.0)]], "Z"), "M1 2Z");
        assert_eq!(
            data(&[vec![(1.0, 2.0), (0.5, 1.75), (2.0, 3.0)]], ""),
            "M1 2l-.5-.25 1.5 1.25"
        );
    }

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
