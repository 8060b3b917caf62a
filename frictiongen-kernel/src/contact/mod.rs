//! The contact at one frequency: its sums over all modes, both limits, the regime between them.
//!
//! [`sums`] has V, U, G, H and H_c, [`pairs`] takes them over two modes at once, [`driven`] what limits without search
//! take of an undamped chain, `several` these at frequencies side by side; `dominant` leaves out what cancels of the mode that outweighs the others; [`limits`] the
//! formulas of both limits, [`constraint`] the search that the exact one needs and whether a motion is admitted;
//! [`absorber`] the common zeros of V and H.  Motions of masses are the business of the response.

pub mod absorber;
pub mod constraint;
pub(crate) mod dominant;
pub mod driven;
pub mod limits;
pub mod pairs;
pub mod regime;
pub(crate) mod several;
pub mod sums;
