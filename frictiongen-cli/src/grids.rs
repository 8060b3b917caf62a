//! Grid of frequencies and frictions, with the settings for results at its points.

use crate::asked::MovingPart;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::Setting;

/// System, frequencies, frictions, units and motions of a command that computes at each point of a grid.
pub struct Grids {
    /// The system that the answers describe.
    pub system: System,
    /// Frequencies of the results.
    pub frequencies: Frequencies,
    /// Frictions of the results.
    pub frictions: Frictions,
    /// Units of the results: SI units under a load, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the results contain.
    pub parts: Vec<MovingPart>,
}

impl Grids {
    /// Returns the settings for the tables of the library.
    pub fn setting(&self) -> Setting<'_> {
        Setting {
            system: &self.system,
            measure: self.measure,
            frequency: self.frequencies.unit(),
            frequencies: self.frequencies.given(),
            frictions: self.frictions.given(),
            forces: self.frictions.are_forces(),
            parts: &self.parts,
        }
    }

    /// Returns the number of points: frequencies times frictions.
    pub fn len(&self) -> usize {
        self.frequencies.len().saturating_mul(self.frictions.len())
    }
}
