//! Computes limits without search. `before/` has its own version of this file, because its commit has no function for
//! them.

use frictiongen::FrictionSystem;

/// Computes both limits at r.
pub fn limits<F: FrictionSystem>(system: &F, r: F::Scalar) -> Option<[F::Scalar; 2]> {
    let limits = system.limits_without_search(r).ok()?;
    Some([limits.continuous, limits.sliding])
}
