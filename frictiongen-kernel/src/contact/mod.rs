//! The contact at one frequency: its sums over all modes, both limits, the regime between them.
//!
//! [`sums`] has V, U, G, H and H_c; [`pairs`] takes them over two modes at once; `dominant` leaves out what cancels of
//! the mode that outweighs the others. [`limits`] has the formulas of both limits. Without search, [`driven`] has them
//! for an undamped chain whose constants are laid out, `several` for frequencies side by side. [`constraint`] is the
//! search that the exact limit needs, and whether a motion is admitted; [`absorber`] the common zeros of V and H.
//! Motions of masses are the business of the response.

pub mod absorber;
pub mod constraint;
pub(crate) mod dominant;
pub mod driven;
pub mod limits;
pub mod pairs;
pub mod regime;
pub(crate) mod several;
pub mod sums;
