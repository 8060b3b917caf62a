//! Recordings, and the results from them: transmissibilities, the friction force, parameters.

pub mod decay;
pub mod drive;
mod estimate;
pub mod fit;
pub mod identify;
mod observed;
pub mod recording;
mod residuals;
pub mod transmissibility;
