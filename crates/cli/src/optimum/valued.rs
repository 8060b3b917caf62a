//! A quantity in the options of `frictiongen optimum`, with a value. The value is an upper bound on the quantity, or
//! the number by which the quantity is divided.

use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::bound;
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

impl QuantityArgument {
    /// Parses a name and a value. `wrong` converts an error to a failure, whose message contains the name and the text
    /// of the option.
    pub fn parsed(
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
