//! Reads recordings and sweeps from CSV text, and writes recordings as CSV text. The text has a line of names with
//! units, then numbers.

use super::Channel;
use super::bare;
use super::rate::even_rate;
use super::series::Recording;
use super::table::{self, CsvRequest, CsvTable};
use super::unit::{Dimension, Unit};
use crate::measure::MeasureError;
use std::fmt::Write as _;

impl CsvTable {
    /// Reads a table: a line of names, optionally a line of units, then numbers. The function ignores lines that begin
    /// with #.
    pub(crate) fn read(text: &str) -> Result<Self, MeasureError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
            .peekable();
        let (number, head) = lines.next().ok_or(MeasureError::Format {
            line: 1,
            what: "the file is empty".to_owned(),
        })?;
        let separator = [';', '\t', ',']
            .into_iter()
            .find(|mark| head.contains(*mark));
        let cells = |line: &str| -> Vec<String> {
            let clean = |cell: &str| cell.trim().trim_matches('"').trim().to_owned();
            match separator {
                Some(mark) => line.split(mark).map(clean).collect(),
                None => vec![clean(line)],
            }
        };
        let mut names = cells(head);
        if names.iter().any(|name| name.parse::<f64>().is_ok()) {
            return Err(MeasureError::Format {
                line: number,
                what:
                    "the first line must name the columns with their units, but here it has numbers"
                        .to_owned(),
            });
        }
        if let Some((_, second)) = lines.peek() {
            let units = cells(second);
            let worded = units.iter().all(|unit| unit.parse::<f64>().is_err());
            let known = units.iter().any(|unit| unit.parse::<Unit>().is_ok());
            if units.len() == names.len() && worded && known {
                for (name, unit) in names.iter_mut().zip(&units) {
                    let has = Unit::split(name).1.is_some();
                    if !unit.is_empty() && !has {
                        let _ = write!(name, " ({unit})");
                    }
                }
                lines.next();
            }
        }
        let mut table = Self {
            names,
            lines: Vec::new(),
            rows: Vec::new(),
        };
        for (line, text) in lines {
            let found = cells(text);
            if found.len() != table.names.len() {
                return Err(MeasureError::Format {
                    line,
                    what: format!(
                        "it has {} cells, but there are {} names",
                        found.len(),
                        table.names.len()
                    ),
                });
            }
            let row = found.iter().zip(&table.names).map(|(cell, name)| {
                if cell.is_empty() {
                    return Ok(None);
                }
                // If commas do not separate the cells, a comma is a decimal comma.
                let value = table::number(cell, separator != Some(','));
                value.map(Some).ok_or_else(|| MeasureError::NotANumber {
                    line,
                    channel: name.clone(),
                    text: cell.clone(),
                })
            });
            let row = row.collect::<Result<_, _>>()?;
            table.rows.push(row);
            table.lines.push(line);
        }
        Ok(table)
    }

    /// Returns all numbers of a column. Fails for an empty cell.
    fn column(&self, index: usize) -> Result<Vec<f64>, MeasureError> {
        let name = self.names.get(index).cloned().unwrap_or_default();
        let cells = self.rows.iter().zip(&self.lines);
        cells
            .map(|(row, line)| {
                let cell = row.get(index).copied().flatten();
                cell.ok_or_else(|| MeasureError::NotANumber {
                    line: *line,
                    channel: name.clone(),
                    text: String::new(),
                })
            })
            .collect()
    }

    /// Returns the index of a column. `asked` is the name of the column, or its number as text.
    fn place(&self, asked: &str) -> Option<usize> {
        let named = |name: &String| name == asked || Unit::split(name).0 == asked;
        let by_number = || asked.parse::<usize>().ok()?.checked_sub(1);
        self.names
            .iter()
            .position(named)
            .or_else(by_number)
            .filter(|place| *place < self.names.len())
    }
}

/// Returns the name of the signal in a column. It is the column's name without its unit and without an ending such as
/// `.displacement`.
fn subject(name: &str) -> &str {
    let kinds = [".displacement", ".velocity", ".acceleration", ".amplitude"];
    let stripped = kinds.iter().find_map(|kind| name.strip_suffix(kind));
    stripped.unwrap_or(name)
}

/// Returns true if a column contains the time of the samples.
fn is_time(name: &str, unit: Option<Unit>) -> bool {
    ["time", "t", "Time"].contains(&name)
        || unit.is_some_and(|unit| unit.dimension() == Dimension::Time)
}

impl Recording {
    /// Reads a recording from CSV text: a line of names with their units, then numbers.
    ///
    /// The units are endings of the names, as in `time_s,base_mm,upper_m_s2`, or a second line. Commas, semicolons or
    /// tabs separate the cells. Between semicolons or tabs, a number may have a decimal comma.
    ///
    /// The text may contain numbers alone, without a line of names. [`CsvRequest::columns`] then names the columns. If
    /// the request has no rate, the first of several columns is then the time in s. A text may also be a PEER AT2
    /// record in g, which becomes the channel `base`.
    ///
    /// # Errors
    /// [`MeasureError`] for everything that [`new`](Self::new) rejects, and for a missing unit, rate or column.
    /// [`MeasureError`] also for a cell that is not a number, and for unequal time steps.
    pub fn from_csv(text: &str, request: &CsvRequest) -> Result<Self, MeasureError> {
        let (sampling, channels) = read(text, request)?;
        let rate = match sampling {
            Sampling::Rate(rate) => rate,
            Sampling::Times(times, lines) => even_rate(&times, |index| place(&lines, index))?,
        };
        Self::new(rate, channels)
    }

    /// Reads from CSV text the inputs that drive a scene. One channel is enough, and it may be constant. The time steps may
    /// differ.
    ///
    /// # Errors
    /// Same errors as [`from_csv`](Self::from_csv), and those of [`inputs_at`](Self::inputs_at).
    pub fn inputs_from_csv(text: &str, request: &CsvRequest) -> Result<Self, MeasureError> {
        match read(text, request)? {
            (Sampling::Rate(rate), channels) => Self::inputs(rate, channels),
            (Sampling::Times(times, lines), channels) => {
                Self::inputs_named(&times, channels, |index| place(&lines, index))
            }
        }
    }

    /// Returns the recording as CSV text with all digits of every number. From this text, [`from_csv`](Self::from_csv)
    /// reads an equal recording.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut text = String::from("time_s");
        for channel in self.channels() {
            let _ = write!(text, ",{}_{}", channel.name, channel.unit.ending());
        }
        text.push('\n');
        for index in 0..self.len() {
            let time = self.uneven_times().and_then(|times| times.get(index));
            let time = time.map_or_else(|| index as f64 / self.rate(), |time| *time);
            let _ = write!(text, "{time:?}");
            for channel in self.channels() {
                let value = channel.samples.get(index).copied().unwrap_or(f64::NAN);
                let _ = write!(text, ",{value:?}");
            }
            text.push('\n');
        }
        text
    }
}

/// Sampling of the channels in a file.
enum Sampling {
    /// Samples per second.
    Rate(f64),
    /// Times of the samples in s, and the line of each in the file.
    Times(Vec<f64>, Vec<usize>),
}

/// Returns the name of a sample for an error.
fn place(lines: &[usize], index: usize) -> String {
    format!("line {}", lines.get(index).copied().unwrap_or(0))
}

/// Returns the sampling and the channels of CSV text.
fn read(text: &str, request: &CsvRequest) -> Result<(Sampling, Vec<Channel>), MeasureError> {
    if let Some(record) = bare::at2(text, request) {
        return record.map(|(rate, channels)| (Sampling::Rate(rate), channels));
    }
    let table = match bare::columns(text, request.rate)? {
        Some(_) if request.columns.is_empty() => {
            return Err(MeasureError::Format {
                line: 1,
                what: "the columns have no names; write names in the first line, or give the column and the unit of each \
                       channel: --channel base=2:g, in Python channels={\"base\": (2, \"g\")}"
                    .to_owned(),
            });
        }
        Some(table) => table,
        None => CsvTable::read(text).map_err(|error| bare::foreign(text, error))?,
    };
    let mut time = None;
    let mut channels = Vec::new();
    let mut add = |name: &str, place: usize, unit: Option<Unit>| -> Result<(), MeasureError> {
        let samples = table.column(place)?;
        if is_time(name, unit) {
            let unit = unit.ok_or_else(|| MeasureError::NoUnit(name.to_owned()))?;
            time = Some(
                samples
                    .into_iter()
                    .map(|t| t * unit.scale())
                    .collect::<Vec<f64>>(),
            );
            return Ok(());
        }
        channels.push(Channel {
            name: name.to_owned(),
            unit: unit.ok_or_else(|| MeasureError::NoUnit(name.to_owned()))?,
            samples,
        });
        Ok(())
    };
    if request.columns.is_empty() {
        for (place, header) in table.names.iter().enumerate() {
            let (name, unit) = Unit::split(header);
            add(subject(name), place, unit)?;
        }
    } else {
        let asked = request.columns.iter();
        let time_asked = asked.clone().any(|column| column.name == "time");
        for column in asked {
            let place = table
                .place(&column.column)
                .ok_or_else(|| MeasureError::Format {
                    line: 1,
                    what: format!(
                        "there is no column `{}`; the columns are {}",
                        column.column,
                        table.names.join(", ")
                    ),
                })?;
            let own = table.names.get(place).and_then(|name| Unit::split(name).1);
            add(&column.name, place, column.unit.or(own))?;
        }
        if !time_asked && request.rate.is_none() {
            let split = table.names.iter().map(|name| Unit::split(name));
            let found = split
                .enumerate()
                .find(|(_, (name, unit))| is_time(name, *unit));
            if let Some((place, (name, unit))) = found {
                add(name, place, unit)?;
            }
        }
    }
    let sampling = match (time, request.rate) {
        (Some(time), None) => Sampling::Times(time, table.lines),
        (_, Some(rate)) => Sampling::Rate(rate),
        (None, None) => return Err(MeasureError::NoRate),
    };
    Ok((sampling, channels))
}
