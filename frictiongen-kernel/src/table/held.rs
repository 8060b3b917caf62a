//! Responses while the contact is held: rational functions of s = ir by their zeros and poles.

use super::quotient::Quotient;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;

/// A factor in s = ir, by a zero s = x + iy of a polynomial with real coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Root<S> {
    /// (s − x)² + y² = x² − (r − y)(r + y) − 2ixr, of the zeros x ± iy; y is given in two parts: the digits of r − y then
    /// hold beside the zero.
    Pair {
        /// y.
        at: S,
        /// What the rounding of y left out.
        rest: S,
        /// x².
        off: S,
        /// −2x.
        rate: S,
    },
    /// s − x, of a zero on the real axis of s.
    Real {
        /// −x.
        rate: S,
    },
}

impl<S: Float> Root<S> {
    /// The factor at r.
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

/// gain·Π numerator/Π denominator, complex.
#[derive(Clone, Copy, Debug)]
pub struct Transfer<'a, S> {
    /// What stands before it.
    pub gain: S,
    /// The zeros.
    pub numerator: &'a [Root<S>],
    /// The poles.
    pub denominator: &'a [Root<S>],
}

impl<S: Float> Transfer<'_, S> {
    /// The quotient at r; infinite or no number on a pole.
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

/// Π factors at r, if there are any: the first twelve without a loop, so that of constant factors nothing but arithmetic
/// remains.
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

/// A product with the factor at a place, if there is one.
#[inline(always)]
fn times<S: Float>(product: Complex<S>, roots: &[Root<S>], place: usize, r: S) -> Complex<S> {
    match roots.get(place) {
        Some(root) => complex::mul(product, root.value(r), true),
        None => product,
    }
}

/// A response while the contact is held, at any r.
#[derive(Clone, Copy, Debug)]
pub enum HeldResponse<'a, S> {
    /// The same at every r: of a mass that the held contact ties to its support or cuts off from the load.
    Fixed(S),
    /// Of an undamped chain: real, with its sign.
    Undamped(Quotient<'a, S>),
    /// Of a damped chain.
    Damped(Transfer<'a, S>),
}

impl<S: Float> HeldResponse<'_, S> {
    /// The response at r.
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
