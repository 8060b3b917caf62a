//! Arithmetic operators of series.

use super::IntervalSeries;
use frictiongen_model::interval::Interval;
use std::ops::{Add, Div, Mul, Neg, Sub};

impl<const N: usize> Add for IntervalSeries<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut series = self;
        let (mut terms, mut others) = (series.terms.as_mut_slice(), other.terms.as_slice());
        while let ([a, after @ ..], [b, others_after @ ..]) = (terms, others) {
            *a = *a + *b;
            (terms, others) = (after, others_after);
        }
        series
    }
}

impl<const N: usize> Sub for IntervalSeries<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let mut series = self;
        let (mut terms, mut others) = (series.terms.as_mut_slice(), other.terms.as_slice());
        while let ([a, after @ ..], [b, others_after @ ..]) = (terms, others) {
            *a = *a - *b;
            (terms, others) = (after, others_after);
        }
        series
    }
}

impl<const N: usize> Neg for IntervalSeries<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            terms: self.terms.map(Neg::neg),
        }
    }
}

impl<const N: usize> Mul for IntervalSeries<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut terms = [Interval::ZERO; N];
        if let ([own], [a], [b]) = (
            terms.as_mut_slice(),
            self.terms.as_slice(),
            other.terms.as_slice(),
        ) {
            *own = *a * *b;
            return Self { terms };
        }
        let (a, b) = (Self::trimmed(&self.terms), Self::trimmed(&other.terms));
        for (k, term) in terms.iter_mut().enumerate() {
            *term = Self::convolved(a, b, k, 0);
        }
        Self { terms }
    }
}

impl<const N: usize> Div for IntervalSeries<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut quotient = Self::fixed(Interval::ZERO);
        if other.value().holds_zero() {
            return Self {
                terms: [Interval::ALL; N],
            };
        }
        let divisor = Self::trimmed(&other.terms);
        let inverse = Interval::ONE / other.value();
        for k in 0..N {
            // The numerator a is the divisor b times the quotient q, so a_k = Σ b_j q_{k−j}. The sum over j ≥ 1 is
            // already known, so the equation gives q_k.
            let known = Self::convolved(divisor, &quotient.terms, k, 1);
            if let Some(term) = quotient.terms.get_mut(k) {
                *term = (self.term(k) - known) * inverse;
            }
        }
        quotient
    }
}
