//! Bounds the rounding errors of the emitted evaluation of a polynomial.

use super::request::is_single;
use crate::interval::Interval;
use frictiongen_kernel::Float;

/// Allowance for products that underflow in the evaluation of a polynomial in single precision. It is about 70 times
/// the smallest positive number.
const UNDERFLOW_SINGLE: f64 = 1e-43;
/// Allowance for products that underflow in the evaluation of a polynomial in double precision. It is about 200 times
/// the smallest positive number.
const UNDERFLOW: f64 = 1e-321;
/// Factor on a sum of rounding errors. It covers the products of these errors, and the rounding of the sum itself.
const UP: f64 = 1.001;

/// Returns an upper bound on the rounding error of the term c_k tᵏ in the emitted evaluation, in rounding units.
///
/// The sum c_2j + c_2j+1·t has one rounding, and its second term has one more. The addition of the higher terms has
/// one rounding. Each of the j products with t² has three roundings: of the product, of t² and of a sum. The
/// difference r − origin is exact if both numbers are within a factor of two. Otherwise it adds one rounding for each
/// power.
fn counts(power: usize, exact_difference: bool) -> f64 {
    let of_difference = if exact_difference { 0 } else { power };
    (power % 2 + 2 + 3 * (power / 2) + of_difference) as f64
}

/// Returns an upper bound on the rounding error of a polynomial's evaluation in the scalar type of the table. If the
/// piece is near a zero of the function, `away` is the range of the distances of r from the zero. The result is then
/// the error divided by this distance.
pub fn rounding<S: Float>(
    coefficients: &[f64],
    origin: f64,
    (from, to): (f64, f64),
    away: Option<Interval>,
) -> f64 {
    let unit = 0.5 * S::EPSILON;
    let t = (from - origin).abs().max((to - origin).abs());
    let exact = 0.5 * origin <= from && to <= 2.0 * origin;
    let nearest = away.map(|away| away.low.abs().min(away.high.abs()));
    let mut sum = 0.0;
    let mut power = 1.0;
    for (k, coefficient) in coefficients.iter().enumerate() {
        let term = coefficient.abs() * counts(k, exact) * unit;
        sum += match nearest {
            None => term * power,
            // For k > 0, tᵏ divided by the distance from the zero grows with this distance, apart from the offset of
            // the origin.
            Some(nearest) if k == 0 => term / nearest,
            Some(_) => term * power / t * 2.0,
        };
        power *= t;
    }
    // The allowance covers products that underflow, and the roundings of this function itself.
    let smallest = if is_single::<S>() {
        UNDERFLOW_SINGLE
    } else {
        UNDERFLOW
    };
    let lost = smallest / nearest.unwrap_or(1.0);
    UP * sum + lost
}

#[cfg(test)]
mod tests {
    use super::super::fit::Fitted;
    use super::rounding;
    use crate::samples::random;

    /// Checks the bound on rounding errors for the emitted evaluation in single precision. The errors must stay within
    /// the bound and come close to it.
    #[test]
    fn roundings_are_within_their_bound() {
        let (mut state, mut nearest) = (3, 0.0_f64);
        for round in 0..8000 {
            let terms = [4, 6, 8, 10][round % 4];
            let mut number = || random(&mut state);
            let origin = (0.2 + 2.0 * number()) as f32;
            let (from, to) = (origin * (0.3 + 0.7 * number() as f32), origin * 1.3);
            let coefficients = (0..terms).map(|_| (number() - 0.3) as f32);
            let coefficients: Vec<f32> = coefficients.collect();
            let r = (from + (to - from) * number() as f32).clamp(from, to);
            let wide: Vec<f64> = coefficients.iter().map(|c| f64::from(*c)).collect();
            let ends = (f64::from(from), f64::from(to));
            let bound = rounding::<f32>(&wide, f64::from(origin), ends, None);
            let t = f64::from(r) - f64::from(origin);
            let exact = wide.iter().rev().fold(0.0, |sum, c| sum * t + c);
            let piece = Fitted {
                from,
                origin,
                coefficients: vec![coefficients],
            };
            let off = (f64::from(piece.value(0, r)) - exact).abs();
            assert!(off <= bound, "{off:e} for {bound:e}: {piece:?} at {r}");
            nearest = nearest.max(off / bound);
        }
        assert!(nearest > 0.2, "{nearest}");
    }
}
