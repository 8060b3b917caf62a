//! Stick-slip motion in time and its steady states.

mod emitted;
mod known;
mod reference;
