//! Advances a stepper from sample to sample.

use super::Input;
use super::drive::{Sample, SubInterval, base_motion, check_base, derived};
use super::interval::StepInterval;
use super::law::StepContact;
use super::scene::StepScene;
use super::state::{Status, Store};
use super::table::StepTables;
use super::types::{Stepped, Stepper};
use crate::errors::{Given, OutOfDomain};
use crate::motion::{Contact, steepest};
use crate::number::scalar::Float;
use core::marker::PhantomData;

/// Largest relative change of the contact's velocity that a friction law over the speed may cause in a sub-interval.
/// With a steeper law a power series would converge in only a small fraction of the sub-interval.
const STEEPEST: f64 = 16.0;

impl<'a, S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'a, S, D, T, V, K>
{
    /// Creates a stepper without load, at rest or in a given state. The state consists of the displacements and
    /// velocities of the masses.
    ///
    /// `store` must be the storage of a stepper at rest.
    ///
    /// # Errors
    /// [`OutOfDomain`] if the given state does not have one finite displacement and one finite velocity for each mass.
    pub fn new(
        scene: StepScene<'a, S, K>,
        tables: T,
        store: V,
        state: Option<(&[S], &[S])>,
    ) -> Result<Self, OutOfDomain> {
        let stiction = scene.dynamics.chain().stiction;
        let mut stepper = Self::of(scene, tables, store, (S::constant(0.0), stiction));
        if let Some((displacements, velocities)) = state {
            stepper.set_state(displacements, velocities)?;
        }
        Ok(stepper)
    }

    /// Creates a stepper at rest without load, in a constant expression. `store` must be the storage of a stepper at
    /// rest. `zero` is the number 0, and `stiction` is μ, the ratio of static to kinetic friction.
    pub(super) const fn of(
        scene: StepScene<'a, S, K>,
        tables: T,
        store: V,
        (zero, stiction): (S, S),
    ) -> Self {
        Self {
            scene,
            tables,
            store,
            status: Status::new(zero, stiction),
            inputs: PhantomData,
        }
    }

    /// Sets the displacements and velocities of the masses in a new stepper.
    fn set_state(&mut self, displacements: &[S], velocities: &[S]) -> Result<(), OutOfDomain> {
        let masses = self.scene.dynamics.modes.len();
        let sound = |values: &[S]| {
            let (_, most) = S::inverse_ratio_range();
            values.len() == masses && values.iter().all(|value| value.abs() <= most)
        };
        if !(sound(displacements) && sound(velocities)) {
            return Err(OutOfDomain::State);
        }
        let dynamics = &self.scene.dynamics;
        let rate = self.scene.units.rate;
        let store = self.store.change();
        self.status.given = S::constant(0.0);
        let weights = dynamics.weights.chunks(masses.max(1));
        let modes = store.modes.iter_mut().zip(dynamics.modes);
        for ((state, mode), weights) in modes.zip(weights) {
            let product = |values: &[S]| {
                let terms = weights.iter().zip(values);
                terms.fold(S::constant(0.0), |sum, (weight, value)| {
                    sum + *weight * *value
                })
            };
            *state = [
                product(displacements),
                product(velocities) / (rate * mode.resonance),
            ];
            let terms = weights.iter().zip(velocities);
            let size = terms.fold(S::constant(0.0), |sum, (weight, value)| {
                sum + (*weight * *value).abs()
            });
            self.status.given = self.status.given + mode.contact.abs() * size / rate;
        }
        self.status.energy = self.energy();
        self.status.contact = self.direction();
        Ok(())
    }

    /// Sets the input at the start of the first step. Without this call the input at this instant is 0. With linear
    /// input, the first step starts from `sample`. After the call, [`contact`](Self::contact) returns the contact
    /// force under `sample`. For a moving base, `contact` assumes a constant velocity of the base.
    ///
    /// # Errors
    /// The errors of [`advance`](Self::advance), and [`OutOfDomain::Begun`] after the first step.
    pub fn begin(&mut self, sample: Sample<'_, S>) -> Result<(), OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        if self.status.steps != 0 {
            return Err(OutOfDomain::Begun);
        }
        self.keep_sample(&sample);
        self.status.pull = self.pull();
        self.status.unknown = true;
        self.status.contact = self.direction();
        self.status.contact_force = S::constant(0.0);
        if !self.status.level.is_zero() {
            let [place, velocity] = sample.base;
            let zero = S::constant(0.0);
            let motion = [place, velocity * self.dt(), zero, zero];
            let parts = self.tables.view().pace.parts;
            self.interval(&sample, motion, SubInterval::nth(0, parts))
                .begin();
        }
        Ok(())
    }

    pub(super) fn keep_sample(&mut self, sample: &Sample<'_, S>) {
        let store = self.store.change();
        let moving = store.last.len().saturating_sub(sample.forces.len());
        let last = store.last.iter_mut().skip(moving);
        for (last, force) in last.zip(sample.forces) {
            *last = *force / self.scene.units.stiffness;
        }
        if self.scene.on_base {
            self.status.base = sample.base;
        }
        self.status.level = sample.friction / self.scene.units.stiffness;
    }

    /// Advances the stepper by one step. With linear input, the input reaches this sample at the end of the step. With
    /// zero-order hold, the input has this sample during the whole step.
    ///
    /// # Errors
    /// [`OutOfDomain`] in the following cases. The stepper then keeps its state.
    ///
    /// - [`Force`](OutOfDomain::Force), [`BaseMotion`](OutOfDomain::BaseMotion) and [`Friction`](OutOfDomain::Friction)
    ///   for NaN, infinite numbers, numbers so large that their squares overflow, and a negative friction force.
    /// - [`StepSteepness`](OutOfDomain::StepSteepness) for a friction force that is too large for a friction law over
    ///   the speed. The law would change the contact's velocity by more than 16 times that velocity in a sub-interval.
    /// - [`Forces`](OutOfDomain::Forces) for a wrong number of forces.
    /// - [`Work`](OutOfDomain::Work) once the work exceeds the square of the largest permitted input, because one more
    ///   step could overflow.
    pub fn advance(&mut self, sample: Sample<'_, S>) -> Result<Stepped<S>, OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        self.check_work()?;
        let pace = self.tables.view().pace;
        let steep = steepest(self.scene.law);
        if S::constant(0.0) < steep {
            // `rate` is the change of the contact's velocity that the law causes in a sub-interval, divided by this
            // velocity.
            let friction = sample.friction / self.scene.units.stiffness;
            let seconds = pace.step / S::constant(f64::from(pace.parts));
            let rate = self.scene.acceleration(&pace, friction * steep / seconds);
            if !(rate <= S::constant(STEEPEST)) {
                return Err(OutOfDomain::StepSteepness);
            }
        }
        #[cfg(feature = "event-times")]
        {
            self.status.last_event = None;
        }
        let hold = self.scene.input == Input::Hold;
        let from = if hold { sample.base } else { self.status.base };
        if hold {
            self.jump_base(sample.base);
        }
        self.status.level = sample.friction / self.scene.units.stiffness;
        let step = pace.step;
        let per_step = |[place, velocity]: [S; 2]| [place, velocity * step];
        let motion = base_motion(self.scene.input, per_step(from), per_step(sample.base));
        let (events, exceeded) =
            self.advance_interval(&sample, motion, SubInterval::nth(0, pace.parts));
        let mut stepped = Stepped {
            contact: Contact::Stuck,
            force: S::constant(0.0),
            events,
            exceeded,
        };
        if 1 < pace.parts {
            self.advance_further(&sample, motion, &mut stepped);
        }
        self.keep_sample(&sample);
        if hold && self.scene.on_base {
            let [place, velocity] = sample.base;
            self.status.base = [place + velocity * step, velocity];
        }
        if self.status.level.is_zero() {
            self.status.contact = self.direction();
        }
        self.status.given = S::constant(0.0);
        self.status.steps = self.status.steps.wrapping_add(1);
        self.status.exceeded += u64::from(stepped.exceeded);
        stepped.contact = self.status.contact;
        stepped.force = self.force();
        Ok(stepped)
    }

    /// Advances the stepper through the second and all later sub-intervals of a step.
    // The compiler must not inline `advance_further` and `advance_interval`. The inlined code would prepare addresses
    // for further sub-intervals in every step, although most steps have only one sub-interval.
    #[inline(never)]
    fn advance_further(
        &mut self,
        sample: &Sample<'_, S>,
        motion: [S; 4],
        stepped: &mut Stepped<S>,
    ) {
        let parts = self.tables.view().pace.parts;
        for part in 1..parts {
            self.status.spent = u8::try_from(stepped.events).unwrap_or(u8::MAX);
            let stretch = SubInterval::nth(part, parts);
            let (events, exceeded) = self.advance_interval(sample, motion, stretch);
            stepped.events += events;
            stepped.exceeded |= exceeded;
        }
        self.status.spent = 0;
    }

    /// Advances the stepper through one sub-interval of a step. Returns the number of events in it, and a flag. The
    /// flag is true if the stepper has reached the bound on events or on pieces of motion and followed no further
    /// events.
    #[inline(never)]
    fn advance_interval(
        &mut self,
        sample: &Sample<'_, S>,
        motion: [S; 4],
        stretch: SubInterval<S>,
    ) -> (u32, bool) {
        let mut interval = self.interval(sample, motion, stretch);
        interval.advance();
        (interval.events, interval.exceeded)
    }

    /// Creates the data with which the stepper advances through a sub-interval. Writes the inputs as polynomials over
    /// this sub-interval.
    #[inline]
    fn interval(
        &mut self,
        sample: &Sample<'_, S>,
        motion: [S; 4],
        stretch: SubInterval<S>,
    ) -> StepInterval<'_, 'a, S, D, K> {
        let base = self.write_inputs(sample, motion, stretch);
        StepInterval {
            scene: &self.scene,
            table: self.tables.view(),
            store: self.store.change(),
            status: &mut self.status,
            base,
            progress: S::constant(0.0),
            events: 0,
            exceeded: false,
            #[cfg(feature = "event-times")]
            stretch,
        }
    }

    /// Changes the velocity of the base at the present instant. With linear input, the next step starts at this
    /// velocity. The displacement of the base and the motion of the masses do not jump. A base that moves in straight
    /// lines between samples needs this call before each step. With zero-order hold the call has no effect, because
    /// each sample sets the velocity.
    ///
    /// # Errors
    /// [`OutOfDomain::BaseMotion`] for NaN, infinity and a velocity whose square overflows, and
    /// [`OutOfDomain::BaseAtRest`] if the scene's base does not move. The stepper then keeps its state.
    pub fn set_base_velocity(&mut self, velocity: S) -> Result<(), OutOfDomain> {
        if !self.scene.on_base {
            return Err(OutOfDomain::BaseAtRest);
        }
        let [place, _] = self.status.base;
        check_base(&self.scene, [place, velocity])?;
        self.jump_base([place, velocity]);
        self.status.base = [place, velocity];
        Ok(())
    }

    /// Applies the jump of the base at the start of a step. The mass that rubs on the base does not jump with the base.
    /// If the velocity of the base jumps, the next sub-interval determines the state of the contact anew.
    fn jump_base(&mut self, [place, velocity]: [S; 2]) {
        if !self.scene.rubs_on_base() || self.status.unknown {
            return;
        }
        let [old_place, old_velocity] = self.status.base;
        if velocity == old_velocity {
            if self.status.contact == Contact::Stuck {
                self.status.stuck_at = self.status.stuck_at + (old_place - place);
            }
            return;
        }
        if self.status.contact == Contact::Stuck {
            self.release();
        }
        self.status.unknown = true;
    }

    /// Computes the state of the chain's modes from the modes of the chain with its contact stuck. The contact must
    /// stick before the call.
    fn release(&mut self) {
        let lifted = self.lifted();
        let receptance = self.tables.view().pace.receptance;
        self.store.change().release(&self.scene, receptance, lifted);
    }

    /// Writes the inputs as polynomials over the sub-interval `stretch`. Returns the displacement of the base as a
    /// polynomial over this sub-interval. `motion` is this displacement as a polynomial over the whole step.
    pub(super) fn write_inputs(
        &mut self,
        sample: &Sample<'_, S>,
        motion: [S; 4],
        stretch: SubInterval<S>,
    ) -> [S; 4] {
        let on_base = self.scene.on_base;
        let hold = self.scene.input == Input::Hold;
        let stiffness = self.scene.units.stiffness;
        let base = if on_base {
            stretch.cubic(motion)
        } else {
            motion
        };
        let store = self.store.change();
        let mut channels = store.drive.iter_mut().zip(store.last);
        if on_base && let Some((drive, _)) = channels.next() {
            for (term, from) in drive.iter_mut().zip(base) {
                *term = from;
            }
        }
        // If damping acts relative to the base, the velocity of the base is a separate input.
        if sample.forces.len() < channels.len()
            && let Some((drive, _)) = channels.next()
        {
            let inverse = S::constant(1.0) / self.tables.view().pace.span;
            for (term, rate) in drive.iter_mut().zip(derived(base)) {
                *term = rate * inverse;
            }
        }
        for ((drive, last), force) in channels.zip(sample.forces) {
            let force = *force / stiffness;
            *drive = stretch.line(if hold { force } else { *last }, force);
        }
        base
    }

    /// Sets the event budget from the next step on. The budget is the number of events that the stepper follows in a
    /// step. A budget of 0 means that there is no budget.
    ///
    /// A step within the budget has the same result to the last bit as without a budget. The exception is a step in
    /// which a search needs more than [`Cost::SEARCH`](super::Cost::SEARCH) evaluations. At the first event beyond the
    /// budget, the stepper ends the step by a rule without a search, and reports [`Stepped::exceeded`]. By this rule,
    /// a contact at rest stays stuck if its force does not exceed μF. In every other case the friction force is
    /// constant for the rest of a sub-interval. This force is at most the kinetic force, and moves the contact as
    /// little as possible. The rule therefore creates no energy. [`cost`](Self::cost) returns the largest cost of a
    /// step with the budget.
    ///
    /// [`save`](Self::save) and [`write_image`](Self::write_image) store the budget with the state.
    pub fn set_event_budget(&mut self, events: u8) {
        self.status.budget = events;
    }

    /// Sets μ, the ratio of the static to the kinetic friction force, from the next step on.
    ///
    /// # Errors
    /// [`OutOfDomain::Stiction`] for NaN, infinity, numbers less than 1, and numbers outside the range in which the
    /// number type does not overflow.
    pub fn set_stiction(&mut self, mu: S) -> Result<(), OutOfDomain> {
        let (_, most) = S::inverse_ratio_range();
        if !(S::constant(1.0) <= mu && mu <= most) {
            return Err(OutOfDomain::Stiction(Given::of(mu)));
        }
        self.status.stiction = mu;
        Ok(())
    }
}
