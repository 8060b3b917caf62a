//! `frictiongen fit`: fits a scene's parameters to a sweep without friction.

use super::lines::Lines;
use super::read;
use crate::args::FitArguments;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::{SweepFit, SweepPoint};
use std::f64::consts::TAU;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &FitArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&arguments.scene), &arguments.format, false)?;
    let system = read::scene(&arguments.scene)?;
    let text = read::text(&arguments.sweep)?;
    let points =
        SweepPoint::read(&text, &system).map_err(|error| read::told(&arguments.sweep, &error))?;
    let found = system.fit_sweep(&points, arguments.damping);
    let found = found.map_err(|error| read::told(&arguments.sweep, &error))?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    let lines = lines(&system, &found, points.len());
    destination.write(out, |out| {
        output::print(&lines, &summary, destination.form, out)
    })
}

fn lines(system: &System, found: &SweepFit, points: usize) -> Lines {
    let mut lines = Lines::default();
    let scene = system.scene();
    if !found.is_explained() {
        let note = "the description does not explain the sweep: residuals exceed the deviations; check the chain, the damping and that friction was off";
        lines.said.push(("verdict", note.to_owned()));
    }
    lines.estimate("sqrt(k1/m1)", found.reference, 1.0, "Hz");
    // The factors from f to r, and from ω to r.
    let inverse = frictiongen::measure::Estimate {
        value: 1.0 / found.reference.value,
        from: 1.0 / found.reference.to,
        to: 1.0 / found.reference.from,
    };
    lines.estimate("r per Hz", inverse, 1.0, "s");
    lines.estimate("r per rad/s", inverse, 1.0 / TAU, "s");
    for (mass, gamma) in scene.masses.iter().skip(1).zip(&found.masses) {
        lines.estimate(format!("gamma {}", mass.name), *gamma, 1.0, "");
    }
    for (spring, kappa) in scene.springs.iter().skip(1).zip(&found.springs) {
        let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
        lines.estimate(format!("kappa {from} - {to}"), *kappa, 1.0, "");
    }
    if let Some(damping) = found.damping {
        lines.estimate("zeta", damping, 1.0, "");
    }
    for (mode, natural) in found.natural.iter().enumerate() {
        lines.estimate(
            format!("natural frequency {}", mode + 1),
            *natural,
            1.0,
            "Hz",
        );
    }
    lines.number("points", points as f64, "");
    lines.number("relative scatter", found.scatter, "");
    if let Some(misfit) = found.misfit {
        lines.number("misfit (1 is noise)", misfit, "");
    }
    lines.number("condition", found.condition, "");
    // These are the values of the fitted description. Its first mass keeps its value.
    for (mass, new) in scene.masses.iter().zip(&found.system.scene().masses) {
        lines.number(
            format!("mass {} of the description", mass.name),
            new.value,
            "kg",
        );
    }
    for (spring, new) in scene.springs.iter().zip(&found.system.scene().springs) {
        let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
        lines.number(
            format!("spring {from} - {to} of the description"),
            new.stiffness,
            "N/m",
        );
    }
    lines
}
