//! Number types and elementary functions, from which all other modules build their formulas.
//!
//! The number types are `f64` and `f32` ([`scalar`]), double-double with about 31 digits ([`dd`]), and dual numbers,
//! which carry a derivative ([`dual`]). The functions are complex operations, trigonometry of angles in half-turns,
//! phases reduced to one cycle, and functions that stay accurate even if a plain difference would cancel ([`special`]).
//! The module knows nothing of masses and springs.

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
