//! The law of an elastic contact: a spring in series with a slider (Jenkins element).
//!
//! The force is f = (z̄ − q)/ρ, with the displacement q of the slider and the compliance ρ = k₁/k of the spring.
//! The slider rests while |f| ≤ μβ: the contact *sticks*, and its force follows the motion. While the slider moves, |f|
//! is β. The slider stops where the velocity z̄′ vanishes.
//!
//! A stuck contact stores its force f, from which q = z̄ − ρf follows. If it stored q, f would lose digits with a stiff
//! spring, because z̄ − q is then a small difference.

mod derivative;
mod on_chain;

use crate::contact::sums::Chain;

/// Constants of a chain whose contact is elastic.
#[derive(Clone, Copy, Debug)]
pub struct ElasticChain<S> {
    /// Constants of the chain.
    pub chain: Chain<S>,
    /// Compliance ρ of the spring in series with the slider: k₁ divided by the stiffness of this spring.
    pub compliance: S,
}
