//! Computes limits without search. These limits are closed formulas, which use the velocity constraint at the reversal
//! in place of its largest value. The program in `before/` has its own version of this file, because its commit has no
//! function for these limits.

use frictiongen::FrictionSystem;

/// Computes both limits at the frequency ratio r, without search.
pub fn limits<F: FrictionSystem>(system: &F, r: F::Scalar) -> Option<[F::Scalar; 2]> {
    let limits = system.limits_without_search(r).ok()?;
    Some([limits.continuous, limits.sliding])
}
