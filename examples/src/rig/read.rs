//! Identifies responses from recordings at many frequencies.

use super::{LENGTH, NATURAL, Noise, recording};
use frictiongen::System;
use frictiongen::measure::{Measured, Transmissibility};
use std::error::Error;

/// Middle of the range in which lags are given, in rad.
const MIDDLE: f64 = std::f64::consts::FRAC_PI_2;
/// A whole turn, in rad.
const TURN: f64 = std::f64::consts::TAU;

/// Response of the plate at one frequency, identified from a recording.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Frequency ratio r that belongs to the identified driving frequency.
    pub r: f64,
    /// Amplitude X̄_fft (4.4).
    pub amplitude: f64,
    /// Lag φ_fft (4.5) in degrees, between −90 and 270.
    pub lag: f64,
}

impl Point {
    fn new(r: f64, found: Transmissibility) -> Self {
        let lag = found.lag() - ((found.lag() - MIDDLE) / TURN).round() * TURN;
        Self {
            r,
            amplitude: found.amplitude(),
            lag: lag.to_degrees(),
        }
    }
}

/// Returns frequency ratios in a range at intervals `step`. The ratios are not round numbers, so that no ratio is a
/// resonance.
#[must_use]
pub fn frequencies((from, to): (f64, f64), step: f64) -> Vec<f64> {
    let count = ((to - from) / step).round() as u32;
    (0..count)
        .map(|i| from + (f64::from(i) + 0.37) * step)
        .collect()
}

/// Simulates recordings of the one-storey rig at one friction ratio, and identifies the response from each. A
/// recording has 60 s at 2 kHz with noise at 40 dB. Frequencies at which the plate would be stuck give no point.
///
/// # Errors
/// Fails if a recording does not determine the response.
pub fn points(
    system: &System,
    beta: f64,
    frequencies: &[f64],
    noise: &mut Noise,
) -> Result<Vec<Point>, Box<dyn Error>> {
    let mut points = Vec::new();
    for r in frequencies {
        if system.at(*r)?.limits().sliding <= beta {
            continue;
        }
        let recording = recording(system, (r * NATURAL, beta), LENGTH, noise)?;
        let measured = Measured::of(&recording, system.scene())?;
        let found = measured.transmissibility(0).ok_or("not recorded")?;
        points.push(Point::new(
            system.frequency_ratio_at_hertz(measured.hertz),
            found,
        ));
    }
    Ok(points)
}
