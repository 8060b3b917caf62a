//! A grid of frequencies and frictions, with the settings for answers over the grid.

use crate::asked::Part;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::Setting;

/// System, frequencies, frictions, units and motions of a command that answers over a grid.
pub struct Grids {
    /// The system that the answers describe.
    pub system: System,
    /// Frequencies for which the answers are computed.
    pub frequencies: Frequencies,
    /// Frictions for which the answers are computed.
    pub frictions: Frictions,
    /// Units of the answers: SI units under a load, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the answers contain.
    pub parts: Vec<Part>,
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
