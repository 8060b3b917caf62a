//! Numbers: the scalar over which every formula is written, and the functions that the formulas need.
//!
//! The scalars are `f64` and `f32` ([`scalar`]), double-double ([`dd`]), and numbers with a derivative ([`dual`]). The
//! functions are complex operations, half-turn trigonometry, phases reduced to one cycle, and functions that keep their
//! digits where a plain difference would lose them ([`special`]). This module knows neither masses nor springs.

pub mod complex;
pub mod dd;
pub mod dual;
mod euler;
mod float;
pub(crate) mod lanes;
pub(crate) mod pairs;
pub(crate) mod phase;
pub mod scalar;
pub mod special;
pub mod trig;
