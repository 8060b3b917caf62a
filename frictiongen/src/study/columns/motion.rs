//! Columns of the motions of the contact and of masses. Several tables have these columns.

use super::builder::Columns;
use super::column::{Head, Shown, TableRow};
use super::measure::PhysicalQuantity;
use super::setting::MovingPart;
use crate::Complex;
use crate::study::response::{MotionQuantity, Swing};
use crate::study::units::polar;

/// The motion of the contact or of a mass in one row of a table, in non-dimensional groups. A quantity is `None` if the
/// row does not contain it.
#[derive(Clone, Copy, Debug, Default)]
pub struct PartMotion<'r> {
    /// Largest displacement (amplitude), divided by P/k₁ (by Y for base motion), and its phase in rad.
    pub swing: Option<Swing>,
    /// Lag of the motion's fundamental component behind the excitation, in rad.
    pub fundamental_phase: Option<f64>,
    /// Monoharmonic estimate of the amplitude, divided by P/k₁ (by Y for base motion).
    pub monoharmonic: Option<f64>,
    /// Largest |dx̄/dτ| and largest |d²x̄/dτ²| of the motion in a cycle.
    pub rates: Option<(f64, f64)>,
    /// Largest force in the contact, divided by P, and the energy that the contact dissipates in a cycle, divided by
    /// P²/k₁. For base motion, P is k₁Y.
    pub contact: Option<(f64, f64)>,
    /// Equivalent viscous damping ratio of the contact, computed with the strain energy of all springs or of one
    /// spring.
    pub damping: Option<f64>,
    /// Complex amplitudes of the requested harmonics, in the order of the request.
    pub harmonics: &'r [Complex<f64>],
}

/// A row of a table that contains motions.
pub trait MotionRow: TableRow {
    /// Returns the motion of the contact or mass with this index in the table.
    fn motion(&self, part: usize) -> Option<PartMotion<'_>>;
}

/// Selects the columns that each motion has in addition to amplitude and phase.
#[derive(Clone, Copy, Debug)]
pub struct MotionColumns<'a> {
    /// True if each motion has a column for the monoharmonic amplitude.
    pub monoharmonic: bool,
    /// True if each motion has columns for velocity and acceleration.
    pub rates: bool,
    /// Orders of the harmonics that have columns.
    pub orders: &'a [u32],
    /// True if JSON files contain the real and imaginary part of each harmonic.
    pub complex: bool,
}

/// Adds the columns of the motions of the contact and masses in `parts` to a table.
pub fn motions<'a, R: MotionRow + 'a>(
    columns: &mut Columns<'a, R>,
    parts: &[MovingPart],
    of: MotionColumns<'_>,
) {
    use PhysicalQuantity::{Acceleration, Velocity};
    for (part, named) in parts.iter().enumerate() {
        let size = named.dimension();
        let length = columns.measure().title(size);
        columns.begin_motion(named);
        if named.size != MotionQuantity::Displacement {
            // A largest velocity or acceleration has neither a phase nor harmonics.
            let of = named.size;
            let name = match of {
                MotionQuantity::Energy => "cycle",
                MotionQuantity::Damping => "ratio",
                _ => "amplitude",
            };
            columns.number(Head::of(name, size), move |row: &R| {
                let motion = row.motion(part)?;
                Some(match of {
                    MotionQuantity::Velocity => motion.rates?.0,
                    MotionQuantity::Force => motion.contact?.0,
                    MotionQuantity::Energy => motion.contact?.1,
                    MotionQuantity::Damping => motion.damping?,
                    _ => motion.rates?.1,
                })
            });
            continue;
        }
        columns.number(Head::of("amplitude", size), move |row: &R| {
            Some(row.motion(part)?.swing?.amplitude)
        });
        phases(columns, part);
        if of.monoharmonic {
            let head = Head::of("amplitude_monoharmonic", size);
            columns.number(head.titled(&["monoharmonic", length]), move |row| {
                row.motion(part)?.monoharmonic
            });
        }
        if of.rates && !named.of.is_force() {
            columns.number(Head::of("velocity", Velocity), move |row| {
                Some(row.motion(part)?.rates?.0)
            });
            columns.number(Head::of("acceleration", Acceleration), move |row| {
                Some(row.motion(part)?.rates?.1)
            });
        }
        harmonics(columns, part, (of.orders, size, of.complex));
    }
}

/// Adds the columns of the phases of a motion.
pub(super) fn phases<'a, R: MotionRow + 'a>(columns: &mut Columns<'a, R>, part: usize) {
    use PhysicalQuantity::Angle;
    columns.number(Head::of("phase", Angle), move |row: &R| {
        row.motion(part)?.swing?.phase
    });
    let angle = columns.measure().title(Angle);
    let head = Head::of("fundamental_phase", Angle);
    columns.number(head.titled(&["fundamental", angle]), move |row| {
        row.motion(part)?.fundamental_phase
    });
}

/// Adds the columns of the harmonics of a motion with these orders.
pub(super) fn harmonics<'a, R: MotionRow + 'a>(
    columns: &mut Columns<'a, R>,
    part: usize,
    (orders, size, complex): (&[u32], PhysicalQuantity, bool),
) {
    for (place, order) in orders.iter().enumerate() {
        harmonic(columns, (part, place), *order, (size, complex));
    }
}

/// Adds the columns of a harmonic: its amplitude and its lag. If requested, JSON files also get the real and imaginary
/// part.
fn harmonic<'a, R: MotionRow + 'a>(
    columns: &mut Columns<'a, R>,
    (part, place): (usize, usize),
    order: u32,
    (size, complex): (PhysicalQuantity, bool),
) {
    use PhysicalQuantity::Angle;
    let of = move |row: &R| row.motion(part)?.harmonics.get(place).copied();
    columns.begin_harmonic(order);
    let [length, angle] = [size, Angle].map(|dimension| columns.measure().title(dimension));
    let head = Head::of("amplitude", size).titled(&[&format!("|X_{order}|"), length]);
    columns.number(head, move |row| Some(polar(of(row)?).0));
    let head = Head::of("phase", Angle).titled(&[&format!("lag X_{order}"), angle]);
    columns.number(head, move |row| Some(polar(of(row)?).1));
    if complex {
        columns.show(Shown::Json);
        columns.number(Head::of("re", size), move |row| Some(of(row)?.re));
        columns.number(Head::of("im", size), move |row| Some(of(row)?.im));
        columns.show(Shown::Everywhere);
    }
}
