//! Tests of the examples.

mod facts;
mod gallery;
mod several;
mod two_stops;
