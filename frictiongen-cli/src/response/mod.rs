//! `frictiongen response`: regime and motion over frequency and friction.

mod point;
mod report;

use crate::args::ResponseArguments;
use crate::failure::Failure;
use crate::grid::{self, MOST_POINTS, Quantity};
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::UnknownMass;
use frictiongen_codegen::Limits;
use report::{Mass, ResponseReport};

/// The highest harmonic there may be.
const MOST_HARMONICS: u32 = 9999;

/// Runs the command.
pub fn run(arguments: &ResponseArguments) -> Result<(), Failure> {
    let r = grid::parse(&arguments.r, Quantity::FrequencyRatio).map_err(Failure::new)?;
    let beta = grid::parse(&arguments.beta, Quantity::FrictionRatio).map_err(Failure::new)?;
    if r.len().saturating_mul(beta.len()) > MOST_POINTS {
        return Err(Failure::new(format_args!(
            "--r and --beta: more than {MOST_POINTS} points together, the most there may be"
        )));
    }
    let orders = orders(arguments.harmonics.as_deref())?;
    let description = arguments.file.description(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let masses = masses(&system, &arguments.mass)?;
    let summary = Summary::of(&system);
    let report = ResponseReport {
        system,
        r,
        beta,
        masses,
        orders,
    };
    output::print(&report, &summary, &arguments.format)
}

/// The odd numbers up to the one asked for.
fn orders(highest: Option<&str>) -> Result<Vec<u32>, Failure> {
    let Some(text) = highest else {
        return Ok(Vec::new());
    };
    match text.trim().parse() {
        Ok(highest @ 1..=MOST_HARMONICS) => Ok((1..=highest).step_by(2).collect()),
        _ => Err(Failure::new(format_args!(
            "--harmonics `{text}`: a whole number from 1 to {MOST_HARMONICS} is needed"
        ))),
    }
}

/// The masses asked for, each once, or all.
fn masses(system: &System, names: &[String]) -> Result<Vec<Mass>, Failure> {
    let known = || system.scene().masses.iter().enumerate();
    let all = known().map(|(index, mass)| Mass {
        index,
        name: mass.name.clone(),
    });
    if names.is_empty() {
        return Ok(all.collect());
    }
    let mut masses: Vec<Mass> = Vec::new();
    for name in names {
        let Some(mass) = all.clone().find(|mass| mass.name == *name) else {
            let name = name.clone();
            let known = known().map(|(_, mass)| mass.name.clone()).collect();
            return Err(Failure::new(format_args!(
                "--mass: {}",
                UnknownMass { name, known }
            )));
        };
        if masses.iter().all(|known| known.index != mass.index) {
            masses.push(mass);
        }
    }
    Ok(masses)
}
