//! The first instant at which a polynomial on [0, 1] becomes negative.

use super::series::{Poly, TERMS};

/// Halvings of the interval, after which its two ends are neighbours within rounding.
const HALVINGS: u32 = 52;

/// Returns the first τ in [0, 1] from which on the polynomial is negative. `zeros` says how many of its first terms are
/// 0 by what has happened at the start, whatever rounding makes of them.
pub fn first_negative(terms: &Poly, zeros: usize) -> Option<f64> {
    let terms = terms.get(zeros..)?;
    let start = terms.iter().position(|&term| term != 0.0)?;
    let terms = terms.get(start..)?;
    let (first, others) = terms.split_first()?;
    if !(*first > 0.0) {
        return Some(0.0);
    }
    let falls: f64 = others.iter().map(|term| term.min(0.0)).sum();
    if *first + falls > 0.0 {
        return None;
    }
    search(terms)
}

/// Halves [0, 1] in Bernstein's form until each part has no root or one.
fn search(terms: &[f64]) -> Option<f64> {
    let mut waiting = vec![(0.0, 1.0, bernstein(terms), 0)];
    while let Some((low, high, form, depth)) = waiting.pop() {
        if form.iter().all(|&value| value > 0.0) {
            continue;
        }
        let changes = form
            .iter()
            .zip(form.iter().skip(1))
            .filter(|(a, b)| (**a > 0.0) != (**b > 0.0))
            .count();
        let starts = form.first().is_some_and(|&value| value > 0.0);
        if !starts {
            return Some(low);
        }
        if changes == 1 || depth >= HALVINGS {
            return Some(bisect(terms, low, high));
        }
        let middle = 0.5 * (low + high);
        let (left, right) = halves(form);
        waiting.push((middle, high, right, depth + 1));
        waiting.push((low, middle, left, depth + 1));
    }
    None
}

/// Returns Bernstein's coefficients on [0, 1]: b_i = Σ_k≤i C(i, k)/C(n, k) a_k.
fn bernstein(terms: &[f64]) -> Vec<f64> {
    // Differences are undone one after the other: the triangle of a_k/C(n, k) by sums.
    let degree = terms.len().saturating_sub(1);
    let mut binomial = 1.0;
    let mut form: Vec<f64> = Vec::with_capacity(TERMS);
    for (k, term) in terms.iter().enumerate() {
        form.push(term / binomial);
        binomial = binomial * (degree - k) as f64 / (k + 1) as f64;
    }
    for pass in (0..degree).rev() {
        let mut before = form.get(pass).copied().unwrap_or(0.0);
        for value in form.iter_mut().skip(pass + 1) {
            *value += before;
            before = *value;
        }
    }
    form
}

/// Divides a form at the middle (de Casteljau).
fn halves(mut form: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let mut left = Vec::with_capacity(form.len());
    let mut right = Vec::with_capacity(form.len());
    while let (Some(&first), Some(&last)) = (form.first(), form.last()) {
        left.push(first);
        right.push(last);
        form = form
            .iter()
            .zip(form.iter().skip(1))
            .map(|(a, b)| 0.5 * (a + b))
            .collect();
    }
    right.reverse();
    (left, right)
}

/// Bisects a change of sign from positive.
fn bisect(terms: &[f64], mut low: f64, mut high: f64) -> f64 {
    for _ in 0..HALVINGS + 8 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if value(terms, middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Evaluates a polynomial.
pub fn value(terms: &[f64], at: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * at + term)
}
