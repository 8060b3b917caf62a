//! The steady response of a scene: at one frequency ratio, then at one friction ratio.
//!
//! [`Scene`] is what a scene has to say: its numbers, and the formulas that a generator may have specialised.
//! [`At`] has the sums at one r, and with them both limits and the regime; [`Continuous`] is the motion at one β,
//! [`Stuck`] the response with the contact stuck.  Emitted solvers and the run-time system are these types, over
//! their own scenes.  Nothing here knows of time, events or text.

mod at;
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
