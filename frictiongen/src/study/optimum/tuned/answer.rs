//! The best friction together with one number: what may be asked and what is told.

use super::number::Tunable;
use crate::study::optimum::Optimum;
use crate::study::system::System;

/// A number that is chosen together with the friction, and between which values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The number.
    pub of: Tunable,
    /// The smallest value, in its own unit.
    pub from: f64,
    /// The largest.
    pub to: f64,
}

/// The best friction at one value of the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedPoint {
    /// The value.
    pub value: f64,
    /// The best friction there, as β of the scene as it is described; NaN where there is none.
    pub beta: f64,
    /// The largest amplitude with it, over P/k₁ of the scene as it is described, for base motion over Y; infinite where no
    /// friction bounds it, NaN where the search found none before its work was done.
    pub amplitude: f64,
}

/// The friction and the value of one number that keep the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct TunedOptimum {
    /// The value of the number.
    pub value: f64,
    /// Whether it is an end of its interval: beyond, it may be better still.
    pub at_end: bool,
    /// The scene with this value.
    pub system: System,
    /// The best friction with this value. Its groups are those of the scene as it is *described*: r, β and amplitudes turn
    /// into Hz, N and m by that scene, whose m₁ and k₁ they refer to.
    pub optimum: Optimum,
    /// The best friction at the values that were looked at first, ascending: how much the number matters.
    pub scan: Vec<TunedPoint>,
    /// How many amplitudes were computed in all.
    pub evaluations: usize,
}
