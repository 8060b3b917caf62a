//! Passes the linker script of the emulated board, and writes a recording of the frame as sensors would deliver it: the
//! exact motion with noise of a fixed seed, in whole counts.

use std::{env, error::Error, f64::consts::TAU, fs, path::Path};

frictiongen::friction_system! {
    /// Two floors on a shaking base, a friction damper between the upper one and the wall.
    pub struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.01, 0.012],
        stiction: 1.2,
        provide: [simulation],
    }
}

/// Motion of the base: 1.5 Hz, 10 mm.
const FREQUENCY: f64 = 1.5;
const AMPLITUDE: f64 = 0.01;
/// Friction force of the damper, N.
const FRICTION: f64 = 3.5;
const SAMPLES: usize = 4000;
const RATE: f64 = 1000.0;
/// The value of one count, for each quantity of the recording: in m, m/s, m and N.
const COUNTS: [f64; 4] = [1e-6, 1e-5, 1e-6, 1e-3];
/// Standard deviations of the sensors' noise, in the units of [`COUNTS`] but not in counts: m, m/s, m and N.
const NOISE: [f64; 4] = [2e-6, 2e-4, 1e-5, 0.02];

/// Random numbers with an approximately normal distribution. Each is the sum of twelve uniform random numbers.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let mut sum = -6.0;
        for _ in 0..12 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            sum += (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        }
        sum
    }
}

fn recording() -> Result<Vec<u8>, Box<dyn Error>> {
    let stiffness = 1190.0_f64;
    let force = stiffness * AMPLITUDE;
    let omega = TAU * FREQUENCY;
    let r = omega / (stiffness / 3.27).sqrt();
    let mut run = Frame::simulation(r, FRICTION / force)?;
    let mut noise = Noise(20_260_101);
    let mut bytes = Vec::new();
    for sample in 0..=SAMPLES {
        let phase = omega * sample as f64 / RATE;
        let values = [
            AMPLITUDE * phase.cos(),
            -AMPLITUDE * omega * phase.sin(),
            AMPLITUDE * run.upper().displacement(),
            force * run.friction(),
        ];
        for ((value, sigma), count) in values.into_iter().zip(NOISE).zip(COUNTS) {
            let counts = ((value + sigma * noise.next()) / count).round();
            bytes.extend((counts as i16).to_le_bytes());
        }
        let mut left = omega / RATE;
        while left > 1e-12 {
            left -= run.advance(left)?.length;
        }
    }
    Ok(bytes)
}

fn main() -> Result<(), Box<dyn Error>> {
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);
    fs::write(out.join("memory.x"), include_str!("../memory.x"))?;
    fs::write(out.join("recording.bin"), recording()?)?;
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rerun-if-changed=../memory.x");
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
