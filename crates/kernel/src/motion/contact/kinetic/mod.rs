//! The kinetic friction force as a function of the speed: one constant force, or straight lines between points.

mod coupled;
mod line;
mod lines;
mod segment;

pub use coupled::MAX_STEEPNESS;
pub use lines::{Constant, KineticLaw, Lines};

pub(crate) use line::{KineticLine, line, place as line_at, steepest};
