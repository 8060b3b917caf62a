//! Tests of stick-slip motion in time, and of its steady states.

mod above;
mod amplitudes;
mod cycle_energy;
mod edges;
mod emitted;
mod errors;
mod events;
mod from_rest;
mod independent;
mod known;
mod multipliers;
mod offcentre;
mod plain;
mod reference;
mod runs;
mod several;
mod slow;
