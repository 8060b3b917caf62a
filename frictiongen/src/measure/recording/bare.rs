//! Reads records without a line of column names: PEER AT2 records, and columns that contain only numbers.

use super::Channel;
use super::table::{CsvRequest, CsvTable, number};
use super::unit::Unit;
use crate::measure::MeasureError;

/// The possible formats of a file with a recording, as text for a message.
const FORMATS: &str = "CSV with a line of names and units, columns of numbers alone with --channel NAME=COLUMN:UNIT, and PEER AT2 in g";

/// Number of lines at the start of an AT2 record in which the reader looks for the number of samples and the time step.
const HEADER: usize = 6;

/// Returns the cells of a line of numbers, or `None` if a cell is not a number. If `commas_separate` is true, commas
/// separate the cells. Otherwise semicolons, tabs or blanks separate them, and numbers may have decimal commas.
fn cells(line: &str, commas_separate: bool) -> Option<Vec<f64>> {
    let words: Vec<&str> = if line.contains(';') {
        line.split(';').map(str::trim).collect()
    } else if commas_separate {
        line.split(',').map(str::trim).collect()
    } else {
        line.split_whitespace().collect()
    };
    let comma = line.contains(';') || !commas_separate;
    words.into_iter().map(|word| number(word, comma)).collect()
}

/// Reads columns that contain only numbers. Returns `None` if the first line is not a line of numbers. Without a rate,
/// the first of several columns contains the time in s.
///
/// If the rate is given, a line such as `0,5` is one number with a decimal comma. If the rate is not given, the line
/// contains the two numbers 0 and 5.
pub(super) fn columns(text: &str, rate: Option<f64>) -> Result<Option<CsvTable>, MeasureError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = text.lines().map(str::trim).enumerate();
    let mut lines = lines
        .map(|(index, line)| (index + 1, line))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with(['#', '%']))
        .peekable();
    let Some((_, first)) = lines.peek().copied() else {
        return Ok(None);
    };
    let one_word = !first.contains([';', ' ', '\t']);
    let spaced = first.split(',').count() != 1 && first.contains('.');
    let commas_separate =
        !first.contains(';') && first.contains(',') && (spaced || (one_word && rate.is_none()));
    let Some(numbers) = cells(first, commas_separate) else {
        return Ok(None);
    };
    let timed = rate.is_none() && 1 < numbers.len();
    let name = |index: usize| match (timed, index) {
        (true, 1) => "time (s)".to_owned(),
        _ => format!("column {index}"),
    };
    let mut table = CsvTable {
        names: (1..=numbers.len()).map(name).collect(),
        lines: Vec::new(),
        rows: Vec::new(),
    };
    for (line, text) in lines {
        let row = cells(text, commas_separate).ok_or_else(|| MeasureError::Format {
            line,
            what: format!("`{text}` is not a line of numbers like the first one"),
        })?;
        if row.len() != numbers.len() {
            let what = format!(
                "it has {} numbers, but the first line has {}",
                row.len(),
                numbers.len()
            );
            return Err(MeasureError::Format { line, what });
        }
        table.rows.push(row.into_iter().map(Some).collect());
        table.lines.push(line);
    }
    Ok(Some(table))
}

/// Adds the possible formats of a recording to the message of `error`. If a line of numbers precedes the faulty line,
/// the function returns `error` unchanged.
pub(super) fn foreign(text: &str, error: MeasureError) -> MeasureError {
    let (line, what) = match &error {
        MeasureError::Format { line, what } => (*line, what.clone()),
        MeasureError::NotANumber {
            line,
            channel,
            text,
        } => (
            *line,
            format!("`{text}` of `{channel}` is not a finite number"),
        ),
        _ => return error,
    };
    let mut before = text.lines().take(line.saturating_sub(1));
    let numeric = |line: &str| {
        let words = line.split([';', '\t', ',', ' ']);
        let mut words = words.filter(|word| !word.is_empty()).peekable();
        words.peek().is_some() && words.all(|word| number(word, false).is_some())
    };
    if before.any(numeric) {
        return error;
    }
    MeasureError::Format {
        line,
        what: format!("{what}; the formats of a recording are {FORMATS}"),
    }
}

/// Data from the header of an AT2 file (a record of an earthquake).
struct At2 {
    /// Number of lines of the file before its first sample.
    lines: usize,
    points: usize,
    step: f64,
}

/// Returns the header of an AT2 record, or `None` if the text has none. The header has a line such as `NPTS= 4000, DT=
/// .0050 SEC`, or the older form `4000 .0050 NPTS, DT`.
fn header(text: &str) -> Option<Result<At2, MeasureError>> {
    let lines = text.lines().take(HEADER).enumerate();
    let mut counted = lines.filter(|(_, line)| {
        let line = line.to_uppercase();
        line.contains("NPTS") && line.contains("DT")
    });
    let (index, line) = counted.next()?;
    let words = line.split(|letter: char| letter.is_whitespace() || [',', '='].contains(&letter));
    let mut numbers = words.filter_map(|word| number(word, false));
    let refuse = |what: &str| MeasureError::Format {
        line: index + 1,
        what: what.to_owned(),
    };
    let (Some(points), Some(step)) = (numbers.next(), numbers.next()) else {
        return Some(Err(refuse(
            "NPTS and DT are needed as numbers, as in `NPTS= 4000, DT= .0050 SEC`",
        )));
    };
    if points < 2.0 || points.fract() != 0.0 || step <= 0.0 {
        return Some(Err(refuse(
            "NPTS must be a whole number of samples, at least 2, and DT a time step above 0 s",
        )));
    }
    let mut above = text.lines().take(index).map(str::to_uppercase);
    let unit = above.find_map(|line| Some(line.split_once("UNITS OF ")?.1.trim().to_owned()));
    match unit.as_deref() {
        Some("G") => Some(Ok(At2 {
            lines: index + 1,
            points: points as usize,
            step,
        })),
        Some(unit) => Some(Err(refuse(&format!(
            "the samples are in {unit}; of PEER records only accelerations in g (AT2) are read"
        )))),
        None => Some(Err(refuse(
            "no line above it says `IN UNITS OF G`, as a PEER AT2 record does",
        ))),
    }
}

/// Reads a PEER AT2 record: the acceleration of the base in units of g. Returns `None` if the text has no line with
/// NPTS and DT.
pub(super) fn at2(
    text: &str,
    request: &CsvRequest,
) -> Option<Result<(f64, Vec<Channel>), MeasureError>> {
    let read = |header: At2| {
        if !request.columns.is_empty() {
            return Err(MeasureError::Format {
                line: header.lines,
                what: "a PEER AT2 record is the acceleration of the base in g; leave --channel out"
                    .to_owned(),
            });
        }
        let mut samples = Vec::with_capacity(header.points.min(text.len()));
        let mut line = header.lines;
        for words in text.lines().skip(header.lines) {
            line += 1;
            for word in words.split_whitespace() {
                let value = number(word, false).ok_or_else(|| MeasureError::NotANumber {
                    line,
                    channel: "base".to_owned(),
                    text: word.to_owned(),
                })?;
                samples.push(value);
            }
        }
        if samples.len() != header.points {
            let what = format!(
                "the file ends here with {} samples, but NPTS is {}",
                samples.len(),
                header.points
            );
            return Err(MeasureError::Format { line, what });
        }
        let base = Channel {
            name: "base".to_owned(),
            unit: Unit::GRAVITY,
            samples,
        };
        Ok((request.rate.unwrap_or(1.0 / header.step), vec![base]))
    };
    Some(header(text)?.and_then(read))
}
