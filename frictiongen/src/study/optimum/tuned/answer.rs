//! The request and the result of the best friction together with one number.

use super::number::Tunable;
use crate::study::optimum::Optimum;
use crate::study::system::System;

/// A number that is chosen together with the friction, and its interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The number that is chosen.
    pub of: Tunable,
    /// The smallest value, in the number's own unit.
    pub from: f64,
    /// The largest value, in the number's own unit.
    pub to: f64,
}

/// The best friction at one value of the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedPoint {
    /// The value of the number.
    pub value: f64,
    /// The best friction, as β of the scene as it is described. NaN where there is none.
    pub beta: f64,
    /// The largest amplitude with this friction, over P/k₁ of the scene as it is described, for base motion over Y. It
    /// is infinite where no friction bounds the amplitude. NaN means that the search met its bound on work before it
    /// found any friction.
    pub amplitude: f64,
}

/// The friction and the value of one number that keep the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct TunedOptimum {
    /// The best value of the number.
    pub value: f64,
    /// True if the best value is a bound of the interval. A value beyond the bound may be better.
    pub at_end: bool,
    /// The scene with this value.
    pub system: System,
    /// The best friction with this value. Its groups are those of the scene as it is *described*. That scene's m₁ and
    /// k₁ convert r, β and amplitudes to Hz, N and m.
    pub optimum: Optimum,
    /// The best friction at the values of the scan, ascending. It shows how much the number matters.
    pub scan: Vec<TunedPoint>,
    /// Total number of amplitudes that were computed.
    pub evaluations: usize,
}
