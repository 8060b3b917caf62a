//! The plain exact event stepper in C, `peers/stepper.c`, as a program: it has its own clock.

use crate::clock::Time;
use crate::scenes::Label;
use std::process::Command;

/// An undamped transient dies out by friction alone, in thousands of cycles.
const MOST_CYCLES: &str = "2000";

/// One run: how long it took, and the amplitude in the contact.
pub struct Run {
    /// ns.
    pub time: f64,
    /// |z̄| in the last cycle.
    pub amplitude: f64,
}

/// Runs it; none for a contact that it does not know.
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

/// Of all runs.
pub fn time(runs: &[Run]) -> Time {
    let mut times: Vec<f64> = runs.iter().map(|run| run.time).collect();
    times.sort_by(f64::total_cmp);
    Time {
        median: times[times.len() / 2],
        least: times[0],
    }
}
