//! Tests of the command line. Each test runs the program as a user would.

mod bad_input;
mod common;
mod compile;
mod curve;
mod curve_refused;
mod diff;
mod drive;
mod drive_joined;
mod elastic;
mod expand;
mod export;
mod features;
mod first_hour;
mod first_steps;
mod hints;
mod joined;
mod limits;
mod map;
mod mistakes;
mod optimum;
mod orbit;
mod periodic;
mod play;
mod quantities;
mod recorded;
mod records;
#[cfg(feature = "report")]
mod report;
mod response;
mod sensitivity;
mod time;
mod time_refused;
mod time_stribeck;
mod units;
mod units_refused;
mod width;
