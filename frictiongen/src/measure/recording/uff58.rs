//! Reads and writes data set 58 of the Universal File Format in its text form. A file contains functions of time at
//! nodes. Each channel of a recording is one data set.
//!
//! No crate reads this format. The reader accepts real data, evenly or unevenly spaced, in single or double precision.
//! The writer writes evenly spaced data in double precision, with 13 digits of each sample and 6 digits of the time
//! step.

use super::{Channel, CsvColumn, CsvRequest, Dimension, Recording, Unit};
use crate::measure::MeasureError;
use std::fmt::Write as _;

/// Function type 1 of a data set 58: a response over time.
const TIME_RESPONSE: i64 = 1;
/// Abscissa type 17 of a data set 58: time.
const TIME: i64 = 17;
/// Largest relative difference at which two time steps are treated as equal. The file contains only six digits of a
/// time step.
const SAME: f64 = 2e-5;

/// One data set 58 of a file. It contains one channel.
struct Set {
    line: usize,
    channel: Channel,
    step: f64,
}

/// The lines of a file, with their numbers.
struct FileLines<'t> {
    lines: std::iter::Peekable<std::iter::Enumerate<std::str::Lines<'t>>>,
    last: usize,
}

impl<'t> FileLines<'t> {
    fn next(&mut self) -> Result<&'t str, MeasureError> {
        let (index, line) = self.lines.next().ok_or_else(|| MeasureError::Format {
            line: self.last + 1,
            what: "the file ends within a data set".to_owned(),
        })?;
        self.last = index + 1;
        Ok(line)
    }

    fn wrong<T>(&self, what: impl Into<String>) -> Result<T, MeasureError> {
        Err(MeasureError::Format {
            line: self.last,
            what: what.into(),
        })
    }
}

/// Returns the characters of a line between two columns, without blanks. If the line ends earlier, the result is
/// shorter.
fn field(line: &str, from: usize, to: usize) -> &str {
    line.get(from..to.min(line.len())).unwrap_or("").trim()
}

fn number<T: std::str::FromStr>(
    lines: &FileLines<'_>,
    text: &str,
    what: &str,
) -> Result<T, MeasureError> {
    match text.replace(['D', 'd'], "E").parse() {
        Ok(value) => Ok(value),
        Err(_) => lines.wrong(format!("`{text}` is not {what}")),
    }
}

impl Recording {
    /// Reads a recording from the functions of time in a universal file: the data sets 58 in text form.
    ///
    /// The response entity of a data set is the name of its channel. If there is no entity, or if the first line of
    /// the data set begins with the entity, the first line is the name. The unit is the label of the ordinate, or the
    /// unit that `request` gives for the column of this name. The type code of the ordinate alone does not give a
    /// unit.
    ///
    /// # Errors
    /// [`MeasureError`] for everything that [`new`](Self::new) rejects, and for a data set that is not in this form.
    /// [`MeasureError`] also for a channel without a unit, and for unequal time steps.
    pub fn from_uff58(text: &str, request: &CsvRequest) -> Result<Self, MeasureError> {
        let mut lines = FileLines {
            lines: text.lines().enumerate().peekable(),
            last: 0,
        };
        let mut sets: Vec<Set> = Vec::new();
        while lines.lines.peek().is_some() {
            if lines.next()?.trim() != "-1" {
                continue;
            }
            if lines.lines.peek().is_none() {
                break;
            }
            let kind = lines.next()?.trim();
            match kind {
                "58" => sets.extend(set(&mut lines, request)?),
                kind if kind.starts_with("58") => {
                    return lines.wrong("the data set 58 is binary; write it as text");
                }
                // The reader skips data sets of other types.
                _ => while lines.next()?.trim() != "-1" {},
            }
        }
        let Some(first) = sets.first() else {
            return lines.wrong("the file has no function of time (data set 58)");
        };
        let step = first.step;
        for set in &sets {
            if SAME * step < (set.step - step).abs() {
                return Err(MeasureError::MixedRates {
                    place: format!("the channel `{}`, line {}", set.channel.name, set.line),
                    before: step,
                    after: set.step,
                });
            }
        }
        let rate = request.rate.unwrap_or(1.0 / step);
        if SAME < (rate * step - 1.0).abs() {
            return Err(MeasureError::MixedRates {
                place: "the rate given".to_owned(),
                before: step,
                after: 1.0 / rate,
            });
        }
        Self::new(rate, sets.into_iter().map(|set| set.channel).collect())
    }

    /// Returns the recording as a universal file, one data set 58 for each channel.
    #[must_use]
    pub fn to_uff58(&self) -> String {
        let mut text = String::new();
        for channel in self.channels() {
            let ordinate = match channel.unit.dimension() {
                Dimension::Displacement => 8,
                Dimension::Velocity => 11,
                Dimension::Acceleration => 12,
                _ => 13,
            };
            let name = &channel.name;
            let axis = |kind: i64, label: &str, unit: &str| {
                format!("{kind:>10}    0    0    0 {label:<20} {unit:<20}\n")
            };
            text.push_str("    -1\n    58\n");
            let _ = write!(text, "{name}\nNONE\nNONE\nNONE\nNONE\n");
            let _ = writeln!(
                text,
                "{TIME_RESPONSE:>5}{:>10}{:>5}{:>10} {:<10}{:>10}{:>4} {:<10}{:>10}{:>4}",
                0,
                0,
                0,
                short(name),
                0,
                0,
                "NONE",
                0,
                0
            );
            let count = channel.samples.len();
            let times = self.uneven_times();
            let step = times.map_or(1.0 / self.rate(), |_| 0.0);
            let (start, step) = (exponential(0.0, 5), exponential(step, 5));
            let _ = writeln!(
                text,
                "{:>10}{count:>10}{:>10}{start:>13}{step:>13}{start:>13}",
                4,
                u8::from(times.is_none())
            );
            text.push_str(&axis(TIME, "Time", "s"));
            text.push_str(&axis(ordinate, "NONE", channel.unit.name()));
            text.push_str(&axis(0, "NONE", "NONE"));
            text.push_str(&axis(0, "NONE", "NONE"));
            let times = times.unwrap_or_default();
            for (index, value) in channel.samples.iter().enumerate() {
                if let Some(time) = times.get(index) {
                    let _ = write!(text, "{:>13}", exponential(*time, 5));
                }
                let _ = write!(text, "{:>20}", exponential(*value, 12));
                let line = if times.is_empty() { 4 } else { 2 };
                if (index + 1).is_multiple_of(line) || index + 1 == count {
                    text.push('\n');
                }
            }
            text.push_str("    -1\n");
        }
        text
    }
}

/// Returns the first ten characters of a name. The entity field has this width.
fn short(name: &str) -> String {
    name.chars().take(10).collect()
}

/// Formats a number with an exponent as Fortran does, for example 1.00000E-03.
fn exponential(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$E}");
    let Some((mantissa, exponent)) = text.split_once('E') else {
        return text;
    };
    let (sign, size) = match exponent.strip_prefix('-') {
        Some(size) => ('-', size),
        None => ('+', exponent),
    };
    format!("{mantissa}E{sign}{size:0>2}")
}

/// Reads the next data set 58. Returns `None` if the data set contains no function of time, or if the request does not
/// include its channel.
fn set(lines: &mut FileLines<'_>, request: &CsvRequest) -> Result<Option<Set>, MeasureError> {
    let line = lines.last;
    let title = lines.next()?.trim().to_owned();
    for _ in 0..4 {
        lines.next()?;
    }
    let record = lines.next()?;
    let function: i64 = number(lines, field(record, 0, 5), "a function type")?;
    let entity = field(record, 31, 41);
    // The entity field has room for only ten characters. The function therefore reads a longer name from the title.
    let name = match entity {
        "" | "NONE" => title.as_str(),
        entity if title.starts_with(entity) => title.as_str(),
        entity => entity,
    }
    .to_owned();
    let record = lines.next()?;
    let kind: i64 = number(lines, field(record, 0, 10), "a data type")?;
    let count: usize = number(lines, field(record, 10, 20), "a number of samples")?;
    let even: i64 = number(lines, field(record, 20, 30), "0 (uneven) or 1 (even)")?;
    let step: f64 = number(lines, field(record, 43, 56), "a step")?;
    let abscissa = lines.next()?;
    let abscissa: i64 = number(lines, field(abscissa, 0, 10), "a kind of abscissa")?;
    let ordinate = lines.next()?;
    let code: i64 = number(lines, field(ordinate, 0, 10), "a kind of ordinate")?;
    let label = field(ordinate, 47, 67).to_owned();
    lines.next()?;
    lines.next()?;
    let values = values(lines)?;
    let asked = request.columns.iter().find(|column| column.column == name);
    let of_time = function == TIME_RESPONSE && (abscissa == TIME || abscissa == 0);
    if !of_time || (asked.is_none() && !request.columns.is_empty()) {
        return Ok(None);
    }
    if kind != 2 && kind != 4 {
        return lines.wrong(format!(
            "`{name}` has complex samples, but a function of time must be real"
        ));
    }
    let unit = unit(&name, &label, asked)?;
    check_code(&name, code, unit)?;
    let (step, samples) = if even == 1 {
        (step, values)
    } else {
        unspaced(&name, line, &values)?
    };
    if samples.len() != count {
        return lines.wrong(format!(
            "`{name}` has {} samples, but its header says {count}",
            samples.len()
        ));
    }
    if !(0.0 < step && step.is_finite()) {
        return lines.wrong(format!("`{name}`: the time step {step} is not above 0"));
    }
    let name = asked.map_or(name, |asked| asked.name.clone());
    Ok(Some(Set {
        line,
        channel: Channel {
            name,
            unit,
            samples,
        },
        step,
    }))
}

/// Reads the numbers until the end of the data set. A number occupies 13 or 20 characters. Blanks usually separate the
/// numbers.
fn values(lines: &mut FileLines<'_>) -> Result<Vec<f64>, MeasureError> {
    let mut values = Vec::new();
    loop {
        let line = lines.next()?;
        if line.trim() == "-1" {
            return Ok(values);
        }
        for cell in cells(line) {
            let value: f64 = number(lines, cell, "a number")?;
            values.push(value);
        }
    }
}

/// Returns the numbers of a line as texts. A negative number may follow the previous number without a blank. The end of
/// the previous number's exponent then separates the two numbers.
fn cells(line: &str) -> impl Iterator<Item = &str> {
    line.split_whitespace().flat_map(|word| {
        let mut parts = Vec::new();
        let mut rest = word;
        while let Some(mark) = rest.find(['E', 'e', 'D', 'd']) {
            // The exponent has a sign and two or three digits.
            let end = rest
                .char_indices()
                .skip_while(|(place, _)| *place < mark + 2)
                .find(|(_, sign)| ['-', '+'].contains(sign))
                .map_or(rest.len(), |(place, _)| place);
            let (one, more) = rest.split_at(end);
            parts.push(one);
            rest = more;
        }
        if !rest.is_empty() {
            parts.push(rest);
        }
        parts
    })
}

fn unit(name: &str, label: &str, asked: Option<&CsvColumn>) -> Result<Unit, MeasureError> {
    match asked.and_then(|asked| asked.unit) {
        Some(unit) => Ok(unit),
        None if label.is_empty() || label == "NONE" => Err(MeasureError::NoUnit(name.to_owned())),
        None => label.parse(),
    }
}

/// Fails if the type code of the ordinate is known and contradicts the unit of the channel.
fn check_code(name: &str, code: i64, unit: Unit) -> Result<(), MeasureError> {
    let dimension = match code {
        8 => Dimension::Displacement,
        11 => Dimension::Velocity,
        12 => Dimension::Acceleration,
        9 | 13 => Dimension::Force,
        _ => return Ok(()),
    };
    if dimension == unit.dimension() {
        return Ok(());
    }
    Err(MeasureError::WrongDimension {
        channel: name.to_owned(),
        unit: unit.name(),
        needed: dimension.needed(),
    })
}

/// Converts pairs of time and sample to the time step and the samples. Fails if the times are not evenly spaced.
fn unspaced(name: &str, line: usize, values: &[f64]) -> Result<(f64, Vec<f64>), MeasureError> {
    let pairs: Vec<(f64, f64)> = values
        .chunks_exact(2)
        .filter_map(|pair| Some((*pair.first()?, *pair.last()?)))
        .collect();
    let steps = pairs.len().saturating_sub(1).max(1) as f64;
    let (Some(first), Some(last)) = (pairs.first(), pairs.last()) else {
        return Ok((0.0, Vec::new()));
    };
    let mean = (last.0 - first.0) / steps;
    for pair in pairs.windows(2) {
        let &[a, b] = pair else { continue };
        // The times in the file have six digits. The tolerance therefore includes the rounding of a time.
        let rounded = 1e-5 * a.0.abs().max(b.0.abs());
        if 1e-2 * mean + rounded < (b.0 - a.0 - mean).abs() {
            return Err(MeasureError::MixedRates {
                place: format!("the channel `{name}`, line {line}"),
                before: mean,
                after: b.0 - a.0,
            });
        }
    }
    Ok((mean, pairs.into_iter().map(|pair| pair.1).collect()))
}
