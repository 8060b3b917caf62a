//! Trait of the chains whose contact a stepper can follow: a rigid or an elastic contact. The trait provides the force
//! in the contact while the contact sticks.

use super::interval::StepInterval;
use crate::motion::ContactChain;
use crate::number::scalar::Float;

/// Trait of the chains whose contact a stepper can follow.
pub trait StepContact<S: Float>: ContactChain<S> {
    /// Returns the force that keeps the contact stuck in a sub-interval, as a polynomial in time. The result does not
    /// contain the contribution of the stuck chain's modes to this force.
    fn stuck_force_terms<const D: usize>(interval: &StepInterval<'_, '_, S, D, Self>) -> [S; 4];
}
