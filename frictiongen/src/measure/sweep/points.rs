//! Measured amplitudes of a sweep, and the table that contains them.

use crate::measure::MeasureError;
use crate::measure::recording::CsvTable;
use crate::study::System;

/// One measured amplitude of a mass at one frequency, without friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPoint {
    /// Driving frequency of the measured point, in Hz.
    pub hertz: f64,
    /// Index of the measured mass in the scene description.
    pub mass: usize,
    /// Measured amplitude: |X/Y| for base motion, or |X/P| in m/N for a force. X is the amplitude of the mass.
    pub amplitude: f64,
    /// Standard deviation of the amplitude. If it is `None`, the fit assumes the same relative error for all
    /// amplitudes, as in (6.16).
    pub deviation: Option<f64>,
}

impl SweepPoint {
    /// Reads the points of a sweep from a table. Its columns are `frequency_Hz`, then `NAME.transmissibility` and
    /// optionally `NAME.deviation` for each mass. The call ignores other columns and empty cells.
    ///
    /// # Errors
    /// [`MeasureError`] for a cell that is not a number, and for missing frequencies. [`MeasureError`] also for a mass
    /// that the scene does not have, and for a table without points.
    pub fn read(text: &str, system: &System) -> Result<Vec<Self>, MeasureError> {
        let table = CsvTable::read(text)?;
        let named = |name: &str| table.names.iter().position(|other| other == name);
        let wrong = |what: String| MeasureError::Sweep { line: 1, what };
        let frequency = named("frequency_Hz")
            .ok_or_else(|| wrong("there is no column `frequency_Hz`".to_owned()))?;
        let mut columns = Vec::new();
        for (place, name) in table.names.iter().enumerate() {
            let Some(mass) = name.strip_suffix(".transmissibility") else {
                continue;
            };
            let known = &system.scene().masses;
            let index = known.iter().position(|other| other.name == mass);
            let index = index.ok_or_else(|| MeasureError::NoSuchPlace {
                channel: mass.to_owned(),
                known: known.iter().map(|mass| mass.name.clone()).collect(),
            })?;
            columns.push((index, place, named(&format!("{mass}.deviation"))));
        }
        if columns.is_empty() {
            return Err(wrong(
                "there is no column `NAME.transmissibility` of a mass".to_owned(),
            ));
        }
        let mut points = Vec::new();
        for (row, line) in table.rows.iter().zip(&table.lines) {
            let cell = |place: usize| row.get(place).copied().flatten();
            for (mass, place, deviation) in &columns {
                let (Some(hertz), Some(amplitude)) = (cell(frequency), cell(*place)) else {
                    continue;
                };
                let deviation = deviation.and_then(cell);
                let fits = 0.0 < hertz
                    && 0.0 < amplitude
                    && deviation.is_none_or(|deviation| 0.0 < deviation);
                if !fits {
                    return Err(MeasureError::Sweep {
                        line: *line,
                        what: "frequencies, transmissibilities and deviations must be above 0"
                            .to_owned(),
                    });
                }
                points.push(Self {
                    hertz,
                    mass: *mass,
                    amplitude,
                    deviation,
                });
            }
        }
        Ok(points)
    }
}
