//! Synthetic recordings: the simulation from rest, sampled, with seeded noise.

use frictiongen::System;
use frictiongen::measure::{Channel, Recording, Unit};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::path::Path;

/// The natural frequency of the one-storey rig, Hz (4.3.1).
pub const NATURAL: f64 = 3.086;
/// The amplitude of its base, m.
pub const Y: f64 = 1.75e-3;
/// β of the recordings of the page.
const BETA: f64 = 0.4;
/// Samples a second.
const RATE: f64 = 100.0;
/// Noise over signal: 40 dB.
const NOISE: f64 = 0.01;
/// γ, κ and r₁ for each Hz of the two-storey rig (6.4.2).
const STOREYS: [f64; 3] = [0.9772, 1.1119, 0.3419];

/// Noise that is the same in every run.
pub struct Noise(ChaCha8Rng);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    pub fn next(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}

/// The one-storey rig.
pub fn plate() -> Result<System, Box<dyn Error>> {
    let omega = TAU * NATURAL;
    let text = format!(
        "struct Plate {{ masses: {{ plate: 2.0 }}, springs: {{ base - plate: {:?} }}, contact: plate - wall, excitation: base }}",
        2.0 * omega * omega
    );
    Ok(text.parse()?)
}

/// Base and plate in mm, after 200 cycles from rest.
pub fn recording(
    system: &System,
    (hertz, beta): (f64, f64),
    (rate, seconds): (f64, f64),
    noise: &mut Noise,
) -> Result<Recording, Box<dyn Error>> {
    let mut run = system.simulation(system.frequency_ratio_at_hertz(hertz), beta)?;
    let (mut base, mut mass) = (Vec::new(), Vec::new());
    for index in 0..(rate * seconds) as u32 {
        let target = TAU * (200.0 + hertz * f64::from(index) / rate);
        loop {
            let left = target - (TAU * run.cycles() as f64 + run.phase());
            if left <= 1e-11 * target {
                break;
            }
            run.advance(left)?;
        }
        base.push(1e3 * Y * target.cos());
        mass.push(1e3 * Y * run.run().mass(0).displacement());
    }
    let mut channel = |name: &str, mut samples: Vec<f64>| {
        let squares: f64 = samples.iter().map(|x| x * x).sum();
        let deviation = NOISE * (squares / samples.len() as f64).sqrt();
        samples
            .iter_mut()
            .for_each(|x| *x += deviation * noise.next());
        Channel {
            name: name.to_owned(),
            unit: Unit::MILLIMETRE,
            samples,
        }
    };
    let channels = vec![channel("base", base), channel("plate", mass)];
    Ok(Recording::new(rate, channels)?)
}

/// A free vibration from 20 mm, in mm: about ±F/k in turn (4.2).
pub fn decay(length: f64, rate: f64, seconds: f64, noise: &mut Noise) -> Vec<f64> {
    let half = 0.5 / NATURAL;
    let mut samples = Vec::new();
    for index in 0..(rate * seconds) as u32 {
        // Held for half a second, then let go.
        let since = (f64::from(index) / rate - 0.5).max(0.0);
        let (mut swing, mut extreme) = (0.0, 20.0_f64);
        while swing + 1.0 <= since / half && length < extreme.abs() {
            extreme = 2.0 * length * extreme.signum() - extreme;
            swing += 1.0;
        }
        let centre = length * extreme.signum();
        let moves = length < extreme.abs();
        let x = if moves {
            centre + (extreme - centre) * (PI * (since / half - swing)).cos()
        } else {
            extreme
        };
        samples.push(x + 0.02 * noise.next());
    }
    samples
}

/// (6.15) of the two-storey rig, in Hz, with its roots by (A.2) and (A.5).
pub fn two_storeys(hertz: f64) -> f64 {
    let [gamma, kappa, seconds] = STOREYS;
    let k1 = seconds.powi(-2);
    let k2 = kappa * k1;
    let b = ((k1 + k2) * gamma + k2) / (2.0 * gamma);
    let root = (b * b - k1 * k2 / gamma).sqrt();
    let [w0, w1, w2] = [k2 / gamma, b - root, b + root];
    let f = hertz * hertz;
    w1 * w2 / w0 * (w0 - f) / ((w1 - f) * (w2 - f))
}

/// A sweep of amplitudes with errors of one in a thousand.
fn sweep(mass: &str, frequencies: &[f64], of: impl Fn(f64) -> f64, noise: &mut Noise) -> String {
    let mut text = format!("frequency_Hz,{mass}.transmissibility,{mass}.deviation\n");
    for hertz in frequencies {
        let size = of(*hertz).abs();
        let deviation = 1e-3 * size;
        let measured = size + deviation * noise.next();
        let _ = writeln!(text, "{hertz:.3},{measured:.6},{deviation:.6}");
    }
    text
}

/// A CSV with six decimals.
fn csv(recording: &Recording) -> String {
    let mut text = "time_s".to_owned();
    for channel in recording.channels() {
        let _ = write!(text, ",{}_mm", channel.name);
    }
    for index in 0..recording.len() {
        let _ = write!(text, "\n{:.2}", index as f64 / recording.rate());
        for channel in recording.channels() {
            let _ = write!(text, ",{:.5}", channel.samples[index]);
        }
    }
    text + "\n"
}

/// All recordings of the page.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let system = plate()?;
    let mut noise = Noise::new(2026);
    for (name, hertz) in [
        ("slow", 1.543),
        ("below", 2.5),
        ("above", 3.9),
        ("fast", 5.0),
    ] {
        let recording = recording(&system, (hertz, BETA), (RATE, 12.0), &mut noise)?;
        std::fs::write(folder.join(format!("{name}.csv")), csv(&recording))?;
    }
    let samples = decay(1e3 * BETA * Y, RATE, 4.0, &mut noise);
    let channel = Channel {
        name: "plate".to_owned(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    std::fs::write(
        folder.join("decay.csv"),
        csv(&Recording::new(RATE, vec![channel])?),
    )?;
    let frequencies: Vec<f64> = [0.8, 1.4, 2.0, 2.4, 2.7, 3.5, 4.0, 4.6, 5.5, 6.5, 7.2, 8.0].into();
    let one = |hertz: f64| 1.0 / (1.0 - (hertz / NATURAL).powi(2));
    std::fs::write(
        folder.join("sweep.csv"),
        sweep("plate", &frequencies, one, &mut noise),
    )?;
    let frequencies: Vec<f64> = (2..=32).map(|i| 0.25 * f64::from(i)).collect();
    std::fs::write(
        folder.join("storeys.csv"),
        sweep("m1", &frequencies, two_storeys, &mut noise),
    )?;
    Ok(())
}
