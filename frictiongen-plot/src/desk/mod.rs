//! Figures of the results of a [`System`](frictiongen::System): curves, regimes, maps, motions over time, and a sketch
//! of the system.

mod curves;
mod map;
mod motions;
mod phases;
mod regimes;
mod scales;
mod sketch;

pub use curves::{Drawn, Reading, curve_figure, keys, keys_of, lines, panel};
pub use map::{Shade, map_figure, map_panel};
pub use motions::{history_figure, spectrum_figure};
pub use phases::{folded, phase_ends, principal};
pub use regimes::{limit_lines, regimes};
pub use scales::Scales;
pub use sketch::{sketch, sketch_under_record};
