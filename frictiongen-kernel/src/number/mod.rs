//! Numbers: the scalar over which every formula is written, and the functions that formulas need of it.
//!
//! `f64` and `f32` ([`scalar`]), double-double ([`dd`]), numbers with a derivative ([`dual`]); complex operations,
//! half-turn trigonometry, phases brought into one cycle, and functions that keep their digits where a plain difference
//! would lose them ([`special`]).  Nothing here knows of masses or springs.

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
