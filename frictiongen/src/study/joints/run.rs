//! The motion from event to event.

use super::events::set_phase;
use super::model::{Model, at, level_fits};
use super::roots::first_negative;
use super::series::{Poly, Series, wave_terms};
use super::tree::{Tree, set};
use super::{Chain, JointError, Wave};

/// Phase of a contact that sticks.
pub const STUCK: i8 = 0;
/// Phase of a contact without force.
pub const FREE: i8 = 2;
/// Largest number of events in one call of [`Motion::run`].
pub const MAX_EVENTS: usize = 100_000;
/// Largest number of stretches in one call of [`Motion::run`].
pub const MAX_STRETCHES: usize = 10_000_000;
/// Events that are no farther apart than this fraction of a stretch are one event.
const SAME: f64 = 1e-11;

/// The state of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Displacement of each mass.
    pub x: Vec<f64>,
    /// Velocity of each mass.
    pub v: Vec<f64>,
    /// Force of each elastic contact; 0 for rigid ones.
    pub forces: Vec<f64>,
    /// Relative displacement at which each rigid contact sticks.
    pub places: Vec<f64>,
    /// −1 and 1 for a contact that slides with that sign of ż, 0 for one that sticks, 2 for one without force.
    pub phases: Vec<i8>,
    /// For each contact, the number of leading terms that are 0 in the polynomial of its next event, and the direction
    /// of sliding to which that polynomial belongs.
    pub(super) zeros: Vec<(usize, i8)>,
}

impl State {
    /// Returns the phase of a contact.
    pub fn phase(&self, contact: usize) -> i8 {
        self.phases.get(contact).copied().unwrap_or(FREE)
    }
}

/// An event, which several contacts may share.
#[derive(Clone, Debug, PartialEq)]
pub struct Transition {
    /// Its instant.
    pub time: f64,
    /// The phases before it.
    pub before: Vec<i8>,
    /// The phases after it.
    pub after: Vec<i8>,
}

/// A motion in time.
#[derive(Clone, Debug)]
pub struct Motion {
    pub(super) model: Model,
    pub(super) state: State,
    pub(super) time: f64,
    pub(super) tree: Tree,
    stalls: usize,
}

impl Motion {
    /// Starts at time 0 with all masses at 0 and at rest, and elastic contacts without force.
    pub fn from_rest(chain: &Chain) -> Result<Self, JointError> {
        let rest = vec![0.0; chain.masses.len()];
        Self::from(chain, &rest, &rest)
    }

    /// Starts at time 0 with given displacements and velocities, and elastic contacts without force.
    pub fn from(chain: &Chain, x: &[f64], v: &[f64]) -> Result<Self, JointError> {
        let model = Model::new(chain)?;
        let contacts = model.contacts.len();
        let full = |values: &[f64]| (0..model.wall()).map(|i| at(values, i)).collect();
        let state = State {
            x: full(x),
            v: full(v),
            forces: vec![0.0; contacts],
            places: vec![0.0; contacts],
            phases: vec![FREE; contacts],
            zeros: vec![(0, 0); contacts],
        };
        let tree = Tree::new(&model, |_| false);
        let mut motion = Self {
            model,
            state,
            time: 0.0,
            tree,
            stalls: 0,
        };
        motion.begin()?;
        Ok(motion)
    }

    /// Returns the time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Returns the state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Returns the chain.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns the relative velocity of a contact, and its relative displacement.
    pub fn relative(&self, contact: usize) -> (f64, f64) {
        let (x, v) = self.nodes();
        let Some(c) = self.model.contacts.get(contact) else {
            return (0.0, 0.0);
        };
        let sticks = c.is_rigid() && self.state.phase(contact) == STUCK;
        let place = if sticks {
            at(&self.state.places, contact)
        } else {
            c.across(&x)
        };
        (c.across(&v), place)
    }

    /// Returns the present force of each contact.
    pub fn forces(&self) -> Vec<f64> {
        let span = (self.time, 0.0);
        let series = Series::new(&self.model, &self.state, &self.tree, span);
        let contacts = 0..self.model.contacts.len();
        contacts.map(|j| series.force(j, 0.0)).collect()
    }

    /// Starts again at time 0 with a state of this chain.
    pub fn restart(&mut self, state: State) {
        self.time = 0.0;
        self.state = state;
        self.join();
        let (mut x, mut v) = self.nodes();
        self.tree.meet(&self.model, &mut v);
        self.tree.place(&mut x, &mut v, &self.state.places);
        self.keep_masses(x, v);
    }

    /// Changes the level of a contact from now on.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the contact cannot have this level, and those of a decision.
    pub fn set_level(&mut self, contact: usize, level: Wave) -> Result<(), JointError> {
        let (x, v) = self.nodes();
        let force = at(&self.state.forces, contact);
        let Some(c) = self.model.contacts.get_mut(contact) else {
            return Ok(());
        };
        if !level_fits(&level, c.is_rigid()) {
            return Err(JointError::Number("the level of a contact"));
        }
        let was_free = c.is_free();
        c.level = level;
        let speed = c.across(&v);
        let phase = self.state.phase(contact);
        let slides = speed.signum() as i8;
        let new = match (c.is_free(), c.stiffness) {
            (true, _) => FREE,
            (false, None) if was_free && speed != 0.0 => slides,
            (false, None) if was_free => STUCK,
            (false, None) => phase,
            (false, Some(_)) if force.abs() >= level.constant && force * speed > 0.0 => slides,
            (false, Some(_)) => STUCK,
        };
        let place = c.across(&x);
        if c.stiffness.is_some() {
            let most = level.constant;
            set(&mut self.state.forces, contact, force.clamp(-most, most));
        }
        if was_free {
            set(&mut self.state.places, contact, place);
        }
        set_phase(&mut self.state.phases, contact, new);
        self.model.stretch = self.model.stretch.min(shortest(&level));
        self.ask(&[], &[])
    }

    /// Changes a load from now on, for instance to the line that leads to the next sample of a record.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the load is not finite, [`JointError::Ends`] if there is no such load.
    pub fn set_load(&mut self, load: usize, to: Wave) -> Result<(), JointError> {
        if !to.is_finite() {
            return Err(JointError::Number("a load"));
        }
        let jump = self.model.change_load(load, to, self.time);
        let jump = jump.ok_or(JointError::Ends("a load"))?;
        self.model.stretch = self.model.stretch.min(shortest(&to));
        if jump != 0.0 {
            // Accelerations and holding forces jump; velocities and elastic forces do not.
            let contacts = self.model.contacts.iter().zip(&self.state.phases);
            for ((contact, phase), zeros) in contacts.zip(&mut self.state.zeros) {
                if contact.is_rigid() {
                    zeros.0 = zeros.0.min(usize::from(*phase != STUCK));
                }
            }
        }
        Ok(())
    }

    /// Runs to an instant and returns the events on the way. `watch` sees each stretch, and the fraction of it that the
    /// motion has covered.
    pub fn run(
        &mut self,
        until: f64,
        watch: &mut dyn FnMut(&Series, f64, &State),
    ) -> Result<Vec<Transition>, JointError> {
        let mut events = Vec::new();
        for _ in 0..MAX_STRETCHES {
            if self.time >= until {
                return Ok(events);
            }
            if let Some(event) = self.step(until, watch)? {
                events.push(event);
                if events.len() > MAX_EVENTS {
                    return Err(JointError::Events);
                }
            }
        }
        Err(JointError::Stretches)
    }

    /// Advances to the end of a stretch or to the next event.
    fn step(
        &mut self,
        until: f64,
        watch: &mut dyn FnMut(&Series, f64, &State),
    ) -> Result<Option<Transition>, JointError> {
        let left = until - self.time;
        let length = left.min(self.model.stretch);
        let series = Series::new(&self.model, &self.state, &self.tree, (self.time, length));
        let roots: Vec<_> = (0..self.model.contacts.len())
            .filter_map(|j| self.next_event(&series, j).map(|(at, side)| (j, at, side)))
            .collect();
        let first = roots
            .iter()
            .map(|root| root.1)
            .fold(f64::INFINITY, f64::min);
        let fraction = first.min(1.0);
        watch(&series, fraction, &self.state);
        self.take(&series, fraction);
        let same = SAME * (self.model.stretch / length).min(1.0 / SAME.sqrt());
        if fraction > same {
            self.stalls = 0;
            self.state.zeros.fill((0, 0));
        }
        self.time = if first > 1.0 && length == left {
            until
        } else {
            self.time + fraction * length
        };
        if first > 1.0 {
            return self.finite().map(|()| None);
        }
        self.stalls += 1;
        if self.stalls > 16 + 8 * self.model.contacts.len() {
            return Err(JointError::Stalled);
        }
        let window = first + same;
        let hits = roots.iter().filter(|root| root.1 <= window);
        let hits: Vec<(usize, i8)> = hits.map(|&(j, _, side)| (j, side)).collect();
        let before = self.state.phases.clone();
        self.pass(&series, fraction, &hits)?;
        self.finite()?;
        let after = self.state.phases.clone();
        Ok((before != after).then_some(Transition {
            time: self.time,
            before,
            after,
        }))
    }

    /// Refuses what is not a number.
    fn finite(&self) -> Result<(), JointError> {
        let numbers = self.state.x.iter().chain(&self.state.v);
        if numbers.chain(&self.state.forces).all(|x| x.is_finite()) {
            Ok(())
        } else {
            Err(JointError::NotFinite)
        }
    }

    /// Takes over the state at a fraction of a stretch.
    fn take(&mut self, series: &Series, fraction: f64) {
        let (x, v) = series.motion(fraction);
        self.state.x = x;
        self.state.v = v;
        for (j, contact) in self.model.contacts.iter().enumerate() {
            if !contact.is_rigid() && self.state.phase(j) == STUCK {
                set(&mut self.state.forces, j, series.force(j, fraction));
            }
        }
    }

    /// Returns the next event of a contact in a stretch, and its side.
    fn next_event(&self, series: &Series, j: usize) -> Option<(f64, i8)> {
        let contact = self.model.contacts.get(j)?;
        let (zeros, zero_side) = self.state.zeros.get(j).copied().unwrap_or_default();
        match self.state.phase(j) {
            FREE => None,
            STUCK => {
                let level = wave_terms(&contact.level, series.start, series.length, 0);
                let force = series.force_terms(j);
                let sides = [1_i8, -1].map(|side| {
                    let margin = margin(contact.stiction, &level, f64::from(side), &force);
                    let zeros = if side == zero_side { zeros } else { 0 };
                    first_negative(&margin, zeros).map(|at| (at, side))
                });
                let [up, down] = sides;
                match (up, down) {
                    (Some(up), Some(down)) => Some(if down.0 < up.0 { down } else { up }),
                    (up, down) => up.or(down),
                }
            }
            side => {
                let speed = series.speed_terms(contact.plus, contact.minus);
                let speed = speed.map(|term| f64::from(side) * term);
                first_negative(&speed, zeros).map(|at| (at, side))
            }
        }
    }

    /// Joins the masses of the contacts that stick.
    pub(super) fn join(&mut self) {
        self.tree = Tree::new(&self.model, |j| self.state.phase(j) == STUCK);
    }

    /// Takes the values of the masses from those of the nodes.
    fn keep_masses(&mut self, mut x: Vec<f64>, mut v: Vec<f64>) {
        x.truncate(self.model.wall());
        v.truncate(self.model.wall());
        self.state.x = x;
        self.state.v = v;
    }

    /// Returns displacements and velocities of all nodes.
    pub(super) fn nodes(&self) -> (Vec<f64>, Vec<f64>) {
        let (mut x, mut v) = (self.state.x.clone(), self.state.v.clone());
        let base = |d| at(&wave_terms(&self.model.base, self.time, 0.0, d), 0);
        x.extend([0.0, base(0)]);
        v.extend([0.0, base(1)]);
        (x, v)
    }
}

/// Returns the terms of the margin of a contact that sticks.
fn margin(stiction: f64, level: &Poly, side: f64, force: &Poly) -> Poly {
    let mut margin = level.map(|term| stiction * term);
    for (margin, force) in margin.iter_mut().zip(force) {
        *margin -= side * force;
    }
    margin
}

/// Longest stretch for a wave.
fn shortest(wave: &Wave) -> f64 {
    if wave.amplitude == 0.0 {
        f64::INFINITY
    } else {
        1.0 / wave.omega.abs()
    }
}
