//! Fits polynomials to the functions of a table in an interval of r, through Chebyshev points, and rounds their
//! coefficients.

use super::digits::{above, to_decimals};
use super::exact::{ANGLE, Exact, SIZE};
use super::split::LimitZero;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::polynomial;
use std::f64::consts::PI;

/// Step to which the code rounds the origin of a polynomial piece, as a fraction of half the length of the piece.
const ORIGIN: f64 = 0.1;
/// Smallest allowed relative error for which polynomials with four coefficients give the smallest table.
const FOUR_TERMS: f64 = 3e-3;
/// Smallest allowed relative error for which polynomials with six coefficients give the smallest table.
const SIX_TERMS: f64 = 1e-7;
/// Smallest allowed relative error for which polynomials with eight coefficients give the smallest table.
const EIGHT_TERMS: f64 = 1e-10;

/// A piece of a table. On its interval of r, a polynomial approximates each function of the table.
#[derive(Clone, Debug)]
pub struct Fitted<S> {
    /// Smallest r of the polynomial piece.
    pub from: S,
    /// Origin of the piece: its polynomials are in r − `origin`.
    pub origin: S,
    /// Coefficients of each function's polynomial in r − `origin`, from the constant term upwards.
    pub coefficients: Vec<Vec<S>>,
}

impl<S: Float> Fitted<S> {
    /// Returns the number of numbers that the polynomial piece stores.
    pub(super) fn numbers(&self) -> usize {
        2 + self.coefficients.iter().map(Vec::len).sum::<usize>()
    }

    /// Returns the value of a function's polynomial at r, in the arithmetic of the table. `function` is the index of
    /// the function. The value is NaN if the piece does not have the function.
    pub fn value(&self, function: usize, r: S) -> S {
        let coefficients = self.coefficients.get(function);
        coefficients.map_or(S::constant(f64::NAN), |of| polynomial(of, r - self.origin))
    }
}

/// Numbers of coefficients that a polynomial of a table may have.
pub(super) const TERMS: [usize; 4] = [4, 6, 8, 10];

/// Returns the number of coefficients of each polynomial with which a table of this accuracy stores the fewest
/// numbers.
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

/// Settings for the fit of a polynomial piece: number of functions, number of coefficients and rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct FitSettings {
    /// Number of functions in each piece. Each function has one polynomial.
    pub functions: usize,
    /// Number of coefficients of each function's polynomial.
    pub terms: usize,
    /// Factor by which the fitted β_lim differs from the exact β_lim. The functions a = β_lim·U/|V| and g =
    /// β_lim·G/|V|, from which the motion of the contact follows, contain the same factor.
    pub side_factor: f64,
    /// Largest change of a function, relative to β_lim, that may result if one coefficient is rounded to decimals.
    pub rounding: f64,
}

/// Fits one polynomial to each tabulated function over [low, high], with the settings `form`. If `zero` gives a zero r₀
/// of β_lim, the function fits the quotients β_lim/(r − r₀) and |V|/(r − r₀) instead. The relative error then stays
/// small up to the zero.
pub(super) fn fit<S: Float>(
    exact: &mut Exact<'_>,
    (low, high): (f64, f64),
    zero: Option<LimitZero>,
    form: FitSettings,
) -> Option<Fitted<S>> {
    let (half, middle) = (0.5 * (high - low), 0.5 * (low + high));
    let origin =
        S::constant(zero.map_or_else(|| to_decimals(middle, ORIGIN * half), |zero| zero.at));
    let mut coefficients = Vec::with_capacity(form.functions);
    for function in 0..form.functions {
        // For β_lim and |V| the relative error matters, also near their common zero.
        let is_relative = function == 0 || function == SIZE;
        let zero = zero.filter(|_| is_relative);
        // The quotient by r − r₀ has one term fewer than β_lim.
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
        // The allowed rounding of each coefficient follows from its effect at the ends of the piece.
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
            // The rounded origin differs from the exact zero, so the polynomial is multiplied by the distance from the
            // exact zero.
            through = times_distance(&through, -zero.distance(origin.to_f64()));
        }
        coefficients.push(through.into_iter().map(S::constant).collect());
    }
    // The previous piece covers all r below `low`. Near a zero the start of this piece must therefore be exact to the
    // last digit.
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

/// Returns the coefficients of a polynomial in t, multiplied by t − `rest`.
fn times_distance(coefficients: &[f64], rest: f64) -> Vec<f64> {
    let lower = coefficients.iter().copied().chain([0.0]);
    let higher = [0.0].into_iter().chain(coefficients.iter().copied());
    lower
        .zip(higher)
        .map(|(same, before)| before - rest * same)
        .collect()
}

/// Adds whole turns to the angles in a list, so that neighbouring angles differ as little as possible.
fn unwrap(angles: &mut [f64]) {
    let mut last: Option<f64> = None;
    for angle in angles {
        if let Some(last) = last {
            *angle += ((last - *angle) / (2.0 * PI)).round() * 2.0 * PI;
        }
        last = Some(*angle);
    }
}

/// Returns the coefficients of the polynomial through values at given points, by divided
/// differences.
pub fn interpolated(places: &[f64], values: &[f64]) -> Vec<f64> {
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
    // Converts Newton's form to powers of the variable, from the last factor inwards.
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
