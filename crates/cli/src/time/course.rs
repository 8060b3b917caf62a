//! Settings of a motion over time: frequency, friction, units, and the list of motions.

use crate::asked::MovingPart;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::columns::{
    Frequency, FrequencyUnit, FrictionSetting, HistoryTable, Setting,
};

/// Settings of a motion over time: frequency, friction, units, and the motions in the output.
pub struct RunSettings<'a> {
    /// The system whose motion the output contains.
    pub system: &'a System,
    /// Unit in which the user gave the frequency.
    pub unit: FrequencyUnit,
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction in the contact, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the output contains.
    pub parts: Vec<MovingPart>,
    /// True if the output contains times in seconds next to the phase τ.
    pub in_seconds: bool,
}

impl RunSettings<'_> {
    /// Returns the tables of samples and events, with the units of this motion over time.
    pub fn table(&self) -> HistoryTable<'_> {
        HistoryTable {
            setting: Setting {
                parts: &self.parts,
                ..Setting::new(self.system, self.measure, self.unit)
            },
            at: self.frequency,
            in_seconds: self.in_seconds,
        }
    }
}
