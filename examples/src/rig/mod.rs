//! Simulates recordings of the rigs of chapters 4 and 6, with seeded noise.

mod decay;
mod read;

pub use decay::decay;
pub use read::{Point, frequencies, points};

use frictiongen::measure::{Channel, Recording, Unit};
use frictiongen::study::simulation::SystemSimulation;
use frictiongen::{Of, System};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::error::Error;
use std::f64::consts::TAU;

/// Natural frequency of the one-storey rig, Hz (4.3.1).
pub const NATURAL: f64 = 3.086;
/// Amplitude of the base of the one-storey rig, m.
pub const Y: f64 = 1.75e-3;
/// Sampling rate of a recording in samples a second, and its length in s (4.3.3).
pub const LENGTH: (f64, f64) = (2000.0, 60.0);
/// Amplitude of the noise divided by that of the signal. It corresponds to 40 dB.
const NOISE: f64 = 0.01;
/// Parameters of the two-storey rig (6.4.2): mass ratio γ, stiffness ratio κ, and r₁ at 1 Hz.
pub const STOREYS: [f64; 3] = [0.9772, 1.1119, 0.3419];
/// Number of cycles from rest before a recording begins, as in 3.6.1.
const SKIPPED: f64 = 200.0;

/// Normally distributed noise, the same in every run.
#[derive(Debug)]
pub struct Noise(ChaCha8Rng);

impl Noise {
    /// Creates the noise that belongs to a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// Returns the next number of the noise, with mean 0 and standard deviation 1.
    pub fn draw(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}

/// Returns the one-storey rig with its disc on the `wall` or on the `base`. The text `more` is added to the
/// description.
///
/// # Errors
/// Returns the error in the description.
pub fn one_storey(disc: &str, more: &str) -> Result<System, Box<dyn Error>> {
    let omega = TAU * NATURAL;
    let text = format!(
        "struct Plate {{ masses: {{ plate: 2.0 }}, springs: {{ base - plate: {:?} }}, contact: plate - {disc}, excitation: base, {more} }}",
        2.0 * omega * omega
    );
    Ok(text.parse()?)
}

/// Returns the two-storey rig.
///
/// # Errors
/// Never fails, because its description is right.
pub fn two_storeys() -> Result<System, Box<dyn Error>> {
    let [gamma, kappa, seconds] = STOREYS;
    let (mass, spring) = (3.0, 3.0 * (TAU / seconds).powi(2));
    let text = format!(
        "struct Storeys {{ masses: {{ m1: {mass:?}, m2: {:?} }}, springs: {{ base - m1: {spring:?}, m1 - m2: {:?} }}, contact: m1 - wall, excitation: base }}",
        gamma * mass,
        kappa * spring
    );
    Ok(text.parse()?)
}

/// Advances a simulation to the phase τ = `target`.
///
/// # Errors
/// Never fails in practice, because the simulation does not go back in time.
pub fn reach(run: &mut SystemSimulation<'_>, target: f64) -> Result<(), Box<dyn Error>> {
    loop {
        let left = target - (TAU * run.cycles() as f64 + run.phase());
        if left <= 1e-11 * target {
            return Ok(());
        }
        run.advance(left)?;
    }
}

/// Returns the motions of the base and of the first mass, divided by Y. They are `count` samples of a simulation,
/// which begin at cycle `from`.
///
/// # Errors
/// Never fails in practice, because the simulation does not go back in time.
pub fn followed(
    run: &mut SystemSimulation<'_>,
    from: f64,
    (hertz, rate): (f64, f64),
    count: u32,
) -> Result<[Vec<f64>; 2], Box<dyn Error>> {
    let (mut base, mut mass) = (Vec::new(), Vec::new());
    for index in 0..count {
        let target = TAU * (from + hertz * f64::from(index) / rate);
        reach(run, target)?;
        base.push(target.cos());
        mass.push(run.run().mass(0).displacement());
    }
    Ok([base, mass])
}

/// Creates a recording in mm from motions divided by Y, the base first and then the masses. Each channel gets noise at
/// 40 dB below its signal.
///
/// # Errors
/// Fails if the samples do not form a valid recording.
pub fn noisy(
    system: &System,
    motions: &[Vec<f64>],
    rate: f64,
    noise: &mut Noise,
) -> Result<Recording, Box<dyn Error>> {
    let masses = system.scene().masses.iter().map(|mass| mass.name.clone());
    let names = std::iter::once("base".to_owned()).chain(masses);
    let channels = names.zip(motions).map(|(name, motion)| {
        let mut samples: Vec<f64> = motion.iter().map(|x| 1e3 * Y * x).collect();
        let squares: f64 = samples.iter().map(|x| x * x).sum();
        let deviation = NOISE * (squares / samples.len() as f64).sqrt();
        for x in &mut samples {
            *x += deviation * noise.draw();
        }
        Channel {
            name,
            unit: Unit::MILLIMETRE,
            samples,
        }
    });
    Ok(Recording::new(rate, channels.collect())?)
}

/// Returns a recording of base and plate with friction, after 200 cycles from rest.
///
/// # Errors
/// Fails for an invalid frequency or friction ratio.
pub fn recording(
    system: &System,
    (hertz, beta): (f64, f64),
    (rate, seconds): (f64, f64),
    noise: &mut Noise,
) -> Result<Recording, Box<dyn Error>> {
    let mut run = system.simulation(system.frequency_ratio_at_hertz(hertz), beta)?;
    let motions = followed(&mut run, SKIPPED, (hertz, rate), (rate * seconds) as u32)?;
    noisy(system, &motions, rate, noise)
}

/// Returns a recording of base and all masses in the steady state without friction. A simulation from rest does not
/// reach this state, because nothing damps the transient.
///
/// # Errors
/// Fails for an invalid frequency.
pub fn without_friction(
    system: &System,
    hertz: f64,
    (rate, seconds): (f64, f64),
    noise: &mut Noise,
) -> Result<Recording, Box<dyn Error>> {
    let response = system
        .at(system.frequency_ratio_at_hertz(hertz))?
        .response(0.0)?;
    let base: Vec<f64> = (0..(rate * seconds) as u32)
        .map(|index| (TAU * hertz * f64::from(index) / rate).cos())
        .collect();
    let mut motions = Vec::new();
    for mass in 0..system.scene().masses.len() {
        // Without damping a mass moves in phase with the base or in opposition to it, so the harmonic is real.
        let size = response
            .harmonic(Of::Mass(mass), 1)
            .ok_or("no such mass")?
            .re;
        motions.push(base.iter().map(|x| size * x).collect());
    }
    motions.insert(0, base);
    noisy(system, &motions, rate, noise)
}
