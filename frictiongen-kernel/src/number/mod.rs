//! Number types and elementary functions, of which the formulas of all other modules consist.
//!
//! The number types are `f64` and `f32` ([`scalar`]), double-double with about 31 digits ([`dd`]), and dual numbers,
//! which carry a derivative ([`dual`]). The functions are complex operations, trigonometry of angles in half-turns,
//! phases reduced to one cycle, and functions that stay accurate where a plain difference would cancel ([`special`]).
//! This module does not use masses or springs.

pub mod complex;
pub mod dd;
pub mod dual;
mod euler;
mod float;
pub(crate) mod lanes;
pub(crate) mod matrix;
pub(crate) mod pairs;
pub(crate) mod phase;
pub mod scalar;
pub mod special;
pub mod trig;
