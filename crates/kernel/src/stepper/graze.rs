//! Detects grazes in a stepper with derivatives. A graze is an event whose derivative is unreliable.
//!
//! At an event a function g of the motion crosses zero. The derivative of the event's instant with respect to a
//! variable is −ġ/g′. Here ġ is the derivative of g with respect to the variable, and g′ its derivative with respect to
//! time. An error δ of g shifts the instant by δ/g′, and therefore changes g′ by g″δ/g′. The relative error of the
//! derivative is g″δ/g′². In a graze, g′ is almost 0 at the crossing, and this relative error becomes large.

use super::Store;
use super::interval::StepInterval;
use super::law::StepContact;
use super::table::StepTables;
use super::types::Stepper;
use crate::motion::{Law, Power};
use crate::number::scalar::Float;

/// Error δ of a function of the motion, divided by the sum of the absolute values of the function's terms. The value is
/// the rounding error of an input in `f64`.
const ROUNDED: f64 = f64::EPSILON;
/// Largest permitted relative error of the derivative of an event's instant. With a larger error, the event is a graze
/// (an event whose derivative is unreliable).
const BOUND: f64 = 1e-6;
/// Largest difference between a contact force and μF at which rounding may decide whether the contact slides, divided
/// by μF.
const MARGINAL: f64 = 1e-12;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Records a graze (an event whose derivative is unreliable). An event is a graze if `sum` crosses `level` at the
    /// instant `tau` so slowly that the derivative of this instant has a relative error above [`BOUND`]. For numbers
    /// without derivatives the function does nothing.
    #[inline]
    pub(super) fn note_crossing(&mut self, sum: &Power<S>, level: S, tau: S) {
        if !S::CARRIES {
            return;
        }
        let zero = S::constant(0.0);
        let (mut value, mut slope, mut half) = (zero, zero, zero);
        for term in sum.used().iter().rev() {
            half = half * tau + slope;
            slope = slope * tau + value;
            value = value * tau + *term;
        }
        let curve = (half + half).abs();
        let size = sum.size + level.abs();
        let error = curve * size * S::constant(ROUNDED);
        let is_steep = error < slope * slope * S::constant(BOUND);
        self.status.grazed |= !is_steep;
    }

    /// Records a graze (an event whose derivative is unreliable) if rounding may decide whether the contact sticks or
    /// slides. The contact has zero velocity and the force `force`.
    #[inline]
    pub(super) fn note_choice(&mut self, force: S) {
        if S::CARRIES {
            self.status.grazed |= self.law().is_marginal(force, S::constant(MARGINAL));
        }
    }
}

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns true if a stepper with derivatives has met a graze (an event whose derivative is unreliable). For a
    /// stepper without derivatives the result is false.
    #[doc(hidden)]
    #[must_use]
    pub fn grazed(&self) -> bool {
        self.status.grazed
    }
}
