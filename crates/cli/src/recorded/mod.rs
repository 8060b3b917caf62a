//! Commands that evaluate recordings: `transmissibility`, `identify`, `fit`, `drive`.

mod decay;
#[cfg(feature = "pictures")]
mod draw;
mod drive;
mod driven;
mod fit;
mod identify;
mod lines;
mod peaks;
mod read;
pub mod signals;
mod spectrum;
mod transmissibility;

pub use drive::run as drive;
pub use fit::run as fit;
pub use identify::run as identify;
pub use transmissibility::run as transmissibility;
