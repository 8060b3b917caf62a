//! Elastic contacts (Jenkins elements): a spring in series with the slider.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panics"
)]

mod bilinear;
mod digits;
mod emitted;
mod energy;
mod features;
mod full_slip;
mod joints;
mod multipliers;
mod named;
mod random;
mod refused;
mod rigid_limit;
mod sensitivities;
mod steady;
mod stepper;
