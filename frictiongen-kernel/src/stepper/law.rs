//! The law of a contact within a step, while the contact sticks.

use super::interval::StepInterval;
use crate::motion::ContactChain;
use crate::number::scalar::Float;

/// A chain whose contact a stepper can follow.
pub trait StepContact<S: Float>: ContactChain<S> {
    /// The force in the sticking contact over a sub-interval, as a polynomial, without the share of the stuck chain's
    /// modes.
    fn stuck_force_terms<const D: usize>(interval: &StepInterval<'_, '_, S, D, Self>) -> [S; 4];
}
