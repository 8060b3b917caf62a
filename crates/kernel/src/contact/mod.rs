//! Contact of the chain at one frequency: modal sums, limits of continuous and stuck motion, and the regime.
//!
//! * [`sums`] defines the modal sums V, U, G, H and H_c, and [`pairs`] evaluates them for two modes at the same time.
//! * [`quadrature`] has the load that damping relative to a moving base adds, and `load` computes the responses to all
//!   loads.
//! * `dominant` leaves out the largest modal terms where they would cancel.
//! * [`limits`] has the formulas of the limits β_lim and β*_lim.
//! * [`driven`] (for undamped chains) and `several` (for several frequencies at the same time) compute the limits
//!   faster, if no search for S is needed.
//! * [`constraint`] searches for the velocity constraint S of the exact limit, and decides whether a continuous motion
//!   exists.
//! * [`absorber`] covers the frequencies at which V and H are both zero.
//!
//! The module `response` computes the motions of the masses.

pub mod absorber;
pub mod constraint;
pub(crate) mod dominant;
pub mod driven;
pub mod limits;
mod load;
pub mod pairs;
pub mod quadrature;
pub mod regime;
pub(crate) mod several;
pub mod sums;
