//! Limits without search: `before/` has this file of its own, as its commit knows no function for them.

use crate::methods::Pair;
use frictiongen::FrictionSystem;

/// Both limits at r.
pub fn limits<F: FrictionSystem>(system: &F, r: F::Scalar) -> Option<Pair<F::Scalar>> {
    let limits = system.limits_without_search(r).ok()?;
    Some([limits.continuous, limits.sliding])
}
