//! A stepper on its way: from sample to sample.

use super::Input;
use super::drive::{Sample, Stretch, base_motion};
use super::now::Stepped;
use super::part::Through;
use super::scene::StepScene;
use super::state::{FixedStore, Status, Store};
use super::table::{FixedTables, Tables};
use crate::errors::OutOfDomain;
use crate::number::scalar::Float;
use crate::simulation::{Contact, law};
use core::marker::PhantomData;

/// A friction law may change the contact's velocity within a part by so many times that velocity at most: where it is
/// steeper, a power series reaches a small fraction of the part alone.
const STEEPEST: f64 = 16.0;

/// The motion under an input that is known step by step.
///
/// `T` holds the tables and `V` the state: arrays or constants in emitted code, vectors at run time.  `D` is the number
/// of coefficients that an input has over a step.
#[derive(Clone, Debug)]
pub struct Stepper<'a, S, const D: usize, T, V> {
    pub(super) scene: StepScene<'a, S>,
    pub(super) tables: T,
    pub(super) store: V,
    pub(super) status: Status<S>,
    inputs: PhantomData<[S; D]>,
}

/// A stepper in arrays: of an emitted solver.
pub type FixedStepper<
    S,
    const D: usize,
    const MODES: usize,
    const HELD: usize,
    const INPUTS: usize,
> = Stepper<
    'static,
    S,
    D,
    FixedTables<S, D, MODES, HELD, INPUTS>,
    FixedStore<S, D, MODES, HELD, INPUTS>,
>;

impl<'a, S: Float, const D: usize, T: Tables<S, D>, V: Store<S, D>> Stepper<'a, S, D, T, V> {
    /// At rest under no load, or in a state: displacements and velocities of the masses.
    ///
    /// `store` is at rest.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a state that is not one finite number for each mass.
    pub fn new(
        scene: StepScene<'a, S>,
        tables: T,
        store: V,
        state: Option<(&[S], &[S])>,
    ) -> Result<Self, OutOfDomain> {
        let stiction = scene.dynamics.chain.stiction;
        let mut stepper = Self {
            scene,
            tables,
            store,
            status: Status::new(stiction),
            inputs: PhantomData,
        };
        if let Some((displacements, velocities)) = state {
            stepper.place(displacements, velocities)?;
        }
        Ok(stepper)
    }

    /// Puts the masses somewhere.
    fn place(&mut self, displacements: &[S], velocities: &[S]) -> Result<(), OutOfDomain> {
        let masses = self.scene.dynamics.modes.len();
        let sound = |values: &[S]| {
            let (_, most) = S::inverse_ratio_range();
            values.len() == masses && values.iter().all(|value| value.abs() <= most)
        };
        if !(sound(displacements) && sound(velocities)) {
            return Err(OutOfDomain { argument: "state" });
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

    /// The input at the start, from which the first step goes on if inputs are linear: none unless said so.  The contact
    /// and its force answer at once, of a moving base as if its velocity stayed.
    ///
    /// # Errors
    /// [`OutOfDomain`] as of [`advance`](Self::advance); "steps" after the first step.
    pub fn begin(&mut self, sample: Sample<'_, S>) -> Result<(), OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        if self.status.steps != 0 {
            return Err(OutOfDomain { argument: "steps" });
        }
        self.keep(&sample);
        self.status.pull = self.pull();
        self.status.unknown = true;
        self.status.contact = self.direction();
        self.status.holding = S::constant(0.0);
        if !self.status.friction.is_zero() {
            let [place, velocity] = sample.base;
            let zero = S::constant(0.0);
            let motion = [place, velocity * self.dt(), zero, zero];
            let parts = self.tables.view().pace.parts;
            self.through(&sample, motion, Stretch::of(0, parts)).begin();
        }
        Ok(())
    }

    fn keep(&mut self, sample: &Sample<'_, S>) {
        let moving = usize::from(self.scene.on_base);
        let store = self.store.change();
        let last = store.last.iter_mut().skip(moving);
        for (last, force) in last.zip(sample.forces) {
            *last = *force / self.scene.units.stiffness;
        }
        if self.scene.on_base {
            self.status.base = sample.base;
        }
        self.status.friction = sample.friction / self.scene.units.stiffness;
    }

    /// Takes a step: to this input if inputs are linear, with it if they are held.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and infinite forces ("force"), motions of the base ("base") and friction forces, also
    /// negative ones ("friction"), for numbers so large that their squares overflow, and for another number of forces
    /// ("forces"); once the work exceeds what the squares of the largest inputs come to ("work").  The stepper is then what
    /// it was.
    pub fn advance(&mut self, sample: Sample<'_, S>) -> Result<Stepped<S>, OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        self.check_work()?;
        let pace = self.tables.view().pace;
        let steep = law::steepest(self.scene.law);
        if S::constant(0.0) < steep {
            // How much the law bends the motion within a part.
            let friction = sample.friction / self.scene.units.stiffness;
            let seconds = pace.step / S::constant(f64::from(pace.parts));
            let rate = self.scene.acceleration(&pace, friction * steep / seconds);
            if !(rate <= S::constant(STEEPEST)) {
                return Err(OutOfDomain {
                    argument: "friction",
                });
            }
        }
        let hold = self.scene.input == Input::Hold;
        let from = if hold { sample.base } else { self.status.base };
        if hold {
            self.jump(sample.base);
        }
        self.status.friction = sample.friction / self.scene.units.stiffness;
        let step = pace.step;
        let per_step = |[place, velocity]: [S; 2]| [place, velocity * step];
        let motion = base_motion(self.scene.input, per_step(from), per_step(sample.base));
        let mut stepped = Stepped {
            contact: Contact::Stuck,
            force: S::constant(0.0),
            events: 0,
            exceeded: false,
        };
        for part in 0..pace.parts {
            let (events, exceeded) = self.part(&sample, motion, Stretch::of(part, pace.parts));
            stepped.events += events;
            stepped.exceeded |= exceeded;
        }
        self.keep(&sample);
        if hold && self.scene.on_base {
            let [place, velocity] = sample.base;
            self.status.base = [place + velocity * step, velocity];
        }
        if self.status.friction.is_zero() {
            self.status.contact = self.direction();
        }
        self.status.given = S::constant(0.0);
        self.status.steps = self.status.steps.wrapping_add(1);
        self.status.exceeded += u64::from(stepped.exceeded);
        stepped.contact = self.status.contact;
        stepped.force = self.force();
        Ok(stepped)
    }

    /// Goes through one part of a step; how many events it had, and whether there were more than are followed.
    // In a loop the compiler prepares addresses for parts that mostly do not come: a seventh of a step.
    #[inline(never)]
    fn part(&mut self, sample: &Sample<'_, S>, motion: [S; 4], stretch: Stretch<S>) -> (u32, bool) {
        let mut through = self.through(sample, motion, stretch);
        through.go();
        (through.events, through.exceeded)
    }

    /// At the start of a part, with the inputs laid over it.
    #[inline]
    fn through(
        &mut self,
        sample: &Sample<'_, S>,
        motion: [S; 4],
        stretch: Stretch<S>,
    ) -> Through<'_, 'a, S, D> {
        let base = self.lay(sample, motion, stretch);
        Through {
            scene: &self.scene,
            table: self.tables.view(),
            store: self.store.change(),
            status: &mut self.status,
            base,
            place: S::constant(0.0),
            events: 0,
            exceeded: false,
        }
    }

    /// The base where a held input puts it: it leaves a contact behind that rubs on it.
    fn jump(&mut self, [place, velocity]: [S; 2]) {
        if !self.scene.rubs_on_base() || self.status.unknown {
            return;
        }
        let [old_place, old_velocity] = self.status.base;
        if velocity == old_velocity {
            if self.status.contact == Contact::Stuck {
                self.status.place = self.status.place + (old_place - place);
            }
            return;
        }
        if self.status.contact == Contact::Stuck {
            self.release();
        }
        self.status.unknown = true;
    }

    /// Writes the modes' state while the contact sticks.
    fn release(&mut self) {
        let lifted = self.lifted();
        let receptance = self.tables.view().pace.receptance;
        self.store.change().release(&self.scene, receptance, lifted);
    }

    /// The inputs over a part of the step; the base's motion for the contact.
    fn lay(&mut self, sample: &Sample<'_, S>, motion: [S; 4], stretch: Stretch<S>) -> [S; 4] {
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
        for ((drive, last), force) in channels.zip(sample.forces) {
            let force = *force / stiffness;
            *drive = stretch.line(if hold { force } else { *last }, force);
        }
        base
    }

    /// Another μ, from now on.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, infinity, and less than 1.
    pub fn set_stiction(&mut self, mu: S) -> Result<(), OutOfDomain> {
        let (_, most) = S::inverse_ratio_range();
        if !(S::constant(1.0) <= mu && mu <= most) {
            return Err(OutOfDomain {
                argument: "stiction",
            });
        }
        self.status.stiction = mu;
        Ok(())
    }
}
