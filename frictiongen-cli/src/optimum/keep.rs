//! The bounds of `frictiongen optimum`: `--keep 'roof-base <= 5mm'`.

use crate::asked::Part;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::number::computed;
use frictiongen::System;
use frictiongen::study::columns::{OptimumLine, OptimumTable, bound};
use frictiongen::study::optimum::{Kept, OptimumError, OptimumRequest};
use frictiongen::study::response::Size;

/// A bound of the command line: its text, the quantity, and the bound as non-dimensional group.
pub struct Bound {
    text: String,
    part: Part,
    most: f64,
}

/// Parses the bounds.
pub fn parsed(system: &System, texts: &[String], measure: &Measure) -> Result<Vec<Bound>, Failure> {
    texts
        .iter()
        .map(|text| one(system, text, measure))
        .collect()
}

fn one(system: &System, text: &str, measure: &Measure) -> Result<Bound, Failure> {
    let wrong =
        |problem: &dyn std::fmt::Display| Failure::new(format_args!("--keep `{text}`: {problem}"));
    let (name, limit) = text
        .split_once("<=")
        .or_else(|| text.split_once('≤'))
        .ok_or_else(|| wrong(&"a quantity and its bound are needed, as in roof-base <= 5mm"))?;
    let part = Part::named(system, name).map_err(|error| wrong(&error))?;
    if part.size == Size::Damping {
        return Err(wrong(
            &"an equivalent damping ratio has no upper bound; leave it out",
        ));
    }
    let most = bound(limit, part.dimension()).map_err(|problem| wrong(&problem))?;
    let has_unit = limit.trim().parse::<f64>().is_err();
    if measure.scale().is_none() && has_unit {
        return Err(wrong(
            &"a bound with a unit needs the load; give --base, --force or --unbalance",
        ));
    }
    // The groups of an optimum are those at r = 1.
    let reference = system.angular_frequency(1.0);
    let unit = measure.convert(part.dimension(), 1.0, reference);
    Ok(Bound {
        text: text.to_owned(),
        most: most / unit,
        part,
    })
}

/// Finds the best friction within the bounds, and returns the lines of the answer.
pub fn lines(
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    bounds: &[Bound],
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let (system, measure) = (table.setting.system, &table.setting.measure);
    let kept: Vec<Kept> = bounds
        .iter()
        .map(|bound| Kept {
            of: bound.part.of,
            size: bound.part.size,
            most: bound.most,
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
                "--keep `{}`: no friction holds this bound{before}; the least value is {} {}, with a friction of {} {}",
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
    let values: Vec<(Part, f64, f64)> = values
        .map(|(bound, largest)| (bound.part.clone(), bound.most, *largest))
        .collect();
    Ok(table.lines_with(&found.optimum, None, &values))
}
