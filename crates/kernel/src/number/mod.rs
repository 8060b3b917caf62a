//! Number types and elementary functions, from which all other modules build their formulas.
//!
//! The number types are `f64` and `f32` ([`scalar`]), double-double with about 31 digits ([`dd`]), and dual numbers,
//! which contain a derivative ([`dual`]). Some functions compute with complex numbers, with angles in half-turns, and
//! with phases. Others stay accurate even if a plain difference would cancel ([`special`]). The module contains nothing
//! about masses and springs.

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
