//! Steady response of a scene at one frequency ratio r, and its motion at one friction ratio β.
//!
//! [`Scene`] provides the constants of a scene, and formulas that a generator may specialise. [`At`] evaluates the sums
//! over the modes at one r, and computes β_lim, β*_lim and the regime from them. [`Continuous`] is the motion at one β
//! if the contact slides all the time. [`Stuck`] is the response while the contact is stuck. Emitted solvers and the
//! run-time system use the same types with their own scenes. This module contains no time integration and no events.

mod at;
mod coefficient_types;
pub mod coefficients;
mod continuous;
pub mod motion;
mod numbers;
mod scene;
mod slices;
mod stuck;

pub use at::{At, MostEvaluations};
pub use continuous::{Continuous, MotionOf, ProvidesMotion};
pub use numbers::{Ends, Numbers};
pub use scene::{Scene, limits_of_sums};
pub use stuck::{ProvidesStuck, Stuck};
