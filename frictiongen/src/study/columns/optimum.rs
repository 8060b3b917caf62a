//! Rows and columns of the tables about the best friction: the result, its peaks, tolerances and sensitivities.

mod lines;

pub use lines::OptimumLine;

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
use super::measure::PhysicalQuantity;
use super::setting::{AtFrequency, Frequency, MovingPart, Setting};
use crate::study::{
    optimum::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance},
    sensitivity::{OperatingPoint, Parameter},
    words,
};

/// The tables of the best friction.
#[derive(Clone, Copy)]
pub struct OptimumTable<'a> {
    /// System, units, and the contact or mass whose amplitude is minimised.
    pub setting: Setting<'a>,
    /// Quantities with their upper bounds. [`Optimum::largest`] has their largest values over the band.
    pub kept: &'a [(MovingPart, f64)],
    /// Several quantities with their divisors, if the search has minimised the largest quotient. Otherwise empty.
    pub weighted: &'a [(MovingPart, f64)],
}

/// A row of the table of peaks: a frequency at which the amplitude with the best friction is largest.
#[derive(Clone, Copy, Debug)]
pub struct PeakRow {
    frequency: Frequency,
    peak: OptimumPeak,
    /// Angular frequency at the frequency ratio r = 1, in rad/s.
    reference: f64,
}

/// A row of the table of sensitivities: the relative change of the best amplitude per unit of one parameter.
#[derive(Clone, Debug)]
pub struct OptimumSensitivityRow {
    parameter: Parameter,
    symbol: String,
    relative: f64,
}

impl TableRow for Optimum {
    fn omega(&self) -> f64 {
        self.reference
    }
}

impl TableRow for PeakRow {
    fn omega(&self) -> f64 {
        self.reference
    }
}

impl AtFrequency for PeakRow {
    fn frequency(&self) -> Frequency {
        self.frequency
    }
}

impl TableRow for Tolerance {}

impl TableRow for OptimumSensitivityRow {}

/// Returns the width of the interval of β that contains the best friction. Returns `None` if the search converged.
fn unsure(optimum: &Optimum) -> Option<f64> {
    let [from, to] = optimum.bracket;
    (optimum.end != OptimumEnd::Converged).then_some(to - from)
}

impl<'a> OptimumTable<'a> {
    /// Returns the rows of the table of peaks.
    #[must_use]
    pub fn peaks(&self, optimum: &Optimum) -> Vec<PeakRow> {
        let peaks = optimum.peaks.iter().map(|peak| PeakRow {
            frequency: Frequency::at(self.setting.system, peak.r),
            peak: *peak,
            reference: optimum.reference,
        });
        peaks.collect()
    }

    /// Returns the rows of the table of sensitivities. Without a load the list is empty.
    #[must_use]
    pub fn sensitivities(&self, optimum: &Optimum) -> Vec<OptimumSensitivityRow> {
        let Some(point) = self.point() else {
            return Vec::new();
        };
        let scene = self.setting.system.scene();
        let all = optimum.sensitivities.iter();
        let rows = all.map(|(parameter, relative)| OptimumSensitivityRow {
            parameter: *parameter,
            symbol: parameter.symbol(scene, &point),
            relative: *relative,
        });
        rows.collect()
    }

    /// Returns an operating point from which the parameters take their names and units. The numbers of the point have
    /// no effect.
    fn point(&self) -> Option<OperatingPoint> {
        Some(OperatingPoint::Physical {
            hertz: 1.0,
            friction: 1.0,
            load: self.setting.measure.load()?,
        })
    }

    /// Returns the columns of the table with the best friction and its amplitude, the limits, and the work of the
    /// search.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, Optimum>> {
        let mut columns = self.best();
        columns.extend(self.bounds());
        columns.extend(self.effort());
        columns
    }

    /// Returns the physical quantity of the minimised amplitude, such as a length or a force.
    fn size(&self) -> PhysicalQuantity {
        let part = self.setting.parts.first();
        part.map_or(PhysicalQuantity::Length, MovingPart::dimension)
    }

    /// Returns the columns of the best friction. The first line of a column's heading is the label in the printed
    /// result.
    fn best(&self) -> Vec<Column<'a, Optimum>> {
        use PhysicalQuantity::Force;
        let mut columns = Columns::new(&self.setting.measure);
        let mut beta = "friction";
        if self.setting.measure.scale().is_some() {
            let head = Head::of("friction", Force);
            columns.number_within(head, |of: &Optimum| Some(of.beta), unsure);
            beta = "beta";
        }
        let head = Head::new("beta").titled(&[beta]);
        columns.number_within(head, |of| Some(of.beta), unsure);
        let part = self.setting.parts.first();
        let label = match part {
            Some(part) => format!("largest amplitude of {}", part.name),
            None => "largest amplitude".to_owned(),
        };
        let head = Head::of("amplitude", self.size()).titled(&[&label]);
        columns.number(head, |of| Some(of.amplitude));
        let head = Head::new("kind").titled(&["what limits it"]);
        columns.word(head, "", |of| Some(words::kind(of.kind)));
        let head = Head::new("end").titled(&["how the search ended"]);
        columns.word(head, "", |of| Some(words::end(of.end)));
        let open = |of: &Optimum| of.end != OptimumEnd::Converged || of.kind == OptimumKind::Flat;
        let head = Head::of("bracket_from", Force).titled(&["the least lies from"]);
        columns.number(head, |of| of.bracket.first().copied());
        columns.say_if(open);
        let head = Head::of("bracket_to", Force).titled(&["the least lies to"]);
        columns.number(head, |of| of.bracket.get(1).copied());
        columns.say_if(open);
        let label = "largest amplitude beyond the jump";
        let head = Head::of("beyond_jump", self.size()).titled(&[label]);
        columns.number(head, |of| of.beyond_jump);
        columns.say_if(|of| of.beyond_jump.is_some());
        columns.done()
    }

    /// Returns the columns with which the best friction can be compared: the limits of friction, the amplitude without
    /// friction, and the amplitude with a stuck contact.
    fn bounds(&self) -> Vec<Column<'a, Optimum>> {
        use PhysicalQuantity::Force;
        let mut columns = Columns::new(&self.setting.measure);
        let head = Head::of("unbounded_to", Force).titled(&["unbounded at a resonance up to"]);
        columns.number(head, |of: &Optimum| Some(of.unbounded_to));
        columns.say_if(|of| 0.0 < of.unbounded_to);
        let head = Head::of("free_of_sticking", Force).titled(&["nothing sticks up to"]);
        columns.number(head, |of| Some(of.free_of_sticking));
        columns.say_if(|of| !of.free_of_sticking.is_nan());
        let head = Head::of("locked", Force).titled(&["stuck over the whole band from"]);
        columns.number(head, |of| Some(of.locked));
        let label = "largest amplitude without friction";
        let head = Head::of("without_friction", self.size()).titled(&[label]);
        columns.number(head, |of| Some(of.without_friction));
        let label = match self.setting.system.scene().is_joined() {
            true => "largest amplitude with all contacts stuck",
            false => "largest amplitude with the contact stuck",
        };
        let head = Head::of("with_contact_locked", self.size()).titled(&[label]);
        columns.number(head, |of| Some(of.with_contact_locked));
        columns.done()
    }

    /// Returns the columns that state the computing work of the search for the best friction.
    fn effort(&self) -> Vec<Column<'a, Optimum>> {
        let mut columns = Columns::new(&self.setting.measure);
        let head = Head::new("evaluations").titled(&["amplitudes computed"]);
        columns.count(head, |of: &Optimum| Some(of.evaluations));
        let label = "frequencies at which the motion does not settle";
        let head = Head::new("unsettled").titled(&[label]);
        columns.count(head, |of| Some(of.unsettled.len()));
        columns.say_if(|of| !of.unsettled.is_empty());
        let head = Head::new("unanswered").titled(&["of these without an answer"]);
        columns.count(head, |of| Some(of.unanswered));
        columns.say_if(|of| 0 < of.unanswered);
        columns.done()
    }

    /// Returns the columns of the table of peaks.
    #[must_use]
    pub fn peak_columns(&self) -> Vec<Column<'a, PeakRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        let head = Head::of("amplitude", self.size());
        columns.number(head, |row: &PeakRow| Some(row.peak.amplitude));
        columns.word("regime", "", |row| Some(words::regime(row.peak.regime)));
        columns.flag("at_end", |row| Some(row.peak.at_end));
        columns.done()
    }

    /// Returns the columns of the table of tolerances of the friction.
    #[must_use]
    pub fn tolerance_columns(&self) -> Vec<Column<'a, Tolerance>> {
        let mut columns = Columns::new(&self.setting.measure);
        columns.number("excess", |row: &Tolerance| Some(row.excess));
        let head = Head::of("beta_from", PhysicalQuantity::Force).under_load("friction_from");
        columns.number(head, |row| Some(row.from));
        let head = Head::of("beta_to", PhysicalQuantity::Force).under_load("friction_to");
        columns.number(head, |row| Some(row.to));
        columns.done()
    }

    /// Returns the columns of the table of sensitivities. Without a load the list is empty.
    #[must_use]
    pub fn sensitivity_columns(&self) -> Vec<Column<'a, OptimumSensitivityRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        if self.setting.measure.load().is_some() {
            columns.word("parameter", "", |row: &OptimumSensitivityRow| {
                Some(&row.symbol)
            });
            columns.number("relative", |row| Some(row.relative));
        }
        columns.done()
    }
}
