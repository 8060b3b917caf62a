//! Units of the results, from the options for the load.

use crate::args::LoadArguments;
use crate::asked::number;
use crate::failure::Failure;
use frictiongen::System;
pub use frictiongen::study::columns::Measure;
#[cfg(feature = "report")]
pub use frictiongen::study::columns::PhysicalQuantity;
use frictiongen::study::columns::{base_load, unbalance};
use frictiongen::study::units::{Load, LoadError};

/// Returns the units of the results under the given load. Without a load the results are non-dimensional groups.
pub fn of(arguments: &LoadArguments, system: &System) -> Result<Measure, Failure> {
    let groups = Measure::groups(system);
    let under = |load: Load, name: &str, text: &str| {
        Measure::under(system, load).map_err(|error| match error {
            LoadError::DrivenByBase | LoadError::DrivenByForce(_) => Failure::new(format_args!(
                "{name}: {error}; its load is given by {}",
                option(&groups)
            )),
            _ => Failure::new(format_args!("{name} `{text}`: {error}")),
        })
    };
    let mut measure = groups;
    if let Some(text) = &arguments.force {
        measure = under(Load::Force(number("--force", text)?), "--force", text)?;
    }
    if let Some(text) = &arguments.unbalance {
        let load = unbalance(text).map_err(|problem| wrong("--unbalance", text, &problem))?;
        measure = under(load, "--unbalance", text)?;
    }
    if let Some(text) = &arguments.base {
        let load = base_load(text).map_err(|problem| wrong("--base", text, &problem))?;
        measure = under(load, "--base", text)?;
    }
    Ok(measure)
}

fn wrong(option: &str, text: &str, problem: &str) -> Failure {
    let hint = crate::hint::decimal(text);
    Failure::new(format_args!("{option} `{text}`: {problem}{hint}"))
}

/// Returns the units of the results under a load of constant amplitude. Fails for any other load.
pub fn constant(arguments: &LoadArguments, system: &System) -> Result<Measure, Failure> {
    let measure = of(arguments, system)?;
    if let Some(load) = measure.load() {
        let option = match load {
            Load::Unbalance(_) => "--unbalance",
            Load::Force(_) => "--force",
            _ => "--base",
        };
        let constant = system.constant_scale(load);
        constant.map_err(|error| Failure::new(format_args!("{option}: {error}")))?;
    }
    Ok(measure)
}

/// Returns the name of the option for the load: `--base` if the base drives the scene, otherwise `--force`.
pub fn option(measure: &Measure) -> &'static str {
    if measure.is_base_motion() {
        "--base"
    } else {
        "--force"
    }
}

/// Describes the load in words, with its units of force and length. Returns `None` without a load.
pub fn description(measure: &Measure, number: impl Fn(f64) -> String) -> Option<String> {
    let scale = measure.scale()?;
    let (force, length) = (number(scale.force()), number(scale.length()));
    match measure.load()? {
        Load::BaseVelocity(velocity) => {
            return Some(format!(
                "base velocity {} m/s at every frequency",
                number(velocity)
            ));
        }
        Load::BaseAcceleration(acceleration) => {
            let acceleration = number(acceleration);
            return Some(format!(
                "base acceleration {acceleration} m/s2 at every frequency"
            ));
        }
        Load::Unbalance(unbalance) => {
            return Some(format!(
                "unbalance m e = {} kg m, P = m e omega^2",
                number(unbalance)
            ));
        }
        Load::Force(_) | Load::Base(_) => {}
    }
    Some(if measure.is_base_motion() {
        format!("Y = {length} m, k1 Y = {force} N")
    } else {
        format!("P = {force} N, P/k1 = {length} m")
    })
}
