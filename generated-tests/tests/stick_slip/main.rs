//! Stick-slip motion in time and its steady states.

mod amplitudes;
mod edges;
mod emitted;
mod energy;
mod errors;
mod events;
mod independent;
mod known;
mod multipliers;
mod reference;
mod runs;
mod several;
