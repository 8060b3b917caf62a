//! What acts on a chain over time: forces, the base's motion, and the level of each contact.

use super::{Series, whole};
use crate::number::scalar::Float;

/// Forces on the masses, displacement of the base and friction level of each contact, as functions of time.
///
/// Each function writes power series about the instant `t`.  The coefficient of order n is the n-th derivative times
/// `span`ⁿ/n!.  A function that does not write leaves zeros.
pub trait Drive<T: Float> {
    /// Writes the displacement of the base.
    fn base(&self, t: T, span: T, series: &mut Series<T>) {
        let _ = (t, span, series);
    }
    /// Writes the force on a mass.
    fn force(&self, mass: usize, t: T, span: T, series: &mut Series<T>);
    /// Writes the kinetic friction force of a contact.  A contact whose level is 0 or below transmits no force.
    fn level(&self, joint: usize, t: T, span: T, series: &mut Series<T>);
    /// Returns a bound on the angular frequencies of all functions.
    fn rate(&self) -> T;
    /// Returns the first instant after `t` at which a function jumps or bends, if there is one.
    fn bend_after(&self, t: T) -> Option<T> {
        let _ = t;
        None
    }
}

/// Adds amplitude·cos(ωt + phase) to a series about `t`, for `half_turns` = (ωt + phase)/π and `angle` = ω·span.
///
/// ```
/// use frictiongen_kernel::joints::{TERMS, harmonic};
///
/// let mut series = [0.0; TERMS];
/// harmonic(2.0, 0.0, 0.5, &mut series);
/// let value = series.iter().rev().fold(0.0, |sum, term| sum * 0.8 + term);
/// assert!((value - 2.0 * 0.4f64.cos()).abs() < 1e-15);
/// ```
pub fn harmonic<T: Float>(amplitude: T, half_turns: T, angle: T, series: &mut Series<T>) {
    let (sine, cosine) = half_turns.sin_cos_pi();
    let (mut term, mut next) = (amplitude * cosine, -(amplitude * sine));
    for (n, coefficient) in series.iter_mut().enumerate() {
        *coefficient = *coefficient + term;
        let factor = angle / whole(n + 1);
        (term, next) = (next * factor, -(term * factor));
    }
}
