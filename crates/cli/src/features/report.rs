//! Table of features, with one line for each feature.

use crate::failure::Failure;
use crate::frequency::Band;
use crate::measure::Measure;
use crate::number::{Cell, Lossless as _, computed};
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::study::columns::{Column, FeatureLine, FeatureTable, MovingPart, Setting};
use frictiongen::study::features::Sensed;
use frictiongen::study::joined::JoinedError;
use serde_json::{Value as Json, json};

/// The features of a response, with the options for the output.
pub struct FeaturesReport<'s> {
    /// The system that the results describe.
    pub system: &'s System,
    /// Range of frequencies of the results.
    pub band: Band,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The features, one for each line.
    pub lines: Vec<FeatureLine>,
}

/// Returns the columns of the table of features, for a system and its units.
pub fn table<'a>(
    system: &'a System,
    band: &Band,
    measure: Measure,
    parts: &'a [MovingPart],
) -> FeatureTable<'a> {
    FeatureTable {
        setting: Setting {
            parts,
            ..Setting::new(system, measure, band.unit())
        },
    }
}

impl FeaturesReport<'_> {
    /// Returns the columns of the table of features, for the system and the units of this report.
    pub fn table(&self) -> FeatureTable<'_> {
        table(self.system, &self.band, self.measure, &[])
    }

    fn derivatives(&self, sensed: &Sensed) -> Json {
        let table = self.table();
        let each = sensed.slopes.iter().map(|slope| {
            json!({
                "parameter": table.symbol(slope.parameter),
                "value": Cell::from(slope.value).json(),
                "derivative": Cell::from(slope.derivative).json(),
            })
        });
        each.collect()
    }
}

impl ResultTable for FeaturesReport<'_> {
    type Row = FeatureLine;

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn each(&self, visit: Visitor<'_, FeatureLine>) -> Result<(), Failure> {
        self.lines.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, FeatureLine>> {
        self.table().columns(&self.lines)
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        let [from, to] = [self.band.from, self.band.to];
        let ends = [from, to].map(computed);
        let mut text = format!("r from {} to {}", ends[0], ends[1]);
        if self.band.tells_hertz() {
            let hertz = [from, to].map(|r| computed(self.system.hertz(r)));
            text.push_str(&format!(", {} to {} Hz", hertz[0], hertz[1]));
        }
        let mut lines = vec![("range", text)];
        if let Ok(joined) = self.system.joined()
            && self.system.scene().is_joined()
        {
            lines.push((
                "not listed",
                "invariant points, thresholds and regimes, which need a single contact without dashpots".to_owned(),
            ));
            let scale = self.measure.scale();
            let joined = scale.map_or_else(
                || joined.clone(),
                |scale| joined.with_length(scale.length()),
            );
            if let Err(error @ (JoinedError::NotLinear | JoinedError::NoAmplitude)) =
                joined.stuck_limit(from)
            {
                lines.push(("without frictions", error.to_string()));
            }
            if joined.is_damped() {
                let text = "there are no antiresonances".to_owned();
                lines.push(("with damping", text));
            }
        } else if self.system.modal().is_damped() {
            lines.push((
                "with damping",
                "there are no antiresonances, invariant points or inversions; two frictions can have the same \
                 amplitude at a frequency"
                    .to_owned(),
            ));
        }
        lines
    }

    fn more(&self, line: &FeatureLine) -> Option<(&'static str, Json)> {
        let all = line.sensed.iter();
        let all = all.map(|(name, sensed)| ((*name).to_owned(), self.derivatives(sensed)));
        Some(("derivatives", all.collect()))
    }
}
