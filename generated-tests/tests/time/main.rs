//! Tests of motion in time: the real-time stepper, and friction laws that depend on the speed.

mod from_base;
mod images;
mod joined;
mod joined_base;
mod joined_orbits;
mod periodic;
mod step_readings;
mod stepper;
mod stribeck;
