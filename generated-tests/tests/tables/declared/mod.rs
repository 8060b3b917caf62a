//! Compares tables of declared accuracy with the exact results, at points that the builder of the tables did not use.

mod accuracy;
mod bad_input;
mod emitted;
mod emitted_stuck;
mod exact;
mod held_chain;
mod proven;
mod random;
mod scenes;
mod smaller;
mod standalone;
mod stuck;
mod verified;
