//! Interpolation of the input between samples.

/// Interpolation of a stepper's input between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// Zero-order hold: a force keeps its value, and the base its velocity, from the start of the step.
    Hold,
    /// A force follows a straight line to its value at the end of the step. The base follows the cubic with the
    /// displacements and velocities at both end points.
    Linear,
}
