//! Runs the plain exact event stepper `bench/peers/stepper.c`. The program measures its own time.

use crate::clock::Time;
use crate::scenes::Label;
use std::process::Command;

/// Largest number of cycles of a run. In an undamped scene only friction damps the transient, which takes thousands
/// of cycles.
const MOST_CYCLES: &str = "2000";

/// Result of a run of the event stepper.
pub struct Run {
    /// Time of the whole run, in ns.
    pub time: f64,
    /// Amplitude |z̄| of the contact in the last cycle of the run.
    pub amplitude: f64,
}

/// Runs the event stepper for a scene at the point (r, β). Returns `None` for a contact that it does not support.
pub fn run(label: &Label, [r, beta]: [f64; 2]) -> Option<Run> {
    let (contact, excited) = match &label.name[..4] {
        "Wall" => (label.masses, 1),
        "Base" => (1, 0),
        _ => return None,
    };
    let numbers = [label.masses, contact, excited].map(|x| x.to_string());
    let reals = [label.zeta, r, beta].map(|x| format!("{x:?}"));
    let output = Command::new(env!("STEPPER"))
        .args(numbers)
        .args(reals)
        .args([MOST_CYCLES, "1"])
        .output()
        .ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let mut words = text.split_whitespace();
    let microseconds: f64 = words.next()?.parse().ok()?;
    let amplitude = words.nth(4)?.parse().ok()?;
    Some(Run {
        time: microseconds * 1e3,
        amplitude,
    })
}

/// Returns the median and the shortest time of several runs.
pub fn time(runs: &[Run]) -> Time {
    let mut times: Vec<f64> = runs.iter().map(|run| run.time).collect();
    times.sort_by(f64::total_cmp);
    Time {
        median: times[times.len() / 2],
        least: times[0],
    }
}
