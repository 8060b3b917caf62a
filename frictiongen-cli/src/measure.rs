//! Determines the units of the answers from the options for the load.

use crate::args::LoadArguments;
use crate::asked::number;
use crate::failure::Failure;
use frictiongen::System;
#[cfg(feature = "report")]
pub use frictiongen::study::columns::Dimension;
pub use frictiongen::study::columns::Measure;
use frictiongen::study::units::{Load, LoadError};

/// Returns the units under the given load. Without a load the units are non-dimensional groups.
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
    if let Some(text) = &arguments.base {
        measure = under(Load::Base(number("--base", text)?), "--base", text)?;
    }
    Ok(measure)
}

/// Returns the option for the load: `--base` if the base drives the scene, otherwise `--force`.
pub fn option(measure: &Measure) -> &'static str {
    if measure.is_base_motion() {
        "--base"
    } else {
        "--force"
    }
}

/// Describes the load and its units of force and length in words.
pub fn description(measure: &Measure, number: impl Fn(f64) -> String) -> Option<String> {
    let scale = measure.scale()?;
    let (force, length) = (number(scale.force()), number(scale.length()));
    Some(if measure.is_base_motion() {
        format!("Y = {length} m, k1 Y = {force} N")
    } else {
        format!("P = {force} N, P/k1 = {length} m")
    })
}
