//! Law of an elastic contact: a spring in series with a slider (Jenkins element).
//!
//! The force is f = (z̄ − q)/ρ, with the relative displacement z̄ of the contact, the displacement q of the slider and
//! the compliance ρ = k₁/k of the spring. The slider rests while |f| ≤ μβ, where β is the friction ratio and μ the
//! ratio of static to kinetic friction. The contact then *sticks*, and the force f is a function of z̄. While the
//! slider moves, |f| is β. The slider stops at the instant at which the velocity z̄′ vanishes.
//!
//! For a stuck contact the code stores the force f. The displacement q = z̄ − ρf of the slider follows from this
//! force. With a stiff spring, z̄ − q is a small difference. If the code stored q instead, the code would get f with
//! few digits.

mod derivative;
mod on_chain;

use crate::contact::sums::Chain;

/// Constants of a chain whose contact is elastic.
#[derive(Clone, Copy, Debug)]
pub struct ElasticChain<S> {
    /// Constants of the chain, which do not depend on the law of the contact.
    pub chain: Chain<S>,
    /// Compliance ρ of the spring in series with the slider: k₁ divided by the stiffness of this spring.
    pub compliance: S,
}
