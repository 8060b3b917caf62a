//! Interpolation of a stepper's input between two samples.

/// Interpolation of a stepper's input between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// Zero-order hold: during a step, a force has a constant value, and the base a constant velocity.
    Hold,
    /// Linear input: during a step, a force changes linearly to its value at the end of the step. The displacement of
    /// the base is the cubic polynomial with the given displacements and velocities at both ends of the step.
    Linear,
}
