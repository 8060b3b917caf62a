//! Converts a recording to the inputs of a scene's stepper, one input for each sample.

use super::recording::MOTION;
use super::{Channel, Dimension, MeasureError, Recording};
use crate::study::scene::{Excitation, StepInput};
use crate::study::stepper::SystemStepper;
use crate::study::{StudyError, SystemInput};
use crate::{Error, Given, OutOfDomain, System};

/// Largest difference between the velocities of the base in two steps that counts as rounding of the recorded
/// displacements, as a multiple of the rounding unit.
const ROUNDINGS: f64 = 4.0;
/// Part of a sample interval that counts as rounding of a time after the recording.
const WHOLE: f64 = 1e-9;

/// Necessary quantity of a channel with the name of a mass, for a message.
const ON_MASS: &str =
    "the force on the mass, in a unit such as N; leave the recorded motion of a mass out";

/// The inputs of a stepper at every sample of a recording: base motion or forces, and the friction force.
///
/// The base motion is a recorded displacement, velocity or acceleration.
/// Between samples the base moves in straight lines through displacements, in parabolas under velocities, or in cubics
/// under accelerations. The velocity or the acceleration of these two is a straight line. A step of the base therefore
/// moves nothing before it. Straight lines also join samples of forces and of a recorded friction force.
///
/// The motion starts at the first sample, with all masses at rest relative to the base. The displacement of the base is
/// relative to this sample. The base has the first recorded velocity there, or the velocity 0 if displacements or
/// accelerations are recorded.
///
/// With `input: hold` in the scene description, each sample of a force acts until the next sample. The base then moves in
/// straight lines between its displacements at the samples.
///
/// ```
/// use frictiongen::System;
/// use frictiongen::measure::{CsvRequest, Inputs, Recording};
///
/// let block: System = "struct Block {
///     masses: { plate: 2.0 }, springs: { base - plate: 800.0 },
///     contact: plate - wall, excitation: plate,
/// }".parse()?;
/// let text = "time_s,force_N\n0,0\n0.01,3\n0.02,5\n0.03,5\n";
/// let recording = Recording::inputs_from_csv(text, &CsvRequest::default())?;
/// let inputs = Inputs::of(&recording, &block, Some(1.5))?.followed_by(0.1)?;
/// let mut step = inputs.stepper(&block)?;
/// for sample in 1..inputs.len() {
///     step.advance(inputs.at(sample))?;
/// }
/// assert!((step.time() - 0.13).abs() < 1e-12);
/// assert!(step.mass("plate")?.displacement() > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Inputs<'r> {
    steps: Steps,
    len: usize,
    /// True if each sample of a force acts until the next sample (`input: hold`).
    holds: bool,
    /// The recorded motion of the base, and the motion in every step.
    base: Option<(&'r Channel, Vec<BaseStep>)>,
    /// The recorded force on the excited mass, or `None` if it was not recorded.
    force: Option<SiChannel<'r>>,
    /// The recorded forces on other masses, each with the name of the mass.
    others: Vec<(&'r str, SiChannel<'r>)>,
    friction: DriveFriction<'r>,
}

/// Lengths of the steps between two samples.
#[derive(Clone, Debug)]
enum Steps {
    /// All steps have this length in s.
    Even(f64),
    /// Times of the samples in s, and the length of the shortest step.
    Uneven(Vec<f64>, f64),
}

impl Steps {
    /// Returns the length in s of the step that ends at a sample.
    fn length(&self, sample: usize) -> f64 {
        match self {
            Self::Even(dt) => *dt,
            Self::Uneven(times, shortest) => {
                let ends = sample
                    .checked_sub(1)
                    .and_then(|before| times.get(before..=sample));
                ends.map_or(*shortest, |ends| match ends {
                    [start, end] => end - start,
                    _ => *shortest,
                })
            }
        }
    }

    /// Returns the length in s of the shortest step.
    fn shortest(&self) -> f64 {
        match self {
            Self::Even(dt) | Self::Uneven(_, dt) => *dt,
        }
    }
}

/// Motion of the base in the step that ends at a sample.
#[derive(Clone, Copy, Debug, Default)]
struct BaseStep {
    /// Velocity at the start of the step in m/s, if the velocity jumps there.
    start: Option<f64>,
    /// Displacement in m and velocity in m/s at the end of the step.
    end: [f64; 2],
}

/// A channel of a recording, with the factor that converts its samples to SI units.
#[derive(Clone, Copy, Debug)]
struct SiChannel<'r> {
    samples: &'r [f64],
    scale: f64,
}

impl SiChannel<'_> {
    fn at(&self, sample: usize) -> f64 {
        self.samples.get(sample).copied().unwrap_or(0.0) * self.scale
    }
}

#[derive(Clone, Copy, Debug)]
enum DriveFriction<'r> {
    Constant(f64),
    Recorded(SiChannel<'r>),
}

impl<'r> Inputs<'r> {
    /// Collects the inputs of a scene from the channels of a recording. The channel `base` is the base motion, and
    /// `force` the force on the excited mass. Other channels are forces on the masses of the same name. The kinetic
    /// friction force is the argument `friction`, in N, or the channel `friction`.
    ///
    /// # Errors
    /// [`MeasureError`] for channels with other names, for units that do not fit, and for a missing excitation.
    /// [`MeasureError`] also for a friction force that is missing or given twice.
    pub fn of(
        recording: &'r Recording,
        system: &System,
        friction: Option<f64>,
    ) -> Result<Self, MeasureError> {
        let channels: Vec<&Channel> = recording.channels().iter().collect();
        Self::of_channels((recording, &channels), system, friction)
    }

    /// Collects the inputs of a scene from the given channels of a recording. [`of`](Self::of) uses all channels.
    pub(super) fn of_channels(
        (recording, channels): (&Recording, &[&'r Channel]),
        system: &System,
        friction: Option<f64>,
    ) -> Result<Self, MeasureError> {
        let scene = system.scene();
        let moving = scene.excitation == Excitation::Base;
        let dt = 1.0 / recording.rate();
        let steps = match recording.uneven_times() {
            None => Steps::Even(dt),
            Some(times) => Steps::Uneven(times.to_vec(), dt),
        };
        let mut inputs = Self {
            steps,
            len: recording.len(),
            holds: scene.stepping.input == StepInput::Hold,
            base: None,
            force: None,
            others: Vec::new(),
            friction: DriveFriction::Constant(friction.unwrap_or(0.0)),
        };
        let mut recorded = None;
        let needed = Dimension::Force.needed();
        for channel in channels.iter().copied() {
            let name = channel.name.as_str();
            let is_mass = scene.masses.iter().any(|mass| mass.name == name);
            match name {
                "friction" if !is_mass => recorded = Some(force(channel, needed)?),
                "base" if moving => {
                    inputs.base = Some((channel, base(channel, &inputs.steps)?));
                }
                "force" if !moving && !is_mass => inputs.force = Some(force(channel, needed)?),
                _ if is_mass => inputs.others.push((name, force(channel, ON_MASS)?)),
                _ => {
                    let drive = if moving { "base" } else { "force" };
                    let masses = scene.masses.iter().map(|mass| mass.name.clone());
                    let known = [drive.to_owned(), "friction".to_owned()];
                    return Err(MeasureError::NoSuchPlace {
                        channel: name.to_owned(),
                        known: known.into_iter().chain(masses).collect(),
                    });
                }
            }
        }
        match (recorded, friction) {
            (Some(track), None) => inputs.friction = DriveFriction::Recorded(track),
            (None, Some(_)) => {}
            (None, None) => return Err(MeasureError::NoFriction),
            (Some(_), Some(_)) => return Err(MeasureError::TwoFrictions),
        }
        let driven = inputs.base.is_some() || inputs.force.is_some() || !inputs.others.is_empty();
        if !driven {
            return Err(MeasureError::NoDrive(if moving { "base" } else { "force" }));
        }
        Ok(inputs)
    }

    /// Returns these inputs with at least `seconds` after the last sample, at the rate of the shortest step. At these samples forces are 0,
    /// as are recorded velocities and accelerations of the base. A recorded displacement of the base and a recorded
    /// friction force keep their last value.
    ///
    /// # Errors
    /// Same errors as [`of`](Self::of).
    pub fn followed_by(mut self, seconds: f64) -> Result<Self, MeasureError> {
        let dt = self.steps.shortest();
        let more = (seconds / dt - WHOLE).ceil().max(0.0) as usize;
        self.len += more;
        if let Steps::Uneven(times, _) = &mut self.steps {
            let last = times.last().copied().unwrap_or(0.0);
            times.extend((1..=more).map(|sample| last + dt * sample as f64));
        }
        if let Some((channel, steps)) = &mut self.base {
            let mut longer = channel.clone();
            let rest = match longer.unit.dimension() {
                Dimension::Displacement => longer.samples.last().copied(),
                _ => None,
            };
            longer.samples.resize(self.len, rest.unwrap_or(0.0));
            *steps = base(&longer, &self.steps)?;
        }
        Ok(self)
    }

    /// Returns the time between two samples of the recording, in s. If the steps differ, it is that of the shortest step.
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.steps.shortest()
    }

    /// Returns the times of the samples in s, if the steps differ.
    pub(super) fn uneven_times(&self) -> Option<&[f64]> {
        match &self.steps {
            Steps::Even(_) => None,
            Steps::Uneven(times, _) => Some(times),
        }
    }

    /// Returns the number of samples in the recording.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Returns false, because a recording always has samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Returns the displacements and velocities of all masses at the first sample, in m and m/s. The masses are at rest
    /// relative to the base.
    #[must_use]
    pub fn initial_state(&self, system: &System) -> (Vec<f64>, Vec<f64>) {
        self.initial_state_of(system.scene().masses.len())
    }

    /// Returns the displacements and velocities of a number of masses at the first sample.
    pub(super) fn initial_state_of(&self, masses: usize) -> (Vec<f64>, Vec<f64>) {
        let [place, velocity] = self.base_step(0).end;
        (vec![place; masses], vec![velocity; masses])
    }

    /// Returns a stepper of the scene at the first sample.
    ///
    /// # Errors
    /// Same errors as [`System::stepper`] and [`SystemStepper::begin`]. [`OutOfDomain::Step`] for steps that differ.
    pub fn stepper<'s>(&self, system: &'s System) -> Result<SystemStepper<'s>, StudyError> {
        let Steps::Even(dt) = self.steps else {
            return Err(Error::from(OutOfDomain::Step(Given::of(f64::NAN))).into());
        };
        let (displacements, velocities) = self.initial_state(system);
        let mut stepper = system.stepper_from(dt, (&displacements, &velocities))?;
        stepper.begin(self.at(0))?;
        Ok(stepper)
    }

    /// Returns the input of the step that ends at a sample. Samples count from 0, and sample 0 is the start of the first
    /// step.
    pub fn at(&self, sample: usize) -> SystemInput<'r> {
        let DriveSample {
            base: [place, velocity],
            start_velocity,
            force,
            others,
            friction,
            ..
        } = self.sample(sample);
        let mut input = match &self.base {
            Some(_) => SystemInput::base(place, velocity),
            None => SystemInput::force(force),
        };
        if let Some(velocity) = start_velocity {
            input = input.starting_at(velocity);
        }
        for (name, force) in others {
            input = input.on(name, force);
        }
        input.friction(friction)
    }

    /// Returns the input of the step that ends at a sample, for a scene with several contacts.
    #[must_use]
    pub fn sample(&self, sample: usize) -> DriveSample<'r> {
        let step = self.base_step(sample);
        // With zero-order hold, the sample at the start of the step acts during the whole step.
        let acting = sample.saturating_sub(usize::from(self.holds));
        let (base, start_velocity, end) = if self.holds {
            let [from, _] = self.base_step(acting).end;
            let [to, _] = step.end;
            let velocity = (to - from) / self.steps.length(sample);
            ([from, velocity], None, [to, velocity])
        } else {
            (step.end, step.start, step.end)
        };
        let others = self.others.iter();
        DriveSample {
            base,
            start_velocity,
            end,
            force: self.force.map_or(0.0, |track| track.at(acting)),
            others: others
                .map(|(name, track)| (*name, track.at(acting)))
                .collect(),
            friction: match self.friction {
                DriveFriction::Constant(force) => force,
                DriveFriction::Recorded(track) => {
                    track.at(acting.min(track.samples.len().saturating_sub(1)))
                }
            },
        }
    }

    fn base_step(&self, sample: usize) -> BaseStep {
        let base = self.base.as_ref();
        let base = base.and_then(|(_, steps)| steps.get(sample));
        base.copied().unwrap_or_default()
    }
}

/// Input of the step that ends at one sample. Each mass has the name of its channel in the recording.
#[derive(Clone, Debug)]
pub struct DriveSample<'r> {
    /// Displacement of the base in m and its velocity in m/s, at the end of the step, or at its start with zero-order
    /// hold.
    pub base: [f64; 2],
    /// Velocity of the base at the start of the step in m/s, if the velocity jumps there.
    pub start_velocity: Option<f64>,
    /// Displacement of the base in m and its velocity in m/s, at the end of the step.
    pub end: [f64; 2],
    /// Force on the excited mass, in N.
    pub force: f64,
    /// Forces on other masses, in N. Each force has the name of its mass.
    pub others: Vec<(&'r str, f64)>,
    /// Kinetic friction force, in N. The force of each contact is this force times the contact's share.
    pub friction: f64,
}

fn force<'r>(channel: &'r Channel, needed: &'static str) -> Result<SiChannel<'r>, MeasureError> {
    if channel.unit.dimension() != Dimension::Force {
        return Err(wrong(channel, needed));
    }
    Ok(SiChannel {
        samples: &channel.samples,
        scale: channel.unit.scale(),
    })
}

fn wrong(channel: &Channel, needed: &'static str) -> MeasureError {
    MeasureError::WrongDimension {
        channel: channel.name.clone(),
        unit: channel.unit.name(),
        needed,
    }
}

/// Returns the motion of the base in every step, in m and m/s. The step of the first sample has no length.
fn base(channel: &Channel, lengths: &Steps) -> Result<Vec<BaseStep>, MeasureError> {
    let scale = channel.unit.scale();
    let samples = channel.samples.iter().map(|value| value * scale);
    let first = samples.clone().next().unwrap_or(0.0);
    let pairs = samples.clone().zip(samples.skip(1)).enumerate();
    let pairs = pairs.map(|(before, (from, to))| (from, to, lengths.length(before + 1)));
    let mut step = BaseStep::default();
    let mut steps = vec![step];
    match channel.unit.dimension() {
        Dimension::Displacement => steps.extend(pairs.map(|(from, to, dt)| {
            let ([_, before], velocity) = (step.end, (to - from) / dt);
            let rounding = ROUNDINGS * f64::EPSILON * (from.abs() + to.abs()) / dt;
            step.start = (rounding < (velocity - before).abs()).then_some(velocity);
            step.end = [to - first, velocity];
            step
        })),
        Dimension::Velocity => {
            step.end = [0.0, first];
            steps = vec![step];
            steps.extend(pairs.map(|(from, to, dt)| {
                let [place, _] = step.end;
                step.end = [place + 0.5 * dt * (from + to), to];
                step
            }));
        }
        Dimension::Acceleration => steps.extend(pairs.map(|(from, to, dt)| {
            let [place, velocity] = step.end;
            let rise = dt * velocity + dt * dt / 6.0 * (2.0 * from + to);
            step.end = [place + rise, velocity + 0.5 * dt * (from + to)];
            step
        })),
        _ => return Err(wrong(channel, MOTION)),
    }
    Ok(steps)
}

/// Acceleration of the base in the step from one sample to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct BaseAcceleration {
    /// Jump of the velocity at the start of the step, in m/s.
    pub jump: f64,
    /// Acceleration at the start and at the end of the step, in m/s². It changes linearly within the step.
    pub ends: [f64; 2],
}

/// Returns the acceleration of the base in every step from one sample to the next.
pub(super) fn accelerations(
    channel: &Channel,
    dt: f64,
) -> Result<Vec<BaseAcceleration>, MeasureError> {
    let scale = channel.unit.scale();
    let dimension = channel.unit.dimension();
    let steps = base(channel, &Steps::Even(dt))?;
    let steps = steps.windows(2).zip(channel.samples.windows(2));
    let steps = steps.filter_map(|(steps, samples)| {
        let ([last, step], [from, to]) = (steps, samples) else {
            return None;
        };
        let [_, before] = last.end;
        Some(BaseAcceleration {
            jump: step.start.map_or(0.0, |velocity| velocity - before),
            ends: match dimension {
                Dimension::Acceleration => [from * scale, to * scale],
                Dimension::Velocity => [(to - from) * scale / dt; 2],
                _ => [0.0; 2],
            },
        })
    });
    Ok(steps.collect())
}
