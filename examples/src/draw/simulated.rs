//! Computes motion from rest by the event-driven simulation.

use frictiongen::{Of, System};
use frictiongen_plot::desk::Reading;
use std::f64::consts::TAU;

/// Number of cycles from rest before a simulated motion counts as steady. The thesis takes 200 (3.6.1), but five masses
/// with little friction need more.
pub const CYCLES: usize = 1000;
/// Number of instants of a cycle at which a simulated motion is sampled.
const INSTANTS: usize = 720;

/// Amplitude of a motion, and its lag behind the excitation.
#[derive(Clone, Copy, Debug)]
pub struct Polar {
    /// Amplitude |x̄|.
    pub amplitude: f64,
    /// Lag behind the excitation, in rad.
    pub lag: f64,
}

/// Returns the motions of a simulation from rest after [`CYCLES`] cycles, one list for each motion. The entries are at
/// ascending phase angles of the excitation.
#[must_use]
pub fn from_rest(
    system: &System,
    (r, beta): (f64, f64),
    of: &[Of],
    angles: &[f64],
) -> Option<Vec<Vec<f64>>> {
    let mut run = system.simulation(r, beta).ok()?;
    let settled = TAU * CYCLES as f64;
    let mut passed = 0.0;
    let mut motions = vec![Vec::with_capacity(angles.len()); of.len()];
    for angle in angles {
        while passed < settled + angle {
            let segment = run.advance(settled + angle - passed).ok()?;
            // Rounding of the elapsed phase may make the last interval vanish.
            if segment.length <= 1e-9 && segment.event.is_none() {
                break;
            }
            passed += segment.length;
        }
        for (motion, of) in motions.iter_mut().zip(of) {
            motion.push(run.motion_of(*of)?.0);
        }
    }
    Some(motions)
}

/// Returns amplitude and lag of each of the motions `of`, from a simulation from rest.
#[must_use]
pub fn simulated(
    system: &System,
    at: (f64, f64),
    of: &[Of],
    reading: Reading,
) -> Option<Vec<Polar>> {
    let angles: Vec<f64> = (0..INSTANTS)
        .map(|i| TAU * i as f64 / INSTANTS as f64)
        .collect();
    let motions = from_rest(system, at, of, &angles)?;
    let read = |motion: Vec<f64>| match reading {
        Reading::Amplitude | Reading::Phase | Reading::Rate(_) => largest(&angles, &motion),
        Reading::Harmonic(_) | Reading::HarmonicPhase(_) => fundamental(&angles, &motion),
    };
    Some(motions.into_iter().map(read).collect())
}

fn largest(angles: &[f64], motion: &[f64]) -> Polar {
    let none = Polar {
        amplitude: 0.0,
        lag: 0.0,
    };
    angles.iter().zip(motion).fold(none, |best, (angle, x)| {
        if x.abs() <= best.amplitude {
            return best;
        }
        let half = if *x < 0.0 { 0.5 * TAU } else { 0.0 };
        Polar {
            amplitude: x.abs(),
            lag: angle + half,
        }
    })
}

fn fundamental(angles: &[f64], motion: &[f64]) -> Polar {
    let sums = angles
        .iter()
        .zip(motion)
        .fold((0.0, 0.0), |sum, (angle, x)| {
            (sum.0 + x * angle.cos(), sum.1 + x * angle.sin())
        });
    let share = 2.0 / angles.len() as f64;
    Polar {
        amplitude: share * sums.0.hypot(sums.1),
        lag: sums.1.atan2(sums.0),
    }
}
