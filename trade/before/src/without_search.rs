//! Computes limits without search. These limits are closed formulas, which use the velocity constraint at the reversal
//! in place of its largest value. The earlier commit has no function that returns both limits, so this file calls `at`
//! first.

use crate::methods::Pair;
use frictiongen::{FrictionSystem, LimitsAt};

/// Computes both limits at the frequency ratio r, without search.
pub fn limits<F: FrictionSystem>(system: &F, r: F::Scalar) -> Option<Pair<F::Scalar>> {
    let at = system.at(r).ok()?;
    Some([at.continuous_limit_without_search(), at.sliding_limit()])
}
