//! Steppers of a run-time system, which advance its motion by time steps of a fixed length.

use super::error::{StudyError, UnknownMass};
use super::system::System;
use crate::{OutOfDomain, StepLoad, Stepping, Steps};
use frictiongen_kernel::motion::{AnyContact, Dynamics};
#[cfg(feature = "serde")]
use frictiongen_kernel::stepper::NOT_FINITE;
use frictiongen_kernel::stepper::{
    Channel, ContactNow, HeldLoad, HeldStep, MassNow, ModeStep, Pace, Sample, Saved, StepScene,
    StepTables, Stepped, Stepper, Store, StoreMut, StoreRef, View, Work, fill, image_step,
};
use frictiongen_kernel::{Float, Plain};
use frictiongen_model::stepping::StepperSettings as Settings;
use std::ops::{Deref, DerefMut};

/// Number of coefficients of the polynomial that describes the input over one step. The number is large enough for each
/// interpolation of the input.
const COEFFICIENTS: usize = 4;

/// Constants that advance each mode by one time step of fixed length: the modes of the chain with its contact sliding,
/// and those with its contact stuck.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct SystemStepTables<S> {
    pace: Pace<S>,
    modes: Vec<ModeStep<S, COEFFICIENTS>>,
    held: Vec<HeldStep<S, COEFFICIENTS>>,
    loads: Vec<S>,
    held_loads: Vec<HeldLoad<S>>,
    channels: Vec<Channel<S>>,
}

impl<S: Float> SystemStepTables<S> {
    fn new(scene: &StepScene<'_, S, AnyContact<S>>, step: S) -> Result<Self, OutOfDomain> {
        let (modes, held) = (scene.dynamics.modes.len(), scene.dynamics.held.len());
        let inputs = scene.channels();
        let mut tables = Self {
            pace: Pace::zero(),
            modes: vec![ModeStep::zero(); modes],
            held: vec![HeldStep::zero(); held],
            loads: vec![S::constant(0.0); modes * inputs],
            held_loads: vec![HeldLoad::zero(); held * inputs],
            channels: vec![Channel::zero(); inputs],
        };
        tables.pace = fill(
            scene,
            step,
            (&mut tables.modes, &mut tables.held),
            (
                &mut tables.loads,
                &mut tables.held_loads,
                &mut tables.channels,
            ),
        )?;
        Ok(tables)
    }
}

impl<S> StepTables<S, COEFFICIENTS> for SystemStepTables<S>
where
    S: Copy,
{
    fn view(&self) -> View<'_, S, COEFFICIENTS> {
        View {
            pace: self.pace,
            modes: &self.modes,
            held: &self.held,
            loads: &self.loads,
            held_loads: &self.held_loads,
            channels: &self.channels,
        }
    }
}

/// State of a stepper: displacement and velocity of each mode, with the contact sliding and with the contact stuck.
#[doc(hidden)]
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "StoreForm<S>",
        bound(deserialize = "S: Float + serde::Deserialize<'de>")
    )
)]
pub struct SystemStepStore<S> {
    modes: Vec<[S; 2]>,
    held: Vec<[S; 2]>,
    #[cfg_attr(feature = "serde", serde(skip_serializing))]
    scratch: Vec<[S; 2]>,
    #[cfg_attr(feature = "serde", serde(skip_serializing))]
    drive: Vec<[S; COEFFICIENTS]>,
    last: Vec<S>,
}

/// The vectors of a stepper's state in the form in which serde reads them.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct StoreForm<S> {
    modes: Vec<[S; 2]>,
    held: Vec<[S; 2]>,
    last: Vec<S>,
}

#[cfg(feature = "serde")]
impl<S: Float> TryFrom<StoreForm<S>> for SystemStepStore<S> {
    type Error = &'static str;

    fn try_from(form: StoreForm<S>) -> Result<Self, Self::Error> {
        let read = StoreRef {
            modes: &form.modes,
            held: &form.held,
            last: &form.last,
        };
        if !read.is_finite() {
            return Err(NOT_FINITE);
        }
        let zero = S::constant(0.0);
        Ok(Self {
            scratch: vec![[zero; 2]; form.modes.len()],
            drive: vec![[zero; COEFFICIENTS]; form.last.len()],
            modes: form.modes,
            held: form.held,
            last: form.last,
        })
    }
}

impl<S: Float> SystemStepStore<S> {
    /// Returns the state of a stepper at rest.
    fn new(scene: &StepScene<'_, S, AnyContact<S>>) -> Self {
        let (modes, held) = (scene.dynamics.modes.len(), scene.dynamics.held.len());
        let zero = S::constant(0.0);
        Self {
            modes: vec![[zero; 2]; modes],
            held: vec![[zero; 2]; held],
            scratch: vec![[zero; 2]; modes],
            drive: vec![[zero; COEFFICIENTS]; scene.channels()],
            last: vec![zero; scene.channels()],
        }
    }
}

impl<S> Store<S, COEFFICIENTS> for SystemStepStore<S> {
    fn change(&mut self) -> StoreMut<'_, S, COEFFICIENTS> {
        StoreMut {
            modes: &mut self.modes,
            held: &mut self.held,
            scratch: &mut self.scratch,
            drive: &mut self.drive,
            last: &mut self.last,
        }
    }

    fn read(&self) -> StoreRef<'_, S> {
        StoreRef {
            modes: &self.modes,
            held: &self.held,
            last: &self.last,
        }
    }
}

/// The kernel's stepper, with its constants and its state in vectors.
type KernelStepper<'a, S> =
    Stepper<'a, S, COEFFICIENTS, SystemStepTables<S>, SystemStepStore<S>, AnyContact<S>>;

/// The state of a system's stepper, as [`save`](Stepper::save) returns it.
pub type SystemStepSaved<S = f64> = Saved<S, SystemStepStore<S>>;

/// A stepper, which advances the motion of a system by time steps of equal length, under any input.
#[derive(Clone, Debug)]
pub struct SystemStepper<'a, S = f64> {
    pub(super) system: &'a System<S>,
    settings: &'a Settings<S>,
    stepper: KernelStepper<'a, S>,
    /// The forces of the present input, one for each mass. If a force excites the scene, the force on the excited mass
    /// comes first.
    forces: Vec<S>,
}

/// The input of a stepper at one instant, in the scene's units: loads and friction force.
///
/// ```
/// use frictiongen::study::SystemInput;
///
/// // 20 N on the excited mass and 3 N on the mass `roof`, with a friction force of 12 N.
/// let input = SystemInput::force(20.0).on("roof", 3.0).friction(12.0);
/// # let _ = input;
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use = "an input acts in a step of a stepper"]
pub struct SystemInput<'n, S = f64> {
    excitation: ExcitationLoad<S>,
    /// Velocity of the base at the start of the step. Without it, the step starts at the velocity of the last input.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none")
    )]
    start_velocity: Option<S>,
    #[cfg_attr(feature = "serde", serde(borrow))]
    more: Vec<(&'n str, S)>,
    friction: S,
}

/// The load that excites the scene: a force on a mass, or displacement and velocity of the base.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum ExcitationLoad<S> {
    Force(S),
    Base([S; 2]),
}

impl<'n, S: Float> SystemInput<'n, S> {
    /// Creates an input with a force on the excited mass.
    pub fn force(force: S) -> Self {
        Self::new(ExcitationLoad::Force(force))
    }

    /// Creates an input with a displacement and a velocity of the base.
    pub fn base(displacement: S, velocity: S) -> Self {
        Self::new(ExcitationLoad::Base([displacement, velocity]))
    }

    fn new(excitation: ExcitationLoad<S>) -> Self {
        Self {
            excitation,
            start_velocity: None,
            more: Vec::new(),
            friction: S::constant(0.0),
        }
    }

    /// Converts the numbers of the input to another scalar type.
    #[cfg(feature = "measure")]
    pub(crate) fn map<T>(self, number: impl Fn(S) -> T) -> SystemInput<'n, T> {
        let more = self.more.into_iter();
        SystemInput {
            excitation: match self.excitation {
                ExcitationLoad::Force(force) => ExcitationLoad::Force(number(force)),
                ExcitationLoad::Base(base) => ExcitationLoad::Base(base.map(&number)),
            },
            start_velocity: self.start_velocity.map(&number),
            more: more.map(|(mass, force)| (mass, number(force))).collect(),
            friction: number(self.friction),
        }
    }

    /// Sets the velocity of the base at the start of the step, for a velocity that jumps there. By default the step
    /// starts at the velocity of the last input. `begin` and `input: hold` ignore this velocity.
    pub fn starting_at(mut self, velocity: S) -> Self {
        self.start_velocity = Some(velocity);
        self
    }

    /// Adds a force on the mass called `mass`. Forces on the same mass add up.
    pub fn on(mut self, mass: &'n str, force: S) -> Self {
        self.more.push((mass, force));
        self
    }

    /// Sets the kinetic friction force F at zero speed, which must not be negative. The default is 0.
    pub fn friction(mut self, friction: S) -> Self {
        self.friction = friction;
        self
    }
}

impl<S: Plain> System<S> {
    /// Returns a stepper with time steps of `dt` seconds, from rest without load.
    ///
    /// A force can act on every mass. The description of the scene defines the friction law and the interpolation of
    /// the input between samples.
    ///
    /// ```
    /// use frictiongen::study::SystemInput;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: frictiongen::System = "struct Frame {
    ///     masses: { lower: 3.27, upper: 3.25 },
    ///     springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    ///     contact: upper - wall,
    ///     excitation: base,
    ///     damping: modal[0.010, 0.012],
    ///     stiction: 1.2,
    /// }"
    /// .parse()?;
    /// let mut stepper = frame.stepper(1e-3)?;
    /// for step in 1..=2000_u32 {
    ///     let (sine, cosine) = (12.0 * 1e-3 * f64::from(step)).sin_cos();
    ///     let input = SystemInput::base(0.01 * sine, 0.12 * cosine).friction(2.0);
    ///     stepper.advance(input)?;
    /// }
    /// assert!(stepper.mass("upper")?.displacement().abs() > 1e-3);
    /// let work = stepper.work();
    /// assert!(work.friction > 0.0 && work.damping > 0.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OutOfDomain`] for a step that is not positive and finite, or in which the fastest oscillator advances by more
    /// than [`MAX_PARTS`](frictiongen_kernel::stepper::MAX_PARTS) radians.
    /// [`Unsupported::CriticalDamping`](crate::Unsupported::CriticalDamping) if too many modes are at or beyond
    /// critical damping. Less than half of the digits would then remain.
    pub fn stepper(&self, dt: S) -> Result<SystemStepper<'_, S>, OutOfDomain> {
        self.stepping(dt, None)
    }

    /// Returns a stepper that starts from a given state: the displacements and velocities of all masses.
    ///
    /// # Errors
    /// Same errors as [`stepper`](Self::stepper). [`OutOfDomain`] also if `state` does not have one finite
    /// displacement and one finite velocity for each mass.
    pub fn stepper_from(
        &self,
        dt: S,
        state: (&[S], &[S]),
    ) -> Result<SystemStepper<'_, S>, OutOfDomain> {
        self.stepping(dt, Some(state))
    }

    /// Returns a stepper that continues from an [`image`](SystemStepper::image), with its time step and its state.
    ///
    /// # Errors
    /// [`OutOfDomain`] for an image of another scene or version, and for an image in which a bit has changed.
    pub fn stepper_from_image(&self, bytes: &[u8]) -> Result<SystemStepper<'_, S>, OutOfDomain> {
        let mut stepper = self.stepping(image_step(bytes)?, None)?;
        stepper.restore_image(bytes)?;
        Ok(stepper)
    }

    fn stepping(
        &self,
        dt: S,
        state: Option<(&[S], &[S])>,
    ) -> Result<SystemStepper<'_, S>, OutOfDomain> {
        self.loaded()?;
        SystemStepper::new((self, self.steps()), self.dynamics_in_time()?, dt, state)
    }
}

impl<S: Plain> SystemStepper<'_, S> {
    /// Returns an image of the state, which is a list of bytes for a file. [`System::stepper_from_image`] continues
    /// from these bytes. A run-time system accepts forces on all masses. Its images therefore fit only a run-time
    /// system of the same scene.
    #[must_use]
    pub fn image(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.stepper.image_len()];
        self.stepper.write_image(&mut bytes);
        bytes
    }
}

impl<'a, S: Float> SystemStepper<'a, S> {
    /// Creates a stepper from the system's settings and its data for motions in time.
    pub(super) fn new(
        (system, settings): (&'a System<S>, &'a Settings<S>),
        dynamics: Dynamics<'a, S, AnyContact<S>>,
        dt: S,
        state: Option<(&[S], &[S])>,
    ) -> Result<Self, OutOfDomain> {
        let scene = settings.scene(dynamics);
        let tables = SystemStepTables::new(&scene, dt)?;
        let store = SystemStepStore::new(&scene);
        Ok(Self {
            system,
            settings,
            forces: vec![S::constant(0.0); scene.forces.len()],
            stepper: Stepper::new(scene, tables, store, state)?,
        })
    }

    /// Sets the input at the start of the first step. Without this call, the input at the start is 0. After the call,
    /// [`contact`](Self::contact) returns the force under this input.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance). A call after the first step returns [`OutOfDomain`].
    pub fn begin(&mut self, input: SystemInput<'_, S>) -> Result<(), StudyError> {
        let (base, friction) = self.lay(&input)?;
        let forces = &self.forces;
        Ok(self.stepper.begin(Sample {
            base,
            forces,
            friction,
        })?)
    }

    /// Takes one step. `input` is the input at the end of the step. By default the input changes linearly during the
    /// step. With `input: hold` in the scene description, the new input acts over the whole step.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a number that is NaN or infinite, and for friction below zero. [`OutOfDomain`] also for a
    /// force if the base is excited, and for a base motion if a mass is excited. [`UnknownMass`] for an unknown name.
    /// After an error the stepper is unchanged, except for a velocity of the base that the input sets by
    /// [`starting_at`](SystemInput::starting_at).
    pub fn advance(&mut self, input: SystemInput<'_, S>) -> Result<Stepped<S>, StudyError> {
        let (base, friction) = self.lay(&input)?;
        let forces = &self.forces;
        if let Some(velocity) = input.start_velocity {
            self.stepper.set_base_velocity(velocity)?;
        }
        Ok(self.stepper.advance(Sample {
            base,
            forces,
            friction,
        })?)
    }

    /// Writes the forces of an input to `forces`. Returns the motion of the base and the friction force.
    fn lay(&mut self, input: &SystemInput<'_, S>) -> Result<([S; 2], S), StudyError> {
        let steps = self.settings;
        self.forces.fill(S::constant(0.0));
        let base = match (input.excitation, self.forces.first_mut()) {
            (ExcitationLoad::Base(base), _) if steps.on_base => base,
            (ExcitationLoad::Force(force), Some(excited)) if !steps.on_base => {
                *excited = force;
                [S::constant(0.0); 2]
            }
            (ExcitationLoad::Base(_), _) => return Err(OutOfDomain::BaseAtRest.into()),
            (ExcitationLoad::Force(_), _) => return Err(OutOfDomain::Forces.into()),
        };
        for (name, force) in &input.more {
            let mass = self.system.mass_index(name)?;
            let place = steps.forces.iter().position(|loaded| *loaded == mass);
            if let Some(sum) = place.and_then(|place| self.forces.get_mut(place)) {
                *sum = *sum + *force;
            }
        }
        Ok((base, input.friction))
    }

    /// Returns the present displacement and velocity of the mass called `name`.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<MassNow<S>, UnknownMass> {
        Ok(self.stepper.mass(self.system.mass_index(name)?))
    }

    /// Returns the present displacement and velocity of a mass. `index` is the index in the scene description. For an
    /// invalid index, displacement and velocity are 0.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> MassNow<S> {
        self.stepper.mass(index)
    }

    /// Returns the present displacement and velocity of all masses, in the order of the scene description. The call
    /// evaluates each mode only once for all masses.
    #[must_use]
    pub fn all_masses(&self) -> Vec<MassNow<S>> {
        let mut masses = vec![self.stepper.mass(usize::MAX); self.forces.len()];
        self.stepper.read_masses(&mut masses);
        masses
    }

    fn sample(&mut self, load: &StepLoad<'_, S>) -> Result<(), OutOfDomain> {
        let steps = self.settings;
        load.spread(&steps.forces, steps.on_base, &mut self.forces)
    }
}

impl<'a, S> Deref for SystemStepper<'a, S> {
    type Target = KernelStepper<'a, S>;

    fn deref(&self) -> &Self::Target {
        &self.stepper
    }
}

impl<S> DerefMut for SystemStepper<'_, S> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.stepper
    }
}

impl<S: Plain> Steps for System<S> {
    type Scalar = S;
    type Stepper<'a> = SystemStepper<'a, S>;

    fn stepper(&self, dt: S) -> Result<SystemStepper<'_, S>, OutOfDomain> {
        Self::stepper(self, dt)
    }
}

impl<S: Plain> Stepping for SystemStepper<'_, S> {
    type Scalar = S;

    fn begin_with(&mut self, load: &StepLoad<'_, S>) -> Result<(), OutOfDomain> {
        self.sample(load)?;
        self.stepper.begin(Sample {
            base: load.base,
            forces: &self.forces,
            friction: load.friction,
        })
    }
    fn step(&mut self, load: &StepLoad<'_, S>) -> Result<Stepped<S>, OutOfDomain> {
        self.sample(load)?;
        self.stepper.advance(Sample {
            base: load.base,
            forces: &self.forces,
            friction: load.friction,
        })
    }
    fn mass(&self, index: usize) -> MassNow<S> {
        self.stepper.mass(index)
    }
    fn contact(&self) -> ContactNow<S> {
        self.stepper.contact()
    }
    fn work(&self) -> Work<S> {
        self.stepper.work()
    }
    fn steps(&self) -> u64 {
        self.stepper.steps()
    }
    fn exceeded(&self) -> u64 {
        self.stepper.exceeded()
    }
    fn dt(&self) -> S {
        self.stepper.dt()
    }
    fn set_stiction(&mut self, mu: S) -> Result<(), OutOfDomain> {
        self.stepper.set_stiction(mu)
    }
}
