//! The law of an elastic contact: a spring in series with a slider (Jenkins element).
//!
//! The force is f = (z̄ − q)/ρ, with the place q of the slider and the compliance ρ = k₁/k of the spring.  While
//! |f| ≤ μβ the slider rests: the contact *sticks*, and its force follows the motion.  A slider that moves keeps |f| = β.
//! It stops where the velocity z̄′ vanishes.
//!
//! A contact that sticks remembers its force f, and q = z̄ − ρf follows from it.  The other way around, f would lose
//! digits with a stiff spring, because z̄ − q is then a small difference.

mod derivative;
mod on_chain;

use crate::contact::sums::Chain;

/// Constants of a chain whose contact is elastic.
#[derive(Clone, Copy, Debug)]
pub struct ElasticChain<S> {
    /// Constants of the chain.
    pub chain: Chain<S>,
    /// Compliance ρ of the spring in series with the slider: k₁ over its stiffness.
    pub compliance: S,
}
