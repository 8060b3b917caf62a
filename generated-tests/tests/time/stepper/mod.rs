//! Tests of the real-time stepper.
//!
//! `plain` is an integrator that shares no code with the stepper. The long tests run with `cargo test --release -p
//! generated-tests --test time stepper:: -- --ignored`.

mod bad_input;
pub mod both;
mod budget;
mod creep;
mod energy;
mod exact;
mod extremes;
mod far;
mod independent;
mod kinds;
mod passive;
pub mod plain;
mod plain_itself;
pub mod rig;
pub mod scenes;
mod start;
mod steady;
mod terms;
