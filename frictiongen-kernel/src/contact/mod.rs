//! The contact at one frequency, with its sums over all modes, both limits, and the regime.
//!
//! [`sums`] has V, U, G, H and H_c, and [`pairs`] evaluates them over two modes at once. `dominant` leaves out the
//! terms that cancel for the mode that outweighs the others. [`limits`] has the formulas of both limits. For limits
//! without search there are two faster ways: [`driven`] for an undamped chain whose constants are gathered beforehand,
//! and `several` for frequencies side by side. [`constraint`] has the search for the exact limit, and decides whether a
//! motion is admitted. [`absorber`] treats common zeros of V and H. The module `response` computes motions of masses.

pub mod absorber;
pub mod constraint;
pub(crate) mod dominant;
pub mod driven;
pub mod limits;
pub mod pairs;
pub mod regime;
pub(crate) mod several;
pub mod sums;
