//! Tests of the command line. Each test runs the program as a user would.

mod bad_input;
mod common;
mod compile;
mod curve;
mod curve_refused;
mod drive;
mod expand;
mod features;
mod features_page;
mod first_hour;
mod first_steps;
mod fuzz;
mod limits;
mod map;
mod measure_page;
mod optimum;
mod orbit;
mod recorded;
#[cfg(feature = "report")]
mod report;
mod response;
mod sensitivity;
mod start_page;
mod stick_slip_page;
mod time;
mod time_refused;
mod time_stribeck;
mod units;
mod units_refused;
