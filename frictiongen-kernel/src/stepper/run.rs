//! A stepper: what it is asked, and what it answers.

use super::account::Work;
use super::cost::Cost;
use super::drive::{Sample, Stretch, base_motion};
use super::part::Through;
use super::scene::StepScene;
use super::state::{FixedStore, Saved, Status, Store};
use super::table::{FixedTables, Tables};
use super::{Input, law};
use crate::errors::OutOfDomain;
use crate::number::scalar::Float;
use crate::simulation::Contact;
use core::marker::PhantomData;

/// The motion under an input that is known step by step.
///
/// `T` holds the tables and `V` the state: arrays or constants in emitted code, vectors at run time.  `D` is the number
/// of coefficients that an input has over a step.
#[derive(Clone, Debug)]
pub struct Stepper<'a, S, const D: usize, T, V> {
    scene: StepScene<'a, S>,
    tables: T,
    store: V,
    status: Status<S>,
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

/// What a step has led to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stepped<S> {
    /// What the contact does at its end.
    pub contact: Contact,
    /// The friction force in the contact at its end.
    pub force: S,
    /// How many stops, break-aways and reversals there were.
    pub events: u32,
    /// Whether there were more in a part of it than are followed.
    pub exceeded: bool,
}

/// A mass at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MassNow<S> {
    displacement: S,
    velocity: S,
}

impl<S: Float> MassNow<S> {
    /// Its displacement, in the scene's unit of length.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Its velocity, in that unit a second.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// The contact at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactNow<S> {
    motion: MassNow<S>,
    contact: Contact,
    force: S,
}

impl<S: Float> ContactNow<S> {
    /// The relative displacement.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.motion.displacement
    }

    /// The relative velocity; 0 while the contact sticks.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.motion.velocity
    }

    /// The friction force, in the scene's unit of force: what holds the contact while it sticks; positive against
    /// positive sliding.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Whether it sticks, or which way it slides.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.contact
    }

    /// Whether it sticks.
    #[must_use]
    pub fn is_sticking(&self) -> bool {
        self.contact == Contact::Stuck
    }
}

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
        }
        self.status.energy = self.energy();
        self.status.contact = self.direction();
        Ok(())
    }

    /// What the contact's velocity says of it.
    fn direction(&self) -> Contact {
        let velocity = self.contact_sum().velocity;
        if velocity.is_zero() {
            Contact::Stuck
        } else {
            Contact::along(velocity)
        }
    }

    /// The motion of the contact as the modes say.
    fn contact_sum(&self) -> MassNow<S> {
        let zero = S::constant(0.0);
        let modes = self.scene.dynamics.driven();
        let sum = self.sum(|mode| modes.get(mode).map_or(zero, |mode| mode.contact));
        let [place, velocity] = self.carrying();
        MassNow {
            displacement: sum.displacement - place,
            velocity: sum.velocity - velocity * self.scene.units.rate,
        }
    }

    /// The input at the start, from which the first step goes on if inputs are linear: none unless said so.
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
    /// ("forces").  The stepper is then what it was.
    pub fn advance(&mut self, sample: Sample<'_, S>) -> Result<Stepped<S>, OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        let pace = self.tables.view().pace;
        let steep = law::steepest(self.scene.law);
        if S::constant(0.0) < steep {
            // How much the law bends the motion within a part.
            let friction = sample.friction / self.scene.units.stiffness;
            let seconds = pace.step / S::constant(f64::from(pace.parts));
            let rate = self.scene.acceleration(&pace, friction * steep / seconds);
            if !(rate <= S::constant(16.0)) {
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
        let base = self.lay(sample, motion, stretch);
        let mut through = Through {
            scene: &self.scene,
            table: self.tables.view(),
            store: self.store.change(),
            status: &mut self.status,
            base,
            place: S::constant(0.0),
            events: 0,
            exceeded: false,
        };
        through.go();
        (through.events, through.exceeded)
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

    /// Where the held contact is, and how fast, in the time t√(k₁/m₁).
    fn lifted(&self) -> (S, S) {
        let [place, velocity] = self.carrying();
        (self.status.place + place, velocity)
    }

    /// The base's motion where it carries the contact, in the time t√(k₁/m₁).
    fn carrying(&self) -> [S; 2] {
        if self.scene.rubs_on_base() {
            let [place, velocity] = self.status.base;
            [place, velocity / self.scene.units.rate]
        } else {
            [S::constant(0.0); 2]
        }
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

    /// What a step costs at most.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let pace = self.tables.view().pace;
        self.scene.cost(D, pace.parts, pace.terms)
    }

    /// The length of a step, in seconds.
    #[must_use]
    pub fn dt(&self) -> S {
        self.tables.view().pace.step
    }

    /// How many steps were taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.status.steps
    }

    /// The time since the start, in seconds.
    #[must_use]
    pub fn time(&self) -> S {
        #[allow(
            clippy::cast_precision_loss,
            reason = "exact up to 2^53 steps, which a run of a month at 1 GHz does not take"
        )]
        let steps = self.status.steps as f64;
        S::constant(steps) * self.dt()
    }

    /// In how many steps more events happened than are followed.
    #[must_use]
    pub fn exceeded(&self) -> u64 {
        self.status.exceeded
    }

    /// μ, static over kinetic friction force.
    #[must_use]
    pub fn stiction(&self) -> S {
        self.status.stiction
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

    /// A mass now, by its place in the description; at rest if there is no such mass.
    #[must_use]
    pub fn mass(&self, index: usize) -> MassNow<S> {
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        if sticks && self.scene.dynamics.moves_as_contact(index) {
            return MassNow {
                displacement: self.status.place,
                velocity: S::constant(0.0),
            };
        }
        let shape = self.scene.dynamics.shape(index);
        self.sum(|mode| shape.get(mode).copied().unwrap_or(S::constant(0.0)))
    }

    /// A weighted sum of the modes' displacements, and of their velocities.
    fn sum(&self, weight: impl Fn(usize) -> S) -> MassNow<S> {
        let zero = S::constant(0.0);
        let (mut displacement, mut velocity) = (zero, zero);
        for index in 0..self.scene.dynamics.modes.len() {
            let [y, rate] = self.mode(index);
            displacement = displacement + weight(index) * y;
            velocity = velocity + weight(index) * rate;
        }
        MassNow {
            displacement,
            velocity: velocity * self.scene.units.rate,
        }
    }

    /// A mode's displacement, and its velocity in the time t√(k₁/m₁).
    fn mode(&self, index: usize) -> [S; 2] {
        let zero = S::constant(0.0);
        let dynamics = &self.scene.dynamics;
        let store = self.store.read();
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        let Some(mode) = dynamics.modes.get(index) else {
            return [zero; 2];
        };
        if sticks && index < dynamics.in_contact() {
            let receptance = self.tables.view().pace.receptance;
            let held = store.held.iter().copied();
            let [y, u] = dynamics.released(receptance, held, self.lifted(), index);
            return [y, u * mode.resonance];
        }
        let [y, u] = store.modes.get(index).copied().unwrap_or([zero; 2]);
        [y, u * mode.resonance]
    }

    /// The contact now.
    #[must_use]
    pub fn contact(&self) -> ContactNow<S> {
        let contact = self.status.contact;
        let motion = if contact == Contact::Stuck && !self.status.unknown {
            MassNow {
                displacement: self.status.place,
                velocity: S::constant(0.0),
            }
        } else {
            self.contact_sum()
        };
        ContactNow {
            motion,
            contact,
            force: self.force(),
        }
    }

    /// The friction force now.
    fn force(&self) -> S {
        let zero = S::constant(0.0);
        let status = &self.status;
        let sign: S = status.contact.sign();
        let force = if status.unknown {
            zero
        } else if status.contact != Contact::Stuck {
            let line = law::line(self.scene.law, status.line);
            let slides = !line.slope.is_zero();
            let speed = if slides {
                self.contact_sum().velocity.abs()
            } else {
                zero
            };
            sign * status.friction * (line.level + line.slope * speed)
        } else {
            status.holding
        };
        force * self.scene.units.stiffness
    }

    /// The work done since the start.
    #[must_use]
    pub fn work(&self) -> Work<S> {
        let stiffness = self.scene.units.stiffness;
        let stored = self.energy() - self.status.energy;
        let pulled = self.pull() - self.status.pull;
        let stored = stored + pulled;
        let load = self.status.load.value + pulled;
        let friction = self.status.dissipated.value;
        Work {
            load: load * stiffness,
            friction: friction * stiffness,
            damping: (load - friction - stored) * stiffness,
            stored: stored * stiffness,
        }
    }

    /// The energy of the chain, over k₁: in motion, in its springs, and in those that the base pulls at.
    fn energy(&self) -> S {
        let half = S::constant(0.5);
        let modes = self.scene.dynamics.modes.iter().enumerate();
        let sum = modes.fold(S::constant(0.0), |sum, (index, mode)| {
            let [y, rate] = self.mode(index);
            sum + rate * rate + mode.resonance * mode.resonance * y * y
        });
        sum * half
    }

    /// What the springs to the moving base hold because it is displaced, over k₁.
    fn pull(&self) -> S {
        let zero = S::constant(0.0);
        if !self.scene.on_base {
            return zero;
        }
        let modes = self.scene.dynamics.modes;
        let pulled = self.sum(|mode| modes.get(mode).map_or(zero, |mode| mode.load));
        let [place, _] = self.status.base;
        let half = S::constant(0.5) * self.scene.units.support;
        place * (half * place - pulled.displacement)
    }

    /// Where it stands: everything that a run goes on from.
    #[must_use]
    pub fn save(&self) -> Saved<S, V>
    where
        V: Clone,
    {
        Saved {
            status: self.status,
            store: self.store.clone(),
        }
    }

    /// Goes back to where it stood: the same steps lead to the same bits.
    ///
    /// # Errors
    /// [`OutOfDomain`] ("saved") for the state of a stepper of another scene, as far as its size tells.
    pub fn restore(&mut self, saved: &Saved<S, V>) -> Result<(), OutOfDomain>
    where
        V: Clone,
    {
        let size = |store: &V| {
            let store = store.read();
            (store.modes.len(), store.held.len(), store.last.len())
        };
        if size(&self.store) != size(&saved.store) {
            return Err(OutOfDomain { argument: "saved" });
        }
        self.status = saved.status;
        self.store = saved.store.clone();
        Ok(())
    }
}
