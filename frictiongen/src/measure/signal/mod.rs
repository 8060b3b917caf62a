//! Inputs over time in closed form: forces on masses and motions of the base, written as text.

mod follow;
mod parse;
#[cfg(test)]
mod tests;

pub use follow::SignalInputs;

use crate::study::joints::Wave;
use frictiongen_kernel::joints::Curve;
use std::f64::consts::FRAC_PI_2;

/// Largest difference between a chirp and its pieces of constant frequency, divided by the amplitude of the chirp.
const CHIRP_ERROR: f64 = 1e-6;
/// Largest number of pieces of a chirp.
const MOST_PIECES: f64 = 1e6;
/// Part of a piece, or of a second, that counts as rounding of a time.
const ROUNDING: f64 = 1e-9;
/// Relative difference at which two times are treated as equal.
const SAME: f64 = 1e-12;
/// Relative jump of the displacement or the velocity of the base that counts as rounding.
const NO_JUMP: f64 = 1e-12;

/// A force on a mass, or a motion of the base, as a function of time in closed form.
///
/// The text of a signal has a shape, an amplitude with its unit, and the words that the shape needs:
///
/// | text | value |
/// |---|---|
/// | `const 5 N` | 5 N at all times |
/// | `step 5 N from 1 s` | 0, from 1 s on 5 N; with `for 3 s` it ends after 3 s |
/// | `ramp 5 N from 1 s for 2 s` | rises on a straight line from 0 to 5 N in 2 s, then stays |
/// | `sine 5 N at 2 Hz from 1 s` | 5 sin(2π·2(t − 1)) N from 1 s on; with `for 3 s` it ends after 3 s |
/// | `half-sine 5 N from 1 s for 20 ms` | one half wave of a sine, a pulse of 20 ms |
/// | `rectangle 5 N from 1 s for 20 ms` | a rectangular pulse of 20 ms |
/// | `chirp 5 N at 1 Hz to 9 Hz from 1 s for 20 s` | a sine whose frequency changes linearly from 1 Hz to 9 Hz in 20 s |
///
/// Without `from`, a signal starts at 0 s. A force acts on the mass of `excitation`, or on that of `on NAME`. The unit of a
/// displacement, a velocity or an acceleration makes the signal a motion of the base. All signals are exact but a chirp.
/// It consists of pieces of constant frequency, and differs from the chirp by at most 10⁻⁶ of the amplitude.
///
/// ```
/// use frictiongen::System;
/// use frictiongen::measure::{Signal, SignalInputs};
///
/// let block: System = "struct Block {
///     masses: { block: 2.0 }, contacts: { floor: block - wall }, excitation: block,
/// }".parse()?;
/// let signals = [Signal::parse("step 5 N from 0.5 s", &block)?];
/// let inputs = SignalInputs::new(&signals, (1.5, 3), 3.0)?;
/// let joined = block.joined()?;
/// let history = inputs.history(&joined, None)?;
/// // v = (P − F)t/m
/// let (_, v) = &history.states[3];
/// assert!((v[0] - (5.0 - 3.0) * 1.0 / 2.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    target: Target,
    shape: Shape,
    /// Amplitude in the SI unit.
    amplitude: f64,
    /// Start in s.
    start: f64,
    /// Length in s, or infinity.
    length: f64,
}

/// Force on a mass, or kinematic quantity of the base, whose course over time a signal gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    /// Force on the mass with this index.
    Force(usize),
    /// Displacement of the base.
    Displacement,
    /// Velocity of the base.
    Velocity,
    /// Acceleration of the base.
    Acceleration,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    /// A constant value.
    Step,
    /// A straight line from 0 to the amplitude, and then this value.
    Ramp,
    /// A sine with this angular frequency in rad/s.
    Sine(f64),
    /// A sine whose angular frequency changes linearly between two values in rad/s, in a number of pieces.
    Chirp { ends: [f64; 2], pieces: f64 },
}

/// A function of time until the next instant at which a signal changes its form.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The function. Its time is 0 at the present instant.
    wave: Wave,
    /// End of the piece in s since the start of the motion, or infinity.
    end: f64,
    /// True if the piece starts at the present instant.
    begins: bool,
}

impl Signal {
    /// Returns the signal's function from the instant `time` on, in SI units.
    fn piece(&self, time: f64) -> Piece {
        let (start, stop) = (self.start, self.start + self.length);
        let rounding = ROUNDING * self.length.min(1.0) + 2.0 * SAME * time;
        let near = |instant: f64| (time - instant).abs() <= rounding;
        let piece = |wave, end, begins| Piece { wave, end, begins };
        if time < start && !near(start) {
            return piece(Wave::zero(), start, false);
        }
        let since = (time - start).max(0.0);
        let ends = stop <= time || near(stop);
        let sine = |omega: f64, phase: f64| Wave {
            amplitude: self.amplitude,
            omega,
            phase: phase - FRAC_PI_2,
            ..Wave::zero()
        };
        match self.shape {
            Shape::Ramp if ends => piece(Wave::constant(self.amplitude), f64::INFINITY, near(stop)),
            _ if ends => piece(Wave::zero(), f64::INFINITY, near(stop)),
            Shape::Step => piece(Wave::constant(self.amplitude), stop, near(start)),
            Shape::Ramp => {
                let slope = self.amplitude / self.length;
                let line = Wave {
                    constant: slope * since,
                    slope,
                    ..Wave::zero()
                };
                piece(line, stop, near(start))
            }
            Shape::Sine(omega) => piece(sine(omega, omega * since), stop, near(start)),
            Shape::Chirp {
                ends: [first, last],
                pieces,
            } => {
                let length = self.length / pieces;
                let rate = (last - first) / self.length;
                let phase = |time: f64| (first + 0.5 * rate * time) * time;
                let index = (since / length + ROUNDING).floor().min(pieces - 1.0);
                let [from, to] = [index * length, (index + 1.0) * length];
                let omega = (phase(to) - phase(from)) / length;
                let wave = sine(omega, phase(from) + omega * (since - from));
                piece(wave, start + to, near(start))
            }
        }
    }

    /// Returns the motion of the base that follows `piece`, from its present displacement and velocity, and whether it
    /// jumps at the present instant.
    fn base(&self, piece: &Piece, [place, velocity]: [f64; 2]) -> (Curve<f64>, bool) {
        let wave = &piece.wave;
        let (omega, phase) = (wave.omega, wave.phase);
        let mut curve = Curve::straight([place, velocity]);
        match self.target {
            Target::Displacement => curve = Curve::from(*wave),
            Target::Velocity => {
                curve.wave.slope = wave.constant;
                curve.square = 0.5 * wave.slope;
            }
            _ => {
                curve.square = 0.5 * wave.constant;
                curve.cube = wave.slope / 6.0;
            }
        }
        if wave.amplitude != 0.0 && self.target == Target::Velocity {
            let amplitude = wave.amplitude / omega;
            curve.wave.constant -= amplitude * phase.sin();
            (curve.wave.amplitude, curve.wave.omega) = (amplitude, omega);
            curve.wave.phase = phase - FRAC_PI_2;
        }
        if wave.amplitude != 0.0 && self.target == Target::Acceleration {
            let amplitude = wave.amplitude / (omega * omega);
            curve.wave.constant += amplitude * phase.cos();
            curve.wave.slope -= amplitude * omega * phase.sin();
            (curve.wave.amplitude, curve.wave.omega) = (-amplitude, omega);
            curve.wave.phase = phase;
        }
        let [rise, lift] = [curve.value(0.0, 0) - place, curve.value(0.0, 1) - velocity];
        let (size, speed) = (self.amplitude.abs(), self.fastest() * self.amplitude.abs());
        let jumps = match self.target {
            Target::Displacement => [NO_JUMP * size, NO_JUMP * speed],
            Target::Velocity => [f64::INFINITY, NO_JUMP * size],
            _ => [f64::INFINITY; 2],
        };
        let jolts = piece.begins && (jumps[0] < rise.abs() || jumps[1] < lift.abs());
        (curve, jolts)
    }

    /// Returns the largest rate of change of the signal's function, divided by the amplitude.
    fn fastest(&self) -> f64 {
        match self.shape {
            Shape::Step => 0.0,
            Shape::Ramp => 1.0 / self.length,
            Shape::Sine(omega) => omega,
            Shape::Chirp { ends, .. } => ends[0].max(ends[1]),
        }
    }
}
