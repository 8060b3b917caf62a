//! Stick-slip motion in time and its steady states.

mod amplitudes;
mod emitted;
mod energy;
mod events;
mod known;
mod multipliers;
mod reference;
mod two_stops;
