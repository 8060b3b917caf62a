//! Power series in time of a function that describes the contact, such as its relative velocity. A search finds the
//! zeros of the series.

use super::local::{Local, LocalSeries, ORDER, ROUNDINGS, SERIES_REACH, Walked};
use crate::number::scalar::Float;

/// Largest number of terms of a power series. 1/24! is smaller than the rounding unit of every number type for which
/// tables exist.
pub(crate) const TERMS: usize = 24;

/// Upper bound on the number of steps of a search along a power series.
pub(crate) const WALK: u32 = 64;

/// Power series Σ c_n sⁿ in the time s. The size of its first four terms gives a bound on the rounding error of the
/// series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Power<S> {
    pub terms: [S; TERMS],
    pub count: usize,
    /// Sum of the absolute values of all summands that form the first four terms.
    pub size: S,
}

impl<S: Float> Power<S> {
    pub(crate) fn zero(count: usize) -> Self {
        let zero = S::constant(0.0);
        Self {
            terms: [zero; TERMS],
            count,
            size: zero,
        }
    }

    pub(crate) fn slots(&mut self) -> impl Iterator<Item = &mut S> {
        self.terms.iter_mut().take(self.count)
    }

    pub(crate) fn used(&self) -> &[S] {
        self.terms.get(..self.count).unwrap_or(&self.terms)
    }

    pub(crate) fn term(&self, place: usize) -> S {
        self.terms.get(place).copied().unwrap_or(S::constant(0.0))
    }

    /// Returns the function sign·f − level for a search over the length `reach`, where f is this series.
    pub(crate) fn seen(&self, sign: S, level: S, reach: S) -> PowerUpTo<'_, S> {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let mut bound = S::constant(0.0);
        let count = u32::try_from(self.count).unwrap_or(u32::MAX);
        let mut n = S::constant(f64::from(count));
        for term in self.used().iter().skip(3).rev() {
            n = n - one;
            bound = bound * reach + term.abs() * n * (n - one) * (n - two);
        }
        let noise = (self.size + level.abs()) * S::constant(ROUNDINGS * S::EPSILON);
        PowerUpTo {
            power: self,
            sign,
            level,
            reach,
            bound,
            noise,
            most: WALK,
        }
    }

    /// Replaces this series f by g + share·(f − g), where g is another series.
    pub(crate) fn mix(&mut self, other: &Self, share: S) {
        for (term, other) in self.terms.iter_mut().zip(&other.terms) {
            *term = *other + share * (*term - *other);
        }
        self.size = self.size.max(other.size);
    }
}

/// The function sign·f − level, in which a search looks for a zero. f is a power series with a bound on its third
/// derivative.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PowerUpTo<'p, S> {
    power: &'p Power<S>,
    sign: S,
    level: S,
    reach: S,
    bound: S,
    noise: S,
    most: u32,
}

impl<S: Float> PowerUpTo<'_, S> {
    /// Changes the upper bound on the number of steps of a search.
    pub(crate) fn within(self, most: u32) -> Self {
        Self { most, ..self }
    }
}

impl<S: Float> Walked<S> for PowerUpTo<'_, S> {
    fn most(&self) -> u32 {
        self.most
    }

    fn local(&self, tau: S) -> Local<S> {
        let zero = S::constant(0.0);
        let (mut value, mut slope, mut half) = (zero, zero, zero);
        for term in self.power.used().iter().skip(1).rev() {
            half = half * tau + slope;
            slope = slope * tau + value;
            value = value * tau + *term;
        }
        half = half * tau + slope;
        slope = slope * tau + value;
        let first = self.power.term(0) * self.sign - self.level;
        Local {
            value: value * tau * self.sign + first,
            slope: slope * self.sign,
            curve: (half + half) * self.sign,
            bound: self.bound,
        }
    }

    fn series(&self, value: S, slope: S) -> LocalSeries<S> {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let mut terms = [zero; ORDER];
        let (mut factorial, mut order) = (self.sign, one);
        let used = self.power.used().iter().skip(1);
        for (term, from) in terms.iter_mut().skip(1).zip(used) {
            factorial = factorial * order;
            *term = *from * factorial;
            order = order + one;
        }
        let [first, second, ..] = &mut terms;
        (*first, *second) = (value, slope);
        // The neglected terms are smaller than rounding. If the motion advances by at most a radian, the terms decrease
        // as 1/n!.
        LocalSeries::new(terms, S::constant(SERIES_REACH))
    }

    fn noise(&self) -> S {
        self.noise
    }

    fn reach(&self) -> S {
        self.reach
    }
}
