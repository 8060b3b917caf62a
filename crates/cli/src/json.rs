//! Writes the output of a command as one JSON object. Each point has a line of its own, which the program writes as
//! soon as it has computed the point.

use crate::number::{Cell, Lossless as _};
use crate::summary::Summary;
use serde_json::Value as Json;
use std::io::{self, Write};

/// Version of the object's format. It increases when a field gets another name or another meaning.
const VERSION: u32 = 1;

/// Writes the output of a command as a JSON object, step by step.
pub struct JsonWriter<'a> {
    out: &'a mut dyn Write,
    empty: bool,
}

impl<'a> JsonWriter<'a> {
    /// Begins the JSON object, and writes all fields that come before the points. `name` is that of the list of points.
    pub fn begin(
        out: &'a mut dyn Write,
        summary: &Summary,
        (head, name): (&[(String, Json)], &str),
    ) -> io::Result<Self> {
        let list = |values: &[f64]| numbers(values.iter().copied());
        writeln!(out, "{{")?;
        writeln!(out, "\"version\": {VERSION},")?;
        writeln!(out, "\"scene\": {},", Json::from(summary.scene.as_str()))?;
        let frequencies = list(&summary.natural_frequencies);
        writeln!(out, "\"natural_frequencies\": {frequencies},")?;
        if let Some(hertz) = &summary.hertz {
            writeln!(out, "\"natural_frequencies_Hz\": {},", list(hertz))?;
        }
        if let (Some(scale), Some(_)) = (summary.measure.scale(), summary.measure.load()) {
            let load = object([
                ("force_N", scale.force().into()),
                ("length_m", scale.length().into()),
            ]);
            writeln!(out, "\"load\": {},", Json::Object(load))?;
        }
        writeln!(out, "\"resonances\": {},", list(&summary.resonances))?;
        for (name, value) in head {
            writeln!(out, "\"{name}\": {value},")?;
        }
        write!(out, "\"{name}\": [")?;
        Ok(Self { out, empty: true })
    }

    /// Writes a point to the object's list of points.
    pub fn point(&mut self, point: &Json) -> io::Result<()> {
        let comma = if self.empty { "" } else { "," };
        self.empty = false;
        write!(self.out, "{comma}\n{point}")
    }

    /// Ends the list of points and the JSON object, which may end with one more field.
    pub fn end(self, tail: Option<(&str, String)>) -> io::Result<()> {
        write!(self.out, "\n]")?;
        if let Some((name, text)) = tail {
            write!(self.out, ",\n\"{name}\": {}", Json::from(text))?;
        }
        writeln!(self.out, "\n}}")
    }
}

/// Returns a JSON list of numbers.
fn numbers(values: impl Iterator<Item = f64>) -> Json {
    values.map(|value| Cell::from(value).json()).collect()
}

/// Returns a JSON object. serde_json sorts its fields by name.
pub fn object<const N: usize>(fields: [(&str, Json); N]) -> serde_json::Map<String, Json> {
    fields
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}
