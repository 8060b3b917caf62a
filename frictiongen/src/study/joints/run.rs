//! Motion in time of a chain with several contacts, stored in `Vec`s.

use super::{Chain, Heap, JointError, Model, Series, State, Wave};
use frictiongen_kernel::joints::{self, Bounds, Observe, Short};

/// Largest number of events in one call of [`Motion::run`].
pub const MAX_EVENTS: usize = 100_000;
/// Largest number of stretches (time intervals of a power series) in one call of [`Motion::run`].
pub const MAX_STRETCHES: usize = 10_000_000;

/// Upper bounds on the work of one call of [`Motion::run`].
const BOUNDS: Bounds = Bounds {
    events: MAX_EVENTS,
    stretches: MAX_STRETCHES,
};

/// An event of a motion. Several contacts may have an event at the same instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Transition {
    /// Time of the event since the start of the motion.
    pub time: f64,
    /// Phase of each contact just before the event: −1 or 1 while it slides, 0 while it sticks, 2 if it has no friction
    /// force.
    pub before: Vec<i8>,
    /// Phase of each contact just after the event, with the same numbers as [`before`](Self::before).
    pub after: Vec<i8>,
}

/// Motion in time of a chain with several contacts.
#[derive(Clone, Debug)]
pub struct Motion {
    motion: joints::Motion<f64, Heap>,
}

/// Observer that collects the events of a motion, and passes each stretch (time interval of a power series) to a
/// function.
struct Record<'w> {
    watch: &'w mut dyn FnMut(&Series, f64, &State),
    events: Vec<Transition>,
}

impl Observe<f64, Heap> for Record<'_> {
    fn stretch(&mut self, series: &Series, end: f64, state: &State) {
        (self.watch)(series, end, state);
    }

    fn event(&mut self, time: f64, before: &Short<i8>, after: &Short<i8>) {
        self.events.push(Transition {
            time,
            before: before.to_vec(),
            after: after.to_vec(),
        });
    }
}

impl Motion {
    /// Starts a motion at time 0 from rest, with all displacements 0. Elastic contacts start without force.
    ///
    /// # Errors
    ///
    /// [`JointError`] for an invalid chain.
    pub fn from_rest(chain: &Chain) -> Result<Self, JointError> {
        Self::from(chain, &[], &[])
    }

    /// Starts a motion at time 0 with given displacements and velocities. Elastic contacts start without force.
    ///
    /// # Errors
    ///
    /// [`JointError`] for an invalid chain.
    pub fn from(chain: &Chain, x: &[f64], v: &[f64]) -> Result<Self, JointError> {
        let motion = joints::Motion::new(chain.model()?, x, v)?;
        Ok(Self { motion })
    }

    /// Makes searches for the steady state of this motion use the tables of similar motions. Their chains differ only in
    /// the amplitudes of the loads, in the friction forces and in μ.
    #[must_use]
    pub(crate) fn sharing(self, tables: &joints::SharedTables) -> Self {
        Self {
            motion: self.motion.sharing(tables),
        }
    }

    /// Returns this motion as the type of the crate `frictiongen_kernel`.
    pub(super) fn into_engine(self) -> joints::Motion<f64, Heap> {
        self.motion
    }

    /// Returns the time since the start of the motion.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.motion.time()
    }

    /// Returns the present state of masses and contacts.
    #[must_use]
    pub fn state(&self) -> &State {
        self.motion.state()
    }

    /// Returns the checked chain of this motion, with numbered nodes.
    #[must_use]
    pub fn model(&self) -> &Model {
        self.motion.model()
    }

    /// Returns the relative velocity and the relative displacement of a contact, in this order.
    #[must_use]
    pub fn relative(&self, contact: usize) -> (f64, f64) {
        self.motion.relative(contact)
    }

    /// Returns the present force of each contact.
    #[must_use]
    pub fn forces(&self) -> Vec<f64> {
        self.motion.forces().into_vec()
    }

    /// Restarts the motion at time 0 from a state of this chain.
    pub fn restart(&mut self, state: State) {
        self.motion.restart(state);
    }

    /// Changes the kinetic friction force of a contact from the present instant on.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the contact cannot have this friction force. Another [`JointError`] if the solver
    /// cannot decide which contacts stick.
    pub fn set_level(&mut self, contact: usize, level: Wave) -> Result<(), JointError> {
        Ok(self.motion.set_level(contact, level)?)
    }

    /// Changes a load from the present instant on, for instance to the straight line to the next sample of a record.
    ///
    /// # Errors
    ///
    /// [`JointError::Number`] if the load is not finite. [`JointError::Ends`] if the model has no load with this
    /// index.
    pub fn set_load(&mut self, load: usize, to: Wave) -> Result<(), JointError> {
        if load >= self.model().loads.len() {
            return Err(JointError::Ends("a load"));
        }
        Ok(self.motion.set_load(load, to)?)
    }

    /// Advances the motion to the given instant, and returns the events until this instant. The method calls `watch`
    /// for each stretch (time interval of a power series). Its arguments are the power series, the fraction of the
    /// stretch that the motion covers, and the state.
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

    /// Advances the motion to the given instant, and passes each stretch (time interval of a power series) and each
    /// event to `watch`.
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
