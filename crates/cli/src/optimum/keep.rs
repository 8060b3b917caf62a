//! The option `--keep` of `frictiongen optimum`, which sets upper bounds on amplitudes: `--keep 'roof-base <= 5mm'`.

use super::valued::QuantityArgument;
use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::number::computed;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{Further, OptimumLine, OptimumTable, Tuned};
use frictiongen::study::optimum::{KeptQuantity, OptimumError, OptimumRequest, Tuning};

/// Parses the upper bounds that `--keep` sets.
pub fn parsed(
    system: &System,
    texts: &[String],
    measure: &Measure,
) -> Result<Vec<QuantityArgument>, Failure> {
    texts
        .iter()
        .map(|text| one(system, text, measure))
        .collect()
}

fn one(system: &System, text: &str, measure: &Measure) -> Result<QuantityArgument, Failure> {
    let wrong =
        |problem: &dyn std::fmt::Display| Failure::new(format_args!("--keep `{text}`: {problem}"));
    let (name, limit) = text
        .split_once("<=")
        .or_else(|| text.split_once('≤'))
        .ok_or_else(|| wrong(&"a quantity and its bound are needed, as in roof-base <= 5mm"))?;
    QuantityArgument::parsed(system, (name, limit), measure, &wrong)
}

/// Finds the best friction within the bounds, and returns the lines of the result.
pub fn lines(
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    bounds: &[QuantityArgument],
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let system = table.setting.system;
    let found = system.kept_optimum(request, &kept(bounds), watch);
    let found = found.map_err(|error| failure(table, bounds, None, error))?;
    let values = values(bounds, &found.largest);
    Ok(table.lines_with(&found.optimum, None, Further::Kept(&values)))
}

/// Finds the best friction within the bounds, together with the best value of the number that `--vary` names. Returns
/// the lines of the result.
pub fn varied_lines(
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    bounds: &[QuantityArgument],
    text: &str,
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let system = table.setting.system;
    let vary = Vary::parsed(text)?;
    let tuning = vary.tuning(system)?;
    let found = system.kept_tuned_optimum(request, &tuning, &kept(bounds), watch);
    let (found, largest) = found.map_err(|error| match error {
        OptimumError::Interval | OptimumError::Scene(_) => vary.wrong(&error),
        error => failure(table, bounds, Some(&tuning), error),
    })?;
    let of = tuning.of;
    let tuned = Tuned { of, found: &found };
    let optimum = tuned.optimum();
    let values = values(bounds, &largest);
    Ok(table.lines_with(&optimum, Some(&tuned), Further::Kept(&values)))
}

fn kept(bounds: &[QuantityArgument]) -> Vec<KeptQuantity> {
    let kept = bounds.iter().map(|bound| KeptQuantity {
        of: bound.part.of,
        size: bound.part.size,
        most: bound.value,
    });
    kept.collect()
}

/// Returns each bounded quantity with its bound and its largest value over the band.
fn values(bounds: &[QuantityArgument], largest: &[f64]) -> Vec<(MovingPart, f64, f64)> {
    let values = bounds.iter().zip(largest);
    values
        .map(|(bound, largest)| (bound.part.clone(), bound.value, *largest))
        .collect()
}

/// Returns the failure for an error of the search. If no friction keeps a quantity within its bound, the failure names
/// this bound.
fn failure(
    table: &OptimumTable<'_>,
    bounds: &[QuantityArgument],
    tuning: Option<&Tuning>,
    error: OptimumError,
) -> Failure {
    let (system, measure) = (table.setting.system, &table.setting.measure);
    let OptimumError::Unreachable {
        index,
        least,
        beta,
        value,
    } = error
    else {
        return Failure::new(error);
    };
    let Some(bound) = bounds.get(index) else {
        return Failure::new(error);
    };
    let dimension = bound.part.dimension();
    let reference = system.angular_frequency(1.0);
    let before = match index {
        0 => "",
        _ => " together with the bounds before it",
    };
    let friction = format!(
        "a friction of {} {}",
        computed(measure.force(beta)),
        match measure.scale() {
            Some(_) => "N",
            None => "(beta)",
        }
    );
    let (any, at) = match tuning.zip(value) {
        None => (String::new(), friction),
        Some((tuning, value)) => {
            let name = tuning.of.symbol(system.scene());
            let value = format!("{} {}", computed(value), tuning.of.unit());
            let at = format!("{friction} and with {name} = {}", value.trim_end());
            (format!(" at any value of {name}"), at)
        }
    };
    let unit = measure.unit_or_reference(dimension);
    let least = format!(
        "{} {unit}",
        computed(measure.convert(dimension, least, reference))
    );
    Failure::new(format_args!(
        "--keep `{} <= {}`: no friction holds this bound{before}{any}; the least value is {}, with {at}",
        bound.name,
        bound.text,
        least.trim_end(),
    ))
}
