//! Runs one method at one point, with a given number of steps in a cycle.

use crate::scenes::RAYLEIGH;
use std::f64::consts::TAU;
use std::process::Command;
use std::time::Instant;

/// The point at which a method runs: number of masses, frequency ratio r and friction ratio β.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Number of masses.
    pub masses: usize,
    /// Frequency ratio r.
    pub r: f64,
    /// Friction ratio β.
    pub beta: f64,
}

impl Point {
    /// Returns the number of cycles after which the transient is smaller than a rounding error. Every transient
    /// decays at least as fast as e^(−0.01 t).
    pub fn cycles(&self) -> usize {
        let slowest = 0.5 * RAYLEIGH[0];
        (30.0 / (slowest * TAU / self.r)).ceil() as usize
    }
}

/// Result of a run of one method, from the last cycle of the run.
#[derive(Clone, Debug)]
pub struct Run {
    /// Time of a step in ns: the median over the repeated runs.
    pub time: f64,
    /// Number of stops of the contact in the last cycle.
    pub stops: usize,
    /// Displacement of the contact at the end of each step of the last cycle.
    pub displacements: Vec<f64>,
}

/// Returns the median of times, or of other numbers.
pub fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Runs a stepper of this library. `make` creates the stepper. `advance` advances it by a step under a force, and
/// returns the number of events. `place` returns the displacement of the contact. At the points of this program every
/// stop is followed by a break-away, and the motion has no reversals. Half of the events are therefore stops.
pub fn ours<T>(
    point: &Point,
    (steps, runs, hold): (usize, usize, bool),
    make: impl Fn(f64) -> T,
    advance: impl Fn(&mut T, f64) -> u32,
    place: impl Fn(&T) -> f64,
) -> Run {
    // If the force is constant within a step, the stepper gets its value at the start of the step. If it is linear,
    // the stepper gets its value at the end.
    let first = usize::from(!hold);
    let forces: Vec<f64> = (first..first + steps)
        .map(|step| (TAU * step as f64 / steps as f64).cos())
        .collect();
    let (mut times, mut stops) = (Vec::new(), 0);
    let mut displacements = vec![0.0; steps];
    for _ in 0..runs {
        let mut stepper = make(TAU / point.r / steps as f64);
        let start = Instant::now();
        for cycle in 0..point.cycles() {
            let last = cycle + 1 == point.cycles();
            let mut events = 0;
            for (force, displacement) in forces.iter().zip(&mut displacements) {
                events += advance(&mut stepper, *force) as usize;
                if last {
                    *displacement = place(&stepper);
                }
            }
            stops = events / 2;
        }
        let seconds = start.elapsed().as_secs_f64();
        times.push(1e9 * seconds / (point.cycles() * steps) as f64);
    }
    Run {
        time: median(times),
        stops,
        displacements,
    }
}

/// Runs a method of the C program, which measures its own time.
#[cfg(with_c)]
pub fn in_c(method: &str, point: &Point, steps: usize, runs: usize) -> Option<Run> {
    let contact = point.masses;
    let [a, b] = RAYLEIGH;
    let output = Command::new(env!("TIME_STEPPING"))
        .arg(method)
        .args([point.masses, contact, 1].map(|number| number.to_string()))
        .args([a, b, point.r, point.beta].map(|number| format!("{number:?}")))
        .args([steps, point.cycles(), runs].map(|number| number.to_string()))
        .output()
        .ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let mut lines = text.lines();
    let mut head = lines.next()?.split_whitespace();
    let time = head.next()?.parse().ok()?;
    let stops = head.next()?.parse().ok()?;
    let number = |line: &str| line.split_whitespace().next()?.parse().ok();
    let displacements: Option<Vec<f64>> = lines.map(number).collect();
    Some(Run {
        time,
        stops,
        displacements: displacements?,
    })
}

/// Returns `None`, because no C compiler was found.
#[cfg(not(with_c))]
pub fn in_c(_: &str, _: &Point, _: usize, _: usize) -> Option<Run> {
    let _ = Command::new;
    None
}
