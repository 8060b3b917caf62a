//! Quotients of products: a rational function of r by its zeros and poles, each of which keeps its digits.

use crate::number::scalar::Float;

/// A factor in r², by a zero s = x + iy of the polynomial in s = ir (or by its square for an undamped chain).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor<S> {
    /// (r − y)(r + y), y given in two parts: the digits of r − y then hold beside the zero.
    Zero {
        /// y.
        at: S,
        /// What the rounding of y left out.
        rest: S,
    },
    /// ((r − y)(r + y) + x²)² + 4x²y², of a pair of zeros beside the axis.
    Pair {
        /// y.
        at: S,
        /// What the rounding of y left out.
        rest: S,
        /// x².
        off: S,
        /// 4x²y².
        least: S,
    },
    /// r² + x², of a zero on the real axis of s.
    Real {
        /// x².
        off: S,
    },
}

impl<S: Float> Factor<S> {
    /// The factor at r.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> S {
        match *self {
            Self::Zero { at, rest } => ((r - at) - rest) * (r + at),
            Self::Pair {
                at,
                rest,
                off,
                least,
            } => {
                let beside = ((r - at) - rest) * (r + at) + off;
                beside * beside + least
            }
            Self::Real { off } => r * r + off,
        }
    }
}

/// gain·Π numerator/Π denominator, or its root where the factors are those of squares.
#[derive(Clone, Copy, Debug)]
pub struct Quotient<'a, S> {
    /// What stands before it.
    pub gain: S,
    /// The factors are those of the squares of what is meant.
    pub squared: bool,
    /// The zeros.
    pub numerator: &'a [Factor<S>],
    /// The poles.
    pub denominator: &'a [Factor<S>],
}

impl<S: Float> Quotient<'_, S> {
    /// The size of the quotient at r.
    #[inline(always)]
    #[must_use]
    pub fn size(&self, r: S) -> S {
        self.value(r).abs()
    }

    /// The quotient at r, with its sign where there is one; infinite on a pole.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> S {
        let (above, below) = (product(self.numerator, r), product(self.denominator, r));
        // A quotient without poles costs no division.
        let quotient = if self.denominator.is_empty() {
            above
        } else {
            above / below
        };
        if self.squared {
            self.gain * quotient.sqrt()
        } else {
            self.gain * quotient
        }
    }
}

/// Π factors at r: the first twelve without a loop, so that of constant factors nothing but arithmetic remains.
#[inline(always)]
fn product<S: Float>(factors: &[Factor<S>], r: S) -> S {
    let mut product = S::constant(1.0);
    product = times(product, factors, 0, r);
    product = times(product, factors, 1, r);
    product = times(product, factors, 2, r);
    product = times(product, factors, 3, r);
    product = times(product, factors, 4, r);
    product = times(product, factors, 5, r);
    product = times(product, factors, 6, r);
    product = times(product, factors, 7, r);
    product = times(product, factors, 8, r);
    product = times(product, factors, 9, r);
    product = times(product, factors, 10, r);
    product = times(product, factors, 11, r);
    for factor in factors.iter().skip(12) {
        product = product * factor.value(r);
    }
    product
}

/// A product with the factor at a place, if there is one.
#[inline(always)]
fn times<S: Float>(product: S, factors: &[Factor<S>], place: usize, r: S) -> S {
    match factors.get(place) {
        Some(factor) => product * factor.value(r),
        None => product,
    }
}
