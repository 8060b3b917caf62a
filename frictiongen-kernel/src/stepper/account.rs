//! Work and energy.

/// What the load has done since the start, and where it went, in the scene's unit of force times its unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Work<S> {
    /// The work of the forces and of the moving base.
    pub load: S,
    /// What friction took.
    pub friction: S,
    /// What modal damping took: what is left of the load's work.
    pub damping: S,
    /// By how much more is stored, in motion and in springs, than at the start.
    pub stored: S,
}
