//! Rows and columns of the table of curves over frequency.

use super::builder::Columns;
use super::column::{Column, Head};
use super::measure::PhysicalQuantity;
use super::motion::{MotionColumns, MotionRow, PartMotion, motions};
use super::setting::{AtFriction, Frequency, FrictionSetting, Setting, at};
use crate::Error;
use crate::study::{
    curve::{Curve, CurvePoint, CurveStart},
    words,
};

/// A row of the table of curves: a point of a curve, or an end point of a gap in the curve.
#[derive(Clone, Debug)]
pub struct CurveRow {
    /// The friction of the curve, as friction ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// The initial state from which the motions of the curve start.
    pub start: CurveStart,
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Number of the curve's continuous piece, counted from 1 in ascending order of frequency. `None` in a gap.
    pub piece: Option<usize>,
    /// The response at the point, or the reason for the gap.
    pub found: Result<CurvePoint, Error>,
}

/// The table of curves over frequency.
#[derive(Clone, Copy)]
pub struct CurveTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
    /// True if the table has a column with the initial state from which each curve starts.
    pub starts: bool,
    /// True if the table has columns for velocities and accelerations.
    pub rates: bool,
    /// The orders of the harmonics that the table contains.
    pub orders: &'a [u32],
}

impl CurveRow {
    fn point(&self) -> Option<&CurvePoint> {
        self.found.as_ref().ok()
    }
}

at!(CurveRow);

impl AtFriction for CurveRow {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl MotionRow for CurveRow {
    fn motion(&self, part: usize) -> Option<PartMotion<'_>> {
        let point = self.point()?;
        let movement = point.movements.get(part)?;
        Some(PartMotion {
            swing: Some(movement.swing),
            fundamental_phase: movement.fundamental_phase,
            monoharmonic: None,
            rates: movement.rates,
            contact: Some((point.contact_force, point.friction_work)),
            damping: movement.damping,
            harmonics: &movement.harmonics,
        })
    }
}

impl<'a> CurveTable<'a> {
    /// Returns the rows of one curve, in ascending order of frequency.
    #[must_use]
    pub fn rows(&self, friction: FrictionSetting, curve: &Curve) -> Vec<CurveRow> {
        let row = |r: f64, piece: Option<usize>, found: Result<CurvePoint, Error>| {
            let frequency = Frequency::at(self.setting.system, r);
            CurveRow {
                friction: friction.at(&self.setting.measure, frequency),
                start: curve.start,
                frequency,
                piece,
                found,
            }
        };
        let mut rows = Vec::new();
        for (piece, found) in (1..).zip(&curve.pieces) {
            let points = found.points.iter();
            rows.extend(points.map(|point| row(point.r, Some(piece), Ok(point.clone()))));
        }
        for gap in &curve.gaps {
            let ends = [gap.from, gap.to].into_iter();
            let ends = ends.take(if gap.from < gap.to { 2 } else { 1 });
            rows.extend(ends.map(|r| row(r, None, Err(gap.reason))));
        }
        rows.sort_by(|a, b| a.frequency.r.total_cmp(&b.frequency.r));
        rows
    }

    /// Returns the columns of the table, from left to right.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, CurveRow>> {
        use PhysicalQuantity::{Force, Length, Power};
        let measure = self.setting.measure;
        let (newton, power) = match measure.scale() {
            Some(_) => ("(N)", ["power", "(W)"]),
            None => ("", ["work", ""]),
        };
        let mut columns = Columns::new(&measure);
        self.setting.friction(&mut columns);
        if self.starts {
            let head = Head::new("from").attribute("start");
            columns.word(head, "down", |row: &CurveRow| Some(words::start(row.start)));
        }
        self.setting.frequency(&mut columns);
        columns.count("piece", |row| row.piece);
        columns.word("regime", "continuous", |row| {
            Some(words::regime(row.point()?.regime))
        });
        columns.word("answer", "last 64 cycles", |row| {
            Some(words::on_curve(row.found.as_ref().map_err(|error| *error)))
        });
        columns.count("stops", |row| Some(row.point()?.stops));
        columns.count("period", |row| Some(row.point()?.period as usize));
        let head = Head::of("contact_force", Force).titled(&["force", newton]);
        columns.number(head, |row| Some(row.point()?.contact_force));
        let head = Head::of("friction_work", Power).under_load("friction_power");
        columns.number(head.titled(&power), |row| Some(row.point()?.friction_work));
        columns.number(Head::of("offset", Length), move |row| {
            Some(measure.sign() * row.point()?.offset)
        });
        columns.flag("marginal", |row| Some(row.point()?.marginal));
        columns.flag(Head::new("from_rest").titled(&["from", "rest"]), |row| {
            Some(row.point()?.from_rest)
        });
        let extent = MotionColumns {
            monoharmonic: false,
            rates: self.rates,
            orders: self.orders,
            complex: false,
        };
        motions(&mut columns, self.setting.parts, extent);
        let mut columns = columns.done();
        for column in columns.iter_mut().filter(|column| column.part.is_some()) {
            column.title = vec![column.name_in_part()];
        }
        columns
    }
}
