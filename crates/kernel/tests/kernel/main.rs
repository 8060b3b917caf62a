//! Tests of the kernel's public functions.

mod constraint;
mod phases;
mod ranges;
mod scalar;
