//! Computes the response spectrum of a recorded base motion, with the natural periods of a scene.

use super::read;
use crate::args::RecordingArguments;
use crate::failure::Failure;
use crate::number::computed;
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::measure::columns::{SpectrumRow, spectrum_columns, spectrum_rows};
use frictiongen::study::columns::Column;
use frictiongen::study::scene::Excitation;
use serde_json::{Value as Json, json};

/// The response spectrum of a recorded base motion, with the options for the output.
pub struct ResponseSpectrumReport<'s> {
    system: &'s System,
    zeta: f64,
    /// The peak responses: first those at the natural periods of the scene, then those over the whole range of periods.
    pub rows: Vec<SpectrumRow>,
}

impl<'s> ResponseSpectrumReport<'s> {
    /// Computes the response spectrum for oscillators with the damping ratio ζ.
    pub fn of(system: &'s System, files: &RecordingArguments, zeta: f64) -> Result<Self, Failure> {
        if system.scene().excitation != Excitation::Base {
            return Err(Failure::new(
                "--spectrum: a response spectrum belongs to a moving base; write `excitation: base`, or leave --spectrum out",
            ));
        }
        let recording = files.inputs()?;
        let rows = spectrum_rows(system, &recording, zeta).map_err(|error| {
            let path = files.recordings.first();
            path.map_or_else(|| Failure::new(&error), |path| read::told(path, &error))
        })?;
        Ok(Self { system, zeta, rows })
    }

    /// Returns a phrase about the oscillators of the spectrum.
    pub fn description(&self) -> String {
        format!(
            "largest response within the record, damping ratio {}",
            computed(self.zeta)
        )
    }
}

impl ResultTable for ResponseSpectrumReport<'_> {
    type Row = SpectrumRow;

    fn len(&self) -> usize {
        self.rows.len()
    }

    fn each(&self, visit: Visitor<'_, SpectrumRow>) -> Result<(), Failure> {
        self.rows.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, SpectrumRow>> {
        spectrum_columns(self.system)
    }

    fn head(&self) -> Vec<(String, Json)> {
        vec![("damping_ratio".to_owned(), json!(self.zeta))]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![("response spectrum", self.description())]
    }
}
