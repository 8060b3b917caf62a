//! The option `--input`: inputs over time in closed form.

use crate::failure::Failure;
use frictiongen::System;
use frictiongen::measure::{Signal, SignalInputs};

/// Parses the texts of the option.
pub fn parsed(system: &System, texts: &[String]) -> Result<Vec<Signal>, Failure> {
    let parse = |text: &String| Signal::parse(text, system);
    let signals = texts.iter().map(parse).collect::<Result<_, _>>();
    signals.map_err(|error| Failure::new(format_args!("--input {error}")))
}

/// Collects the inputs of a motion to the time `until` in s, with a number of sample intervals.
pub fn inputs(
    signals: &[Signal],
    until: (f64, usize),
    friction: f64,
) -> Result<SignalInputs<'_>, Failure> {
    let inputs = SignalInputs::new(signals, until, friction);
    inputs.map_err(|error| Failure::new(format_args!("--input: {error}")))
}
