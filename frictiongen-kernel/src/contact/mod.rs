//! The contact of the chain at one frequency: its sums over all modes, the limits of continuous and stuck motion, and
//! the regime.
//!
//! [`sums`] defines the sums V, U, G, H and H_c over the modes, and [`pairs`] evaluates them for two modes at once.
//! [`quadrature`] has the load due to damping relative to a moving base. `dominant` leaves out the largest modal terms
//! where they would cancel. [`limits`] has the formulas of both limits. [`driven`] and `several` evaluate the limits
//! faster where no search for S is wanted. [`driven`] serves an undamped chain, `several` serves several frequencies at
//! once. [`constraint`] searches the velocity constraint S of the exact limit, and decides whether a continuous motion
//! exists. [`absorber`] treats frequencies at which V and H are both zero. The module `response` computes the motions
//! of the masses.

pub mod absorber;
pub mod constraint;
pub(crate) mod dominant;
pub mod driven;
pub mod limits;
pub mod pairs;
pub mod quadrature;
pub mod regime;
pub(crate) mod several;
pub mod sums;
