//! Computes a frame of five storeys under a synthetic earthquake. Each storey has a friction damper on a brace. Finds
//! the best common friction force, and the best distribution of the forces over the storeys.

use super::record::{Sample, ground};
use frictiongen::System;
use frictiongen::study::joined::{Joined, JoinedInput};
use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
use std::error::Error;

/// Peak acceleration of the ground, in m/s².
pub const PEAK: f64 = 3.0;
/// Number of steps of the simulation in a second.
pub const RATE: u32 = 100;
/// Range of the common friction force that is searched, in N.
pub const RANGE: (f64, f64) = (5.0e4, 5.0e6);

/// Returns the frame of five storeys as a run-time system.
///
/// # Errors
/// Errors of the description.
pub fn frame() -> Result<System, Box<dyn Error>> {
    Ok(include_str!("../../scenes/storeys.friction").parse()?)
}

/// Result of a simulation of the frame under an earthquake.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Largest drift of each storey (displacement relative to the storey below), in m.
    pub drifts: Vec<f64>,
    /// At each step, the time in s and the displacement of the roof relative to the ground in m.
    pub roof: Vec<(f64, f64)>,
    /// Energy that each damper dissipates, in J.
    pub energies: Vec<f64>,
}

impl Run {
    /// Returns the largest drift over all storeys, in m.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.drifts.iter().copied().fold(0.0, f64::max)
    }
}

/// Simulates the frame under an earthquake. `forces` has the friction force of each damper, in N.
///
/// # Errors
/// Errors of the solver.
pub fn run(joined: &Joined<'_>, record: &[Sample], forces: &[f64]) -> Result<Run, Box<dyn Error>> {
    let names = joined.contact_names();
    let names = names.iter().map(String::as_str);
    let frictions: Vec<(&str, f64)> = names.zip(forces.iter().copied()).collect();
    let mut step = joined.stepper(1.0 / f64::from(RATE))?;
    let mut found = Run {
        drifts: vec![0.0; frictions.len()],
        ..Run::default()
    };
    for sample in record {
        step.advance(JoinedInput {
            base: [sample.displacement, sample.velocity],
            frictions: &frictions,
            ..JoinedInput::default()
        })?;
        let mut below = sample.displacement;
        for (drift, [floor, _]) in found.drifts.iter_mut().zip(step.masses()) {
            *drift = drift.max((floor - below).abs());
            below = floor;
        }
        found.roof.push((sample.time, below - sample.displacement));
    }
    found.energies = step.contacts().iter().map(|now| now.energy).collect();
    Ok(found)
}

/// Searches for positive numbers with the smallest `cost`. Returns the numbers and their cost.
///
/// The search multiplies or divides one number after the other by a factor, which is `first` at the start. If no
/// change reduces the cost, the factor becomes its square root. The search ends when the factor is below 1.03. It
/// finds a local minimum.
///
/// # Errors
/// Errors of `cost`.
pub fn descend(
    start: &[f64],
    first: f64,
    cost: &mut impl FnMut(&[f64]) -> Result<f64, Box<dyn Error>>,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let (mut best, mut factor) = (start.to_vec(), first);
    let mut least = cost(&best)?;
    while 1.03 < factor {
        let before = least;
        for index in 0..best.len() {
            for change in [factor, 1.0 / factor] {
                let mut tried = best.clone();
                if let Some(number) = tried.get_mut(index) {
                    *number *= change;
                }
                let value = cost(&tried)?;
                if value < least {
                    (best, least) = (tried, value);
                    break;
                }
            }
        }
        if before <= least {
            factor = factor.sqrt();
        }
    }
    Ok((best, least))
}

/// Results for the frame without dampers, with equal dampers, and with the best distribution of friction forces.
#[derive(Clone, Debug)]
pub struct Design {
    /// Result of the frame without dampers.
    pub free: Run,
    /// Largest drift in m for several common friction forces. Each pair has the friction force in N and the drift.
    pub curve: Vec<(f64, f64)>,
    /// Best common friction force of equal dampers, in N, with the result of the frame.
    pub equal: (f64, Run),
    /// Best friction force of each damper in N, with the result of the frame.
    pub distributed: (Vec<f64>, Run),
    /// Number of earthquakes that the search has simulated.
    pub runs: usize,
}

/// Searches for the best friction forces of the dampers: a common force, and a force for each damper.
///
/// # Errors
/// Errors of the description and of the solver.
pub fn design() -> Result<Design, Box<dyn Error>> {
    let (system, record) = (frame()?, ground(PEAK, RATE));
    let joined = system.joined()?;
    let mut runs = 0;
    let mut largest = |forces: &[f64]| -> Result<f64, Box<dyn Error>> {
        runs += 1;
        Ok(run(&joined, &record, forces)?.largest())
    };
    let mut curve = Vec::new();
    let mut best = (0.0, f64::INFINITY);
    for place in 0..=20_u32 {
        let force = RANGE.0 * (RANGE.1 / RANGE.0).powf(f64::from(place) / 20.0);
        let drift = largest(&[force; 5])?;
        curve.push((force, drift));
        if drift < best.1 {
            best = (force, drift);
        }
    }
    let (equal, _) = descend(&[best.0], 1.12, &mut |number| {
        largest(&[number.first().copied().unwrap_or_default(); 5])
    })?;
    let equal = equal.first().copied().unwrap_or_default();
    let (forces, _) = descend(&[equal; 5], 1.4, &mut largest)?;
    Ok(Design {
        free: run(&joined, &record, &[0.0; 5])?,
        curve,
        equal: (equal, run(&joined, &record, &[equal; 5])?),
        distributed: (forces.clone(), run(&joined, &record, &forces)?),
        runs,
    })
}

/// Returns a text about the best friction forces and the drifts.
#[must_use]
pub fn report(design: &Design) -> String {
    let mm = |run: &Run| {
        let drifts = run.drifts.iter();
        let drifts: Vec<String> = drifts.map(|drift| format!("{:.2}", 1e3 * drift)).collect();
        format!("largest drifts {} mm", drifts.join(", "))
    };
    let forces = design.distributed.0.iter();
    let forces: Vec<String> = forces.map(|force| format!("{:.0}", force / 1e3)).collect();
    [
        format!("Frame of five storeys, {} earthquakes", design.runs),
        format!("  without dampers: {}", mm(&design.free)),
        format!(
            "  best common force {:.0} kN: {}",
            design.equal.0 / 1e3,
            mm(&design.equal.1)
        ),
        format!(
            "  best forces {} kN from the first storey to the roof: {}",
            forces.join(", "),
            mm(&design.distributed.1)
        ),
    ]
    .join("\n")
}

/// Returns a figure with three panels: the largest drift over the common friction force, the drifts of the storeys,
/// and the motion of the roof.
#[must_use]
pub fn picture(design: &Design) -> Figure {
    let runs = [
        ("without dampers", 1, &design.free),
        ("best common force", 2, &design.equal.1),
        ("best distribution", 0, &design.distributed.1),
    ];
    let curve = design
        .curve
        .iter()
        .map(|(force, drift)| (force / 1e3, 1e3 * drift));
    let curve: Vec<(f64, f64)> = curve.collect();
    let most = 1.05e3 * design.free.largest();
    let over_force = Panel::new(
        "largest drift of a storey",
        Axis::log("common friction force, kN", RANGE.0 / 1e3, RANGE.1 / 1e3),
        Axis::new("drift, mm", 0.0, most),
    )
    .with(Line::new(
        "equal dampers",
        Colour::Series(2),
        Stroke::Solid,
        vec![curve],
    ));
    let mut storeys = Panel::new(
        "largest drift of each storey",
        Axis::new("drift, mm", 0.0, most),
        Axis::new("storey", 0.0, 5.5),
    );
    let roofs = runs.iter().flat_map(|(_, _, run)| run.roof.iter());
    let mut roof = Panel::new(
        "displacement of the roof",
        Axis::new("time, s", 0.0, 20.0),
        Axis::fitted(
            "relative to the ground, mm",
            roofs.map(|point| 1e3 * point.1),
        ),
    );
    for (name, colour, run) in runs {
        let drifts = (1..).zip(&run.drifts);
        let drifts = drifts.map(|(storey, drift)| (1e3 * drift, f64::from(storey)));
        let colour = Colour::Series(colour);
        storeys = storeys.with(Line::new(
            name,
            colour,
            Stroke::Solid,
            vec![drifts.collect()],
        ));
        let motion = run.roof.iter().filter(|point| point.0 <= 20.0);
        let motion = motion.map(|(time, moved)| (*time, 1e3 * moved));
        roof = roof.with(Line::new(
            name,
            colour,
            Stroke::Thin,
            vec![motion.collect()],
        ));
    }
    let panels = vec![over_force, storeys, roof];
    Figure::new("", "frame of five storeys in an earthquake", 1, panels)
}
