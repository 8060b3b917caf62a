//! What stands before the numbers: which scene, its natural frequencies, its groups.

use crate::number::computed;
use frictiongen::System;
use frictiongen::study::Scene;
use std::io::{self, Write};

/// The most natural frequencies in the preamble of a table.
const MOST_SHOWN: usize = 8;

/// What stands before the numbers.
#[derive(Clone, Debug)]
pub struct Summary {
    /// The scene's name.
    pub scene: String,
    /// rad/s in the scene's own units, ascending.
    pub natural_frequencies: Vec<f64>,
    /// The frequency ratios of those.
    pub resonances: Vec<f64>,
    contact: String,
    load: Load,
}
