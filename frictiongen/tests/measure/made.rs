//! Recordings made by simulation, for the tests of this folder.

use frictiongen::System;
use frictiongen::measure::{Channel, Recording, Unit};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::TAU;

/// Natural frequency of the rig of chapter 4, in Hz.
pub const NATURAL: f64 = 3.086;
/// Amplitude of the base of that rig, in m.
pub const Y: f64 = 1.75e-3;
/// Sampling rate, in samples a second.
pub const RATE: f64 = 2000.0;

/// Returns the rig of chapter 4 with a mass of 2 kg. `more` adds lines to the description.
pub fn rig(more: &str) -> System {
    let omega = TAU * NATURAL;
    format!(
        "struct Rig {{ masses: {{ plate: 2.0 }}, springs: {{ base - plate: {:?} }}, contact: plate - wall, excitation: base, {more} }}",
        2.0 * omega * omega
    )
    .parse()
    .unwrap()
}

/// Random numbers with mean 0 and standard deviation 1, which depend only on the seed.
pub struct Noise(ChaCha8Rng);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    pub fn next(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }

    /// Adds noise with this standard deviation to the samples.
    pub fn add(&mut self, samples: &mut [f64], deviation: f64) {
        for value in samples {
            *value += deviation * self.next();
        }
    }
}

/// Settings of a simulated recording.
#[derive(Clone, Copy)]
pub struct How {
    pub hertz: f64,
    pub beta: f64,
    pub rate: f64,
    pub seconds: f64,
    /// Number of cycles from rest before the recording begins.
    pub skip: f64,
}

/// Returns the displacements over Y of the base and of every mass, in a run from rest.
pub fn motions(system: &System, how: How) -> Vec<Vec<f64>> {
    let r = system.frequency_ratio_at_hertz(how.hertz);
    let mut run = system.simulation(r, how.beta).unwrap();
    let count = (how.seconds * how.rate).round() as usize;
    let masses = system.scene().masses.len();
    let mut all = vec![Vec::with_capacity(count); masses + 1];
    for index in 0..count {
        let target = TAU * (how.skip + how.hertz * index as f64 / how.rate);
        loop {
            let left = target - (TAU * run.cycles() as f64 + run.phase());
            if left <= 1e-11 * target.max(1.0) {
                break;
            }
            run.advance(left).unwrap();
        }
        all[0].push(target.cos());
        for (place, motion) in all[1..].iter_mut().enumerate() {
            motion.push(run.run().mass(place).displacement());
        }
    }
    all
}

/// Returns the root mean square of the samples.
pub fn rms(samples: &[f64]) -> f64 {
    (samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64).sqrt()
}

/// Returns a recording of motions in mm. The noise of each is 1/`snr` of its root mean square, so that an `snr` of 100
/// is 40 dB.
pub fn recording(
    system: &System,
    motions: &[Vec<f64>],
    rate: f64,
    snr: f64,
    noise: &mut Noise,
) -> Recording {
    let names = system.scene().masses.iter().map(|mass| mass.name.clone());
    let names = std::iter::once("base".to_owned()).chain(names);
    let channels = names.zip(motions).map(|(name, motion)| {
        let mut samples: Vec<f64> = motion.iter().map(|x| 1e3 * Y * x).collect();
        let deviation = rms(&samples) / snr;
        noise.add(&mut samples, deviation);
        Channel {
            name,
            unit: Unit::MILLIMETRE,
            samples,
        }
    });
    Recording::new(rate, channels.collect()).unwrap()
}
