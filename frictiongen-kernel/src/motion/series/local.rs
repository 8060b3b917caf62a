//! A function between two events as a walk needs it: its derivatives at an instant, or its series from the start.

use crate::number::scalar::Float;

/// Rounding bound of a sum over modes, in roundings of the sum of its terms' sizes.
pub(crate) const ROUNDINGS: f64 = 4.0;
/// Length over which a series serves, in radians of the fastest oscillator.  The terms left out, of the order 0.03⁹/9!,
/// are below rounding.
pub(crate) const SERIES_REACH: f64 = 0.03;

/// Upper bound on the steps of a walk along one segment.  A segment that needs more continues in another segment.
pub const MAX_STEPS: u32 = 4000;

/// Value and derivatives of a function at one instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local<S> {
    pub value: S,
    pub slope: S,
    pub curve: S,
    /// Upper bound on |f‴| from this instant on, over the reach.
    pub bound: S,
}

/// Number of derivatives in a series, including the value.
pub(crate) const ORDER: usize = 9;

/// A function by its derivatives at the start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LocalSeries<S> {
    terms: [S; ORDER],
    /// Length up to which the terms left out are below rounding.
    pub reach: S,
}

impl<S: Float> LocalSeries<S> {
    /// Creates a series from the derivatives at the start.  Beyond `reach` the terms left out exceed rounding.
    pub(crate) fn new(terms: [S; ORDER], reach: S) -> Self {
        Self { terms, reach }
    }

    /// Value, slope and curvature at τ.
    pub(crate) fn at(&self, tau: S, bound: S) -> Local<S> {
        // The terms are written out, because in a loop the reciprocals would be double-precision divisions on the
        // target.
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

    /// The derivative of this order at the start.
    pub(crate) fn term(&self, order: usize) -> S {
        self.terms.get(order).copied().unwrap_or(S::constant(0.0))
    }
}

/// A function that a walk follows.
pub(crate) trait Walked<S> {
    /// Upper bound on the steps of a walk along the function.
    const MOST: u32 = MAX_STEPS;
    /// Value and derivatives of the function at τ, with a bound on its third derivative from τ on.
    fn local(&self, tau: S) -> Local<S>;
    /// Series of the function shortly after the start, for a value and a slope that are known better than by
    /// evaluation.
    fn series(&self, value: S, slope: S) -> LocalSeries<S>;
    /// Rounding noise of a value.
    fn noise(&self) -> S;
    /// Length in τ over which the function is searched.
    fn reach(&self) -> S;
}
