//! The steady motion in a recording: driving frequency, transmissibilities, phases and harmonics.

use super::recording::{Dimension, MOTION};
use super::tone::{FEWEST_CYCLES, HARMONICS, Tone, ToneBasis, frequency};
use super::{Channel, MeasureError, Recording, steady};
use crate::Complex;
use crate::study::scene::{Excitation, Scene};
use crate::study::units::polar;
use std::f64::consts::TAU;

/// Smallest number of samples that a recording must have in a cycle of the driving frequency.
const FEWEST_SAMPLES: f64 = 5.0;

/// The steady motion found in a recording: driving frequency, excitation, and displacements of the masses.
///
/// ```
/// use frictiongen::System;
/// use frictiongen::measure::{Channel, Measured, Recording, Unit};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let plate: System = "struct Plate {
///     masses: { plate: 1.0 }, springs: { base - plate: 376.0 }, contact: plate - wall, excitation: base,
/// }"
/// .parse()?;
/// let turns = |hertz: f64| move |i: usize| std::f64::consts::TAU * hertz * i as f64 / 500.0;
/// let channel = |name: &str, samples: Vec<f64>| Channel { name: name.into(), unit: Unit::MILLIMETRE, samples };
/// let base = (0..5000).map(turns(4.01)).map(|turn| 1.75 * turn.cos()).collect();
/// let mass = (0..5000).map(turns(4.01)).map(|turn| 3.5 * (turn - 0.3).cos()).collect();
/// let recording = Recording::new(500.0, vec![channel("base", base), channel("plate", mass)])?;
/// let measured = Measured::of(&recording, plate.scene())?;
/// let plate = measured.transmissibility(0).ok_or("not recorded")?;
/// assert!((measured.hertz - 4.01).abs() < 1e-6);
/// assert!((plate.amplitude() - 2.0).abs() < 1e-6 && (plate.lag() - 0.3).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Driving frequency of the recording, in Hz.
    pub hertz: f64,
    /// Standard deviation of the driving frequency, in Hz.
    pub hertz_deviation: f64,
    /// Sampling rate of the recording, in samples per second.
    pub rate: f64,
    /// Start and end of the interval of steady motion, in s from the first sample of the recording.
    pub steady: (f64, f64),
    /// Mean and harmonics of the excitation: displacement of the base in m, or force in N.
    pub drive: Tone,
    /// Displacement of each recorded mass in m, as mean and harmonics, with the index of the mass in the scene
    /// description.
    pub masses: Vec<(usize, Tone)>,
}

/// A complex amplitude divided by the amplitude of the excitation, with its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmissibility {
    /// Complex ratio X/Y for base motion, or X/P in m/N for a force. X is the amplitude of the mass.
    pub value: Complex<f64>,
    /// Standard deviation of the real part and of the imaginary part of [`value`](Self::value).
    pub deviation: f64,
}

impl Transmissibility {
    /// Returns the displacement transmissibility |X/Y| (4.4), or |X/P| in m/N for a force.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        polar(self.value).0
    }

    /// Returns the lag of the mass behind the excitation, in rad, in (−π, π] (4.5, with a positive sign for a lag).
    #[must_use]
    pub fn lag(&self) -> f64 {
        polar(self.value).1
    }
}

impl Measured {
    /// Finds the steady motion in a recording. The channel of the excitation must have the name `base` or `force`.
    /// Every other channel must have the name of one of the scene's masses.
    ///
    /// The call converts velocities and accelerations to displacements at each harmonic.
    ///
    /// # Errors
    /// [`MeasureError`] for a channel that does not belong to the scene or has an impossible unit. [`MeasureError`]
    /// also for a missing excitation or missing masses, and for an excitation without motion or with a drift.
    /// [`MeasureError`] also for too few cycles, and for a motion that is never steady.
    pub fn of(recording: &Recording, scene: &Scene) -> Result<Self, MeasureError> {
        let places = places(recording, scene)?;
        let rate = recording.even_rate()?;
        let (drive, _) = places.drive;
        let per_sample = frequency(&drive.samples).ok_or_else(|| MeasureError::TooShort {
            found: "no frequency with at least four cycles exceeds the noise".to_owned(),
            needed: "8 cycles of the excitation",
        })?;
        if 1.0 / FEWEST_SAMPLES < per_sample {
            return Err(MeasureError::TooSlow {
                rate,
                hertz: per_sample * rate,
            });
        }
        let all = std::iter::once((drive.name.as_str(), drive.samples.as_slice()));
        let masses = places.masses.iter();
        let all = all
            .chain(masses.map(|(_, channel)| (channel.name.as_str(), channel.samples.as_slice())));
        let from = steady::start(&all.collect::<Vec<_>>(), per_sample, rate)?;
        let kept = |channel: &'_ Channel| -> Vec<f64> {
            channel.samples.iter().skip(from).copied().collect()
        };
        let driven = kept(drive);
        let per_sample = frequency(&driven).unwrap_or(per_sample);
        if per_sample * (driven.len() as f64) < FEWEST_CYCLES {
            return Err(MeasureError::NotSteady(drive.name.clone()));
        }
        let basis = ToneBasis::new(driven.len(), per_sample, HARMONICS);
        let omega = TAU * per_sample * rate;
        let tone = |channel: &Channel, samples: &[f64]| {
            let tone = basis.tone(samples);
            tone.map(|tone| in_metres(tone, channel, omega))
                .ok_or_else(|| MeasureError::NotSteady(channel.name.clone()))
        };
        let drive_tone = tone(drive, &driven)?;
        let masses = places.masses.iter();
        let masses = masses.map(|(place, channel)| Ok((*place, tone(channel, &kept(channel))?)));
        let masses = masses.collect::<Result<Vec<_>, MeasureError>>()?;
        let seconds = driven.len() as f64 / rate;
        // `phase` is the standard deviation of a phase from the whole record. For half of the record it is √2 times as
        // large. The middles of the two halves are T/2 apart, where T is the length of the record. The standard
        // deviation of the frequency is therefore 2·`phase`/(2π·T/2).
        let phase = drive_tone.deviation / drive_tone.fundamental().norm();
        Ok(Self {
            hertz: per_sample * rate,
            hertz_deviation: phase / (std::f64::consts::PI * 0.5 * seconds),
            rate,
            steady: (from as f64 / rate, recording.len() as f64 / rate),
            drive: drive_tone,
            masses,
        })
    }

    /// Returns the amplitude of the excitation: Y in m, or P in N.
    #[must_use]
    pub fn drive_amplitude(&self) -> f64 {
        self.drive.fundamental().norm()
    }

    /// Returns the complex amplitude X_1 of the fundamental component of a mass, divided by the complex amplitude of
    /// the excitation. Returns `None` if the recording does not contain the mass.
    #[must_use]
    pub fn transmissibility(&self, mass: usize) -> Option<Transmissibility> {
        let tone = self.tone(mass)?;
        let drive = self.drive.fundamental();
        let value = tone.fundamental() / drive;
        let (own, of_drive) = (tone.deviation, value.norm() * self.drive.deviation);
        Some(Transmissibility {
            value,
            deviation: own.hypot(of_drive) / drive.norm(),
        })
    }

    /// Returns the complex amplitude X_n of harmonic n of a mass, divided by the amplitude of the excitation. In the
    /// displacement Re Σ X_n e^{inτ}, the phase τ is 0 at a maximum of the excitation. Returns `None` if the recording
    /// does not contain the mass.
    #[must_use]
    pub fn harmonic(&self, mass: usize, n: u32) -> Option<Complex<f64>> {
        let tone = self.tone(mass)?;
        let place = usize::try_from(n).ok()?.checked_sub(1)?;
        let drive = self.drive.fundamental();
        let turn = drive / drive.norm();
        let value = tone.harmonics.get(place)?;
        Some(value / (turn.powu(n) * drive.norm()))
    }

    /// Returns mean and harmonics of the displacement of a mass, in m. Returns `None` if the recording does not contain
    /// the mass.
    #[must_use]
    pub fn tone(&self, mass: usize) -> Option<&Tone> {
        let found = self.masses.iter().find(|(place, _)| *place == mass);
        found.map(|(_, tone)| tone)
    }
}

/// The channels of a recording, assigned to the excitation and to the masses of a scene.
struct AssignedChannels<'r> {
    drive: (&'r Channel, Dimension),
    masses: Vec<(usize, &'r Channel)>,
}

fn places<'r>(
    recording: &'r Recording,
    scene: &Scene,
) -> Result<AssignedChannels<'r>, MeasureError> {
    let drive_name = match scene.excitation {
        Excitation::Base => "base",
        Excitation::Force(_) => "force",
    };
    let mut drive = None;
    let mut masses = Vec::new();
    for channel in recording.channels() {
        let dimension = channel.unit.dimension();
        let is_force = dimension == Dimension::Force;
        let place = scene
            .masses
            .iter()
            .position(|mass| mass.name == channel.name);
        let is_drive = channel.name == drive_name;
        if place.is_none() && !is_drive {
            let names = scene.masses.iter().map(|mass| mass.name.clone());
            return Err(MeasureError::NoSuchPlace {
                channel: channel.name.clone(),
                known: std::iter::once(drive_name.to_owned())
                    .chain(names)
                    .collect(),
            });
        }
        if is_force != (is_drive && drive_name == "force") {
            return Err(MeasureError::WrongDimension {
                channel: channel.name.clone(),
                unit: channel.unit.name(),
                needed: if is_force {
                    MOTION
                } else {
                    Dimension::Force.needed()
                },
            });
        }
        match place {
            Some(place) if !is_drive => masses.push((place, channel)),
            _ => drive = Some((channel, dimension)),
        }
    }
    if masses.is_empty() {
        return Err(MeasureError::NoMass);
    }
    let drive = drive.ok_or(MeasureError::NoDrive(drive_name))?;
    Ok(AssignedChannels { drive, masses })
}

/// Converts mean and harmonics of a channel to displacements in m, or to forces in N. `omega` is the driving frequency
/// in rad/s.
fn in_metres(tone: Tone, channel: &Channel, omega: f64) -> Tone {
    let scale = channel.unit.scale();
    let derivatives = match channel.unit.dimension() {
        Dimension::Velocity => 1,
        Dimension::Acceleration => 2,
        _ => 0,
    };
    let harmonics = tone.harmonics.iter().enumerate().map(|(index, value)| {
        let rate = Complex::new(0.0, omega * (index as f64 + 1.0));
        value * scale / rate.powi(derivatives)
    });
    let at_omega = scale / omega.powi(derivatives);
    Tone {
        // The mean of a velocity or an acceleration contains no information about the mean position.
        mean: if derivatives == 0 {
            tone.mean * scale
        } else {
            0.0
        },
        harmonics: harmonics.collect(),
        deviation: tone.deviation * at_omega,
        residual: tone.residual * at_omega,
    }
}
