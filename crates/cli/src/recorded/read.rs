//! Reads recordings, and the description of the scene on which they were recorded.

use crate::args::{FileArgument, RecordingArguments};
use crate::asked::number_that;
use crate::failure::{Failure, reason};
use crate::grid::MOST_POINTS;
use frictiongen::System;
use frictiongen::measure::{
    CsvColumn, CsvRequest, Inputs, MeasureError, Measured, Recording, Unit,
};
use frictiongen_codegen::SizeLimits;
use std::fs;
use std::path::Path;

/// Reads the scene on which the recordings were made.
pub fn scene(path: &Path) -> Result<System, Failure> {
    let file = FileArgument {
        file: Some(path.to_owned()),
    };
    let description = file.description(&SizeLimits::RUN_TIME)?;
    System::try_from(description.scene).map_err(Failure::new)
}

/// Reads the scene on which the recordings were made. The scene may have several contacts and dashpots, but its kinetic
/// friction must then be constant.
pub fn any_scene(path: &Path) -> Result<System, Failure> {
    let file = FileArgument {
        file: Some(path.to_owned()),
    };
    let description = file.any(&SizeLimits::RUN_TIME)?;
    System::try_from(description.scene).map_err(Failure::new)
}

/// Reads the text of a file.
pub fn text(path: &Path) -> Result<String, Failure> {
    let bytes = fs::read(path).map_err(|error| {
        Failure::new(format_args!(
            "cannot read {}: {}",
            path.display(),
            reason(&error)
        ))
    })?;
    String::from_utf8(bytes).map_err(|_| {
        Failure::new(format_args!(
            "{} is not a recording: it is not text, as CSV, columns of numbers, PEER AT2 and universal files (UFF58) are",
            path.display()
        ))
    })
}

/// Returns the failure for an error in a file. Its message contains the file's name.
pub fn told(path: &Path, error: &MeasureError) -> Failure {
    Failure::new(format_args!("{}: {error}", path.display()))
}

/// Collects the inputs of a scene from a recording, and follows it for `after` seconds. Error messages contain the name of
/// the file.
pub fn drive<'r>(
    files: &RecordingArguments,
    recording: &'r Recording,
    system: &System,
    (friction, after): (Option<f64>, f64),
) -> Result<Inputs<'r>, Failure> {
    let path = files.recordings.first();
    if MOST_POINTS as f64 <= after * recording.rate() {
        return Err(Failure::new(format_args!(
            "--after: the motion would have more than {MOST_POINTS} samples; give a shorter time"
        )));
    }
    let inputs = Inputs::of(recording, system, friction);
    let inputs = inputs.and_then(|inputs| inputs.followed_by(after));
    inputs.map_err(|error| match path {
        Some(path) => told(path, &error),
        None => Failure::new(error),
    })
}

impl RecordingArguments {
    fn request(&self) -> Result<CsvRequest, Failure> {
        let rate = self
            .rate
            .as_deref()
            .map(|text| number_that("--rate", text, |rate| 0.0 < rate, "a number above 0"))
            .transpose()?;
        let columns = self.channel.iter().map(|text| column(text));
        Ok(CsvRequest {
            rate,
            columns: columns.collect::<Result<_, _>>()?,
        })
    }

    /// Reads all recordings, in the order of the command line.
    pub fn recordings(&self) -> Result<Vec<Recording>, Failure> {
        let request = self.request()?;
        let read = |path: &std::path::PathBuf| {
            let text = text(path)?;
            Recording::from_text(&text, &request).map_err(|error| told(path, &error))
        };
        self.recordings.iter().map(read).collect()
    }

    /// Reads the recording that drives a scene. Fails if the user gives several recordings.
    pub fn inputs(&self) -> Result<Recording, Failure> {
        let [path] = self.recordings.as_slice() else {
            return Err(Failure::new("give only one recording to drive a scene"));
        };
        let text = text(path)?;
        Recording::inputs_from_csv(&text, &self.request()?).map_err(|error| told(path, &error))
    }

    /// Evaluates the steady motion in each recording.
    pub fn measured(&self, system: &System) -> Result<Vec<Measured>, Failure> {
        let recordings = self.recordings()?;
        let pairs = self.recordings.iter().zip(&recordings);
        pairs
            .map(|(path, recording)| {
                Measured::of(recording, system.scene()).map_err(|error| told(path, &error))
            })
            .collect()
    }
}

/// Parses a channel in the form `NAME=COLUMN:UNIT`.
fn column(text: &str) -> Result<CsvColumn, Failure> {
    let wrong = || {
        Failure::new(format_args!(
            "--channel `{text}`: NAME=COLUMN:UNIT is needed, as in lower=AI1:mm"
        ))
    };
    let (name, rest) = text.split_once('=').ok_or_else(wrong)?;
    let (column, unit) = match rest.rsplit_once(':') {
        Some((column, unit)) => (column, Some(unit)),
        None => (rest, None),
    };
    if name.is_empty() || column.is_empty() {
        return Err(wrong());
    }
    let unit = unit.map(str::parse::<Unit>).transpose();
    Ok(CsvColumn {
        name: name.trim().to_owned(),
        column: column.trim().to_owned(),
        unit: unit.map_err(|error| Failure::new(format_args!("--channel `{text}`: {error}")))?,
    })
}
