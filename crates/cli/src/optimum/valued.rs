//! The quantities with values in the options of `frictiongen optimum`: bounds, as in `--keep 'roof-base <= 5mm'`, and
//! divisors, as in `--of roof/5mm --of 'accel(roof)/2m/s2'`.

use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::bound;
use frictiongen::study::optimum::QuantityValue;
use frictiongen::study::response::MotionQuantity;
use std::fmt::Display;

/// A quantity and its value, which the user gives in one option.
pub struct QuantityArgument {
    /// Name of the quantity.
    pub name: String,
    /// Text of the quantity's value on the command line.
    pub text: String,
    pub part: MovingPart,
    /// The value, converted to the unit of `Optimum::amplitude` for this quantity.
    pub value: f64,
}

/// Parses the upper bounds that `--keep` sets.
pub fn bounds(
    system: &System,
    texts: &[String],
    measure: &Measure,
) -> Result<Vec<QuantityArgument>, Failure> {
    let one = |text: &String| {
        let wrong =
            |problem: &dyn Display| Failure::new(format_args!("--keep `{text}`: {problem}"));
        let both = text.split_once("<=").or_else(|| text.split_once('≤'));
        let both = both
            .ok_or_else(|| wrong(&"a quantity and its bound are needed, as in roof-base <= 5mm"))?;
        QuantityArgument::parsed(system, both, measure, &wrong)
    };
    texts.iter().map(one).collect()
}

/// Parses the quantities in several options `--of`, and the value that divides each quantity.
pub fn quotients(
    system: &System,
    texts: &[String],
    measure: &Measure,
) -> Result<Vec<QuantityArgument>, Failure> {
    let one = |text: &String| {
        let wrong = |problem: &dyn Display| Failure::new(format_args!("--of `{text}`: {problem}"));
        let both = text.split_once('/').ok_or_else(|| {
            wrong(&"each of several quantities needs a value to divide it by, as in roof/5mm")
        })?;
        let valued = QuantityArgument::parsed(system, both, measure, &wrong)?;
        if !(0.0 < valued.value) {
            return Err(wrong(&"the value must be above 0"));
        }
        Ok(valued)
    };
    texts.iter().map(one).collect()
}

/// Returns the quantities with their values, for the search.
pub fn values(all: &[QuantityArgument]) -> Vec<QuantityValue> {
    let values = all.iter().map(|valued| QuantityValue {
        of: valued.part.of,
        size: valued.part.size,
        value: valued.value,
    });
    values.collect()
}

/// Returns the quantities with their values, for the lines of the result.
pub fn parts(all: &[QuantityArgument]) -> Vec<(MovingPart, f64)> {
    let parts = all.iter().map(|one| (one.part.clone(), one.value));
    parts.collect()
}

impl QuantityArgument {
    /// Parses a name and a value. `wrong` converts an error to a failure, whose message contains the name and the text
    /// of the option.
    fn parsed(
        system: &System,
        (name, text): (&str, &str),
        measure: &Measure,
        wrong: &dyn Fn(&dyn Display) -> Failure,
    ) -> Result<Self, Failure> {
        let part = MovingPart::named(system, name).map_err(|error| wrong(&error))?;
        if part.size == MotionQuantity::Damping {
            return Err(wrong(
                &"an equivalent damping ratio has no upper bound; leave it out",
            ));
        }
        let value = bound(text, part.dimension()).map_err(|problem| wrong(&problem))?;
        let has_unit = text.trim().parse::<f64>().is_err();
        if measure.scale().is_none() && has_unit {
            return Err(wrong(
                &"a value with a unit needs the load; give --base, --force or --unbalance",
            ));
        }
        // The amplitudes in the result of the search are non-dimensional, and refer to the load at r = 1. The code
        // therefore converts the value with the load at r = 1.
        let reference = system.angular_frequency(1.0);
        let unit = measure.convert(part.dimension(), 1.0, reference);
        Ok(Self {
            name: name.trim().to_owned(),
            text: text.trim().to_owned(),
            value: value / unit,
            part,
        })
    }
}
