//! Power series of one quantity over a stretch (time interval).

use crate::Float;

/// Number of coefficients of a power series in `f64`. In a stretch of one radian, the first neglected term is below
/// 1/22! = 1e-21 of the first term.
pub const TERMS: usize = 22;

/// Returns the number of coefficients that a power series needs in this number type. In `f32`, the first neglected term
/// is below 1/12! = 2e-9 of the first term.
pub(super) fn terms_of<S: Float>() -> usize {
    if S::EPSILON < 1e-10 { TERMS } else { 12 }
}

/// Coefficients of the power series of one quantity over a stretch (time interval). The variable is the elapsed
/// fraction of the stretch, from 0 to 1.
pub type Poly<S> = [S; TERMS];

/// Returns the coefficients of a quantity that is always 0.
pub(super) fn nothing<S: Float>() -> Poly<S> {
    [S::constant(0.0); TERMS]
}

/// Returns the value of the polynomial `terms` at the point `at`.
pub fn value<S: Float>(terms: &[S], at: S) -> S {
    let terms = terms.iter().rev();
    terms.fold(S::constant(0.0), |sum, term| sum * at + *term)
}
