//! Closed forms: limits, continuous motion, stuck responses, at run time and emitted, against references of 40 digits and against the governing equations.

mod absorber;
mod closed_form;
mod corrections;
mod domain;
mod doors;
mod edges;
mod large;
mod readings;
mod rounded_once;
mod search;
mod static_start;
mod stuck;
mod weak_coupling;
