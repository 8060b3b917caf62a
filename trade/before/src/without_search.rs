//! Computes limits without search. The earlier commit has no function for them, so they are computed by way of `at`.

use crate::methods::Pair;
use frictiongen::{FrictionSystem, LimitsAt};

/// Computes both limits at the frequency ratio r, without search.
pub fn limits<F: FrictionSystem>(system: &F, r: F::Scalar) -> Option<Pair<F::Scalar>> {
    let at = system.at(r).ok()?;
    Some([at.continuous_limit_without_search(), at.sliding_limit()])
}
