//! Finds the first instant at which a polynomial on the interval [0, 1] becomes negative.

use super::poly::{TERMS, value, value_and_slope};
use crate::Float;
use crate::errors::Halt;

/// Number of bisections after which the two ends of the interval are equal apart from rounding.
pub(super) fn halvings<S: Float>() -> u32 {
    if S::EPSILON < 1e-10 { 52 } else { 23 }
}

/// Returns the first point τ in [0, 1] after which the polynomial is negative. The first `zeros` coefficients are
/// exactly 0, because an event occurs at the point 0. The function ignores their computed values, which are only
/// rounding errors.
pub fn first_negative<S: Float>(terms: &[S], zeros: usize) -> Option<S> {
    // Without a limit the search has no error.
    let mut left = u32::MAX;
    first_negative_within(terms, zeros, &mut left).unwrap_or_default()
}

/// Returns the point of [`first_negative`]. The search divides intervals at most `left` times, and subtracts the number of
/// its divisions from `left`.
///
/// # Errors
///
/// [`Halt::Stretches`] if it needs more divisions.
pub(super) fn first_negative_within<S: Float>(
    terms: &[S],
    zeros: usize,
    left: &mut u32,
) -> Result<Option<S>, Halt> {
    let zero = S::constant(0.0);
    let terms = terms.get(zeros..).unwrap_or_default();
    let start = terms.iter().position(|term| !term.is_zero());
    let last = terms.iter().rposition(|term| !term.is_zero());
    let (Some(start), Some(last)) = (start, last) else {
        return Ok(None);
    };
    let terms = terms.get(start..=last).unwrap_or_default();
    let Some((first, others)) = terms.split_first().filter(|(first, _)| **first > zero) else {
        return Ok(Some(zero));
    };
    let falls = others
        .iter()
        .fold(zero, |falls, term| falls + crate::Scalar::min(*term, zero));
    if *first + falls > zero || stays_positive(terms) {
        return Ok(None);
    }
    let root = if falls_steadily(terms) {
        let one = S::constant(1.0);
        let ends_positive = value(terms, one) > zero;
        (!ends_positive).then(|| bisect(terms, zero, one))
    } else {
        search(terms, left)?
    };
    Ok(root.map(|root| carried(terms, root)))
}

/// Returns a root of the polynomial `terms` with its derivative, −(∂q/∂p)/q′ for the polynomial q. The search finds only
/// the value of the root. Without derivatives the function returns the root itself.
pub fn carried<S: Float>(terms: &[S], root: S) -> S {
    if !S::CARRIES {
        return root;
    }
    let root = root.primal();
    let (here, slope) = value_and_slope(terms, root);
    // At a double root the derivative does not exist. The test for a graze finds such a root.
    if slope.is_zero() {
        return root;
    }
    root - (here - here.primal()) / slope
}

/// Returns true if the derivative of the polynomial `terms` is negative on [0, 1] by more than rounding errors.
fn falls_steadily<S: Float>(terms: &[S]) -> bool {
    let mut slope = [S::constant(0.0); TERMS];
    let mut order = S::constant(0.0);
    for (slope, term) in slope.iter_mut().zip(terms.iter().skip(1)) {
        order = order + S::constant(1.0);
        *slope = -(order * *term);
    }
    slope
        .get(..terms.len().saturating_sub(1))
        .is_some_and(stays_positive)
}

/// Number of coefficients in the fast test [`stays_above`].
pub(super) const QUICK: usize = 6;

/// Returns true if a lower bound on the polynomial `terms` is positive on [0, 1] by more than rounding errors. The
/// lower bound is a polynomial of degree 5. It replaces each negative term of higher degree by its value at 1, and
/// omits the positive terms of higher degree.
fn stays_positive<S: Float>(terms: &[S]) -> bool {
    let zero = S::constant(0.0);
    let mut low = [zero; QUICK];
    for (low, term) in low.iter_mut().zip(terms) {
        *low = *term;
    }
    let high = terms.iter().skip(QUICK);
    let falls = high.fold(zero, |falls, term| falls + crate::Scalar::min(*term, zero));
    stays_above(low, -falls)
}

/// Returns true if the polynomial of degree 5 with the coefficients `terms` is greater than `bound` on [0, 1] by more
/// than rounding errors.
pub(super) fn stays_above<S: Float>(terms: [S; QUICK], bound: S) -> bool {
    // The margin, 1e-3 times the first coefficient, is far larger than rounding errors.
    let least = S::constant(1e-3) * terms[0] + bound;
    bernstein(terms).iter().all(|value| *value > least)
}

/// Returns the Bernstein coefficients on [0, 1] of the polynomial of degree 5 with the coefficients `terms`. The values of
/// the polynomial lie between the smallest and the largest of them.
fn bernstein<S: Float>([a, b, c, d, e, f]: [S; QUICK]) -> [S; QUICK] {
    // Divides each term by its binomial coefficient, and then adds as in Pascal's triangle. Loops would take several
    // times the instructions.
    let (fifth, tenth) = (S::constant(0.2), S::constant(0.1));
    let (b, c, d, e) = (fifth * b, tenth * c, tenth * d, fifth * e);
    let f = f + e;
    let e = e + d;
    let f = f + e;
    let d = d + c;
    let e = e + d;
    let f = f + e;
    let c = c + b;
    let d = d + c;
    let e = e + d;
    let f = f + e;
    let b = b + a;
    let c = c + b;
    let d = d + c;
    let e = e + d;
    let f = f + e;
    [a, b, c, d, e, f]
}

/// Returns the first point in [0, 1] at which the polynomial `terms` is no longer positive. The function bisects this
/// interval until the first subinterval with a root has only one root. The Bernstein form of the polynomial shows the
/// number of roots.
///
/// A subinterval extends from index/2^depth to (index + 1)/2^depth. When the search returns to a subinterval, the code
/// computes its Bernstein form again from the form on [0, 1]. The search therefore needs no stack.
///
/// Both halves of an interval have together at most as many sign changes as the interval. In each depth the search
/// therefore divides fewer intervals than the polynomial has terms.
fn search<S: Float>(terms: &[S], left: &mut u32) -> Result<Option<S>, Halt> {
    let mut divide = |times: u32| {
        *left = left.checked_sub(times).ok_or(Halt::Stretches)?;
        Ok(())
    };
    let half = S::constant(0.5);
    let whole = Form::new(terms);
    let (mut form, mut depth, mut index, mut width) = (whole, 0_u32, 0_u64, S::constant(1.0));
    // `low` is the start of the subinterval, index·width, without a rounding error. A conversion of the index would
    // link functions of double precision to an image in single precision.
    let mut low = S::constant(0.0);
    loop {
        if !form.is_positive() {
            if !form.starts_positive() {
                return Ok(Some(low));
            }
            if form.changes() == 1 || depth >= halvings::<S>() {
                return Ok(Some(bisect(terms, low, low + width)));
            }
            divide(1)?;
            let (left, right) = form.halves();
            (depth, index, width) = (depth + 1, 2 * index, half * width);
            if left.is_positive() {
                (index, low, form) = (index + 1, low + width, right);
            } else {
                form = left;
            }
            continue;
        }
        while depth > 0 && index % 2 == 1 {
            low = low - width;
            (depth, index, width) = (depth - 1, index / 2, width + width);
        }
        if depth == 0 {
            return Ok(None);
        }
        (index, low) = (index + 1, low + width);
        divide(depth)?;
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
        let degree = terms.len().saturating_sub(1);
        let mut values = [S::constant(0.0); TERMS];
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let (mut binomial, mut order) = (one, one);
        let mut left = terms.iter().skip(1).fold(zero, |degree, _| degree + one);
        for (value, term) in values.iter_mut().zip(terms) {
            *value = *term / binomial;
            binomial = binomial * left / order;
            (left, order) = (left - one, order + one);
        }
        let count = terms.len();
        for pass in 0..degree {
            // In descending order the sums of one pass do not depend on each other.
            let used = values.get_mut(pass..count).unwrap_or_default();
            let mut upper: Option<&mut S> = None;
            for lower in used.iter_mut().rev() {
                if let Some(upper) = upper {
                    *upper = *upper + *lower;
                }
                upper = Some(lower);
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

/// Largest number of Newton steps before a bisection starts.
pub(super) const NEWTON: usize = 8;

/// Finds the point between `low` and `high` at which the polynomial changes its sign from positive to negative.
/// Newton's method first shortens the interval, and bisections then find the point.
fn bisect<S: Float>(terms: &[S], mut low: S, mut high: S) -> S {
    let half = S::constant(0.5);
    let mut middle = half * (low + high);
    for _ in 0..NEWTON {
        let (here, slope) = value_and_slope(terms, middle);
        if here > S::constant(0.0) {
            low = middle;
        } else {
            high = middle;
        }
        let next = middle - here / slope;
        if !(next > low && next < high) {
            break;
        }
        let moved = (next - middle).abs();
        middle = next;
        let near = S::constant(8.0 * S::EPSILON);
        if moved <= S::constant(4.0) * near {
            // The distance of the root from the point `middle` is within rounding errors.
            let (below, above) = (middle - near, middle + near);
            if below > low && value(terms, below) > S::constant(0.0) {
                low = below;
            }
            if above < high && !(value(terms, above) > S::constant(0.0)) {
                high = above;
            }
            break;
        }
    }
    for _ in 0..halvings::<S>() + 8 {
        let middle = half * (low + high);
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
