//! Tests of design studies (curves, maps, sweeps, features, optima), and of random input to every function.

mod answers;
mod combined;
mod desk;
mod features;
mod fuzz;
mod optimum;
mod optimum_short;
mod quantities;
mod tuned_optimum;
