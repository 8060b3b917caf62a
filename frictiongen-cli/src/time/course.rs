//! Settings of a motion over time: frequency, friction, units, and the contact and masses.

use crate::asked::Part;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::{Frequency, FrequencyUnit, Friction, HistoryTable, Setting};

/// Settings of a motion over time: frequency, friction, units, and the contact and masses.
pub struct Course<'a> {
    /// The system.
    pub system: &'a System,
    /// The unit of the frequency.
    pub unit: FrequencyUnit,
    /// The frequency.
    pub frequency: Frequency,
    /// The friction.
    pub friction: Friction,
    /// The units of the answers.
    pub measure: Measure,
    /// The contact and masses whose motions are written.
    pub parts: Vec<Part>,
    /// True if times are written in seconds too.
    pub in_seconds: bool,
}

impl Course<'_> {
    /// Returns the tables of the motion.
    pub fn table(&self) -> HistoryTable<'_> {
        HistoryTable {
            setting: Setting {
                system: self.system,
                measure: self.measure,
                frequency: self.unit,
                frequencies: &[],
                frictions: &[],
                forces: false,
                parts: &self.parts,
            },
            at: self.frequency,
            in_seconds: self.in_seconds,
        }
    }
}
