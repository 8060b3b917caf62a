//! Reads the load of `frictiongen periodic`: a table of one period, or harmonics.

use crate::args::{PeriodicArguments, RecordingArguments};
use crate::asked::number_that;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::measure::Dimension;
use frictiongen::study::periodic::{BaseTable, Harmonic, PeriodicError, PeriodicLoad};
use frictiongen::study::scene::Excitation;

/// Returns the periodic load that the arguments describe.
pub fn of(arguments: &PeriodicArguments, system: &System) -> Result<PeriodicLoad, Failure> {
    match (&arguments.table, &arguments.harmonics, &arguments.hz) {
        (Some(_), None, None) => table(arguments, system),
        (None, Some(harmonics), Some(hz)) => {
            let needed = "one frequency above 0";
            let hertz = number_that("--hz", hz, |hertz| 0.0 < hertz, needed)?;
            let harmonics = parsed(harmonics)?;
            PeriodicLoad::harmonics(1.0 / hertz, &harmonics)
                .map_err(|error| Failure::new(format_args!("--harmonics: {error}")))
        }
        (None, Some(_), None) => Err(Failure::new(
            "--harmonics needs the frequency of the first order: give --hz",
        )),
        (Some(_), None, Some(_)) => Err(Failure::new(
            "--hz belongs to --harmonics; the times of a table give its period",
        )),
        _ => Err(Failure::new(
            "give the load: the file of a table over one period, or --harmonics with --hz",
        )),
    }
}

/// Reads a table of one period of the load.
fn table(arguments: &PeriodicArguments, system: &System) -> Result<PeriodicLoad, Failure> {
    let Some(path) = &arguments.table else {
        return Err(Failure::new("give the file of a table"));
    };
    let files = RecordingArguments {
        scene: arguments.scene.clone(),
        recordings: vec![path.clone()],
        channel: arguments.channel.clone(),
        rate: arguments.rate.clone(),
    };
    let recording = files.inputs()?;
    let told = |problem: &dyn std::fmt::Display| {
        Failure::new(format_args!("{}: {problem}", path.display()))
    };
    let wanted = match system.scene().excitation {
        Excitation::Base => "base",
        Excitation::Force(_) => "force",
    };
    let [channel] = recording.channels() else {
        return Err(told(&format_args!(
            "a table of one period has the time and the load alone, as column `{wanted}`"
        )));
    };
    let scale = channel.unit.scale();
    let samples: Vec<f64> = channel.samples.iter().map(|value| value * scale).collect();
    let step = 1.0 / recording.even_rate().map_err(|error| told(&error))?;
    let quantity = match channel.unit.dimension() {
        Dimension::Force => None,
        Dimension::Displacement => Some(BaseTable::Displacement),
        Dimension::Velocity => Some(BaseTable::Velocity),
        Dimension::Acceleration => Some(BaseTable::Acceleration),
        Dimension::Time => return Err(told(&"the unit of the load is a time")),
    };
    let moves = quantity.is_some();
    if channel.name != wanted || moves != (wanted == "base") {
        let error = match wanted {
            "base" => PeriodicError::BaseMoves,
            _ => PeriodicError::BaseAtRest,
        };
        return Err(told(&format_args!(
            "the column `{}` is in {}: {error}",
            channel.name,
            channel.unit.name()
        )));
    }
    let load = match quantity {
        None => PeriodicLoad::forces(step, &samples),
        Some(quantity) => PeriodicLoad::base(step, &samples, quantity),
    };
    load.map_err(|error| told(&error))
}

/// Parses harmonics such as `1:100@0, 3:20@45`. Each harmonic has an order, an amplitude and a lag in degrees. The lag
/// is 0 if the text gives none.
fn parsed(text: &str) -> Result<Vec<Harmonic>, Failure> {
    let one = |text: &str| {
        let wrong = || {
            Failure::new(format_args!(
                "--harmonics `{}`: ORDER:AMPLITUDE@DEGREES is needed, as in 1:100@0,3:20@45",
                text.trim()
            ))
        };
        let (order, rest) = text.split_once(':').ok_or_else(wrong)?;
        let (amplitude, degrees) = rest.split_once('@').unwrap_or((rest, "0"));
        let number = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
        Ok::<_, Failure>(Harmonic {
            order: order.trim().parse().map_err(|_| wrong())?,
            amplitude: number(amplitude)?,
            lag: number(degrees)?.to_radians(),
        })
    };
    text.split(',').map(one).collect()
}
