//! Motion of a chain with several contacts under forces that are known sample by sample. Each contact has its own
//! friction force.

use super::base::Curve;
use super::model::Model;
use super::now::{ContactState, MassState};
use super::poly::angle_of;
use super::run::{Bounds, Motion, Observe};
use super::series::Series;
use super::size::{Size, at};
use super::state::State;
use super::wave::Wave;
use crate::Float;
use crate::errors::{Given, Halt, OutOfDomain};

/// Largest number of events that the stepper follows in one step.
pub const MAX_STEP_EVENTS: usize = 64;
/// Largest product, in rad, of a stepper's time step and an upper bound on the fastest angular frequency of the chain.
/// For the time interval of one power series, this product is at most 1.5 rad (1 rad in `f32`).
pub const MAX_STEP: f64 = 1024.0;

/// Bounds on the work in one step. Every event ends a stretch (time interval of one power series), even if no contact
/// changes its phase. A step may therefore have more stretches than its length alone requires.
const BOUNDS: Bounds = Bounds {
    events: MAX_STEP_EVENTS,
    stretches: MAX_STEP as usize + 4 * MAX_STEP_EVENTS,
};

/// Advances a chain with several contacts by a fixed time step.
#[derive(Clone, Debug)]
pub struct Stepper<S: Float, Z: Size> {
    motion: Motion<S, Z>,
    dt: S,
    /// True if each force is constant during a step. If false, each force changes linearly from the previous sample.
    holds: bool,
    /// Force of each load at the end of the last step.
    forces: Z::Loads<S>,
    /// Displacement and velocity of the base at the end of the last step.
    base: [S; 2],
}

/// Observer that counts the events of a step, and passes the motion to another observer.
struct Counted<'w, W> {
    events: u32,
    watch: &'w mut W,
}

impl<S: Float, Z: Size, W: Observe<S, Z>> Observe<S, Z> for Counted<'_, W> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.watch.stretch(series, end, state);
    }

    fn event(&mut self, time: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.events += 1;
        self.watch.event(time, before, after);
    }
}

impl<S: Float, Z: Size> Stepper<S, Z> {
    /// Starts a stepper from rest, with the time step `dt`. The friction force of each contact is 0 until an input sets
    /// it. If `holds` is true, each force is constant during a step. If `holds` is false, each force changes linearly
    /// from the previous sample.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::Step`] if the step is not positive and finite, or if its product with an upper bound on the
    /// fastest angular frequency exceeds [`MAX_STEP`].
    pub fn new(model: Model<S, Z>, dt: S, holds: bool) -> Result<Self, OutOfDomain> {
        Self::from_state(model, (dt, holds), &[], &[])
    }

    /// Starts a stepper as [`new`](Self::new) does, from the displacements `x` and the velocities `v` of the masses.
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new).
    pub fn from_state(
        mut model: Model<S, Z>,
        (dt, holds): (S, bool),
        x: &[S],
        v: &[S],
    ) -> Result<Self, OutOfDomain> {
        model.base = Curve::zero();
        for contact in model.contacts.as_mut() {
            contact.level = Wave::zero();
        }
        for (_, load) in model.loads.as_mut() {
            *load = Wave::zero();
        }
        model.set_stretch();
        let longest = S::constant(MAX_STEP / angle_of::<S>()) * model.stretch;
        if !(dt > S::constant(0.0) && dt.is_finite() && dt <= longest) {
            return Err(OutOfDomain::Step(Given::of(dt)));
        }
        let forces = model.size.loads(S::constant(0.0));
        Ok(Self {
            motion: Motion::new(model, x, v).map_err(OutOfDomain::Motion)?,
            dt,
            holds,
            forces,
            base: [S::constant(0.0); 2],
        })
    }

    /// Sets the base motion, the forces and the friction forces at the start of the first step. Without this call they
    /// are all 0. Forces that change linearly in the first step start at the values in `forces`. The parameters are
    /// those of [`advance`](Self::advance).
    ///
    /// # Errors
    ///
    /// The errors of [`advance`](Self::advance). The stepper is then unchanged. The caller must not call this method
    /// after the first step.
    pub fn begin(
        &mut self,
        base: [S; 2],
        forces: &[S],
        frictions: &[S],
    ) -> Result<(), OutOfDomain> {
        check(base, forces, frictions)?;
        let mut motion = self.motion.clone();
        let begun = start(&mut motion, base, (forces, frictions));
        begun.map_err(OutOfDomain::Motion)?;
        self.keep(motion, base, forces);
        Ok(())
    }

    /// Advances the motion by one step, and returns the number of events. `base` contains the displacement and the
    /// velocity of the base, and `forces` the force of each load. `frictions` contains the kinetic friction force of
    /// each contact during the step.
    ///
    /// The argument `holds` of [`new`](Self::new) decides to which instant the samples `base` and `forces` belong. If
    /// `holds` is false, the samples belong to the end of the step. The base then moves along a cubic polynomial from
    /// the last sample, and each force changes linearly. If `holds` is true, the samples belong to the start of the
    /// step. The base then keeps the velocity in `base`, and each force is constant.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if a base motion or a force is not finite, or if a friction force is negative or not finite.
    /// [`OutOfDomain::Motion`] with its cause, if the motion exceeds a bound. The stepper is then unchanged.
    pub fn advance(
        &mut self,
        base: [S; 2],
        forces: &[S],
        frictions: &[S],
    ) -> Result<u32, OutOfDomain> {
        self.advance_with(base, (forces, frictions), &mut ())
    }

    /// Advances the motion by one step, as [`advance`](Self::advance) does, and passes each stretch and each event to
    /// `watch`. A stretch is the time interval of one power series. The two slices are `forces` and `frictions`.
    ///
    /// # Errors
    ///
    /// The errors of [`advance`](Self::advance). After an error `watch` may have received the first stretches of the
    /// step.
    pub fn advance_with(
        &mut self,
        base: [S; 2],
        (forces, frictions): (&[S], &[S]),
        watch: &mut impl Observe<S, Z>,
    ) -> Result<u32, OutOfDomain> {
        check(base, forces, frictions)?;
        let mut motion = self.motion.clone();
        let mut count = Counted { events: 0, watch };
        let followed = self.follow(&mut motion, base, (forces, frictions), &mut count);
        followed.map_err(OutOfDomain::Motion)?;
        self.keep(motion, base, forces);
        Ok(count.events)
    }

    /// Changes the velocity of the base at the present instant. If `holds` is false, the next step starts at this
    /// velocity. The displacement of the base and the motion of the masses do not jump.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if the velocity is not finite, or [`OutOfDomain::Motion`] if the solver cannot decide which
    /// contacts stick. The stepper is then unchanged.
    pub fn set_base_velocity(&mut self, velocity: S) -> Result<(), OutOfDomain> {
        let [place, before] = self.base;
        let base = [place, velocity];
        check(base, &[], &[])?;
        if velocity != before {
            let mut motion = self.motion.clone();
            motion.rewind();
            let jolted = motion.jolt_base(Curve::straight(base));
            jolted.map_err(OutOfDomain::Motion)?;
            (self.motion, self.base) = (motion, base);
        }
        Ok(())
    }

    /// Stores the motion and the input at the end of a step.
    fn keep(&mut self, motion: Motion<S, Z>, base: [S; 2], forces: &[S]) {
        self.motion = motion;
        self.base = base;
        for (load, force) in self.forces.as_mut().iter_mut().zip(forces) {
            *load = *force;
        }
    }

    /// Advances `motion`, a copy of the stepper's motion, by one step. If an error occurs, the stepper itself is
    /// therefore unchanged.
    fn follow(
        &self,
        motion: &mut Motion<S, Z>,
        base: [S; 2],
        (forces, frictions): (&[S], &[S]),
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        let zero = S::constant(0.0);
        motion.rewind();
        let rests = |base: &[S; 2]| base.iter().all(|number| number.is_zero());
        let moves = !rests(&base) || !rests(&self.base);
        if moves && self.holds {
            motion.jolt_base(Curve::straight(base))?;
        } else if moves {
            motion.lead_base(Curve::through(self.base, base, self.dt));
        }
        for (load, after) in forces.iter().enumerate() {
            let before = at(self.forces.as_ref(), load);
            if self.holds {
                motion.set_load(load, Wave::constant(*after))?;
            } else {
                motion.lead_load(load, Wave::line((zero, before), (self.dt, *after)));
            }
        }
        set_levels(motion, frictions)?;
        motion.run(self.dt, BOUNDS, watch)
    }

    /// Returns the motion of the chain at the end of the last step.
    pub fn motion(&self) -> &Motion<S, Z> {
        &self.motion
    }

    /// Returns the displacement and the velocity of a mass at the end of the last step.
    pub fn mass(&self, mass: usize) -> MassState<S> {
        self.motion.mass(mass)
    }

    /// Returns the motion and the force of a contact at the end of the last step.
    pub fn contact(&self, contact: usize) -> ContactState<S> {
        self.motion.contact(contact)
    }

    /// Returns the time step of the stepper.
    pub fn dt(&self) -> S {
        self.dt
    }
}

/// Returns an error if a base motion or a force is not finite, or if a friction force is negative or not finite.
fn check<S: Float>(base: [S; 2], forces: &[S], frictions: &[S]) -> Result<(), OutOfDomain> {
    if let Some(number) = base.iter().find(|number| !number.is_finite()) {
        return Err(OutOfDomain::BaseMotion(Given::of(*number)));
    }
    if let Some(force) = forces.iter().find(|force| !force.is_finite()) {
        return Err(OutOfDomain::Force(Given::of(*force)));
    }
    let fits = |friction: &&S| **friction >= S::constant(0.0) && friction.is_finite();
    if let Some(friction) = frictions.iter().find(|friction| !fits(friction)) {
        return Err(OutOfDomain::Friction(Given::of(*friction)));
    }
    Ok(())
}

/// Sets the inputs of a motion at the start of its first step.
fn start<S: Float, Z: Size>(
    motion: &mut Motion<S, Z>,
    base: [S; 2],
    (forces, frictions): (&[S], &[S]),
) -> Result<(), Halt> {
    if base.iter().any(|number| !number.is_zero()) {
        motion.jolt_base(Curve::straight(base))?;
    }
    for (load, force) in forces.iter().enumerate() {
        motion.set_load(load, Wave::constant(*force))?;
    }
    set_levels(motion, frictions)
}

/// Changes the friction forces of the contacts to the values in `frictions`. Forces that are already equal to these
/// values do not change.
fn set_levels<S: Float, Z: Size>(motion: &mut Motion<S, Z>, frictions: &[S]) -> Result<(), Halt> {
    for (contact, friction) in frictions.iter().enumerate() {
        let level = motion.model().contact(contact).map(|c| c.level.constant);
        if level.is_some_and(|level| level != *friction) {
            motion.set_level(contact, Wave::constant(*friction))?;
        }
    }
    Ok(())
}
