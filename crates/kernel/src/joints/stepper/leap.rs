//! Advances a stepper by one sub-interval with its tables, if no contact can change its phase.
//!
//! For each contact the code watches a quantity: the relative velocity while the contact slides, the force while it
//! sticks. The values and derivatives at both ends of the sub-interval determine a cubic polynomial. If the four
//! Bernstein coefficients of the polynomial stay within the limits of the contact by more than the bound in the table,
//! the contact has no event.

use super::Stepper;
use super::shears::shear;
use super::table::Layout;
use super::work::Moments;
use crate::Float;
use crate::joints::least::dot;
use crate::joints::model::Model;
use crate::joints::run::Motion;
use crate::joints::size::{Size, at, sign};
use crate::joints::state::{FREE, STUCK};
use crate::stepper::Input;

/// Distance from a limit, relative to its value at the start of the sub-interval, that the code requires beside the
/// bound of the table. It is far larger than rounding errors.
const MARGIN: f64 = 1e-3;

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Advances the motion by the sub-interval with the index `part`. Returns false, and changes nothing, if a contact
    /// may have an event, or if the stepper has no tables.
    pub(super) fn leap(&mut self, part: u32) -> bool {
        let model = self.motion.model();
        let layout = self.layout;
        let (state, count) = (self.motion.state(), layout.coordinates());
        let starts_at_event = state.zeros.as_ref().iter().any(|(zeros, _)| *zeros > 0);
        let rows = layout.rows(self.tables.as_ref(), state.key());
        let Some([shears, results, contacts, moments]) = rows else {
            return false;
        };
        if starts_at_event {
            return false;
        }
        let times = [self.pace.start(part), self.pace.start(part + 1)];
        let [before, after] = &mut self.ends;
        write(&self.motion, &layout, times[0], before.as_mut());
        write(&self.motion, &layout, times[1], after.as_mut());
        let before = before.as_ref();
        let gained = if layout.shears {
            shear(model, state, shears, after.as_mut())
        } else {
            model.size.masses(S::constant(0.0))
        };
        advance(model, gained.as_ref(), (results, before), after.as_mut());
        let after = after.as_ref();
        let rows = contacts.chunks_exact(3 * count.max(1));
        let quiet = model.contacts().iter().zip(rows).enumerate();
        let quiet = quiet.filter(|(j, _)| state.phase(*j) != FREE);
        let is_quiet = quiet.clone().all(|(j, (contact, rows))| {
            let [value, slope, bound] = split(rows, count);
            let value = |coordinates: &[S]| match (state.phase(j), contact.stiffness) {
                (STUCK, None) => dot(value, coordinates),
                (STUCK, Some(_)) => at(coordinates, 2 * layout.masses + j),
                _ => {
                    layout.speed(contact.plus, coordinates)
                        - layout.speed(contact.minus, coordinates)
                }
            };
            let watched = Watched::new(
                [value(before), value(after)],
                [dot(slope, before), dot(slope, after)],
                size(bound, before),
            );
            let levels = times.map(|time| contact.level.value(time, 0));
            match state.phase(j) {
                STUCK => sticks(&watched, levels.map(|level| contact.stiction * level)),
                side => slides(&watched, (sign(side), contact.creep())),
            }
        });
        let mut results = after.iter().take(2 * layout.masses + layout.contacts);
        if !is_quiet || results.any(|value| !value.is_finite()) {
            return false;
        }
        let moments = Moments {
            rows: moments,
            layout: &layout,
        };
        let [start, _] = times;
        moments.add(&mut self.status.work, &self.motion, start, (before, after));
        self.motion.land(after, self.pace.start(part + 1));
        true
    }
}

/// Writes the coordinates of a motion. The inputs have their values at the instant `time`.
fn write<S: Float, Z: Size>(motion: &Motion<S, Z>, layout: &Layout, time: S, to: &mut [S]) {
    let (model, state) = (motion.model(), motion.state());
    let is_linear = layout.input == Input::Linear;
    let mut entries = to.iter_mut();
    let mut put = |value: S| {
        if let Some(entry) = entries.next() {
            *entry = value;
        }
    };
    for value in state.x.as_ref() {
        put(*value);
    }
    for value in state.v.as_ref() {
        put(*value);
    }
    for (j, contact) in model.contacts().iter().enumerate() {
        put(match state.phase(j) {
            FREE => S::constant(0.0),
            STUCK => at(state.forces.as_ref(), j),
            side => sign::<S>(side) * contact.level.value(time, 0),
        });
    }
    for (_, load) in model.loads.as_ref() {
        put(load.constant + load.slope * time);
        if is_linear {
            put(load.slope);
        }
    }
    if layout.on_base {
        for value in model
            .base
            .about(time)
            .into_iter()
            .take(if is_linear { 4 } else { 2 })
        {
            put(value);
        }
    }
    if is_linear {
        for (j, contact) in model.contacts().iter().enumerate() {
            put(match state.phase(j) {
                FREE | STUCK => S::constant(0.0),
                side => sign::<S>(side) * contact.level.slope,
            });
        }
    }
}

/// Adds the increments of the displacements, the velocities and the forces of elastic contacts in the sub-interval.
/// `gained` contains the increments of the velocities by shears, which the velocities in `after` contain already.
fn advance<S: Float, Z: Size>(
    model: &Model<S, Z>,
    gained: &[S],
    (rows, before): (&[S], &[S]),
    after: &mut [S],
) {
    let mut rows = rows.chunks_exact(before.len().max(1));
    let masses = model.wall();
    let (places, rest) = after.split_at_mut_checked(masses).unwrap_or_default();
    let (speeds, forces) = rest.split_at_mut_checked(masses).unwrap_or_default();
    for (place, row) in places.iter_mut().zip(rows.by_ref()) {
        *place = *place + dot(row, before);
    }
    let old = before.iter().skip(masses).zip(gained);
    for ((speed, (old, gained)), row) in speeds.iter_mut().zip(old).zip(rows.by_ref()) {
        // One rounding of the velocity in place of two: its errors add up while a chain slides far.
        *speed = *old + (*gained + dot(row, before));
    }
    let contacts = model.contacts().iter().zip(forces);
    for ((_, force), row) in contacts.filter(|(c, _)| !c.is_rigid()).zip(rows) {
        *force = *force + dot(row, before);
    }
}

/// Bernstein coefficients of a watched quantity, and the bound on the difference between the quantity and its cubic
/// polynomial.
struct Watched<S> {
    bernstein: [S; 4],
    bound: S,
}

impl<S: Float> Watched<S> {
    /// Creates the polynomial with the given values and derivatives at both ends.
    fn new([first, last]: [S; 2], slopes: [S; 2], bound: S) -> Self {
        let [rise, end] = slopes.map(|slope| S::constant(1.0 / 3.0) * slope);
        Self {
            bernstein: [first, first + rise, last - end, last],
            bound,
        }
    }
}

/// Divides the rows of a contact: of the value of its watched quantity, of its derivative, and of the bound.
fn split<S>(rows: &[S], count: usize) -> [&[S]; 3] {
    let (value, rows) = rows.split_at_checked(count).unwrap_or_default();
    let (slope, bound) = rows.split_at_checked(count).unwrap_or_default();
    [value, slope, bound]
}

/// Returns the sum of the products of a row and the absolute values of the coordinates.
fn size<S: Float>(row: &[S], coordinates: &[S]) -> S {
    let products = row.iter().zip(coordinates);
    products.fold(S::constant(0.0), |sum, (bound, u)| sum + *bound * u.abs())
}

/// Returns true if the force of a contact stays below the static friction force, which changes linearly between the two
/// values in `most`.
fn sticks<S: Float>(watched: &Watched<S>, [from, to]: [S; 2]) -> bool {
    let third = S::constant(1.0 / 3.0);
    let rise = third * (to - from);
    let most = [from, from + rise, to - rise, to];
    let [first, ..] = watched.bernstein;
    let least = watched.bound + S::constant(MARGIN) * (from - first.abs()).abs();
    let mut forces = watched.bernstein.iter().zip(most);
    forces.all(|(force, most)| most - force.abs() > least)
}

/// Returns true if the slider of a contact keeps moving in the direction `side`.
fn slides<S: Float>(watched: &Watched<S>, (side, creep): (S, S)) -> bool {
    let [first, ..] = watched.bernstein;
    let least = watched.bound + S::constant(MARGIN) * (side * first - creep).abs();
    let mut speeds = watched.bernstein.iter();
    speeds.all(|speed| side * *speed - creep > least)
}
