//! Rows and columns of the steady states under periodic loads, and of the motion over a period.

use super::builder::Columns;
use super::column::{Column, ColumnKind, Head, Shown, TableRow};
use super::measure::{Measure, PhysicalQuantity};
use super::setting::MovingPart;
use crate::Of;
use crate::study::System;
use crate::study::periodic::PeriodicState;

/// Row of the table of steady states under a periodic load, at one friction force.
#[derive(Clone, Debug)]
pub struct PeriodicRow {
    /// Kinetic friction force in the contact, in N.
    pub friction: f64,
    /// The steady state at this friction force.
    pub state: PeriodicState,
}

/// A row of the table of a motion over a period: one time step of a steady state under a periodic load.
#[derive(Clone, Copy, Debug)]
pub struct PeriodicSample<'s> {
    row: &'s PeriodicRow,
    step: usize,
}

/// The tables of steady states under a periodic load.
#[derive(Clone, Copy)]
pub struct PeriodicTable<'a> {
    /// System whose steady states are in the table.
    pub system: &'a System,
    /// The motions and spring forces in the table, in the order of the request.
    pub parts: &'a [MovingPart],
}

impl TableRow for PeriodicRow {}
impl TableRow for PeriodicSample<'_> {}

impl PeriodicRow {
    /// Returns the smallest and the largest value of a motion over the period. If `turned` is true, the sign of the
    /// motion is reversed first.
    fn extremes(&self, part: usize, turned: bool) -> Option<[f64; 2]> {
        let [least, most] = self.state.tracks().get(part)?.extremes();
        Some(if turned {
            [0.0 - most, 0.0 - least]
        } else {
            [least, most]
        })
    }

    /// Returns the times of the samples of the motion, in s.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let state = &self.state;
        let steps = 0..state.forces().len();
        steps
            .map(|step| state.start() + step as f64 * state.step())
            .collect()
    }

    /// Returns the displacement of a motion, or the force of a spring, at each sample. If `turned` is true, the values
    /// have the opposite sign.
    #[must_use]
    pub fn values(&self, part: usize, turned: bool) -> Vec<f64> {
        let values = self.state.tracks().get(part).map(|track| &track.values);
        let values = values.into_iter().flatten();
        values
            .map(|[value, _]| if turned { 0.0 - value } else { *value })
            .collect()
    }

    /// Returns the table rows of the motion over a period.
    pub fn samples(&self) -> impl Iterator<Item = PeriodicSample<'_>> {
        (0..self.state.forces().len()).map(|step| PeriodicSample { row: self, step })
    }
}

impl<'a> PeriodicTable<'a> {
    /// Returns the columns of the table of steady states.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, PeriodicRow>> {
        let measure = Measure::si(self.system);
        let mut columns = Columns::new(&measure);
        let head = Head::of("friction", PhysicalQuantity::Force);
        columns.converted(head, |row: &PeriodicRow| Some(row.friction));
        columns.word("state", "marginal", |row| {
            Some(if row.state.is_stable() {
                "stable"
            } else {
                "marginal"
            })
        });
        let head = Head::new("period").titled(&["period", "(of load)"]);
        columns.count(head, |row| Some(row.state.period()));
        columns.count("events", |row| usize::try_from(row.state.events()).ok());
        let head = Head::new("stuck_fraction").titled(&["stuck", "(of period)"]);
        columns.converted(head, |row| Some(row.state.stuck_fraction()));
        let head = Head::new("largest_multiplier").titled(&["multiplier", "(largest)"]);
        columns.converted(head, |row| {
            row.state.multipliers().first().map(|value| value.norm())
        });
        for (name, title) in [
            ("load", "load"),
            ("friction", "friction"),
            ("damping", "damping"),
        ] {
            let head = Head::of(format!("{name}_work"), PhysicalQuantity::Energy);
            columns.converted(head.titled(&[title, "(J)"]), move |row: &PeriodicRow| {
                let work = row.state.work();
                Some(match name {
                    "load" => work.load,
                    "friction" => work.friction,
                    _ => work.damping,
                })
            });
        }
        columns.show(Shown::Objects);
        columns.list("multipliers", ColumnKind::Complex, |row| {
            let all = row.state.multipliers().iter();
            Some(all.map(|value| [value.re, value.im]).collect())
        });
        columns.show(Shown::Everywhere);
        for (place, part) in self.parts.iter().enumerate() {
            columns.begin_motion(part);
            let turned = measure.turns(part.of);
            for (which, name) in ["least", "largest"].into_iter().enumerate() {
                let head = Head::of(name, part.dimension());
                columns.converted(head, move |row: &PeriodicRow| {
                    row.extremes(place, turned)?.get(which).copied()
                });
            }
        }
        columns.done()
    }

    /// Returns the columns of the table of the motion over a period.
    #[must_use]
    pub fn sample_columns<'s>(&self) -> Vec<Column<'s, PeriodicSample<'s>>> {
        let measure = Measure::si(self.system);
        let mut columns = Columns::new(&measure);
        let head = Head::of("time", PhysicalQuantity::Time);
        columns.converted(head, |sample: &PeriodicSample<'_>| {
            let state = &sample.row.state;
            Some(state.start() + sample.step as f64 * state.step())
        });
        let signed = |value: f64, turned: bool| if turned { 0.0 - value } else { value };
        for (place, part) in self.parts.iter().enumerate() {
            columns.begin_motion(part);
            let turned = measure.turns(part.of);
            let names: &[(&str, PhysicalQuantity)] = match part.of.is_force() {
                true => &[("force", PhysicalQuantity::Force)],
                false => &[
                    ("displacement", PhysicalQuantity::Length),
                    ("velocity", PhysicalQuantity::Velocity),
                ],
            };
            for (which, (name, dimension)) in names.iter().enumerate() {
                let head = Head::of(*name, *dimension);
                columns.converted(head, move |sample: &PeriodicSample<'_>| {
                    let track = sample.row.state.tracks().get(place)?;
                    let value = track.values.get(sample.step)?.get(which)?;
                    Some(signed(*value, turned))
                });
            }
        }
        columns.begin_contact(&self.system.name_of_motion(Of::Contact));
        let turned = measure.turns_contact();
        columns.converted(
            Head::of("friction", PhysicalQuantity::Force),
            move |sample: &PeriodicSample<'_>| {
                let force = sample.row.state.forces().get(sample.step)?;
                Some(signed(*force, turned))
            },
        );
        columns.done()
    }
}
