//! Advances the motion of a chain with several contacts from event to event.

use super::decide::MAX_PATTERNS;
use super::model::{Contact, Model};
use super::poly::{Poly, nothing};
use super::roots::first_negative_within;
use super::series::Series;
use super::size::{Size, add, at, set, sign};
use super::state::{FREE, STUCK, State};
use super::table::{Leap, NoTables, Room, Table, Tables};
use super::tree::Tree;
use super::wave::Wave;
use crate::Float;
use crate::errors::Halt;

/// Returns the largest time between two events that the solver treats as simultaneous, divided by the duration of the
/// time interval of one power series.
fn same<S: Float>() -> S {
    S::constant(if S::EPSILON < 1e-10 { 1e-11 } else { 1e-4 })
}

/// Observer of a motion. The solver calls it for every stretch (time interval of one power series) and every event.
pub trait Observe<S: Float, Z: Size> {
    /// True if the observer needs the power series of every stretch. If false, and if the solver advances the motion by a
    /// table, it calls [`leap`](Self::leap) in place of [`stretch`](Self::stretch).
    const NEEDS_SERIES: bool = true;

    /// Receives a stretch that the solver has advanced by a table. The default method ignores it.
    fn leap(&mut self, _: &Leap<'_, S, Z>) {}

    /// Receives the motion from the start of a time interval to the fraction `end` of the interval. During this time
    /// the contacts have the phases in `state`.
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>);

    /// Receives the chain, and the same motion as [`stretch`](Self::stretch). The default method ignores it.
    fn follow(&mut self, _: &Model<S, Z>, _: &Series<S, Z>, _end: S, _: &State<S, Z>) {}

    /// Receives the phases of all contacts (sticking or sliding) before and after an event. The default method ignores
    /// the event.
    fn event(&mut self, _time: S, _before: &Z::Contacts<i8>, _after: &Z::Contacts<i8>) {}
}

/// The unit type is an observer that ignores the motion.
impl<S: Float, Z: Size> Observe<S, Z> for () {
    const NEEDS_SERIES: bool = false;

    fn stretch(&mut self, _: &Series<S, Z>, _: S, _: &State<S, Z>) {}
}

/// Bounds on the work in one call: the numbers of events and of stretches (time intervals of one power series).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Largest number of events in one call.
    pub events: usize,
    /// Largest number of stretches (time intervals of one power series) in one call.
    pub stretches: usize,
}

/// Limits on the work for one event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Limits {
    /// Largest number of intervals that the search for one event divides.
    pub(super) divisions: u32,
    /// Largest number of patterns in one decision which contacts stick. If a smaller number than [`MAX_PATTERNS`] does not
    /// suffice, these contacts stick.
    pub(super) patterns: usize,
}

impl Limits {
    /// Limits of a motion without a bound on the work for one event.
    pub(super) const NONE: Self = Self {
        divisions: u32::MAX,
        patterns: MAX_PATTERNS,
    };
}

/// Motion of a chain with several contacts as a function of time.
#[derive(Clone, Debug)]
pub struct Motion<S: Float, Z: Size> {
    pub(super) model: Model<S, Z>,
    pub(super) state: State<S, Z>,
    pub(super) time: S,
    pub(super) tree: Tree<S, Z>,
    pub(super) stalls: usize,
    pub(super) limits: Limits,
    /// Tables that searches for the steady state of this motion share.
    pub(super) shared: Z::Shared<S>,
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Starts a motion at time 0 with the displacements `x` and the velocities `v` of the masses. At the start elastic
    /// contacts have no force.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the solver cannot decide which contacts stick.
    pub fn new(model: Model<S, Z>, x: &[S], v: &[S]) -> Result<Self, Halt> {
        let mut state = State::at_rest(&model.size);
        state.keep_places(x);
        state.keep_speeds(v);
        let tree = Tree::new(&model, |_| false);
        let shared = model.size.shared();
        let mut motion = Self::at_start(model, state, tree, shared, S::constant(0.0));
        motion.begin()?;
        Ok(motion)
    }

    /// Returns a motion at the instant `zero`, which is 0, before the decision which contacts stick.
    pub(super) const fn at_start(
        model: Model<S, Z>,
        state: State<S, Z>,
        tree: Tree<S, Z>,
        shared: Z::Shared<S>,
        zero: S,
    ) -> Self {
        Self {
            model,
            state,
            time: zero,
            tree,
            stalls: 0,
            limits: Limits::NONE,
            shared,
        }
    }

    /// Returns the time since the start of the motion.
    pub fn time(&self) -> S {
        self.time
    }

    /// Returns the present state of the masses and the contacts.
    pub fn state(&self) -> &State<S, Z> {
        &self.state
    }

    /// Returns the constants and the nodes of the chain.
    pub fn model(&self) -> &Model<S, Z> {
        &self.model
    }

    /// Returns the present relative velocity and the present relative displacement of a contact, in this order.
    pub fn relative(&self, contact: usize) -> (S, S) {
        let (x, v) = self.nodes();
        let Some(c) = self.model.contact(contact) else {
            return (S::constant(0.0), S::constant(0.0));
        };
        let sticks = c.is_rigid() && self.state.phase(contact) == STUCK;
        let place = if sticks {
            at(self.state.places.as_ref(), contact)
        } else {
            c.across(x.as_ref())
        };
        let velocity = if sticks {
            S::constant(0.0)
        } else {
            self.model.slip(c, v.as_ref())
        };
        (velocity, place)
    }

    /// Returns the present force of each contact, in the order of the scene description.
    pub fn forces(&self) -> Z::Contacts<S> {
        let (mut x, mut v) = self.nodes();
        let places = self.state.places.as_ref();
        self.tree
            .place_moving(&self.model, (x.as_mut(), v.as_mut()), places);
        let load = |index| self.model.load_value(index, self.time);
        let mut nodes = self.model.forces(x.as_ref(), v.as_ref(), load, None);
        let mut forces = self.model.size.contacts(S::constant(0.0));
        let contacts = self.model.contacts().iter().zip(forces.as_mut());
        for (j, (contact, force)) in contacts.enumerate() {
            *force = match self.state.phase(j) {
                FREE => S::constant(0.0),
                STUCK if contact.is_rigid() => continue,
                STUCK => {
                    let spring = at(self.state.forces.as_ref(), j);
                    spring + self.model.dashpot(j, v.as_ref())
                }
                side => {
                    let velocity = self.model.slip(contact, v.as_ref());
                    sign::<S>(side) * self.model.kinetic(contact, self.time, velocity)
                }
            };
            contact.pull(nodes.as_mut(), *force);
        }
        let lift = self.model.base.value(self.time, 2);
        self.tree
            .accelerate(&self.model, nodes.as_ref(), lift, forces.as_mut());
        forces
    }

    /// Restarts the motion at time 0 from a state of this chain.
    pub fn restart(&mut self, state: State<S, Z>) {
        self.time = S::constant(0.0);
        self.state = state;
        self.join();
        if self.tree.is_empty() {
            return;
        }
        let (mut x, mut v) = self.nodes();
        self.tree.meet_moving(&self.model, v.as_mut());
        let places = self.state.places.as_ref();
        self.tree
            .place_moving(&self.model, (x.as_mut(), v.as_mut()), places);
        self.state.keep_places(x.as_ref());
        self.state.keep_speeds(v.as_ref());
    }

    /// Sets the motion to a state that it had at time 0, after `change` has set the loads, the friction forces and the
    /// base of that instant.
    pub(super) fn resume(&mut self, state: State<S, Z>, change: impl FnOnce(&mut Model<S, Z>)) {
        self.time = S::constant(0.0);
        self.stalls = 0;
        self.state = state;
        change(&mut self.model);
        self.join();
        self.tree.settle(&self.model, &mut self.state, self.time);
    }

    /// Sets μ of a contact, the ratio of its static to its kinetic friction force.
    pub(super) fn set_stiction(&mut self, contact: usize, mu: S) {
        if let Some(contact) = self.model.contacts.as_mut().get_mut(contact) {
            contact.stiction = mu;
        }
    }

    /// Takes the motion at the instant `time` from its coordinates. The motion has had no event since the last instant.
    pub(super) fn land(&mut self, coordinates: &[S], time: S) {
        self.state.land(&self.model, coordinates);
        self.time = time;
        self.keep_forces();
        self.stalls = 0;
        self.tree.settle(&self.model, &mut self.state, time);
    }

    /// Makes the present instant the time 0 for all loads, friction forces and the base. The state does not change.
    pub(super) fn rewind(&mut self) {
        let time = self.time;
        let contacts = self.model.contacts.as_mut().iter_mut();
        let loads = self.model.loads.as_mut().iter_mut();
        let waves = contacts.map(|contact| &mut contact.level);
        let waves = waves.chain(loads.map(|(_, wave)| wave));
        for wave in waves {
            wave.shift(time);
        }
        self.model.base.shift(time);
        self.time = S::constant(0.0);
    }

    /// Changes the kinetic friction force of a contact from the present instant on.
    ///
    /// # Errors
    ///
    /// [`Halt::Level`] if the contact cannot have the force `level`. Another [`Halt`] if the solver cannot decide which
    /// contacts stick.
    pub fn set_level(&mut self, contact: usize, level: Wave<S>) -> Result<(), Halt> {
        let (x, v) = self.nodes();
        let force = at(self.state.forces.as_ref(), contact);
        let Some(c) = self.model.contacts.as_mut().get_mut(contact) else {
            return Ok(());
        };
        if !c.fits(&level) {
            return Err(Halt::Level);
        }
        let zero = S::constant(0.0);
        let was_free = c.is_free();
        c.level = level;
        let c = *c;
        let most = level.value(self.time, 0);
        let speed = self.model.slip(&c, v.as_ref());
        let phase = self.state.phase(contact);
        // A contact that sticks keeps a force up to its static friction force.
        let limit = if phase == STUCK {
            c.stiction * most
        } else {
            most
        };
        let slides = if speed < zero { -1 } else { 1 };
        let new = match (c.is_free(), c.stiffness) {
            (true, _) => FREE,
            (false, None) if was_free && speed != zero => slides,
            (false, None) if was_free => STUCK,
            (false, None) => phase,
            (false, Some(_)) => {
                let side = match force {
                    force if force > zero => 1,
                    force if force < zero => -1,
                    _ => slides,
                };
                let yields = force.abs() >= limit && sign::<S>(side) * speed > c.creep();
                if yields { side } else { STUCK }
            }
        };
        if c.stiffness.is_some() && force.abs() > limit {
            let kept = crate::Scalar::max(-most, crate::Scalar::min(force, most));
            set(self.state.forces.as_mut(), contact, kept);
        }
        if was_free {
            set(self.state.places.as_mut(), contact, c.across(x.as_ref()));
        }
        self.state.set_phase(contact, new);
        self.shorten(&level);
        self.decide_at_once()
    }

    /// Changes a load from the present instant on. The new load may for instance be the straight line to the next
    /// sample of a record.
    ///
    /// # Errors
    ///
    /// [`Halt::Load`] if the load is not finite, or if no load has this index.
    pub fn set_load(&mut self, load: usize, to: Wave<S>) -> Result<(), Halt> {
        if !to.is_finite() {
            return Err(Halt::Load);
        }
        let jump = self.model.change_load(load, to, self.time);
        let jump = jump.ok_or(Halt::Load)?;
        self.shorten(&to);
        if !jump.is_zero() {
            self.accelerations_jump();
        }
        Ok(())
    }

    /// Prepares the rigid contacts for a jump of the accelerations at the present instant. The forces of sticking rigid
    /// contacts jump too. Velocities and the forces of elastic contacts do not jump.
    pub(super) fn accelerations_jump(&mut self) {
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let sticks = self.state.phase(j) == STUCK;
            if let Some(zeros) = self.state.zeros.as_mut().get_mut(j)
                && contact.is_rigid()
            {
                zeros.0 = zeros.0.min(usize::from(!sticks));
            }
        }
    }

    /// Shortens the stretches (time intervals of one power series) so that a power series can represent the function
    /// `wave`.
    fn shorten(&mut self, wave: &Wave<S>) {
        let longest = wave.longest_stretch();
        self.model.stretch = crate::Scalar::min(self.model.stretch, longest);
    }

    /// Advances the motion to the given instant.
    ///
    /// # Errors
    ///
    /// [`Halt::Events`] or [`Halt::Stretches`] if the call exceeds a bound on its work. [`Halt::NotFinite`] if the
    /// motion exceeds the range of the number type. Another [`Halt`] if the solver cannot decide which contacts stick.
    pub fn run(
        &mut self,
        until: S,
        bounds: Bounds,
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        self.run_by(&mut NoTables, (until, bounds), watch)
    }

    /// Advances the motion as [`run`](Self::run) does, by the given tables. After the tables have been made, the loads,
    /// the base and the friction forces must not change.
    pub(super) fn run_by(
        &mut self,
        tables: &mut impl Tables<S, Z>,
        (until, bounds): (S, Bounds),
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        let (mut events, mut stretches) = (0, bounds.stretches);
        while stretches > 0 {
            if self.time >= until {
                return Ok(());
            }
            let before = self.state.phases.clone();
            let passed = self.step(tables, (until, &mut stretches), watch)?;
            if passed && before != self.state.phases {
                watch.event(self.time, &before, &self.state.phases);
                self.part();
                events += 1;
                if events > bounds.events {
                    return Err(Halt::Events);
                }
            }
        }
        if self.time >= until {
            return Ok(());
        }
        Err(Halt::Stretches)
    }

    /// Advances the motion to the instant `until`, the next event, or the end of a line of the friction law. The function
    /// ends earlier after `stretches` stretches, and without tables after one. It subtracts their number from
    /// `stretches`. Returns true if the motion passed an event.
    fn step(
        &mut self,
        tables: &mut impl Tables<S, Z>,
        (until, stretches): (S, &mut usize),
        watch: &mut impl Observe<S, Z>,
    ) -> Result<bool, Halt> {
        let make = || Table::new(&self.model, &self.state, &self.tree);
        if let Some(found) = tables.find(self.state.key(), make) {
            return self.step_by_table(found, (until, stretches), watch);
        }
        *stretches -= 1;
        self.step_by_series(until, watch)
    }

    /// Advances the motion by a table, as [`step`](Self::step) does.
    fn step_by_table(
        &mut self,
        (table, room): (&Table<S, Z>, &mut Room<Z::Coordinates<S>>),
        (until, stretches): (S, &mut usize),
        watch: &mut impl Observe<S, Z>,
    ) -> Result<bool, Halt> {
        let (one, stretch) = (S::constant(1.0), self.model.stretch);
        self.model
            .write_coordinates(&self.state, self.time, room.before.as_mut());
        let event = loop {
            *stretches -= 1;
            let last = crate::Scalar::min((until - self.time) / stretch, one);
            let start = (self.time, stretch);
            let before = room.before.as_ref();
            let roots = table.next_events((&self.model, &self.state), before, start);
            let first = earliest(roots.as_ref());
            let fraction = crate::Scalar::min(first, last);
            table.advance(&self.model, fraction, room);
            let leap = Leap {
                table,
                model: &self.model,
                length: fraction * stretch,
                before: room.before.as_ref(),
                after: room.after.as_ref(),
                state: &self.state,
                is_whole: fraction == one,
            };
            leap.show((self.time, fraction), watch);
            self.time = if last < one && first > last {
                until
            } else {
                self.time + fraction * stretch
            };
            if fraction > same() {
                self.stalls = 0;
                self.state.zeros.as_mut().fill((0, 0));
            }
            if first <= last {
                break Some((first, roots));
            }
            let is_finite = room.after.as_ref().iter().all(|value| value.is_finite());
            if !is_finite || self.time >= until || *stretches == 0 {
                break None;
            }
            core::mem::swap(&mut room.before, &mut room.after);
        };
        self.state.land(&self.model, room.after.as_ref());
        self.tree.settle(&self.model, &mut self.state, self.time);
        let Some((first, roots)) = event else {
            return self.finite().map(|()| false);
        };
        let (x, _) = self.nodes();
        let hits = self.hits(&roots, first + same());
        self.pass(&hits, |contact| contact.across(x.as_ref()))
    }

    /// Advances the motion by a power series, as [`step`](Self::step) does.
    fn step_by_series(&mut self, until: S, watch: &mut impl Observe<S, Z>) -> Result<bool, Halt> {
        let one = S::constant(1.0);
        let left = until - self.time;
        let length = crate::Scalar::min(left, self.longest_stretch());
        let series = Series::new(&self.model, &self.state, &self.tree, (self.time, length));
        let mut roots = self.model.size.contacts(None);
        let mut divisions = self.limits.divisions;
        for (j, root) in roots.as_mut().iter_mut().enumerate() {
            *root = self.next_event_in(&series, j, &mut divisions)?;
        }
        let first = earliest(roots.as_ref());
        // The stretch (time interval of one power series) ends where a contact leaves its line of the friction law. The
        // end of a line is no event.
        let line_end = self
            .line_end(&series, &mut divisions)?
            .filter(|end| *end < first);
        let first = line_end.map_or(first, |_| S::constant(2.0));
        let end = line_end.unwrap_or(first);
        let fraction = crate::Scalar::min(end, one);
        watch.follow(&self.model, &series, fraction, &self.state);
        watch.stretch(&series, fraction, &self.state);
        self.take(&series, fraction);
        let same = same::<S>();
        let widest = one / same.sqrt();
        let same = same * crate::Scalar::min(self.model.stretch / length, widest);
        self.forget_events(fraction, same);
        self.time = if end > one && length == left {
            until
        } else {
            self.time + fraction * length
        };
        self.keep_forces();
        if first > one {
            return self.finite().map(|()| false);
        }
        let hits = self.hits(&roots, first + same);
        self.pass(&hits, |contact| {
            series.place((contact.plus, contact.minus), fraction)
        })
    }

    /// Forgets the last event if the motion has moved on by more than the fraction `same` of a stretch.
    pub(super) fn forget_events(&mut self, fraction: S, same: S) {
        if fraction > same {
            self.stalls = 0;
            self.state.zeros = self.model.size.contacts((0, 0));
        }
    }

    /// Returns, for each contact with an event up to the fraction `until` of the stretch, the sign of the force or
    /// velocity at the event.
    fn hits(&self, roots: &Z::Contacts<Option<(S, i8)>>, until: S) -> Z::Contacts<Option<i8>> {
        let mut hits = self.model.size.contacts(None);
        for (side, root) in hits.as_mut().iter_mut().zip(roots.as_ref()) {
            *side = root.and_then(|(at, side)| (at <= until).then_some(side));
        }
        hits
    }

    /// Passes an event of the contacts in `hits`. `place` returns the relative displacement of a contact.
    fn pass(
        &mut self,
        hits: &Z::Contacts<Option<i8>>,
        place: impl Fn(&Contact<S>) -> S,
    ) -> Result<bool, Halt> {
        self.stalls += 1;
        if self.stalls > 16 + 8 * self.model.contacts().len() {
            return Err(Halt::Stalled);
        }
        self.change_phases(hits, place)?;
        self.finite().map(|()| true)
    }

    /// Returns an error if a number of the state is infinite or NaN.
    pub(super) fn finite(&self) -> Result<(), Halt> {
        let numbers = self.state.x.as_ref().iter().chain(self.state.v.as_ref());
        let mut numbers = numbers.chain(self.state.forces.as_ref());
        if numbers.all(|x| x.is_finite()) {
            Ok(())
        } else {
            Err(Halt::NotFinite)
        }
    }

    /// Sets the present state to the motion after a fraction of the time interval of the power series.
    pub(super) fn take(&mut self, series: &Series<S, Z>, fraction: S) {
        let (x, v) = series.motion(&self.model, fraction);
        self.state.x = x;
        self.state.v = v;
        for (j, contact) in self.model.contacts().iter().enumerate() {
            if !contact.is_rigid() && self.state.phase(j) == STUCK {
                set(self.state.forces.as_mut(), j, series.force(j, fraction));
            }
        }
        self.keep_parts(fraction * series.length);
    }

    /// Sets the forces of elastic contacts that slide under a friction force that changes with time.
    fn keep_forces(&mut self) {
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let phase = self.state.phase(j);
            if contact.is_rigid() || contact.has_constant_level() || phase.abs() != 1 {
                continue;
            }
            let force = sign::<S>(phase) * contact.level.value(self.time, 0);
            set(self.state.forces.as_mut(), j, force);
        }
    }

    /// Returns the next event of the contact `j` in the time interval of a power series, as
    /// [`next_event`] does.
    ///
    /// # Errors
    ///
    /// [`Halt::Stretches`] if the search reaches its limit.
    fn next_event_in(
        &self,
        series: &Series<S, Z>,
        j: usize,
        divisions: &mut u32,
    ) -> Result<Option<(S, i8)>, Halt> {
        let Some(contact) = self.model.contact(j) else {
            return Ok(None);
        };
        if let Some(stop) = self.model.stop(j) {
            let zeros = self.state.zeros.as_ref().get(j).map_or(0, |zeros| zeros.0);
            return self.stop_event_in(series, (j, &stop), zeros, divisions);
        }
        let watched = match self.state.phase(j) {
            FREE => return Ok(None),
            STUCK => series.force_terms(j),
            _ => series.slip_terms(contact.sides()),
        };
        let time = (series.start, series.length);
        let watched = (j, series.used_of(&watched));
        event_within(&self.model, &self.state, watched, time, divisions)
    }

    /// Builds the trees of the masses that sticking rigid contacts connect.
    pub(super) fn join(&mut self) {
        if self.tree.is_of(&self.state) {
            return;
        }
        self.tree = Tree::new(&self.model, |j| self.state.phase(j) == STUCK);
    }

    /// Returns the present displacements and velocities of all nodes: the masses, the wall and the base.
    pub(super) fn nodes(&self) -> (Z::Nodes<S>, Z::Nodes<S>) {
        self.state.nodes(&self.model, self.time)
    }
}

/// Returns the next event of the contact `j` in a stretch. `watched` is the power series of its force while it
/// sticks, and of its relative velocity while it slides. `time` contains the start and the duration of the stretch.
/// The first result is the fraction of the stretch after which the event occurs. The second result is the sign of
/// the force or velocity at the event.
pub(super) fn next_event<S: Float, Z: Size>(
    model: &Model<S, Z>,
    state: &State<S, Z>,
    watched: (usize, &[S]),
    time: (S, S),
) -> Option<(S, i8)> {
    // Without a limit the search has no error.
    let mut divisions = u32::MAX;
    event_within(model, state, watched, time, &mut divisions).unwrap_or_default()
}

/// Returns the next event of a contact as [`next_event`] does, or an error if the search reaches its limit.
fn event_within<S: Float, Z: Size>(
    model: &Model<S, Z>,
    state: &State<S, Z>,
    (j, watched): (usize, &[S]),
    time: (S, S),
    divisions: &mut u32,
) -> Result<Option<(S, i8)>, Halt> {
    let Some(contact) = model.contact(j) else {
        return Ok(None);
    };
    let zeros = state.zeros.as_ref().get(j).copied();
    let (zeros, zero_side) = zeros.unwrap_or_default();
    match state.phase(j) {
        FREE => Ok(None),
        STUCK => {
            let level = contact.level.terms(time.0, time.1, 0);
            let mut next = |side: i8| {
                let margin = margin(contact.stiction, &level, sign(side), watched);
                let margin = margin.get(..watched.len()).unwrap_or(&margin);
                let zeros = if side == zero_side { zeros } else { 0 };
                let first = first_negative_within(margin, zeros, divisions)?;
                Ok(first.map(|at| (at, side)))
            };
            Ok(match (next(1)?, next(-1)?) {
                (Some(up), Some(down)) => Some(if down.0 < up.0 { down } else { up }),
                (up, down) => up.or(down),
            })
        }
        side => {
            let mut speed = nothing();
            for (speed, term) in speed.iter_mut().zip(watched) {
                *speed = sign::<S>(side) * *term;
            }
            add(&mut speed, 0, -contact.creep());
            let speed = speed.get(..watched.len()).unwrap_or(&speed);
            let first = first_negative_within(speed, zeros, divisions)?;
            Ok(first.map(|at| (at, side)))
        }
    }
}

/// Returns the fraction of the stretch after which the first event occurs, or 2 if no event occurs in it.
fn earliest<S: Float>(roots: &[Option<(S, i8)>]) -> S {
    let roots = roots.iter().flatten().map(|(at, _)| *at);
    roots.fold(S::constant(2.0), crate::Scalar::min)
}

/// Returns the power series of μF − `side`·f for a sticking contact. μF is its static friction force, and f its force.
/// `side` is the sign of the force at which the contact would slide.
fn margin<S: Float>(stiction: S, level: &Poly<S>, side: S, force: &[S]) -> Poly<S> {
    let mut margin = nothing();
    for ((margin, level), force) in margin.iter_mut().zip(level).zip(force) {
        *margin = stiction * *level - side * *force;
    }
    margin
}
