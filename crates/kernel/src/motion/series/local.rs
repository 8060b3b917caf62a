//! A function of time between two events, in which a search finds zeros. The search uses the derivatives of the
//! function at an instant, or its power series from the start.

use crate::number::scalar::Float;

/// Bound on the rounding error of a sum over modes, as a multiple of the rounding unit times the sum of the absolute
/// values of its terms.
pub(crate) const ROUNDINGS: f64 = 4.0;
/// Largest length of a series of [`ORDER`] terms, in radians of the fastest oscillator. The neglected terms are of the
/// order 0.03⁹/9!, which is smaller than rounding.
pub(crate) const SERIES_REACH: f64 = 0.03;

/// Upper bound on the number of steps of a search along one segment. A segment that needs more steps continues in
/// another segment.
pub const MAX_STEPS: u32 = 4000;

/// Value and derivatives of a function at one instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local<S> {
    pub value: S,
    pub slope: S,
    pub curve: S,
    /// Upper bound on the absolute value of the third derivative, from this instant to the end of the searched
    /// interval.
    pub bound: S,
}

/// Number of terms of a series: the value and eight derivatives.
pub(crate) const ORDER: usize = 9;

/// A function of time, given by its value and derivatives at the start of the searched interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LocalSeries<S> {
    terms: [S; ORDER],
    /// Length in τ within which the neglected terms of the series are below rounding.
    pub reach: S,
}

impl<S: Float> LocalSeries<S> {
    /// Creates a series from the derivatives at the start. At distances of more than `reach`, the neglected terms
    /// exceed rounding.
    pub(crate) fn new(terms: [S; ORDER], reach: S) -> Self {
        Self { terms, reach }
    }

    /// Returns value, slope and curvature of the series at τ. The result contains `bound` as the bound on the third
    /// derivative.
    pub(crate) fn at(&self, tau: S, bound: S) -> Local<S> {
        // The code writes out the terms. In a loop, a microcontroller would compute the reciprocals by divisions in
        // double precision.
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8] = self.terms;
        let [h2, h3, h4, h5, h6, h7, h8] = [
            S::constant(1.0 / 2.0),
            S::constant(1.0 / 3.0),
            S::constant(1.0 / 4.0),
            S::constant(1.0 / 5.0),
            S::constant(1.0 / 6.0),
            S::constant(1.0 / 7.0),
            S::constant(1.0 / 8.0),
        ];
        let horner = |terms: &[(S, S)], last: S| {
            let terms = terms.iter();
            terms.fold(last, |sum, (term, factor)| *term + sum * tau * *factor)
        };
        let one = S::constant(1.0);
        let value = [
            (c7, h8),
            (c6, h7),
            (c5, h6),
            (c4, h5),
            (c3, h4),
            (c2, h3),
            (c1, h2),
            (c0, one),
        ];
        let slope = [
            (c7, h7),
            (c6, h6),
            (c5, h5),
            (c4, h4),
            (c3, h3),
            (c2, h2),
            (c1, one),
        ];
        let curve = [(c7, h6), (c6, h5), (c5, h4), (c4, h3), (c3, h2), (c2, one)];
        let value = horner(&value, c8);
        let slope = horner(&slope, c8);
        let curve = horner(&curve, c8);
        Local {
            value,
            slope,
            curve,
            bound,
        }
    }

    /// Returns the derivative of the given order at the start of the interval.
    pub(crate) fn term(&self, order: usize) -> S {
        self.terms.get(order).copied().unwrap_or(S::constant(0.0))
    }
}

/// A function of time in which a *walk* finds zeros or peaks. A walk is a search in steps that skip no zero.
pub(crate) trait Walked<S> {
    /// Upper bound on the number of steps of one search along the function.
    fn most(&self) -> u32 {
        MAX_STEPS
    }
    /// Returns value and derivatives of the function at τ, with a bound on its third derivative from τ on.
    fn local(&self, tau: S) -> Local<S>;
    /// Returns the power series of the function from the start. The caller passes `value` and `slope` at the start,
    /// because the caller knows these two numbers more accurately.
    fn series(&self, value: S, slope: S) -> LocalSeries<S>;
    /// Returns the rounding error of a value of the function.
    fn noise(&self) -> S;
    /// Returns the length of the searched interval, in τ (rad of the excitation).
    fn reach(&self) -> S;
}
