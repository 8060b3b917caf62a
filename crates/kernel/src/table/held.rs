//! Responses of the chain while the contact is stuck, as rational functions of s = ir, where r is the frequency ratio.
//! The code stores the zeros and poles of each function.

use super::quotient::Quotient;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;

/// Factor of a polynomial in s = ir with real coefficients, where r is the frequency ratio. The factor belongs to one
/// real zero s = x, or to one pair of complex zeros s = x ± iy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Root<S> {
    /// Factor of the pair of zeros x ± iy: (s − x)² + y² = x² − (r − y)(r + y) − 2ixr. The variant stores y as a
    /// rounded value and its rounding error, so that r − y keeps its digits close to the zero.
    Pair {
        /// Imaginary part y of the zeros, rounded to the number type.
        at: S,
        /// Rounding error of y: the exact y minus the rounded y.
        rest: S,
        /// x², the square of the real part of the zeros.
        off: S,
        /// Coefficient −2x of r in the imaginary part of the factor, where x is the real part of the zeros.
        rate: S,
    },
    /// Factor s − x of a real zero x.
    Real {
        /// −x, where x is the real zero of the factor.
        rate: S,
    },
}

impl<S: Float> Root<S> {
    /// Returns the factor at the frequency ratio r.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> Complex<S> {
        match *self {
            Self::Pair {
                at,
                rest,
                off,
                rate,
            } => Complex::new(off - ((r - at) - rest) * (r + at), rate * r),
            Self::Real { rate } => Complex::new(rate, r),
        }
    }
}

/// Complex rational function of s = ir, where r is the frequency ratio. The function is `gain` times the product of the
/// factors in `numerator`, divided by the product of the factors in `denominator`.
#[derive(Clone, Copy, Debug)]
pub struct Transfer<'a, S> {
    /// Constant factor of the rational function.
    pub gain: S,
    /// Factors of the numerator, one for each real zero or pair of complex zeros of the function.
    pub numerator: &'a [Root<S>],
    /// Factors of the denominator, one for each real pole or pair of complex poles of the function.
    pub denominator: &'a [Root<S>],
}

impl<S: Float> Transfer<'_, S> {
    /// Returns the rational function at the frequency ratio r. At a pole the result is infinite or NaN.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> Complex<S> {
        let above = match product(self.numerator, r) {
            Some(above) => complex::scale(above, self.gain),
            None => complex::real(self.gain),
        };
        match product(self.denominator, r) {
            Some(below) => complex::mul(above, complex::reciprocal(below, true), true),
            None => above,
        }
    }
}

/// Returns the product of all factors at the frequency ratio r, or `None` if there are no factors. The code multiplies
/// the first twelve factors without a loop, so that factors known at compile time become plain arithmetic.
#[inline(always)]
fn product<S: Float>(roots: &[Root<S>], r: S) -> Option<Complex<S>> {
    let mut product = roots.first()?.value(r);
    product = times(product, roots, 1, r);
    product = times(product, roots, 2, r);
    product = times(product, roots, 3, r);
    product = times(product, roots, 4, r);
    product = times(product, roots, 5, r);
    product = times(product, roots, 6, r);
    product = times(product, roots, 7, r);
    product = times(product, roots, 8, r);
    product = times(product, roots, 9, r);
    product = times(product, roots, 10, r);
    product = times(product, roots, 11, r);
    for root in roots.iter().skip(12) {
        product = complex::mul(product, root.value(r), true);
    }
    Some(product)
}

/// Multiplies `product` by the factor at the index `place` of the list. If the list has no factor at this index,
/// `product` is returned unchanged.
#[inline(always)]
fn times<S: Float>(product: Complex<S>, roots: &[Root<S>], place: usize, r: S) -> Complex<S> {
    match roots.get(place) {
        Some(root) => complex::mul(product, root.value(r), true),
        None => product,
    }
}

/// Response of one mass or of the contact force while the contact is stuck, as a function of the frequency ratio r.
#[derive(Clone, Copy, Debug)]
pub enum HeldResponse<'a, S> {
    /// Response that does not depend on the frequency ratio. The stuck contact then fixes the mass to its support, or
    /// isolates the mass from the load.
    Fixed(S),
    /// Response of an undamped chain. It is real and may be negative.
    Undamped(Quotient<'a, S>),
    /// Response of a damped chain. It is complex.
    Damped(Transfer<'a, S>),
}

impl<S: Float> HeldResponse<'_, S> {
    /// Returns the complex response at the frequency ratio r.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> Complex<S> {
        match self {
            Self::Fixed(amplitude) => complex::real(*amplitude),
            Self::Undamped(quotient) => complex::real(quotient.value(r)),
            Self::Damped(transfer) => transfer.value(r),
        }
    }
}
