//! Taylor series with intervals as coefficients.

mod operators;
#[cfg(test)]
mod tests;

use frictiongen_model::interval::{Interval, TINY};

/// The first `N` Taylor coefficients f⁽ᵏ⁾/k! of a function of one variable, at a point or over an interval.
///
/// Taylor's formula gives the function at r₀ + t as its first N − 1 terms at r₀ plus a remainder. The remainder is
/// t^{N−1} times a number. The last coefficient of the series over an interval contains this number, if the interval
/// contains r₀ and r₀ + t. [`joined`](Self::joined) uses this property.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntervalSeries<const N: usize> {
    /// The Taylor coefficients f⁽ᵏ⁾/k!. The first is the value of f.
    pub terms: [Interval; N],
}

/// Number of terms of the power series of sin(πz)/(πz) that are added up. The next term is below 10⁻²⁹ for |z| ≤ 1.
const SINC_TERMS: usize = 21;
/// Bound on the neglected terms of the power series of sin(πz)/(πz), and of its kth derivative divided by k!. It is
/// valid for each k below the number of terms of an [`IntervalSeries`].
const SINC_REST: f64 = 1e-17;

impl<const N: usize> IntervalSeries<N> {
    /// Returns the series of a constant function.
    #[inline]
    #[must_use]
    pub fn fixed(value: Interval) -> Self {
        let mut terms = [Interval::ZERO; N];
        if let Some(first) = terms.first_mut() {
            *first = value;
        }
        Self { terms }
    }

    /// Returns the series of the variable itself, at a point or over an interval `value`.
    #[must_use]
    pub fn variable(value: Interval) -> Self {
        let mut series = Self::fixed(value);
        if let Some(slope) = series.terms.get_mut(1) {
            *slope = Interval::ONE;
        }
        series
    }

    /// Returns the series of 1/r, where r is the variable.
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

    /// Returns the coefficient with this index, or 0 if the index is too large.
    #[inline]
    #[must_use]
    pub fn term(&self, place: usize) -> Interval {
        self.terms.get(place).copied().unwrap_or(Interval::ZERO)
    }

    /// Returns the value of the function, which is the first coefficient.
    #[inline]
    #[must_use]
    pub fn value(&self) -> Interval {
        self.term(0)
    }

    /// Returns a series with only the first `M` coefficients of this series.
    #[must_use]
    pub fn truncated<const M: usize>(&self) -> IntervalSeries<M> {
        let mut terms = [Interval::ZERO; M];
        for (term, own) in terms.iter_mut().zip(&self.terms) {
            *term = *own;
        }
        IntervalSeries { terms }
    }

    /// Returns the series times a number.
    #[inline]
    #[must_use]
    pub fn times(&self, factor: Interval) -> Self {
        if factor.is_nothing() {
            return Self::fixed(factor);
        }
        let mut series = *self;
        let mut terms = series.terms.as_mut_slice();
        while let [term, after @ ..] = terms {
            *term = *term * factor;
            terms = after;
        }
        series
    }

    /// Adds `factor` times another series to this series.
    pub fn add_times(&mut self, other: &Self, factor: Interval) {
        if factor.is_nothing() {
            return;
        }
        let (mut terms, mut others) = (self.terms.as_mut_slice(), other.terms.as_slice());
        while let ([term, after @ ..], [other, others_after @ ..]) = (terms, others) {
            *term = *term + *other * factor;
            (terms, others) = (after, others_after);
        }
    }

    /// Returns the coefficients without the zeros at the end of the list.
    #[inline(always)]
    fn trimmed(terms: &[Interval]) -> &[Interval] {
        let mut terms = terms;
        while let [rest @ .., last] = terms
            && last.is_nothing()
        {
            terms = rest;
        }
        terms
    }

    /// Returns the sum of a_j b_{k−j} over j from `first` to k.
    ///
    /// The function adds up the bounds of the products with rounding to nearest, and then widens the sum once for all
    /// roundings. With n products whose moduli add up to s, the rounding error is less than (n + 1)εs. The code uses
    /// slices, because without optimisation iterators would be function calls.
    #[inline(always)]
    fn convolved(a: &[Interval], b: &[Interval], k: usize, first: usize) -> Interval {
        let from = if k < first + b.len() {
            first
        } else {
            k + 1 - b.len()
        };
        let after = if k < a.len() { k + 1 } else { a.len() };
        if after <= from {
            return Interval::ZERO;
        }
        let (Some(a), Some(b)) = (a.get(from..after), b.get(k + 1 - after..k + 1 - from)) else {
            return Interval::ALL;
        };
        let (mut left, mut right) = (a, b);
        let (mut low, mut high, mut size) = (0.0, 0.0, 0.0);
        while let ([a, after @ ..], [before @ .., b]) = (left, right) {
            let (least, most) = a.ends_times(*b);
            low += least;
            high += most;
            size += if most < -least { -least } else { most };
            (left, right) = (after, before);
        }
        #[allow(
            clippy::eq_op,
            reason = "NaN alone is not itself, and `is_nan` is a call"
        )]
        if !(0.0 < size && size < f64::INFINITY) || low != low {
            return Self::convolved_term_by_term(a, b);
        }
        let room = size * ((after - from + 1) as f64 * f64::EPSILON) + TINY;
        Interval::new(low - room, high + room)
    }

    /// Returns Σ a_j b_{k−j}, rounded outward after each term. `convolved` calls this function if bounds are infinite
    /// or every product is 0.
    fn convolved_term_by_term(a: &[Interval], b: &[Interval]) -> Interval {
        let pairs = a.iter().zip(b.iter().rev());
        let pairs = pairs.filter(|(a, b)| !a.is_nothing() && !b.is_nothing());
        let products = pairs.map(|(a, b)| *a * *b);
        products
            .reduce(|sum, product| sum + product)
            .unwrap_or(Interval::ZERO)
    }

    /// Returns the series with the coefficients j·a_j, where a_j are the coefficients of this series.
    fn counted(&self) -> Self {
        let mut counted = *self;
        let (mut terms, mut j) = (counted.terms.as_mut_slice(), 0.0);
        while let [term, after @ ..] = terms {
            *term = *term * Interval::point(j);
            (terms, j) = (after, j + 1.0);
        }
        counted
    }

    /// Returns the square of the series.
    #[must_use]
    pub fn squared(&self) -> Self {
        let own = Self::trimmed(&self.terms);
        let mut square = Self::fixed(Interval::ZERO);
        for (k, term) in square.terms.iter_mut().enumerate() {
            // Each product a_j a_{k−j} with j ≠ k − j occurs twice. For even k the square of the middle coefficient
            // remains.
            let half = Self::convolved(own, own, k, k / 2 + 1);
            *term = match own.get(k / 2) {
                Some(middle) if k % 2 == 0 => half.doubled() + middle.squared(),
                _ => half.doubled(),
            };
        }
        square
    }

    /// Returns the exponential of the series.
    #[must_use]
    pub fn exp(&self) -> Self {
        let counted = self.counted();
        let counted = Self::trimmed(&counted.terms);
        let mut series = Self::fixed(self.value().exp());
        for k in 1..N {
            // The coefficients e_k of the exponential follow from k·e_k = Σ j a_j e_{k−j}, with the coefficients a_j of
            // this series.
            let sum = Self::convolved(counted, &series.terms, k, 1);
            if let Some(term) = series.terms.get_mut(k) {
                *term = sum.divided_by(k as f64);
            }
        }
        series
    }

    /// Returns (sin πh, cos πh) of the series h.
    #[must_use]
    pub fn sine_cosine(&self) -> (Self, Self) {
        let (sine, cosine) = self.value().sine_cosine();
        let (mut sine, mut cosine) = (Self::fixed(sine), Self::fixed(cosine));
        let counted = self.counted();
        let counted = Self::trimmed(&counted.terms);
        for k in 1..N {
            let rate = Interval::pi().divided_by(k as f64);
            let of_sine = Self::convolved(counted, &cosine.terms, k, 1);
            let of_cosine = Self::convolved(counted, &sine.terms, k, 1);
            if let Some(term) = sine.terms.get_mut(k) {
                *term = of_sine * rate;
            }
            if let Some(term) = cosine.terms.get_mut(k) {
                *term = -(of_cosine * rate);
            }
        }
        (sine, cosine)
    }

    /// Returns the square root of the series.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        let mut root = Self::fixed(self.value().sqrt());
        let inverse = Interval::ONE / root.value().doubled();
        for k in 1..N {
            // The coefficients b_k of the root follow from a_k = 2 b_0 b_k + Σ_{0<j<k} b_j b_{k−j}. At this point b_k
            // is still 0 in the convolution.
            let known = Self::convolved(&root.terms, &root.terms, k, 1);
            if let Some(term) = root.terms.get_mut(k) {
                *term = (self.term(k) - known) * inverse;
            }
        }
        root
    }

    /// Returns sin(πz)/(πz), where z is this series. The function uses the power series of sin(πz)/(πz), which needs
    /// |z| ≤ 1. Returns `ALL` if |z| may exceed 1.
    #[must_use]
    pub fn sinc(&self) -> Self {
        let z = self.value();
        if !(z.size() <= 1.0) {
            return Self::fixed(Interval::ALL);
        }
        // The coefficient of z^{2j} is (−1)^j π^{2j}/(2j + 1)!.
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
        // Horner's scheme gives each derivative of the power series, divided by k! for order k, from the highest order
        // down.
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

    /// Returns a polynomial in t whose values contain the function at r₀ + t. Its last coefficient is that of `over`,
    /// the series over the interval. Its other coefficients are those of `at`, the series at r₀.
    #[must_use]
    pub fn joined(at: &Self, over: &Self) -> Self {
        let mut joined = *at;
        if let (Some(last), Some(own)) = (joined.terms.last_mut(), over.terms.last()) {
            *last = *own;
        }
        joined
    }

    /// Returns this series, which is over an interval, with narrower coefficients. Taylor's formula gives these
    /// coefficients from the series `at` a point of the interval. `away` is the interval minus that point.
    #[must_use]
    pub fn refined(&self, at: &Self, away: Interval) -> Self {
        let mut refined = *self;
        for (k, term) in refined.terms.iter_mut().enumerate() {
            // The sum Σ_j C(j, k) a_j t^{j−k} runs from the highest term down. C(j − 1, k) is C(j, k)·(j − k)/j.
            let mut chosen = 1;
            for j in k + 1..N {
                chosen = chosen * j / (j - k);
            }
            let mut sum = self.term(N - 1) * Interval::point(chosen as f64);
            for j in (k + 1..N).rev() {
                chosen = chosen * (j - k) / j;
                sum = sum * away + at.term(j - 1) * Interval::point(chosen as f64);
            }
            *term = term.both(sum);
        }
        refined
    }

    /// Returns bounds on the polynomial's values for all t in an interval. The result is the intersection of two
    /// bounds. One comes from the mean value form at the middle of the interval, the second from plain interval
    /// evaluation.
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
