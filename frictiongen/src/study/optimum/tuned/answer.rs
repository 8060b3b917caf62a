//! The request and the result of a search for the best friction together with one number of the scene description.

use super::number::Tunable;
use crate::study::optimum::Optimum;
use crate::study::system::System;

/// A number of the scene description that the search varies together with the friction, and the interval of its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The varied number of the scene description.
    pub of: Tunable,
    /// Lower bound of the interval, in the unit of the varied number.
    pub from: f64,
    /// Upper bound of the interval, in the unit of the varied number.
    pub to: f64,
}

/// The best friction at one value of the varied number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedPoint {
    /// Value of the varied number at this point.
    pub value: f64,
    /// The best friction ratio β, with m₁ and k₁ of the scene description. NaN if no best friction exists.
    pub beta: f64,
    /// The largest amplitude over the band with this friction, divided by P/k₁ (by Y for base motion), with k₁ of the
    /// scene description. The amplitude is infinite if no friction bounds it. The amplitude is NaN if the search
    /// reached its bound on work or was stopped before it found any friction.
    pub amplitude: f64,
}

/// The friction and the value of the varied number that together make the largest amplitude over a band of frequencies
/// smallest.
#[derive(Clone, Debug)]
pub struct TunedOptimum {
    /// The best value of the varied number.
    pub value: f64,
    /// True if the best value of the varied number is a bound of its interval. A value outside the interval may then be
    /// better.
    pub at_end: bool,
    /// The scene with the best value of the varied number.
    pub system: System,
    /// The best friction at the best value of the varied number. Its groups r, β and x̄ refer to m₁ and k₁ of the
    /// original scene description. Use the original description to convert them to Hz, N and m.
    pub optimum: Optimum,
    /// The best friction at all scanned values of the varied number, in ascending order of the values. The list shows
    /// the influence of the number.
    pub scan: Vec<TunedPoint>,
    /// Total number of amplitudes that the search computed.
    pub evaluations: usize,
}
