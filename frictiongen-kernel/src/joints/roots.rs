//! Finds the first instant at which a polynomial on the interval [0, 1] becomes negative.

use super::poly::{Poly, TERMS, terms_of, value};
use crate::Float;

/// Number of bisections after which the two ends of the interval are equal apart from rounding.
fn halvings<S: Float>() -> u32 {
    if S::EPSILON < 1e-10 { 52 } else { 23 }
}

/// Returns the first point τ in [0, 1] after which the polynomial is negative. Because of the event at the start, the
/// first `zeros` coefficients are exactly 0. The function therefore ignores their rounding errors.
pub fn first_negative<S: Float>(terms: &Poly<S>, zeros: usize) -> Option<S> {
    let zero = S::constant(0.0);
    let terms = terms.get(zeros..terms_of::<S>())?;
    let start = terms.iter().position(|term| !term.is_zero())?;
    let terms = terms.get(start..)?;
    let (first, others) = terms.split_first()?;
    if !(*first > zero) {
        return Some(zero);
    }
    let falls = others
        .iter()
        .fold(zero, |falls, term| falls + crate::Scalar::min(*term, zero));
    if *first + falls > zero {
        return None;
    }
    search(terms)
}

/// Bisects the interval [0, 1] until each subinterval has at most one root of the polynomial. The polynomial is in
/// Bernstein form. A subinterval extends from index/2^depth to (index + 1)/2^depth. When the search returns to a
/// subinterval, the code computes its Bernstein form again from the form on [0, 1], so that it needs no stack.
fn search<S: Float>(terms: &[S]) -> Option<S> {
    let half = S::constant(0.5);
    let whole = Form::new(terms);
    let (mut form, mut depth, mut index, mut width) = (whole, 0_u32, 0_u64, S::constant(1.0));
    loop {
        if !form.is_positive() {
            let low = S::constant(index as f64) * width;
            if !form.starts_positive() {
                return Some(low);
            }
            if form.changes() == 1 || depth >= halvings::<S>() {
                return Some(bisect(terms, low, S::constant((index + 1) as f64) * width));
            }
            let (left, right) = form.halves();
            (depth, index, width) = (depth + 1, 2 * index, half * width);
            if left.is_positive() {
                (index, form) = (index + 1, right);
            } else {
                form = left;
            }
            continue;
        }
        while depth > 0 && index % 2 == 1 {
            (depth, index, width) = (depth - 1, index / 2, width + width);
        }
        if depth == 0 {
            return None;
        }
        index += 1;
        form = whole.part(depth, index);
    }
}

/// Bernstein coefficients of a polynomial on an interval.
#[derive(Clone, Copy)]
struct Form<S> {
    values: [S; TERMS],
    count: usize,
}

impl<S: Float> Form<S> {
    /// Returns the Bernstein coefficients b_i = Σ_{k≤i} C(i, k)/C(n, k) a_k of a polynomial on [0, 1]. `terms` contains
    /// the coefficients a_k of the powers.
    fn new(terms: &[S]) -> Self {
        // The numbers a_k/C(n, k) are differences of the Bernstein coefficients. Repeated sums give the coefficients.
        let degree = terms.len().saturating_sub(1);
        let mut values = [S::constant(0.0); TERMS];
        let mut binomial = S::constant(1.0);
        for (k, (value, term)) in values.iter_mut().zip(terms).enumerate() {
            *value = *term / binomial;
            let left = S::constant(degree.saturating_sub(k) as f64);
            binomial = binomial * left / S::constant((k + 1) as f64);
        }
        let count = terms.len();
        for pass in (0..degree).rev() {
            let mut before = S::constant(0.0);
            for value in values.iter_mut().take(count).skip(pass) {
                *value = *value + before;
                before = *value;
            }
        }
        Self { values, count }
    }

    fn used(&self) -> impl Iterator<Item = &S> {
        self.values.iter().take(self.count)
    }

    fn is_positive(&self) -> bool {
        self.used().all(|value| *value > S::constant(0.0))
    }

    fn starts_positive(&self) -> bool {
        self.used()
            .next()
            .is_some_and(|value| *value > S::constant(0.0))
    }

    /// Returns the number of sign changes in the Bernstein coefficients. The polynomial has at most this number of
    /// roots in the interval.
    fn changes(&self) -> usize {
        let zero = S::constant(0.0);
        let pairs = self.used().zip(self.used().skip(1));
        pairs.filter(|(a, b)| (**a > zero) != (**b > zero)).count()
    }

    /// Divides the interval at its middle, and returns the Bernstein coefficients for both halves (de Casteljau's
    /// algorithm).
    fn halves(mut self) -> (Self, Self) {
        let half = S::constant(0.5);
        let (mut left, mut right) = (self, self);
        let firsts = left.values.iter_mut().take(self.count);
        let lasts = right.values.iter_mut().take(self.count).rev();
        for (count, (left, right)) in (1..=self.count).rev().zip(firsts.zip(lasts)) {
            let mut before: Option<&mut S> = None;
            for (place, value) in self.values.iter_mut().take(count).enumerate() {
                if place == 0 {
                    *left = *value;
                }
                if place + 1 == count {
                    *right = *value;
                }
                if let Some(before) = before {
                    *before = half * (*before + *value);
                }
                before = Some(value);
            }
        }
        (left, right)
    }

    /// Returns the Bernstein coefficients for one of 2^`depth` subintervals of equal length. `index` is the index of
    /// the subinterval.
    fn part(self, depth: u32, index: u64) -> Self {
        (0..depth).rev().fold(self, |form, level| {
            let (left, right) = form.halves();
            if index >> level & 1 == 0 { left } else { right }
        })
    }
}

/// Finds by bisection the point between `low` and `high` at which the polynomial changes its sign from positive to
/// negative.
fn bisect<S: Float>(terms: &[S], mut low: S, mut high: S) -> S {
    for _ in 0..halvings::<S>() + 8 {
        let middle = S::constant(0.5) * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if value(terms, middle) > S::constant(0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}
