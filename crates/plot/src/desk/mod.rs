//! Figures of the results of a [`System`](frictiongen::System): curves, regimes, maps, motions over time, and a sketch
//! of the system.

mod branch;
mod curves;
mod joined;
mod joined_map;
mod map;
mod motions;
mod phases;
mod regimes;
mod scales;
mod sketch;

pub use branch::{BranchCurve, branch_figure};
pub use curves::{Drawn, Reading, curve_figure, keys, keys_of, lines, panel};
pub use joined::{
    ContactTrack, JoinedCurve, JoinedMotion, joined_curve_figure, joined_motion_figure,
};
pub use joined_map::{JoinedCells, JoinedClasses, joined_map_figure};
pub use map::{Shade, map_figure, map_panel};
pub use motions::{history_figure, spectrum_figure};
pub use phases::{folded, phase_ends, principal};
pub use regimes::{limit_lines, regimes};
pub use scales::Scales;
pub use sketch::{sketch, sketch_under_record, sketch_without_load};
