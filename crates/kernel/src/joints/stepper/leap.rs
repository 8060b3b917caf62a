//! Advances a stepper by one sub-interval with its tables, if no contact can change its phase.
//!
//! For each contact the code watches a quantity: the relative velocity while the contact slides, the force while it
//! sticks. The values and derivatives at both ends of the sub-interval determine a cubic polynomial. If the four
//! Bernstein coefficients of the polynomial stay within the limits of the contact by more than the bound in the table,
//! the contact has no event. Far from the limits, a bound on the change of the quantity already shows this.

use super::Stepper;
use super::shears::shear;
use super::table::{Layout, ROWS, Rows};
use super::work::Moments;
use crate::Float;
use crate::joints::least::dot;
use crate::joints::model::{Contact, Model};
use crate::joints::run::Motion;
use crate::joints::size::{Size, at, sign};
use crate::joints::state::{FREE, STUCK, State};
use crate::stepper::Input;

/// Distance from a limit, relative to its value at the start of the sub-interval, that the code requires beside the
/// bound of the table. It is far larger than rounding errors.
const MARGIN: f64 = 1e-3;

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Advances the motion by the sub-interval with the index `part`. Returns false, and changes nothing, if a contact
    /// may have an event, or if the stepper has no tables.
    pub(super) fn leap(&mut self, part: u32) -> bool {
        let (layout, motion) = (&Z::layout(&self.layout), &self.motion);
        let (model, state) = (motion.model(), motion.state());
        let Some(rows) = layout.rows(self.tables.as_ref(), state.key()) else {
            return false;
        };
        if state.zeros.as_ref().iter().any(|(zeros, _)| *zeros > 0) {
            return false;
        }
        let times = [self.pace.start(part), self.pace.start(part + 1)];
        let base = times.map(|time| place_and_speed(model, layout, time));
        let [before, after] = &mut self.ends;
        write(motion, layout, times[0], before.as_mut());
        let before = &*before;
        let [[from, _], [to, _]] = base;
        let ends = (before.as_ref(), after.as_mut());
        let moved = advance((model, state), (layout, &rows), ends, to - from);
        let watch = Watch::<S, Z> {
            layout,
            rows: rows.contacts,
            ends: [before, after],
            base: base.map(|[_, speed]| speed),
            times,
        };
        let (before, after) = (before.as_ref(), after.as_ref());
        let mut results = after.iter().take(2 * layout.masses + layout.contacts);
        if !watch.is_quiet(motion) || results.any(|value| !value.is_finite()) {
            return false;
        }
        let moments = Moments {
            rows: rows.moments,
            layout,
            moved: moved.as_ref(),
            moved_base: to - from,
        };
        let [start, end] = times;
        moments.add(&mut self.status.work, motion, start, (before, after));
        self.motion.land(after, end);
        true
    }
}

/// Returns displacement and velocity of the base at the instant `time`.
fn place_and_speed<S: Float, Z: Size>(model: &Model<S, Z>, layout: &Layout, time: S) -> [S; 2] {
    if !layout.on_base {
        return [S::constant(0.0); 2];
    }
    let [place, speed, ..] = model.base.about(time);
    [place, speed]
}

/// Writes the coordinates of a motion at the instant `time`.
fn write<S: Float, Z: Size>(motion: &Motion<S, Z>, layout: &Layout, time: S, to: &mut [S]) {
    let (model, state) = (motion.model(), motion.state());
    let zero = S::constant(0.0);
    let is_linear = layout.input == Input::Linear;
    let mut entries = to.iter_mut();
    let mut put = |value: S| {
        if let Some(entry) = entries.next() {
            *entry = value;
        }
    };
    let motion = state.x.as_ref().iter().chain(state.v.as_ref());
    motion.for_each(|value| put(*value));
    for (j, contact) in model.contacts().iter().enumerate() {
        put(match state.phase(j) {
            FREE => zero,
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
        let terms = model.base.about(time);
        let count = if is_linear { terms.len() } else { 2 };
        terms.iter().take(count).for_each(|term| put(*term));
    }
    if is_linear {
        for (j, contact) in model.contacts().iter().enumerate() {
            put(match state.phase(j) {
                FREE | STUCK => zero,
                side => sign::<S>(side) * contact.level.slope,
            });
        }
    }
}

/// Writes the displacements, the velocities and the forces of elastic contacts at the end of the sub-interval. Returns
/// the increments of the displacements. `moved_base` is that of the base.
fn advance<S: Float, Z: Size>(
    (model, state): (&Model<S, Z>, &State<S, Z>),
    (layout, rows): (&Layout, &Rows<'_, S>),
    (before, after): (&[S], &mut [S]),
    moved_base: S,
) -> Z::Masses<S> {
    let (masses, width) = (layout.masses, layout.width());
    let skipped = layout.coordinates().saturating_sub(width);
    let coordinates = before.get(skipped..).unwrap_or_default();
    let mut rows_left = rows.increments.chunks_exact(width.max(1));
    let [mut moved, mut gained] = [0, 1].map(|_| model.size.masses(S::constant(0.0)));
    for increments in [moved.as_mut(), gained.as_mut()] {
        for (increment, row) in increments.iter_mut().zip(rows_left.by_ref()) {
            *increment = dot(row, coordinates);
        }
    }
    if layout.shears {
        let increments = (moved.as_mut(), gained.as_mut());
        shear(
            (model, state, masses),
            (rows.shears, before, after),
            increments,
        );
    } else {
        let increments = moved.as_ref().iter().chain(gained.as_ref());
        for ((after, before), increment) in after.iter_mut().zip(before).zip(increments) {
            *after = *before + *increment;
        }
    }
    let forces = after.get_mut(2 * masses..).unwrap_or_default();
    let old = before.get(2 * masses..).unwrap_or_default();
    let contacts = model.contacts().iter().zip(forces.iter_mut().zip(old));
    for (j, (contact, (force, old))) in contacts.enumerate() {
        *force = match contact.stiffness.filter(|_| state.phase(j) == STUCK) {
            Some(stiffness) => *old + stiffness * contact.relative(moved.as_ref(), moved_base),
            None => *old,
        };
    }
    moved
}

/// Watches the contacts in a sub-interval.
struct Watch<'w, S: Float, Z: Size> {
    layout: &'w Layout,
    /// Rows of the table for the contacts.
    rows: &'w [S],
    /// Coordinates at the start, and displacements, velocities and forces at the end.
    ends: [&'w Z::Row<S>; 2],
    /// Velocity of the base at both ends.
    base: [S; 2],
    /// Instants of both ends.
    times: [S; 2],
}

impl<S: Float, Z: Size> Watch<'_, S, Z> {
    /// Returns true if no contact can have an event in the sub-interval.
    fn is_quiet(&self, motion: &Motion<S, Z>) -> bool {
        let state = motion.state();
        let count = self.layout.coordinates().max(1);
        let rows = self.rows.chunks_exact((ROWS * count).max(1));
        let mut contacts = motion.model().contacts().iter().zip(rows).enumerate();
        contacts.all(|(j, (contact, rows))| {
            let (reach, rows) = rows.split_at_checked(count).unwrap_or_default();
            let (rates, values) = rows.split_at_checked(3 * count).unwrap_or_default();
            let is_far = |room: S| S::constant(1.0 - MARGIN) * room > size(reach, self.before());
            match (state.phase(j), contact.stiffness) {
                (FREE, _) => true,
                (STUCK, stiffness) => {
                    let levels = self.times.map(|time| contact.level.value(time, 0));
                    let most = levels.map(|level| contact.stiction * level);
                    let first = match stiffness {
                        None => dot(values, self.before()),
                        Some(_) => at(self.before(), 2 * self.layout.masses + j),
                    };
                    if is_far(crate::Scalar::min(most[0], most[1]) - first.abs()) {
                        return true;
                    }
                    let forces = match stiffness {
                        None => self.products(values),
                        Some(_) => self
                            .ends
                            .map(|end| at(end.as_ref(), 2 * self.layout.masses + j)),
                    };
                    sticks(&self.watched(forces, rates), most)
                }
                (side, _) => {
                    let (first, creep) = (self.speed(contact, 0), contact.creep());
                    is_far(sign::<S>(side) * first - creep) || {
                        let speeds = [first, self.speed(contact, 1)];
                        slides(&self.watched(speeds, rates), (sign(side), creep))
                    }
                }
            }
        })
    }

    /// Returns the relative velocity of a contact at the start (`end` = 0) or at the end of the sub-interval.
    fn speed(&self, contact: &Contact<S>, end: usize) -> S {
        let masses = self.layout.masses;
        let speeds = self
            .ends
            .get(end)
            .and_then(|end| end.as_ref().get(masses..2 * masses));
        contact.relative(speeds.unwrap_or_default(), at(&self.base, end))
    }

    /// Returns the coordinates at the start.
    fn before(&self) -> &[S] {
        let [before, _] = self.ends;
        before.as_ref()
    }

    /// Returns the products of the first two rows with the coordinates at the start.
    fn products(&self, rows: &[S]) -> [S; 2] {
        let before = self.before();
        let (first, rest) = rows.split_at_checked(before.len()).unwrap_or_default();
        [dot(first, before), dot(rest, before)]
    }

    /// Returns the polynomial of a watched quantity with the given values at both ends. `rows` are the rows of its
    /// derivative at both ends, and of its bound.
    fn watched(&self, values: [S; 2], rows: &[S]) -> Watched<S> {
        let before = self.before();
        let (slopes, bound) = rows.split_at_checked(2 * before.len()).unwrap_or_default();
        Watched::new(values, self.products(slopes), size(bound, before))
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

/// Returns the sum of the products of a row and the absolute values of the coordinates.
fn size<S: Float>(row: &[S], coordinates: &[S]) -> S {
    let (row, row_rest) = row.as_chunks::<4>();
    let (coordinates, rest) = coordinates.as_chunks::<4>();
    let fours = row.iter().zip(coordinates);
    let sum = fours.fold(S::constant(0.0), |sum, ([a, b, c, d], [e, f, g, h])| {
        sum + *a * e.abs() + *b * f.abs() + *c * g.abs() + *d * h.abs()
    });
    let products = row_rest.iter().zip(rest);
    products.fold(sum, |sum, (bound, u)| sum + *bound * u.abs())
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
