//! Units of the results of scenes with several contacts.

/// Units of the results of a scene with several contacts, expressed in the units of the scene description.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnswerUnits {
    /// Unit of the forces and frictions in the results.
    pub force: f64,
    /// Unit of the displacements in the results.
    pub length: f64,
    /// Unit of the velocities in the results.
    pub speed: f64,
}

impl AnswerUnits {
    /// The units of the scene description.
    pub(super) const OF_SCENE: Self = Self {
        force: 1.0,
        length: 1.0,
        speed: 1.0,
    };

    /// Returns the unit of energies, the unit of force times the unit of length.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.force * self.length
    }
}
