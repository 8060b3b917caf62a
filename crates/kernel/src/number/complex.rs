//! Complex operations that the formulas need, over any [`Scalar`].
//!
//! The operators of the crate num-complex require traits that symbolic scalars cannot implement. This module replaces
//! these operators. Without damping every imaginary part is the constant 0. The argument `damped` is then false, and
//! the functions compute no imaginary part.

use crate::number::scalar::Scalar;
pub use num_complex::Complex;

/// Returns the complex number `re` + 0i.
#[inline(always)]
pub fn real<S: Scalar>(re: S) -> Complex<S> {
    Complex::new(re, S::constant(0.0))
}

/// Returns the sum a + b of two complex numbers.
#[inline(always)]
pub fn add<S: Scalar>(a: Complex<S>, b: Complex<S>) -> Complex<S> {
    Complex::new(a.re + b.re, a.im + b.im)
}

/// Returns k·a for a complex number a and a real factor k.
#[inline(always)]
pub fn scale<S: Scalar>(a: Complex<S>, k: S) -> Complex<S> {
    Complex::new(a.re * k, a.im * k)
}

/// Returns the product a·b. If `damped` is false, returns the product of the real parts.
#[inline(always)]
pub fn mul<S: Scalar>(a: Complex<S>, b: Complex<S>, damped: bool) -> Complex<S> {
    if damped {
        Complex::new(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re)
    } else {
        real(a.re * b.re)
    }
}

/// Returns |Re a| + |Im a|. This sum has the same order of magnitude as |a|, and needs no square root.
#[inline(always)]
pub(crate) fn size<S: Scalar>(a: Complex<S>, damped: bool) -> S {
    if damped {
        a.re.abs() + a.im.abs()
    } else {
        a.re.abs()
    }
}

/// Returns the complex number a if the condition is true, and b if it is false.
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

/// Gives names to the real and the imaginary part of a complex number, as [`Scalar::named`] does. `names` contains the
/// name and the explanation of each part.
#[inline(always)]
pub(crate) fn named<S: Scalar>(
    a: Complex<S>,
    names: [(&'static str, &'static str); 2],
    mode: Option<usize>,
) -> Complex<S> {
    let [(re, about_re), (im, about_im)] = names;
    Complex::new(
        a.re.named(re, about_re, mode),
        a.im.named(im, about_im, mode),
    )
}

/// Returns 1/a for a ≠ 0, without overflow of |a|².
#[inline(always)]
pub fn reciprocal<S: Scalar>(a: Complex<S>, damped: bool) -> Complex<S> {
    if damped {
        inverse(a).0
    } else {
        real((S::constant(1.0) / a.re).named("inverse_re", "Re of the reciprocal", None))
    }
}

/// Returns 1/a for a complex a ≠ 0, and two numbers of about 1/|a| whose product is 1/|a|². The product itself could
/// overflow.
#[inline(always)]
pub(crate) fn inverse<S: Scalar>(a: Complex<S>) -> (Complex<S>, (S, S)) {
    let inverse = (S::constant(1.0) / size(a, true)).named(
        "inverse_norm",
        "1/(|Re| + |Im|) of the divisor",
        None,
    );
    let (re, im) = (
        (a.re * inverse).named("unit_re", "Re of the divisor, over |Re| + |Im|", None),
        (a.im * inverse).named("unit_im", "Im of the divisor, over |Re| + |Im|", None),
    );
    let k = (inverse / (re * re + im * im)).named(
        "inverse_modulus",
        "(1/(|Re| + |Im|))/(Re² + Im²) of `unit_re`, `unit_im`",
        None,
    );
    let reciprocal = Complex::new(
        (re * k).named("inverse_re", "Re of the reciprocal", None),
        (-(im * k)).named("inverse_im", "Im of the reciprocal", None),
    );
    (reciprocal, (inverse, k))
}

/// Returns 1/a for a complex number a that is scaled to |Re a| + |Im a| = 1. `mode` serves only for the names of
/// variables in emitted code.
#[inline(always)]
pub fn reciprocal_of_unit<S: Scalar>(a: Complex<S>, mode: Option<usize>) -> Complex<S> {
    let inverse = (S::constant(1.0) / (a.re * a.re + a.im * a.im)).named(
        "inverse_modulus",
        "1/(Re² + Im²) of `unit_re`, `unit_im`",
        mode,
    );
    Complex::new(a.re * inverse, -(a.im * inverse))
}

/// Returns |a| without overflow of |a|². If `damped` is false, returns |Re a|.
#[inline(always)]
pub fn modulus<S: Scalar>(a: Complex<S>, damped: bool) -> S {
    if damped { a.re.hypot(a.im) } else { a.re.abs() }
}
