//! Units of the answers of scenes with several contacts.

/// Units of the answers, expressed in the units of the description.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnswerUnits {
    /// The unit of forces and frictions.
    pub force: f64,
    /// The unit of displacements.
    pub length: f64,
    /// The unit of velocities.
    pub speed: f64,
}

impl AnswerUnits {
    /// Returns the unit of energies.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.force * self.length
    }
}
