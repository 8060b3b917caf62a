//! The motion in time, with vectors.

use super::{Chain, JointError, Model, Series, State, Wave};
use frictiongen_kernel::joints::{self, Bounds, Observe, Size, Value};

/// Largest number of events in one call of [`Motion::run`].
pub const MAX_EVENTS: usize = 100_000;
/// Largest number of stretches in one call of [`Motion::run`].
pub const MAX_STRETCHES: usize = 10_000_000;

/// Bounds of one call of [`Motion::run`].
const BOUNDS: Bounds = Bounds {
    events: MAX_EVENTS,
    stretches: MAX_STRETCHES,
};

/// The size of a chain whose numbers are in vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heap {
    pub(super) masses: usize,
    pub(super) contacts: usize,
    pub(super) loads: usize,
}

impl Heap {
    /// Returns the number of unknowns of a steady state.
    fn count(&self) -> usize {
        2 * (self.masses + self.contacts)
    }
}

impl Size for Heap {
    type Masses<T: Value> = Vec<T>;
    type Nodes<T: Value> = Vec<T>;
    type Contacts<T: Value> = Vec<T>;
    type Loads<T: Value> = Vec<T>;
    type Unknowns<T: Value> = Vec<T>;
    type Square<T: Value> = Vec<T>;
    type Constants<T: Value> = Vec<T>;

    fn masses<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.masses]
    }

    fn nodes<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.masses + 2]
    }

    fn contacts<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.contacts]
    }

    fn loads<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.loads]
    }

    fn unknowns<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.count()]
    }

    fn square<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.count() * self.count()]
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
    motion: joints::Motion<f64, Heap>,
}

/// Collects the events, and shows each stretch to a function.
struct Record<'w> {
    watch: &'w mut dyn FnMut(&Series, f64, &State),
    events: Vec<Transition>,
}

impl Observe<f64, Heap> for Record<'_> {
    fn stretch(&mut self, series: &Series, end: f64, state: &State) {
        (self.watch)(series, end, state);
    }

    fn event(&mut self, time: f64, before: &Vec<i8>, after: &Vec<i8>) {
        self.events.push(Transition {
            time,
            before: before.clone(),
            after: after.clone(),
        });
    }
}

impl Motion {
    /// Starts at time 0 with all masses at 0 and at rest, and elastic contacts without force.
    ///
    /// # Errors
    ///
    /// [`JointError`] for a chain that cannot be.
    pub fn from_rest(chain: &Chain) -> Result<Self, JointError> {
        Self::from(chain, &[], &[])
    }

    /// Starts at time 0 with given displacements and velocities, and elastic contacts without force.
    ///
    /// # Errors
    ///
    /// [`JointError`] for a chain that cannot be.
    pub fn from(chain: &Chain, x: &[f64], v: &[f64]) -> Result<Self, JointError> {
        let motion = joints::Motion::new(chain.model()?, x, v)?;
        Ok(Self { motion })
    }

    /// Returns the motion of the engine.
    pub(super) fn into_engine(self) -> joints::Motion<f64, Heap> {
        self.motion
    }

    /// Returns the time.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.motion.time()
    }

    /// Returns the state.
    #[must_use]
    pub fn state(&self) -> &State {
        self.motion.state()
    }

    /// Returns the chain.
    #[must_use]
    pub fn model(&self) -> &Model {
        self.motion.model()
    }

    /// Returns the relative velocity of a contact, and its relative displacement.
    #[must_use]
    pub fn relative(&self, contact: usize) -> (f64, f64) {
        self.motion.relative(contact)
    }

    /// Returns the present force of each contact.
    #[must_use]
    pub fn forces(&self) -> Vec<f64> {
        self.motion.forces()
    }

    /// Starts again at time 0 with a state of this chain.
    pub fn restart(&mut self, state: State) {
        self.motion.restart(state);
    }

    /// Changes the level of a contact from now on.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the contact cannot have this level, and those of a decision.
    pub fn set_level(&mut self, contact: usize, level: Wave) -> Result<(), JointError> {
        Ok(self.motion.set_level(contact, level)?)
    }

    /// Changes a load from now on, for instance to the line that leads to the next sample of a record.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the load is not finite, [`JointError::Ends`] if there is no such load.
    pub fn set_load(&mut self, load: usize, to: Wave) -> Result<(), JointError> {
        if load >= self.model().loads.len() {
            return Err(JointError::Ends("a load"));
        }
        Ok(self.motion.set_load(load, to)?)
    }

    /// Runs to an instant and returns the events on the way. `watch` sees each stretch, and the fraction of it that the
    /// motion has covered.
    ///
    /// # Errors
    ///
    /// Same errors as [`run_with`](Self::run_with).
    pub fn run(
        &mut self,
        until: f64,
        watch: &mut dyn FnMut(&Series, f64, &State),
    ) -> Result<Vec<Transition>, JointError> {
        let mut record = Record {
            watch,
            events: Vec::new(),
        };
        self.run_with(until, &mut record)?;
        Ok(record.events)
    }

    /// Runs to an instant and shows each stretch and each event to `watch`.
    ///
    /// # Errors
    ///
    /// [`JointError`] if the motion has too many events or stretches, or leaves the range of numbers.
    pub fn run_with(
        &mut self,
        until: f64,
        watch: &mut impl Observe<f64, Heap>,
    ) -> Result<(), JointError> {
        Ok(self.motion.run(until, BOUNDS, watch)?)
    }
}
