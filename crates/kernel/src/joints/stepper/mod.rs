//! Computes the motion of a chain step by step, under an input that is known at samples. Each contact has its own
//! friction force. All steps have equal length.
//!
//! The stepper divides a step into equal sub-intervals, called `parts` in the code. In a sub-interval the fastest
//! oscillation of the chain advances by at most 1.5 rad (1 rad in `f32`). The inputs are polynomials over a
//! sub-interval. If no contact can change its phase, a product with a constant table gives the motion
//! (`leap`). In every other case the stepper follows the motion from event to event by power series, as a
//! simulation does. Beyond the bound on events it ends the sub-interval by a rule without a search (`coast`).

mod advance;
mod coast;
mod cost;
#[cfg(test)]
mod counted;
mod declared;
mod image;
mod leap;
mod shears;
mod table;
#[cfg(test)]
mod tests;
mod work;

use super::base::Curve;
use super::model::Model;
use super::now::{ContactState, MassState};
use super::poly::angle_of;
use super::run::Motion;
use super::size::Size;
use super::wave::Wave;
use crate::Float;
use crate::errors::{Given, OutOfDomain};
use crate::motion::Total;
use crate::stepper::Input;
use crate::stepper::now::elapsed;

pub use advance::{MAX_STEP_EVENTS, Span, Stepped};
pub use image::{Saved, image_bytes, image_step};
pub use table::{Layout, MAX_TABLE_CONTACTS, MAX_TABLE_ENTRIES, fill};

/// Largest product, in rad, of a stepper's time step and an upper bound on the fastest angular frequency of the chain.
pub const MAX_STEP: f64 = 1024.0;

/// Step of a stepper, and interpolation of its inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace<S> {
    /// Time step, in seconds.
    pub dt: S,
    /// Number of sub-intervals in a step.
    pub parts: u32,
    /// Length of a sub-interval, in seconds.
    pub part: S,
    /// Interpolation of the inputs between two samples.
    pub input: Input,
    /// True if the base can move.
    pub on_base: bool,
}

impl<S: Float> Pace<S> {
    /// Divides the step `dt` into sub-intervals for a chain whose power series need intervals of at most `stretch`.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::Step`] if the step is not positive and finite, or if its product with an upper bound on the
    /// fastest angular frequency exceeds [`MAX_STEP`].
    pub fn new((dt, stretch): (S, S), input: Input, on_base: bool) -> Result<Self, OutOfDomain> {
        let longest = S::constant(MAX_STEP / angle_of::<S>()) * stretch;
        if !(dt > S::constant(0.0) && dt.is_finite() && dt <= longest) {
            return Err(OutOfDomain::Step(Given::of(dt)));
        }
        let mut parts = 1_u32;
        while dt > whole::<S>(parts) * stretch {
            parts += 1;
        }
        Ok(Self {
            dt,
            parts,
            part: dt / whole(parts),
            input,
            on_base,
        })
    }

    /// Returns the start of the sub-interval with the index `part`, as the time since the start of the step. The end of
    /// the last sub-interval is the end of the step.
    fn start(&self, part: u32) -> S {
        if part == self.parts {
            self.dt
        } else {
            whole::<S>(part) * self.part
        }
    }
}

/// Converts an index to a scalar.
fn whole<S: Float>(index: u32) -> S {
    S::whole(usize::try_from(index).unwrap_or(usize::MAX))
}

/// Input of a stepper at one instant, in the units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<'i, S> {
    /// Displacement and velocity of the base.
    pub base: [S; 2],
    /// Force of each load.
    pub forces: &'i [S],
    /// Kinetic friction force of each contact, at least 0. A contact with the friction force 0 has no effect.
    pub frictions: &'i [S],
}

/// Advances a chain with several contacts by a fixed time step.
///
/// `T` contains the tables: an array or a reference to one in emitted code, or a vector at run time. An empty `T` means
/// that the stepper uses power series only.
#[derive(Clone, Debug)]
pub struct Stepper<S: Float, Z: Size, T> {
    motion: Motion<S, Z>,
    pace: Pace<S>,
    layout: Layout,
    tables: T,
    /// Coordinates at both ends of a sub-interval.
    ends: [Z::Row<S>; 2],
    status: Status<S, Z>,
}

/// State of a stepper beside its motion.
#[derive(Clone, Debug)]
struct Status<S: Float, Z: Size> {
    /// Displacement and velocity of the base at the end of the last step.
    base: [S; 2],
    /// Acceleration of the base at the end of the last step.
    lift: S,
    /// Force of each load at the end of the last step.
    forces: Z::Loads<S>,
    /// Kinetic friction force of each contact at the end of the last step.
    levels: Z::Contacts<S>,
    /// Place of the moving origin of the displacements. It is 0 unless no spring holds the chain.
    origin: Total<S>,
    steps: u64,
    exceeded: u64,
    /// Largest number of events in a step, or 0 without a budget.
    budget: u8,
    /// Instant of the last event in the last step.
    last_event: Option<S>,
    work: work::Sums<S>,
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Starts a stepper from rest. All forces and friction forces are 0 until an input sets them.
    ///
    /// # Errors
    ///
    /// Same errors as [`Pace::new`].
    pub fn new(
        model: Model<S, Z>,
        (dt, input, on_base): (S, Input, bool),
        tables: T,
    ) -> Result<Self, OutOfDomain>
    where
        T: AsMut<[S]>,
    {
        Self::from_state(model, (dt, input, on_base), tables, (&[], &[]))
    }

    /// Starts a stepper as [`new`](Self::new) does, from the displacements `x` and the velocities `v` of the masses.
    ///
    /// # Errors
    ///
    /// Same errors as [`Pace::new`], and [`OutOfDomain::State`] if a number of the state is not finite.
    pub fn from_state(
        mut model: Model<S, Z>,
        (dt, input, on_base): (S, Input, bool),
        mut tables: T,
        (x, v): (&[S], &[S]),
    ) -> Result<Self, OutOfDomain>
    where
        T: AsMut<[S]>,
    {
        model.unload();
        model.set_stretch();
        let pace = Pace::new((dt, model.stretch), input, on_base)?;
        if model.law.as_ref().is_empty() {
            let layout = Layout::of(&model, &pace);
            table::fill(&model, pace.part, &layout, tables.as_mut());
        }
        Self::known(model, pace, tables, (x, v))
    }

    /// Starts a stepper with known tables and a known pace, from the displacements `x` and the velocities `v` of the
    /// masses. The chain has no loads and no friction.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::State`] if a number of the state is not finite.
    pub fn known(
        model: Model<S, Z>,
        pace: Pace<S>,
        tables: T,
        (x, v): (&[S], &[S]),
    ) -> Result<Self, OutOfDomain> {
        let zero = S::constant(0.0);
        if !x.iter().chain(v).all(|number| number.is_finite()) {
            return Err(OutOfDomain::State);
        }
        let layout = Layout::of(&model, &pace);
        let row = model.size.row(layout.coordinates(), zero);
        let (forces, levels) = (model.size.loads(zero), model.size.contacts(zero));
        let status = Status::at_rest(forces, levels, zero);
        let motion = Motion::new(model, x, v).map_err(OutOfDomain::Motion)?;
        let mut stepper = Self {
            motion,
            pace,
            layout,
            tables,
            ends: [row.clone(), row],
            status,
        };
        stepper.restart_work();
        Ok(stepper)
    }

    /// Returns the motion of the chain at the end of the last step. Its displacements are relative to the moving origin
    /// of the stepper.
    pub fn motion(&self) -> &Motion<S, Z> {
        &self.motion
    }

    /// Returns the displacement and the velocity of a mass at the end of the last step.
    pub fn mass(&self, mass: usize) -> MassState<S> {
        let now = self.motion.mass(mass);
        MassState {
            displacement: self.far(now.displacement),
            ..now
        }
    }

    /// Returns the motion and the force of a contact at the end of the last step.
    pub fn contact(&self, contact: usize) -> ContactState<S> {
        let now = self.motion.contact(contact);
        let wall = self.motion.model().wall();
        let sides = self.motion.model().contact(contact);
        let displacement = match sides.map(|sides| (sides.plus < wall, sides.minus < wall)) {
            Some((true, false)) => self.far(now.displacement),
            Some((false, true)) => -self.far(-now.displacement),
            _ => now.displacement,
        };
        ContactState {
            displacement,
            ..now
        }
    }

    /// Returns the displacement of a place whose displacement relative to the moving origin is `near`.
    fn far(&self, near: S) -> S {
        let [high, low] = self.status.origin.parts();
        high + (low + near)
    }

    /// Returns the displacement and the velocity of the base at the end of the last step.
    pub fn base(&self) -> [S; 2] {
        self.status.base
    }

    /// Returns the time step of the stepper, in seconds.
    pub fn dt(&self) -> S {
        self.pace.dt
    }

    /// Returns the number of steps since the start.
    pub fn steps(&self) -> u64 {
        self.status.steps
    }

    /// Returns the time since the start, in seconds.
    pub fn time(&self) -> S {
        elapsed(self.status.steps, self.pace.dt)
    }

    /// Returns the number of steps in which the stepper has reached its bound on events.
    pub fn exceeded(&self) -> u64 {
        self.status.exceeded
    }

    /// Returns the instant of the last event in the last step, in seconds since the start of this step. Returns `None`
    /// if the step had no event.
    pub fn last_event(&self) -> Option<S> {
        self.status.last_event
    }

    /// Returns μ, the ratio of the static to the kinetic friction force of a contact.
    pub fn stiction(&self, contact: usize) -> Option<S> {
        let contact = self.motion.model().contact(contact);
        contact.map(|contact| contact.stiction)
    }

    /// Sets μ of a contact, the ratio of the static to the kinetic friction force, from the next step on.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::Stiction`] for NaN, infinity and numbers less than 1. The stepper is then unchanged.
    pub fn set_stiction(&mut self, contact: usize, mu: S) -> Result<(), OutOfDomain> {
        if !(mu >= S::constant(1.0) && mu.is_finite()) {
            return Err(OutOfDomain::Stiction(Given::of(mu)));
        }
        self.motion.set_stiction(contact, mu);
        Ok(())
    }

    /// Sets the largest number of events in a step that the stepper follows, from the next step on. 0 means
    /// [`MAX_STEP_EVENTS`] events in each sub-interval.
    ///
    /// Beyond the budget the stepper ends the sub-interval without a search for events, and reports
    /// [`Stepped::exceeded`]. The contacts then keep their phases. At the end of the sub-interval, a contact that has
    /// slid backwards sticks: its two sides take a common velocity that conserves their momentum.
    pub fn set_event_budget(&mut self, events: u8) {
        self.status.budget = events;
    }
}

impl<S: Float, Z: Size> Status<S, Z> {
    /// Returns the status of a stepper at rest, for forces and friction forces of 0.
    const fn at_rest(forces: Z::Loads<S>, levels: Z::Contacts<S>, zero: S) -> Self {
        Self {
            base: [zero; 2],
            lift: zero,
            forces,
            levels,
            origin: Total::of_parts([zero; 2]),
            steps: 0,
            exceeded: 0,
            budget: 0,
            last_event: None,
            work: work::Sums::zero(zero),
        }
    }
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Sets all loads, friction forces and the displacement of the base to 0.
    fn unload(&mut self) {
        self.base = Curve::zero();
        for contact in self.contacts.as_mut() {
            contact.level = Wave::zero();
        }
        let loads = self.loads.as_mut().iter_mut().map(|(_, load)| load);
        for load in loads.filter(|load| !load.is_constant_load()) {
            *load = Wave::zero();
        }
    }

    /// Returns the numbers of loads and of friction forces in an input of the stepper.
    pub(super) fn inputs(&self) -> (usize, usize) {
        let (mut loads, mut frictions) = (self.loads.as_ref().len(), self.contacts().len());
        if Z::HAS_PARTS {
            let constant = self.loads.as_ref().iter();
            loads -= constant.filter(|(_, load)| load.is_constant_load()).count();
            let contacts = self.contacts().iter();
            frictions -= contacts.filter(|own| own.stop.is_some()).count();
        }
        (loads, frictions)
    }

    /// Returns true if no spring connects the chain to the wall or to the base. Equal displacements of all masses then
    /// cause no force.
    pub(super) fn is_unheld(&self) -> bool {
        let mut springs = self.springs.as_ref().iter();
        springs.all(|(plus, minus, _)| plus.max(minus) < &self.wall())
    }
}
