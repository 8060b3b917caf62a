//! Complex operations that the formulas need, on any [`Scalar`].
//!
//! The operators of num-complex require traits that symbolic scalars cannot have. Without damping every imaginary part
//! is the constant 0. The argument `damped` is then false, and the imaginary part is not computed.

use crate::number::scalar::Scalar;
pub use num_complex::Complex;

/// Returns `re` + 0i.
#[inline(always)]
pub fn real<S: Scalar>(re: S) -> Complex<S> {
    Complex::new(re, S::constant(0.0))
}

/// Returns a + b.
#[inline(always)]
pub fn add<S: Scalar>(a: Complex<S>, b: Complex<S>) -> Complex<S> {
    Complex::new(a.re + b.re, a.im + b.im)
}

/// Returns k·a for a real k.
#[inline(always)]
pub fn scale<S: Scalar>(a: Complex<S>, k: S) -> Complex<S> {
    Complex::new(a.re * k, a.im * k)
}

/// Returns a·b.
#[inline(always)]
pub fn mul<S: Scalar>(a: Complex<S>, b: Complex<S>, damped: bool) -> Complex<S> {
    if damped {
        Complex::new(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re)
    } else {
        real(a.re * b.re)
    }
}

/// Returns |Re| + |Im|, which is of the order of |a| and needs no square root.
#[inline(always)]
pub(crate) fn size<S: Scalar>(a: Complex<S>, damped: bool) -> S {
    if damped {
        a.re.abs() + a.im.abs()
    } else {
        a.re.abs()
    }
}

/// Returns a where the condition is true, b elsewhere.
#[inline(always)]
pub(crate) fn select<S: Scalar>(
    condition: S::Condition,
    a: Complex<S>,
    b: Complex<S>,
) -> Complex<S> {
    Complex::new(
        S::select(condition, a.re, b.re),
        S::select(condition, a.im, b.im),
    )
}

/// Returns 1/a for a ≠ 0 of any size.
#[inline(always)]
pub fn reciprocal<S: Scalar>(a: Complex<S>, damped: bool) -> Complex<S> {
    if damped {
        inverse(a).0
    } else {
        real((S::constant(1.0) / a.re).named("inverse_re", None))
    }
}

/// Returns 1/a for a ≠ 0 of any size, and 1/|a|² as the product of two numbers of about 1/|a|.
#[inline(always)]
pub(crate) fn inverse<S: Scalar>(a: Complex<S>) -> (Complex<S>, (S, S)) {
    let inverse = (S::constant(1.0) / size(a, true)).named("inverse_size", None);
    let (re, im) = (
        (a.re * inverse).named("unit_re", None),
        (a.im * inverse).named("unit_im", None),
    );
    let k = (inverse / (re * re + im * im)).named("inverse_modulus", None);
    let reciprocal = Complex::new(
        (re * k).named("inverse_re", None),
        (-(im * k)).named("inverse_im", None),
    );
    (reciprocal, (inverse, k))
}

/// Returns 1/a for |Re| + |Im| = 1. `mode` only names values in emitted code.
#[inline(always)]
pub fn reciprocal_of_unit<S: Scalar>(a: Complex<S>, mode: Option<usize>) -> Complex<S> {
    let inverse = (S::constant(1.0) / (a.re * a.re + a.im * a.im)).named("inverse_modulus", mode);
    Complex::new(a.re * inverse, -(a.im * inverse))
}

/// Returns |a| for a of any size.
#[inline(always)]
pub fn modulus<S: Scalar>(a: Complex<S>, damped: bool) -> S {
    if damped { a.re.hypot(a.im) } else { a.re.abs() }
}
