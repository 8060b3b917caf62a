//! Derivatives of a motion with respect to its initial state.
//!
//! Between two events a small deviation satisfies the homogeneous linear equations. At an event the deviation jumps if
//! the accelerations do: the motion with the deviation passes the event a time δt later, so that its velocities change
//! by (ẍ⁻ − ẍ⁺)δt, with the accelerations before and after the event. With the watched quantity q, which is 0 at the
//! event, δt = −δq/q̇. q is the relative velocity of a rigid contact that slides, or the difference of the force of a
//! contact that sticks from its static friction force.
//!
//! The force of an elastic contact has no deviation while the contact slides, and its deviation starts from 0 when the
//! contact sticks again.

use super::least::dot;
use super::model::{Contact, Model};
use super::poly::{terms_of, value, value_and_slope};
use super::rates::Rates;
use super::run::{Motion, Observe};
use super::series::Series;
use super::size::{Size, at, set};
use super::state::{FREE, IMPACT, STUCK, State};
use super::table::{Leap, add_row};
use super::tree::Tree;
use super::unknowns::Unknowns;
use crate::Float;

/// Duration of a shot (a motion that the shooting method follows).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShotSpan {
    /// The shot lasts half a cycle of the load. The code then multiplies the state by −1. A motion that repeats with
    /// the opposite sign after half a cycle therefore ends in its initial state.
    Half,
    /// The shot lasts the given number of cycles of the load.
    Cycles(usize),
}

impl ShotSpan {
    /// Returns the number of cycles in a period of the motion.
    pub(super) fn period(self) -> usize {
        match self {
            Self::Half => 1,
            Self::Cycles(period) => period,
        }
    }
}

/// Observer of a motion that advances one small deviation for each unknown of a steady state.
pub(super) struct Tangent<'m, S: Float, Z: Size> {
    model: &'m Model<S, Z>,
    /// Deviations from the motion, with one column for each unknown. The rows are the displacements of the masses, the
    /// velocities of the masses, and the forces of the contacts.
    rows: Z::Square<S>,
    /// Coefficients of one order in the power series of the deviations in `rows`.
    term: Z::Square<S>,
    /// Coefficients of the next order.
    raised: Z::Square<S>,
    /// Number of rows and columns.
    width: usize,
    /// Linear equations of the last stretch, and the phases to which they belong.
    rates: Option<(Rates<S, Z>, Z::Contacts<i8>)>,
    /// Accelerations of the masses at the end of the last stretch.
    accelerations: Z::Masses<S>,
    /// Rates of the watched quantities of the contacts at the end of the last stretch.
    slopes: Z::Contacts<S>,
    /// Differences of the static friction forces from the contact forces at the end of the last stretch, for contacts
    /// that stick.
    margins: Z::Contacts<S>,
    /// Velocities of the masses at the end of the last stretch.
    speeds: Z::Masses<S>,
    /// The stop whose nodes have collided at the end of the last stretch.
    impact: Option<usize>,
    /// True if an event has ended the last stretch.
    is_at_event: bool,
}

impl<'m, S: Float, Z: Size> Tangent<'m, S, Z> {
    /// Starts to observe a motion. Each column begins with a deviation of 1 in the unknown of the column.
    pub(super) fn new(motion: &'m Motion<S, Z>, unknowns: &Unknowns<'_, S, Z>) -> Self {
        let zero = S::constant(0.0);
        let model = motion.model();
        let mut tangent = Self {
            model,
            rows: model.size.square(zero),
            term: model.size.square(zero),
            raised: model.size.square(zero),
            width: model.width(),
            rates: None,
            accelerations: model.size.masses(zero),
            slopes: model.size.contacts(zero),
            margins: model.size.contacts(zero),
            speeds: model.size.masses(zero),
            impact: None,
            is_at_event: false,
        };
        for column in 0..tangent.width {
            tangent.begin(motion, unknowns, column);
        }
        tangent
    }

    /// Sets the deviations of one column at the start.
    fn begin(&mut self, motion: &Motion<S, Z>, unknowns: &Unknowns<'_, S, Z>, column: usize) {
        let (model, masses) = (self.model, self.model.wall());
        let zero = S::constant(0.0);
        let (mut x, mut v) = (model.size.nodes(zero), model.size.nodes(zero));
        let mut places = model.size.contacts(zero);
        let mut slider = None;
        match column.checked_sub(masses) {
            None => set(x.as_mut(), column, unknowns.place),
            Some(mass) if mass < masses => set(v.as_mut(), mass, unknowns.speed),
            Some(rest) => {
                let j = rest - masses;
                if !unknowns.uses(motion, j) {
                    return;
                }
                match model.contact(j).and_then(|contact| contact.stiffness) {
                    None => set(places.as_mut(), j, unknowns.place),
                    Some(_) => slider = Some(j),
                }
            }
        }
        motion.tree.meet(model, v.as_mut());
        motion.tree.place(x.as_mut(), v.as_mut(), places.as_ref());
        for mass in 0..masses {
            self.put(mass, column, at(x.as_ref(), mass));
            self.put(masses + mass, column, at(v.as_ref(), mass));
        }
        for (j, contact) in model.contacts().iter().enumerate() {
            let sticks = motion.state().phase(j) == STUCK;
            if let Some(stiffness) = contact.stiffness.filter(|_| sticks) {
                let own = if slider == Some(j) {
                    unknowns.place
                } else {
                    zero
                };
                let force = stiffness * (contact.across(x.as_ref()) - own);
                self.put(2 * masses + j, column, force);
            }
        }
    }

    /// Sets the deviation in one row and one column.
    fn put(&mut self, row: usize, column: usize, value: S) {
        set(self.rows.as_mut(), row * self.width + column, value);
    }

    /// Returns the deviation in one row and one column, or 0 if the matrix has no such entry.
    fn get(&self, row: usize, column: usize) -> S {
        at(self.rows.as_ref(), row * self.width + column)
    }

    /// Returns the derivatives of the unknowns at the end of a shot with respect to those at its start, column by
    /// column. `end` is the motion at the end of the shot.
    pub(super) fn derivatives(
        &self,
        end: &Motion<S, Z>,
        unknowns: &Unknowns<'_, S, Z>,
        span: ShotSpan,
    ) -> Z::Square<S> {
        let turn = S::constant(if span == ShotSpan::Half { -1.0 } else { 1.0 });
        let mut matrix = self.model.size.square(S::constant(0.0));
        let masses = self.model.wall();
        let columns = matrix.as_mut().chunks_exact_mut(self.width.max(1));
        for (column, entries) in columns.enumerate() {
            let contact = column.checked_sub(2 * masses);
            if contact.is_some_and(|j| !unknowns.moves(j)) {
                continue;
            }
            for (row, entry) in entries.iter_mut().enumerate() {
                *entry = turn
                    * if row < masses {
                        self.get(row, column) / unknowns.place
                    } else if row < 2 * masses {
                        self.get(row, column) / unknowns.speed
                    } else if unknowns.uses(end, row - 2 * masses) {
                        self.place(row - 2 * masses, column) / unknowns.place
                    } else {
                        S::constant(0.0)
                    };
            }
        }
        matrix
    }

    /// Returns the deviation of the position of a contact: that of the slider of an elastic contact, or the relative
    /// displacement of a rigid contact.
    fn place(&self, j: usize, column: usize) -> S {
        let masses = self.model.wall();
        let Some(contact) = self.model.contact(j) else {
            return S::constant(0.0);
        };
        let across = self.across(contact, 0, column);
        match contact.stiffness {
            Some(stiffness) => across - self.get(2 * masses + j, column) / stiffness,
            None => across,
        }
    }

    /// Returns the deviation of the node `plus` of a contact minus that of its node `minus`. The rows of the masses
    /// begin at the index `first`.
    fn across(&self, contact: &Contact<S>, first: usize, column: usize) -> S {
        let of = |node: usize| {
            if node < self.model.wall() {
                self.get(first + node, column)
            } else {
                // The supports (wall and base) have no deviation.
                S::constant(0.0)
            }
        };
        of(contact.plus) - of(contact.minus)
    }

    /// Computes the jump of the deviations at an event that has ended the last stretch. `after` contains the
    /// accelerations of the masses after the event, and `state` the phases.
    fn jump(&mut self, after: impl Iterator<Item = S>, state: &State<S, Z>) {
        if !core::mem::take(&mut self.is_at_event) {
            return;
        }
        let Some((rates, before)) = self.rates.take() else {
            return;
        };
        let Some((j, contact)) = self.trigger(&before, state) else {
            return;
        };
        let slope = at(self.slopes.as_ref(), j);
        if slope.is_zero() {
            return;
        }
        let masses = self.model.wall();
        let was = before.as_ref().get(j).copied().unwrap_or(FREE);
        for (mass, after) in after.enumerate() {
            let step = at(self.accelerations.as_ref(), mass) - after;
            set(self.accelerations.as_mut(), mass, step);
        }
        for column in 0..self.width {
            let watched = if self.model.is_stop(j) {
                self.across(contact, 0, column)
            } else if was != STUCK {
                self.across(contact, masses, column)
            } else if contact.is_rigid() {
                let hold = rates.hold(j).iter().enumerate();
                hold.fold(S::constant(0.0), |sum, (row, factor)| {
                    sum + *factor * self.get(row, column)
                })
            } else {
                self.get(2 * masses + j, column)
            };
            let delay = -watched / slope;
            for mass in 0..masses {
                let jump = delay * at(self.accelerations.as_ref(), mass);
                let moved = self.get(masses + mass, column) + jump;
                self.put(masses + mass, column, moved);
            }
        }
    }

    /// Computes the jump of the deviations at an impact of a stop that has ended the last stretch. `series` is the motion
    /// after the impact.
    ///
    /// The motion with the deviation collides a time δt = −δz/ż later. With the linear map R that the impact applies to
    /// velocities, δx changes by (v⁻ − v⁺)δt, and δv becomes R(δv + a⁻δt) − a⁺δt.
    fn collide(&mut self, stop: usize, series: &Series<S, Z>) {
        self.is_at_event = false;
        self.rates = None;
        let model = self.model;
        let slope = at(self.slopes.as_ref(), stop);
        let Some(own) = model.contact(stop) else {
            return;
        };
        if slope.is_zero() {
            return;
        }
        let masses = model.wall();
        let rate = S::constant(1.0) / series.length;
        let mut after = model.size.masses((S::constant(0.0), S::constant(0.0)));
        for (mass, own) in after.as_mut().iter_mut().enumerate() {
            let terms = series.velocity_terms(mass);
            *own = (at(&terms, 0), rate * at(&terms, 1));
        }
        let kept = (series.speed_at_start(own.plus) - series.speed_at_start(own.minus)) / slope;
        let change = model.impact_of(own, kept - S::constant(1.0));
        for column in 0..self.width {
            let delay = -self.across(own, 0, column) / slope;
            for (mass, (speed, _)) in after.as_ref().iter().enumerate() {
                let jump = (at(self.speeds.as_ref(), mass) - *speed) * delay;
                let place = self.get(mass, column) + jump;
                self.put(mass, column, place);
                let moved = delay * at(self.accelerations.as_ref(), mass);
                let speed = self.get(masses + mass, column) + moved;
                self.put(masses + mass, column, speed);
            }
            let closing = self.across(own, masses, column);
            for (mass, (_, rate)) in after.as_ref().iter().enumerate() {
                let share = match mass {
                    mass if mass == own.plus => change.0,
                    mass if mass == own.minus => -change.1,
                    _ => S::constant(0.0),
                };
                let speed = self.get(masses + mass, column) + share * closing - delay * *rate;
                self.put(masses + mass, column, speed);
            }
        }
    }

    /// Takes the linear equations of the last stretch, if they also belong to the phases in `state`.
    fn known(&mut self, state: &State<S, Z>) -> Option<Rates<S, Z>> {
        // On a line of the friction law, the equations also depend on the line.
        let has_lines = !self.model.law.as_ref().is_empty();
        let known = self
            .rates
            .take()
            .filter(|(_, phases)| !has_lines && *phases == state.phases);
        known.map(|(rates, _)| rates)
    }

    /// Returns the contact whose event has ended the last stretch, if the accelerations may jump there. `before` contains
    /// the phases during the stretch.
    ///
    /// A contact that slides changes its phase only at its own event. A contact that sticks may also break away because
    /// another contact changes its phase; its force then jumps to the limit.
    fn trigger(
        &self,
        before: &Z::Contacts<i8>,
        state: &State<S, Z>,
    ) -> Option<(usize, &'m Contact<S>)> {
        let was = |j: usize| before.as_ref().get(j).copied().unwrap_or(FREE);
        let contacts = self.model.contacts().iter().enumerate();
        let changed = contacts.filter(|(j, contact)| {
            // An elastic contact changes the accelerations only when it breaks away with μ > 1.
            let breaks = was(*j) == STUCK && contact.stiction > S::constant(1.0);
            // So does a stop with a dashpot when it shuts or opens.
            let jumps = match self.model.stop(*j) {
                Some(stop) => !stop.damping.is_zero(),
                None => contact.is_rigid() || breaks,
            };
            was(*j) != state.phase(*j) && jumps
        });
        let margin = |j: usize| match was(j) {
            STUCK if !self.model.is_stop(j) => at(self.margins.as_ref(), j).abs(),
            _ => S::constant(-1.0),
        };
        changed.reduce(|a, b| if margin(b.0) < margin(a.0) { b } else { a })
    }

    /// Sets the deviations of the forces to 0, except those of elastic contacts that stick.
    fn release(&mut self, state: &State<S, Z>) {
        let first = 2 * self.model.wall() * self.width;
        let forces = self.rows.as_mut().get_mut(first..).unwrap_or_default();
        let forces = forces.chunks_exact_mut(self.width.max(1));
        for ((j, contact), force) in self.model.contacts().iter().enumerate().zip(forces) {
            if contact.is_rigid() || state.phase(j) != STUCK {
                force.fill(S::constant(0.0));
            }
        }
        self.press(state);
    }

    /// Sets the deviations of the forces of shut stops, which follow from those of the displacements.
    fn press(&mut self, state: &State<S, Z>) {
        if !self.model.has_stops() {
            return;
        }
        let model = self.model;
        for (j, contact) in model.contacts().iter().enumerate() {
            let Some(stiffness) = contact.stiffness.filter(|_| contact.stop.is_some()) else {
                continue;
            };
            if state.phase(j) != STUCK {
                continue;
            }
            for column in 0..self.width {
                let force = stiffness * self.across(contact, 0, column);
                self.put(2 * model.wall() + j, column, force);
            }
        }
    }

    /// Multiplies the deviations by a matrix of `count` coordinates, of which those of a deviation are the first.
    fn multiply(&mut self, matrix: &[S], count: usize) {
        let size = self.width.max(1);
        let rows = self.term.as_mut().chunks_exact_mut(size);
        for (row, factors) in rows.zip(matrix.chunks_exact(count.max(1))) {
            row.fill(S::constant(0.0));
            for (factor, other) in factors.iter().zip(self.rows.as_ref().chunks_exact(size)) {
                add_row(row, other, *factor);
            }
        }
        core::mem::swap(&mut self.rows, &mut self.term);
    }

    /// Advances the deviations by their power series over the time `length`.
    fn advance(&mut self, rates: &Rates<S, Z>, state: &State<S, Z>, length: S) {
        let used = self.width * self.width;
        for (term, row) in self.term.as_mut().iter_mut().zip(self.rows.as_ref()) {
            *term = *row;
        }
        let ratio = length / self.model.stretch;
        let mut size = S::constant(1.0);
        for order in 0..terms_of::<S>() {
            let order = S::whole(order + 1);
            self.raise(rates, state, length / order);
            let rows = self.rows.as_mut().iter_mut().take(used);
            for (sum, term) in rows.zip(self.term.as_ref()) {
                *sum = *sum + *term;
            }
            size = size * ratio / order;
            if size < S::constant(S::EPSILON) {
                return;
            }
        }
    }

    /// Replaces the coefficients in the field `term` by those of the next order. `next` is the time over the order.
    fn raise(&mut self, rates: &Rates<S, Z>, state: &State<S, Z>, next: S) {
        let (masses, size) = (self.model.wall(), self.width.max(1));
        let term = self.term.as_ref();
        for (index, row) in self.raised.as_mut().chunks_exact_mut(size).enumerate() {
            row.fill(S::constant(0.0));
            let speeds = |node: usize| {
                let row = (masses + node) * size..(masses + node + 1) * size;
                let is_mass = node < masses;
                term.get(row).filter(|_| is_mass).unwrap_or_default()
            };
            if index < masses {
                add_row(row, speeds(index), next);
            } else if index < 2 * masses {
                let factors = rates.acceleration(index - masses).iter();
                for (factor, other) in factors.zip(term.chunks_exact(size)) {
                    if !factor.is_zero() {
                        add_row(row, other, next * *factor);
                    }
                }
            } else if let Some(contact) = self.model.contact(index - 2 * masses)
                && let Some(stiffness) = contact.stiffness
                && state.phase(index - 2 * masses) == STUCK
            {
                add_row(row, speeds(contact.plus), next * stiffness);
                add_row(row, speeds(contact.minus), -next * stiffness);
            }
        }
        core::mem::swap(&mut self.term, &mut self.raised);
    }
}

impl<S: Float, Z: Size> Observe<S, Z> for Tangent<'_, S, Z> {
    const NEEDS_SERIES: bool = false;

    fn leap(&mut self, leap: &Leap<'_, S, Z>) {
        let table = leap.table;
        let starts = table.accelerations().map(|row| dot(row, leap.before));
        self.jump(starts, leap.state);
        self.release(leap.state);
        if leap.is_whole {
            self.multiply(table.whole(), leap.before.len());
            return;
        }
        let rates = self
            .known(leap.state)
            .unwrap_or_else(|| Rates::of(self.model, table));
        self.advance(&rates, leap.state, leap.length);
        self.rates = Some((rates, leap.state.phases.clone()));
        let zero = S::constant(0.0);
        let mut slopes = self.model.size.coordinates(leap.after.len(), zero);
        table.rates(self.model, leap.after, slopes.as_mut());
        let slopes = slopes.as_ref();
        let masses = self.model.wall();
        for (mass, own) in self.accelerations.as_mut().iter_mut().enumerate() {
            *own = at(slopes, masses + mass);
        }
        for (j, slope) in self.slopes.as_mut().iter_mut().enumerate() {
            *slope = table.slope(self.model, leap.state, (j, slopes));
        }
        for (j, margin) in self.margins.as_mut().iter_mut().enumerate() {
            let force = table.force(self.model, (j, leap.after));
            *margin = self.model.static_friction(j, S::constant(0.0)) - force.abs();
        }
    }

    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        let model = self.model;
        let rate = S::constant(1.0) / series.length;
        let starts = (0..model.wall()).map(|mass| rate * at(&series.velocity_terms(mass), 1));
        if let Some(stop) = self.impact.take() {
            self.collide(stop, series);
        } else {
            self.jump(starts, state);
        }
        self.release(state);
        let rates = self.known(state).unwrap_or_else(|| {
            let tree = Tree::new(model, |j| state.phase(j) == STUCK);
            Rates::new(model, state, &tree, series.start)
        });
        self.advance(&rates, state, end * series.length);
        self.rates = Some((rates, state.phases.clone()));
        for (mass, own) in self.accelerations.as_mut().iter_mut().enumerate() {
            *own = rate * value_and_slope(&series.velocity_terms(mass), end).1;
        }
        if Z::HAS_PARTS {
            for (mass, own) in self.speeds.as_mut().iter_mut().enumerate() {
                *own = value(&series.velocity_terms(mass), end);
            }
        }
        for (j, slope) in self.slopes.as_mut().iter_mut().enumerate() {
            let Some(contact) = model.contact(j) else {
                continue;
            };
            if model.is_stop(j) {
                let speed = series.speed_terms(contact.plus, contact.minus);
                *slope = value(&speed, end);
                continue;
            }
            let watched = if state.phase(j) == STUCK {
                series.force_terms(j)
            } else {
                series.slip_terms(contact.sides())
            };
            let (force, change) = value_and_slope(&watched, end);
            *slope = rate * change;
            if state.phase(j) == STUCK {
                // The static friction force may change with time, too.
                let time = series.start + end * series.length;
                let limit = contact.stiction * contact.level.value(time, 1);
                *slope = *slope - limit.copysign(force * limit);
                let most = model.static_friction(j, time);
                set(self.margins.as_mut(), j, most - force.abs());
            }
        }
    }

    fn event(&mut self, _: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.is_at_event = true;
        if !self.model.has_stops() {
            return;
        }
        let phases = before.as_ref().iter().zip(after.as_ref()).enumerate();
        let mut phases = phases.filter(|(j, (before, after))| {
            let collides = **after == IMPACT || (**before == FREE && **after == STUCK);
            let own = self.model.contact(*j);
            collides && own.is_some_and(|own| own.stop.is_some() && own.is_rigid())
        });
        self.impact = phases.next().map(|(j, _)| j);
    }
}

/// Observer of a motion that consists of two other observers.
pub(super) struct Both<'o, A, B>(pub(super) &'o mut A, pub(super) &'o mut B);

impl<S: Float, Z: Size, A: Observe<S, Z>, B: Observe<S, Z>> Observe<S, Z> for Both<'_, A, B> {
    const NEEDS_SERIES: bool = A::NEEDS_SERIES || B::NEEDS_SERIES;

    fn leap(&mut self, leap: &Leap<'_, S, Z>) {
        self.0.leap(leap);
        self.1.leap(leap);
    }

    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.0.stretch(series, end, state);
        self.1.stretch(series, end, state);
    }

    fn event(&mut self, time: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.0.event(time, before, after);
        self.1.event(time, before, after);
    }
}
