//! One piece: polynomials through Chebyshev points, rounded to the table's scalar.

use super::digits::{above, to_decimals};
use super::exact::{ANGLE, Exact, SIZE};
use super::split::Edge;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::polynomial;
use std::f64::consts::PI;

/// An origin is rounded to this share of its piece.
const ORIGIN: f64 = 0.1;
/// Down to these accuracies polynomials of four, six and eight coefficients need least.
const FOUR_TERMS: f64 = 3e-3;
const SIX_TERMS: f64 = 1e-7;
const EIGHT_TERMS: f64 = 1e-10;

/// A piece with its functions in vectors.
#[derive(Clone, Debug)]
pub struct Fitted<S> {
    /// The smallest r of the piece.
    pub from: S,
    /// From where r is counted.
    pub origin: S,
    /// Of each function the coefficients, from the constant on.
    pub coefficients: Vec<Vec<S>>,
}

impl<S: Float> Fitted<S> {
    /// How many numbers it holds.
    pub(super) fn numbers(&self) -> usize {
        2 + self.coefficients.iter().map(Vec::len).sum::<usize>()
    }

    /// A function of the piece at r, in the arithmetic of the table.
    pub fn value(&self, function: usize, r: S) -> S {
        let coefficients = self.coefficients.get(function);
        coefficients.map_or(S::constant(f64::NAN), |of| polynomial(of, r - self.origin))
    }
}

/// So many coefficients a polynomial may have.
pub(super) const TERMS: [usize; 4] = [4, 6, 8, 10];

/// Coefficients of the polynomials that need least for an accuracy.
pub(super) fn terms(accuracy: f64) -> usize {
    let [four, six, eight, ten] = TERMS;
    if accuracy >= FOUR_TERMS {
        four
    } else if accuracy >= SIX_TERMS {
        six
    } else if accuracy >= EIGHT_TERMS {
        eight
    } else {
        ten
    }
}

/// What to fit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    /// How many functions.
    pub functions: usize,
    /// Coefficients of each.
    pub terms: usize,
    /// What β_lim, and a and g that are divided by it, are multiplied by.
    pub side_factor: f64,
    /// By how much the rounding of each coefficient may change an answer, relative to β_lim.
    pub rounding: f64,
}

/// Fits a form over [low, high].  Beside a zero, β_lim over the distance from it is fitted.
pub(super) fn fit<S: Float>(
    exact: &mut Exact<'_>,
    (low, high): (f64, f64),
    zero: Option<Edge>,
    form: Form,
) -> Option<Fitted<S>> {
    let (half, middle) = (0.5 * (high - low), 0.5 * (low + high));
    let origin =
        S::constant(zero.map_or_else(|| to_decimals(middle, ORIGIN * half), |zero| zero.at));
    let mut coefficients = Vec::with_capacity(form.functions);
    for function in 0..form.functions {
        // Of these the relative error counts, also beside the zero that they have in common.
        let is_relative = function == 0 || function == SIZE;
        let zero = zero.filter(|_| is_relative);
        // The quotient by the distance has one term less than β_lim.
        let terms = form.terms - usize::from(zero.is_some());
        let nodes: Vec<f64> = (0..terms)
            .map(|k| middle - half * (PI * (k as f64 + 0.5) / terms as f64).cos())
            .collect();
        let mut values = Vec::with_capacity(terms);
        for r in &nodes {
            let value = exact.function(function, *r)?;
            let factor = if function < ANGLE {
                form.side_factor
            } else {
                1.0
            };
            values.push(factor * value / zero.map_or(1.0, |zero| zero.distance(*r)));
        }
        if function == ANGLE {
            unwrap(&mut values);
        }
        let places: Vec<f64> = nodes.iter().map(|r| (r - origin.to_f64()) / half).collect();
        let mut through = interpolated(&places, &values);
        // What may be lost of each coefficient, at the end of the piece.
        let least = values
            .iter()
            .fold(f64::INFINITY, |least, value| least.min(value.abs()));
        let least = if is_relative { least } else { 1.0 };
        let mut power = 1.0;
        for coefficient in &mut through {
            *coefficient = to_decimals(*coefficient / power, form.rounding * least / power);
            power *= half;
        }
        if let Some(zero) = zero {
            // The zero is where the rounding of the origin leaves it.
            through = times_distance(&through, -zero.distance(origin.to_f64()));
        }
        coefficients.push(through.into_iter().map(S::constant).collect());
    }
    // What lies below is the business of the piece before, beside a zero to the last digit.
    let mut from = S::constant(low);
    let below = zero.is_some_and(|zero| zero.at <= low && zero.distance(from.to_f64()) < 0.0);
    if below || from.to_f64() < low {
        from = above(low);
    }
    Some(Fitted {
        from,
        origin,
        coefficients,
    })
}

/// A polynomial in t times t − rest.
fn times_distance(coefficients: &[f64], rest: f64) -> Vec<f64> {
    let lower = coefficients.iter().copied().chain([0.0]);
    let higher = [0.0].into_iter().chain(coefficients.iter().copied());
    lower
        .zip(higher)
        .map(|(same, before)| before - rest * same)
        .collect()
}

/// Angles moved by whole turns so that neighbours are closest.
fn unwrap(angles: &mut [f64]) {
    let mut last: Option<f64> = None;
    for angle in angles {
        if let Some(last) = last {
            *angle += ((last - *angle) / (2.0 * PI)).round() * 2.0 * PI;
        }
        last = Some(*angle);
    }
}

/// The coefficients of the polynomial through values at places, by divided differences.
pub(super) fn interpolated(places: &[f64], values: &[f64]) -> Vec<f64> {
    let mut differences = values.to_vec();
    let count = places.len();
    for order in 1..count {
        for k in (order..count).rev() {
            let (Some(&value), Some(&before)) = (differences.get(k), differences.get(k - 1)) else {
                continue;
            };
            let (Some(&here), Some(&there)) = (places.get(k), places.get(k - order)) else {
                continue;
            };
            if let Some(difference) = differences.get_mut(k) {
                *difference = (value - before) / (here - there);
            }
        }
    }
    // From Newton's form to powers, from the last factor inwards.
    let mut powers: Vec<f64> = Vec::with_capacity(count);
    for (difference, place) in differences.iter().zip(places).rev() {
        let mut shifted = vec![*difference];
        shifted.extend(powers.iter().copied());
        for (same, before) in shifted.iter_mut().zip(&powers) {
            *same -= place * before;
        }
        powers = shifted;
    }
    powers
}
