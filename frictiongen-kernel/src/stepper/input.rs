//! What the input does between samples.

/// What the input does between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// A force stays what it was at the start of the step; the base goes on with the velocity that it had there.
    Hold,
    /// A force moves in a straight line to what it is at the end of the step; the base along the cubic with the
    /// displacements and velocities at both ends.
    Linear,
}
