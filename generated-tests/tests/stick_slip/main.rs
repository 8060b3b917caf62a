//! Stick-slip motion in time and its steady states.

mod reference;
