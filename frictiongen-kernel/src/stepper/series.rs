//! A function of the contact as a power series about an instant, in the way in which a walk follows it.

use super::TERMS;
use crate::number::scalar::Float;
use crate::simulation::{Local, ORDER, Series, Walked};

/// Σ c_n sⁿ, and what rounding can do to its first terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Power<S> {
    pub terms: [S; TERMS],
    pub count: usize,
    /// The sum of the sizes of what its first terms are made of.
    pub size: S,
}

impl<S: Float> Power<S> {
    pub(super) fn zero(count: usize) -> Self {
        let zero = S::constant(0.0);
        Self {
            terms: [zero; TERMS],
            count,
            size: zero,
        }
    }

    pub(super) fn used(&self) -> &[S] {
        self.terms.get(..self.count).unwrap_or(&self.terms)
    }

    pub(super) fn term(&self, place: usize) -> S {
        self.terms.get(place).copied().unwrap_or(S::constant(0.0))
    }

    /// sign·f − level, up to a place.
    pub(super) fn seen(&self, sign: S, level: S, reach: S) -> Seen<S> {
        let mut power = *self;
        for term in &mut power.terms {
            *term = *term * sign;
        }
        let [first, ..] = &mut power.terms;
        *first = *first - level;
        let mut bound = S::constant(0.0);
        let three = power.used().iter().enumerate().skip(3).rev();
        for (order, term) in three {
            let n = S::constant(f64::from(u32::try_from(order).unwrap_or(u32::MAX)));
            let (one, two) = (S::constant(1.0), S::constant(2.0));
            bound = bound * reach + term.abs() * n * (n - one) * (n - two);
        }
        let noise = (power.size + level.abs()) * S::constant(4.0 * S::EPSILON);
        Seen {
            power,
            reach,
            bound,
            noise,
        }
    }
}

/// A power series up to a place, with a bound on its third derivative there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen<S> {
    power: Power<S>,
    reach: S,
    bound: S,
    noise: S,
}

impl<S: Float> Walked<S> for Seen<S> {
    const MOST: u32 = 64;

    fn local(&self, tau: S) -> Local<S> {
        let zero = S::constant(0.0);
        let (mut value, mut slope, mut half) = (zero, zero, zero);
        for term in self.power.used().iter().rev() {
            half = half * tau + slope;
            slope = slope * tau + value;
            value = value * tau + *term;
        }
        Local {
            value,
            slope,
            curve: half + half,
            bound: self.bound,
        }
    }

    fn series(&self, value: S, slope: S) -> Series<S> {
        let mut terms = [S::constant(0.0); ORDER];
        let mut factorial = S::constant(1.0);
        let used = self.power.used().iter();
        for (order, (term, from)) in terms.iter_mut().zip(used).enumerate() {
            let n = S::constant(f64::from(u32::try_from(order.max(1)).unwrap_or(u32::MAX)));
            factorial = factorial * n;
            *term = *from * factorial;
        }
        let [first, second, ..] = &mut terms;
        (*first, *second) = (value, slope);
        // No term beyond is left out that shows: what turns by a radian at most has them over factorials.
        Series::new(terms, S::constant(0.03))
    }

    fn noise(&self) -> S {
        self.noise
    }

    fn reach(&self) -> S {
        self.reach
    }
}
