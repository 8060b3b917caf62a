//! The option `--keep` of `frictiongen optimum`, which sets upper bounds on amplitudes: `--keep 'roof-base <= 5mm'`.

use super::valued::QuantityArgument;
use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::number::computed;
use frictiongen::System;
use frictiongen::study::columns::{Further, OptimumLine, OptimumTable};
use frictiongen::study::optimum::{KeptQuantity, OptimumError, OptimumRequest};

/// Parses the bounds of `--keep`.
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

/// Finds the best friction within the bounds, and returns the lines of the answer.
pub fn lines(
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    bounds: &[QuantityArgument],
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let (system, measure) = (table.setting.system, &table.setting.measure);
    let kept: Vec<KeptQuantity> = bounds
        .iter()
        .map(|bound| KeptQuantity {
            of: bound.part.of,
            size: bound.part.size,
            most: bound.value,
        })
        .collect();
    let reference = system.angular_frequency(1.0);
    let found = system.kept_optimum(request, &kept, watch);
    let found = found.map_err(|error| match error {
        OptimumError::Unreachable { index, least, beta } => {
            let Some(bound) = bounds.get(index) else {
                return Failure::new(error);
            };
            let dimension = bound.part.dimension();
            let value = measure.convert(dimension, least, reference);
            let before = match index {
                0 => "",
                _ => " together with the bounds before it",
            };
            Failure::new(format_args!(
                "--keep `{} <= {}`: no friction holds this bound{before}; the least value is {} {}, with a friction of {} {}",
                bound.name,
                bound.text,
                computed(value),
                measure.unit(dimension),
                computed(measure.force(beta)),
                match measure.scale() {
                    Some(_) => "N",
                    None => "(beta)",
                }
            ))
        }
        error => Failure::new(error),
    })?;
    let values = bounds.iter().zip(&found.largest);
    let values: Vec<(MovingPart, f64, f64)> = values
        .map(|(bound, largest)| (bound.part.clone(), bound.value, *largest))
        .collect();
    Ok(table.lines_with(&found.optimum, None, Further::Kept(&values)))
}
