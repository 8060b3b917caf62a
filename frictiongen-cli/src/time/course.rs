//! Settings of a motion over time: frequency, friction, units, and the contact and masses.

use crate::asked::MovingPart;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::{
    Frequency, FrequencyUnit, FrictionSetting, HistoryTable, Setting,
};

/// Settings of a motion over time: frequency, friction, units, and the contact and masses.
pub struct RunSettings<'a> {
    /// The system that the answers describe.
    pub system: &'a System,
    /// Unit in which the user gave the frequency.
    pub unit: FrequencyUnit,
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction in the contact, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Units of the answers: SI units under a load, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the output contains.
    pub parts: Vec<MovingPart>,
    /// True if the output has times in seconds as well.
    pub in_seconds: bool,
}

impl RunSettings<'_> {
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
