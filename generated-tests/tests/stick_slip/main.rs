//! Stick-slip motion in time and its steady states.

mod known;
mod reference;
