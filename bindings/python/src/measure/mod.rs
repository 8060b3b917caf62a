//! Evaluates recordings: transmissibilities, friction forces and scene parameters.

pub mod decay;
pub mod drive;
pub mod fit;
pub mod identify;
mod observed;
mod once;
pub mod recording;
pub mod spectrum;
pub mod transmissibility;
