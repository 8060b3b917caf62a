//! Runs a stepper of a scene with one or several contacts, under a load that is the same in every run.

use frictiongen::System;
use frictiongen::study::SystemInput;
use frictiongen::study::joined::{JoinedInput, JoinedStepper};
use frictiongen::study::scene::{Excitation, Scene};
use frictiongen::study::stepper::SystemStepper;
use std::f64::consts::TAU;

/// Number of sine waves in the load.
pub const WAVES: u32 = 8;
/// Two factors for the range of the waves' frequencies. The range begins at the first factor times the lowest natural
/// frequency, and ends at the second factor times the highest natural frequency.
pub const BAND: (f64, f64) = (0.3, 1.2);
/// Seed of the pseudo-random phases of the waves.
const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// A load that is a sum of sine waves with pseudo-random phases. The load has a value and a time derivative at every
/// time.
#[derive(Clone, Debug)]
pub struct SineSum {
    waves: Vec<(f64, f64)>,
    /// Amplitude of each sine wave.
    pub amplitude: f64,
}

impl SineSum {
    /// Creates a load whose sine waves cover the range of the natural frequencies `frequencies`, in rad/s.
    pub fn over(frequencies: &[f64]) -> Self {
        let moving = || frequencies.iter().copied().filter(|rate| *rate > 0.0);
        let lowest = BAND.0 * moving().reduce(f64::min).unwrap_or(1.0);
        let highest = BAND.1 * moving().reduce(f64::max).unwrap_or(1.0);
        let mut seed = SEED;
        let waves = (0..WAVES).map(|wave| {
            // The phases come from a linear congruential generator (Knuth's MMIX). Only the upper bits of `seed` are
            // random enough.
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let phase = TAU * f64::from((seed >> 32) as u32) / f64::from(u32::MAX);
            let part = f64::from(wave) / f64::from(WAVES - 1);
            (lowest * (highest / lowest).powf(part), phase)
        });
        Self {
            waves: waves.collect(),
            amplitude: 1.0 / f64::from(WAVES),
        }
    }

    /// Returns the value and the time derivative of the load at the time t, in s.
    fn at(&self, t: f64) -> [f64; 2] {
        self.waves
            .iter()
            .fold([0.0; 2], |[value, rate], (frequency, phase)| {
                let (sine, cosine) = (frequency * t + phase).sin_cos();
                [
                    value + self.amplitude * sine,
                    rate + self.amplitude * frequency * cosine,
                ]
            })
    }
}

/// Results of a stepper at the end of a step: the motions of masses and contacts.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    /// Displacement of each mass, in the order of the scene description.
    pub masses: Vec<f64>,
    /// Displacement, velocity and friction force of each contact, in the order of the scene description.
    pub contacts: Vec<[f64; 3]>,
    /// Number of events of all contacts in the step.
    pub events: u64,
}

/// A stepper of a scene with one contact, or of a scene with several contacts.
enum AnyStepper<'a> {
    One(Box<SystemStepper<'a>>),
    Several(Box<JoinedStepper<'a>>),
}

/// A run of a stepper that starts from rest.
pub struct StepperRun<'a> {
    stepper: AnyStepper<'a>,
    scene: &'a Scene,
    load: &'a SineSum,
    frictions: Vec<(&'a str, f64)>,
    dt: f64,
    steps: u32,
}

impl<'a> StepperRun<'a> {
    /// Starts a run from rest. `frictions` contains the friction force of each contact.
    pub fn start(
        system: &'a System,
        load: &'a SineSum,
        dt: f64,
        frictions: &'a [(String, f64)],
    ) -> Result<Self, String> {
        let scene = system.scene();
        let stepper = if scene.is_joined() {
            let joined = system.joined().map_err(|error| error.to_string())?;
            let stepper = joined.stepper(dt).map_err(|error| error.to_string())?;
            AnyStepper::Several(Box::new(stepper))
        } else {
            AnyStepper::One(Box::new(
                system.stepper(dt).map_err(|error| error.to_string())?,
            ))
        };
        let frictions = frictions.iter();
        let mut run = Self {
            stepper,
            scene,
            load,
            frictions: frictions
                .map(|(name, force)| (name.as_str(), *force))
                .collect(),
            dt,
            steps: 0,
        };
        run.input(true)?;
        Ok(run)
    }

    /// Advances the run by one step, and returns the results at its end.
    pub fn step(&mut self) -> Result<Answer, String> {
        self.steps += 1;
        let events = self.input(false)?;
        let answer = match &self.stepper {
            AnyStepper::One(stepper) => {
                let now = stepper.contact();
                let masses = stepper.all_masses();
                Answer {
                    masses: masses.iter().map(|mass| mass.displacement()).collect(),
                    contacts: vec![[now.displacement(), now.velocity(), now.force()]],
                    events,
                }
            }
            AnyStepper::Several(stepper) => {
                let contacts = stepper.contacts().into_iter();
                Answer {
                    masses: stepper.masses().iter().map(|[place, _]| *place).collect(),
                    contacts: contacts
                        .map(|now| [now.displacement, now.velocity, now.force])
                        .collect(),
                    events,
                }
            }
        };
        let numbers = answer.masses.iter().chain(answer.contacts.as_flattened());
        if !numbers.clone().all(|number| number.is_finite()) {
            return Err("the motion grows beyond the largest number".to_owned());
        }
        Ok(answer)
    }

    /// Gives the stepper the load at the present time. If `begins` is true, the load is that before the first step.
    /// Otherwise the stepper advances by one step, and the function returns its number of events.
    fn input(&mut self, begins: bool) -> Result<u64, String> {
        let [value, rate] = self.load.at(f64::from(self.steps) * self.dt);
        let excited = match self.scene.excitation {
            Excitation::Base => None,
            Excitation::Force(mass) => self.scene.masses.get(mass),
        };
        match &mut self.stepper {
            AnyStepper::One(stepper) => {
                let input = match excited {
                    None => SystemInput::base(value, rate),
                    Some(_) => SystemInput::force(value),
                };
                let friction = self.frictions.first().map_or(0.0, |(_, force)| *force);
                let input = input.friction(friction);
                if begins {
                    let begun = stepper.begin(input);
                    return begun.map(|()| 0).map_err(|error| error.to_string());
                }
                let stepped = stepper.advance(input).map_err(|error| error.to_string())?;
                Ok(stepped.events.into())
            }
            AnyStepper::Several(stepper) => {
                let force = excited.map(|mass| (mass.name.as_str(), value));
                let input = JoinedInput {
                    base: if force.is_none() {
                        [value, rate]
                    } else {
                        [0.0; 2]
                    },
                    forces: force.as_slice(),
                    frictions: &self.frictions,
                    ..JoinedInput::default()
                };
                if begins {
                    let begun = stepper.begin(input);
                    return begun.map(|()| 0).map_err(|error| error.to_string());
                }
                let events = stepper.advance(input).map_err(|error| error.to_string())?;
                Ok(events as u64)
            }
        }
    }
}
