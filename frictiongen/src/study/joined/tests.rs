//! Tests of scenes with several contacts, from the text of the scene description to the results.

mod balance;
mod branch;
mod features;
mod free;
mod modes;
mod neighbours;
mod reference;
mod refused;
mod sensitivity;
mod settles;
mod shares;
mod single;
mod stepper;
mod stribeck;
mod undamped;

use crate::System;

/// Description of a frame of two floors with a brace, a pair of friction pads and a dashpot.
pub const FRAME: &str = "struct Frame {
    masses: { lower: 2.0, upper: 1.5 },
    springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    contacts: {
        brace: base - lower { stiffness: 4.0e3 },
        pads: lower - upper { share: 0.6, stiction: 1.2 },
    },
    dampers: { lower - upper: 1.5 },
    damping: modal(0.01),
    excitation: base,
}";

pub fn system(text: &str) -> System {
    text.parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Returns the difference of two numbers, divided by the second number.
pub fn apart(got: f64, expected: f64) -> f64 {
    (got - expected).abs() / expected.abs()
}
