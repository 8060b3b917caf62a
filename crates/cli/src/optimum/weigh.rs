//! The option `--of` of `frictiongen optimum` with several quantities. The command divides each quantity by its own
//! value: `--of roof/5mm --of 'accel(roof)/2m/s2'`.

use super::valued::QuantityArgument;
use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::{Further, OptimumLine, OptimumTable};
use frictiongen::study::optimum::{OptimumRequest, Weighted};

/// Parses the quantities in the options `--of`, and the value by which the command divides each quantity.
pub fn parsed(
    system: &System,
    texts: &[String],
    measure: &Measure,
) -> Result<Vec<QuantityArgument>, Failure> {
    let one = |text: &String| {
        let wrong = |problem: &dyn std::fmt::Display| {
            Failure::new(format_args!("--of `{text}`: {problem}"))
        };
        let (name, value) = text.split_once('/').ok_or_else(|| {
            wrong(&"each of several quantities needs a value to divide it by, as in roof/5mm")
        })?;
        let valued = QuantityArgument::parsed(system, (name, value), measure, &wrong)?;
        if !(0.0 < valued.value) {
            return Err(wrong(&"the value must be above 0"));
        }
        Ok(valued)
    };
    texts.iter().map(one).collect()
}

/// Finds the friction that minimises the largest quotient of a quantity and its value, and returns the lines of the
/// result. `table` creates the table for the quantity with the largest quotient.
pub fn lines<'a>(
    table: &dyn Fn(&'a MovingPart) -> OptimumTable<'a>,
    request: &OptimumRequest,
    all: &'a [QuantityArgument],
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let weighted: Vec<Weighted> = all
        .iter()
        .map(|valued| Weighted {
            of: valued.part.of,
            size: valued.part.size,
            over: valued.value,
        })
        .collect();
    let Some(first) = all.first() else {
        return Ok(Vec::new());
    };
    let system = table(&first.part).setting.system;
    let found = system.weighted_optimum(request, &weighted, watch);
    let found = found.map_err(Failure::new)?;
    let values = all.iter().zip(&found.largest);
    let values: Vec<(MovingPart, f64, f64)> = values
        .map(|(valued, largest)| (valued.part.clone(), valued.value, *largest))
        .collect();
    let decisive = all.get(found.decisive).unwrap_or(first);
    let table = table(&decisive.part);
    Ok(table.lines_with(&found.optimum, None, Further::Weighted(&values)))
}
