//! Commands over recordings: `transmissibility`, `identify`, `fit`.

mod decay;
#[cfg(feature = "pictures")]
mod draw;
mod fit;
mod identify;
mod lines;
mod read;
mod transmissibility;

pub use fit::run as fit;
pub use identify::run as identify;
pub use transmissibility::run as transmissibility;
