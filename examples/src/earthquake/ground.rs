//! Computes a synthetic ground motion after Kanai, Tajimi, Clough and Penzien. White noise passes through the resonance
//! of the ground, then through a filter that removes motions slower than an earthquake, and is shaped by an envelope.

use rand::rngs::ChaCha8Rng;
use rand::{Rng, SeedableRng};

/// Sampling rate of the ground motion, in steps a second.
pub const RATE: f64 = 200.0;
/// Duration of the ground motion, in s.
pub const LENGTH: f64 = 30.0;
/// Seed of the random noise from which the ground motion is computed.
const SEED: u64 = 1940;

/// Motion of the ground at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ground {
    /// Time, in s.
    pub time: f64,
    /// Displacement, in m.
    pub displacement: f64,
    /// Velocity, in m/s.
    pub velocity: f64,
    /// Acceleration, in m/s².
    pub acceleration: f64,
}

/// An oscillator that filters noise: its angular frequency ω in rad/s, damping ratio ζ, displacement and velocity.
struct Filter {
    omega: f64,
    zeta: f64,
    place: f64,
    speed: f64,
}

impl Filter {
    fn new(omega: f64, zeta: f64) -> Self {
        Self {
            omega,
            zeta,
            place: 0.0,
            speed: 0.0,
        }
    }

    /// Advances the oscillator by a step of the symplectic Euler method under a load. Returns its acceleration.
    fn driven(&mut self, load: f64, step: f64) -> f64 {
        let pull = 2.0 * self.zeta * self.omega * self.speed + self.omega * self.omega * self.place;
        let acceleration = load - pull;
        self.speed += acceleration * step;
        self.place += self.speed * step;
        acceleration
    }
}

/// Computes the whole ground motion from rest. `peak` is its peak acceleration in m/s².
pub fn ground(peak: f64) -> Vec<Ground> {
    // Within a sample of the recording, the filters take several shorter steps.
    let fine = 20;
    let step = 1.0 / (RATE * f64::from(fine));
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut soil = Filter::new(15.0, 0.6);
    let mut slow = Filter::new(1.5, 0.6);
    let mut motion = vec![Ground::default()];
    let mut time = 0.0;
    while time < LENGTH {
        let mut acceleration = 0.0;
        for _ in 0..fine {
            time += step;
            let noise = uniform(&mut random) * envelope(time);
            soil.driven(noise, step);
            let shaken =
                2.0 * soil.zeta * soil.omega * soil.speed + soil.omega * soil.omega * soil.place;
            acceleration = slow.driven(shaken, step);
        }
        motion.push(Ground {
            time,
            displacement: slow.place,
            velocity: slow.speed,
            acceleration,
        });
    }
    let largest = |most: f64, ground: &Ground| most.max(ground.acceleration.abs());
    let scale = peak / motion.iter().fold(0.0, largest);
    for ground in &mut motion {
        ground.displacement *= scale;
        ground.velocity *= scale;
        ground.acceleration *= scale;
    }
    motion
}

/// Returns the envelope of the ground motion: it rises for two seconds, stays at 1, and decays after ten seconds.
fn envelope(time: f64) -> f64 {
    if time < 2.0 {
        (time / 2.0) * (time / 2.0)
    } else if time < 10.0 {
        1.0
    } else {
        (-0.35 * (time - 10.0)).exp()
    }
}

/// Returns a random number that is evenly distributed between −1 and 1.
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    let bits = u32::try_from(random.next_u64() >> 32).unwrap_or(u32::MAX);
    f64::from(bits) / f64::from(1_u32 << 31) - 1.0
}
