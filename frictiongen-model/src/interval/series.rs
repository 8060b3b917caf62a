//! Taylor series with intervals as coefficients.

use super::Interval;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The first `N` Taylor coefficients f⁽ᵏ⁾/k! of a function of one variable, at a point or, each of them, over an interval.
///
/// By Taylor's formula a function is at r₀ + t its first N − 1 terms at r₀, and t^{N−1} times a number that the last
/// coefficient over an interval with both places holds: [`joined`](Self::joined).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series<const N: usize> {
    /// From the value on.
    pub terms: [Interval; N],
}

/// The terms of the series of sin(πz)/(πz) that are summed, and what those that are not cannot exceed for |z| ≤ 1.
const SINC_TERMS: usize = 21;
const SINC_REST: f64 = 1e-17;

impl<const N: usize> Series<N> {
    /// What does not depend on the variable.
    #[inline]
    #[must_use]
    pub fn fixed(value: Interval) -> Self {
        let mut terms = [Interval::ZERO; N];
        if let Some(first) = terms.first_mut() {
            *first = value;
        }
        Self { terms }
    }

    /// The variable at a point or over an interval.
    #[must_use]
    pub fn variable(value: Interval) -> Self {
        let mut series = Self::fixed(value);
        if let Some(slope) = series.terms.get_mut(1) {
            *slope = Interval::ONE;
        }
        series
    }

    /// One over the variable.
    #[must_use]
    pub fn inverse(value: Interval) -> Self {
        let inverse = Interval::ONE / value;
        let mut power = inverse;
        let mut terms = [Interval::ZERO; N];
        for term in &mut terms {
            *term = power;
            power = -(power * inverse);
        }
        Self { terms }
    }

    /// A coefficient; 0 beyond the last.
    #[inline]
    #[must_use]
    pub fn term(&self, place: usize) -> Interval {
        self.terms.get(place).copied().unwrap_or(Interval::ZERO)
    }

    /// The value.
    #[inline]
    #[must_use]
    pub fn value(&self) -> Interval {
        self.term(0)
    }

    /// The first `M` coefficients.
    #[must_use]
    pub fn truncated<const M: usize>(&self) -> Series<M> {
        let mut terms = [Interval::ZERO; M];
        for (term, own) in terms.iter_mut().zip(&self.terms) {
            *term = *own;
        }
        Series { terms }
    }

    /// Every coefficient times a number.
    #[inline]
    #[must_use]
    pub fn times(&self, factor: Interval) -> Self {
        let mut terms = self.terms;
        for term in &mut terms {
            *term = *term * factor;
        }
        Self { terms }
    }

    /// Σ a_j b_{k−j} over j ≤ k, from j = `first` on.
    ///
    /// By slices: iterators are calls where nothing is optimised.
    #[inline(always)]
    fn convolved(a: &[Interval; N], b: &[Interval; N], k: usize, first: usize) -> Interval {
        let mut sum = Interval::ZERO;
        let mut left = a.get(first..=k).unwrap_or_default();
        let mut right = b.get(..=k - first).unwrap_or_default();
        while let ([a, after @ ..], [before @ .., b]) = (left, right) {
            if !a.is_nothing() && !b.is_nothing() {
                let product = *a * *b;
                sum = if sum.is_nothing() {
                    product
                } else {
                    sum + product
                };
            }
            (left, right) = (after, before);
        }
        sum
    }

    /// j·a_j.
    fn counted(&self) -> [Interval; N] {
        let mut counted = self.terms;
        for (j, term) in counted.iter_mut().enumerate() {
            *term = *term * Interval::point(j as f64);
        }
        counted
    }

    /// The square.
    #[must_use]
    pub fn squared(&self) -> Self {
        let mut square = *self * *self;
        if let Some(first) = square.terms.first_mut() {
            *first = self.value().squared();
        }
        square
    }

    /// e to the series.
    #[must_use]
    pub fn exp(&self) -> Self {
        let counted = self.counted();
        let mut series = Self::fixed(self.value().exp());
        for k in 1..N {
            // k·e_k = Σ j a_j e_{k−j}.
            let sum = Self::convolved(&counted, &series.terms, k, 1);
            if let Some(term) = series.terms.get_mut(k) {
                *term = sum / Interval::point(k as f64);
            }
        }
        series
    }

    /// (sin πh, cos πh) of the series h.
    #[must_use]
    pub fn sine_cosine(&self) -> (Self, Self) {
        let (sine, cosine) = self.value().sine_cosine();
        let (mut sine, mut cosine) = (Self::fixed(sine), Self::fixed(cosine));
        let counted = self.counted();
        for k in 1..N {
            let rate = Interval::pi() / Interval::point(k as f64);
            let of_sine = Self::convolved(&counted, &cosine.terms, k, 1);
            let of_cosine = Self::convolved(&counted, &sine.terms, k, 1);
            if let Some(term) = sine.terms.get_mut(k) {
                *term = of_sine * rate;
            }
            if let Some(term) = cosine.terms.get_mut(k) {
                *term = -(of_cosine * rate);
            }
        }
        (sine, cosine)
    }

    /// The root.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        let mut root = Self::fixed(self.value().sqrt());
        for k in 1..N {
            // a_k = 2 b_0 b_k + Σ_{0<j<k} b_j b_{k−j}; the convolution sees b_k as 0 still.
            let known = Self::convolved(&root.terms, &root.terms, k, 1);
            let twice = root.value() + root.value();
            if let Some(term) = root.terms.get_mut(k) {
                *term = (self.term(k) - known) / twice;
            }
        }
        root
    }

    /// sin(πz)/(πz) of a series z with |z| ≤ 1 at its value, by its own series; everything beyond.
    #[must_use]
    pub fn sinc(&self) -> Self {
        let z = self.value();
        if !(z.size() <= 1.0) {
            return Self::fixed(Interval::ALL);
        }
        // (−1)^j π^{2j}/(2j + 1)! of z^{2j}.
        let mut powers = [Interval::ZERO; 2 * SINC_TERMS];
        let mut weight = Interval::ONE;
        let square = Interval::pi() * Interval::pi();
        for (j, pair) in powers.chunks_exact_mut(2).enumerate() {
            if let Some(even) = pair.first_mut() {
                *even = weight;
            }
            let next = ((2 * j + 2) * (2 * j + 3)) as f64;
            weight = -(weight * square / Interval::point(next));
        }
        // The derivatives over k!, each by Horner's scheme, from the highest down.
        let away = {
            let mut away = *self;
            if let Some(first) = away.terms.first_mut() {
                *first = Interval::ZERO;
            }
            away
        };
        let mut sum = Self::fixed(Interval::ZERO);
        for k in (0..N).rev() {
            let mut value = Interval::ZERO;
            for (power, weight) in powers.iter().enumerate().skip(k).rev() {
                let mut binomial = Interval::ONE;
                for i in 0..k {
                    let factor = Interval::point((power - i) as f64);
                    binomial = binomial * factor / Interval::point((i + 1) as f64);
                }
                value = value * z + *weight * binomial;
            }
            sum = sum * away + Self::fixed(value + Interval::within(SINC_REST));
        }
        sum
    }

    /// A polynomial in t that holds the function at r₀ + t: all terms but the last at r₀, the last over the interval.
    #[must_use]
    pub fn joined(at: &Self, over: &Self) -> Self {
        let mut joined = *at;
        if let (Some(last), Some(own)) = (joined.terms.last_mut(), over.terms.last()) {
            *last = *own;
        }
        joined
    }

    /// The values of the polynomial for all t in an interval: by their middle and its slope, and plainly.
    #[must_use]
    pub fn range(&self, t: Interval) -> Interval {
        let middle = Interval::point(t.middle());
        let (mut plain, mut value, mut slope) = (Interval::ZERO, Interval::ZERO, Interval::ZERO);
        for (k, term) in self.terms.iter().enumerate().rev() {
            plain = plain * t + *term;
            value = value * middle + *term;
            if k > 0 {
                slope = slope * t + *term * Interval::point(k as f64);
            }
        }
        (value + slope * (t - middle)).both(plain)
    }
}

impl<const N: usize> Add for Series<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut terms = self.terms;
        for (a, b) in terms.iter_mut().zip(&other.terms) {
            *a = *a + *b;
        }
        Self { terms }
    }
}

impl<const N: usize> Sub for Series<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let mut terms = self.terms;
        for (a, b) in terms.iter_mut().zip(&other.terms) {
            *a = *a - *b;
        }
        Self { terms }
    }
}

impl<const N: usize> Neg for Series<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            terms: self.terms.map(Neg::neg),
        }
    }
}

impl<const N: usize> Mul for Series<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut terms = [Interval::ZERO; N];
        for (k, term) in terms.iter_mut().enumerate() {
            *term = Self::convolved(&self.terms, &other.terms, k, 0);
        }
        Self { terms }
    }
}

impl<const N: usize> Div for Series<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut quotient = Self::fixed(Interval::ZERO);
        if other.value().holds_zero() {
            return Self {
                terms: [Interval::ALL; N],
            };
        }
        for k in 0..N {
            // a_k = Σ b_j q_{k−j}, of which q_k is seen as 0 still.
            let known = Self::convolved(&other.terms, &quotient.terms, k, 0);
            if let Some(term) = quotient.terms.get_mut(k) {
                *term = (self.term(k) - known) / other.value();
            }
        }
        quotient
    }
}
