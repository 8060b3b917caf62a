//! Tests of closed forms: limits, continuous motion and stuck responses, of run-time systems and of emitted code. The
//! references have 40 digits, or come from solutions of the governing equations.

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
