//! The request and the result of a search for the best friction together with one number of the description.

use super::number::Tunable;
use crate::study::optimum::Optimum;
use crate::study::system::System;

/// A number of the description that is optimised together with the friction, and the interval of its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The number of the description that is optimised.
    pub of: Tunable,
    /// Lower bound of the interval, in the own unit of the optimised number.
    pub from: f64,
    /// Upper bound of the interval, in the own unit of the optimised number.
    pub to: f64,
}

/// The best friction for one value of the optimised number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedPoint {
    /// The value of the optimised number.
    pub value: f64,
    /// The best friction ratio β, in the groups of the scene as it is described. NaN if no best friction exists.
    pub beta: f64,
    /// The largest amplitude over the band with this friction, in units of P/k₁ (for base motion Y) of the scene as it
    /// is described. It is infinite if no friction bounds the amplitude. NaN means that the search reached its bound on
    /// work before it found any friction.
    pub amplitude: f64,
}

/// The friction and the value of one number that together give the smallest peak over a band of frequencies.
#[derive(Clone, Debug)]
pub struct TunedOptimum {
    /// The best value of the optimised number.
    pub value: f64,
    /// True if the best value is a bound of the interval. A value outside the interval may then be better.
    pub at_end: bool,
    /// The scene with the best value of the optimised number.
    pub system: System,
    /// The best friction with the best value. Its groups refer to the scene as it is *described*. The described m₁ and
    /// k₁ convert r, β and amplitudes to Hz, N and m.
    pub optimum: Optimum,
    /// The best friction at all scanned values of the optimised number, in ascending order. The list shows how much the
    /// number matters.
    pub scan: Vec<TunedPoint>,
    /// Total number of amplitudes that the search computed.
    pub evaluations: usize,
}
