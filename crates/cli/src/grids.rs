//! The system, frequencies, frictions, units and motions of a command that computes at each point of a grid.

use crate::asked::MovingPart;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::Setting;

/// System, frequencies, frictions, units and motions of a command that computes at each point of a grid.
pub struct Grids {
    /// The system that the results describe.
    pub system: System,
    /// Frequencies at which the command computes results.
    pub frequencies: Frequencies,
    /// Frictions at which the command computes results.
    pub frictions: Frictions,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the results contain.
    pub parts: Vec<MovingPart>,
}

impl Grids {
    /// Returns the data that the library's tables need: system, units, frequencies, frictions and motions.
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

    /// Returns the number of points: the number of frequencies times the number of frictions.
    pub fn len(&self) -> usize {
        self.frequencies.len().saturating_mul(self.frictions.len())
    }
}
