//! A grid of frequencies and frictions with everything needed to write answers over it.

use crate::asked::Part;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::Setting;

/// System, frequencies, frictions, units and motions of a command that answers over a grid.
pub struct Grids {
    /// The system.
    pub system: System,
    /// The frequencies.
    pub frequencies: Frequencies,
    /// The frictions.
    pub frictions: Frictions,
    /// The units of the answers.
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
