//! Quotients of products. They give a rational function of r by its zeros and poles, each of which keeps its digits.

use crate::number::scalar::Float;

/// Factor in r², from a zero s = x + iy of the polynomial in s = ir, or from its square for an undamped chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor<S> {
    /// Factor (r − y)(r + y). It stores y as a rounded value and a rest, so that r − y keeps its digits close to the
    /// zero.
    Zero {
        /// Imaginary part y of the zero, rounded to the scalar.
        at: S,
        /// Rounding error of y: the exact y minus the rounded y.
        rest: S,
    },
    /// Factor ((r − y)(r + y) + x²)² + 4x²y² of a pair of zeros off the imaginary axis.
    Pair {
        /// Imaginary part y of the zero, rounded to the scalar.
        at: S,
        /// Rounding error of y: the exact y minus the rounded y.
        rest: S,
        /// x², the square of the real part of the zeros.
        off: S,
        /// 4x²y², the constant term.
        least: S,
    },
    /// Factor r² + x² of a zero on the real axis of s.
    Real {
        /// x², the square of the zero.
        off: S,
    },
}

impl<S: Float> Factor<S> {
    /// Returns the factor at r.
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

/// Rational function gain·Π numerator/Π denominator, or gain times the root of that quotient if `squared` is set.
#[derive(Clone, Copy, Debug)]
pub struct Quotient<'a, S> {
    /// Constant factor.
    pub gain: S,
    /// True if the factors are those of the square of the wanted function.
    pub squared: bool,
    /// Zeros.
    pub numerator: &'a [Factor<S>],
    /// Poles.
    pub denominator: &'a [Factor<S>],
}

impl<S: Float> Quotient<'_, S> {
    /// Returns the modulus of the quotient at r.
    #[inline(always)]
    #[must_use]
    pub fn size(&self, r: S) -> S {
        self.value(r).abs()
    }

    /// Returns the quotient at r, with its sign unless it is a root; infinite on a pole.
    #[inline(always)]
    #[must_use]
    pub fn value(&self, r: S) -> S {
        let (above, below) = (product(self.numerator, r), product(self.denominator, r));
        // A quotient without poles needs no division.
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

/// Returns the product of all factors at r. The first twelve are written out without a loop, so that constant factors
/// compile to plain arithmetic.
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

/// Multiplies a product by the factor at index `place`, if there is one.
#[inline(always)]
fn times<S: Float>(product: S, factors: &[Factor<S>], place: usize, r: S) -> S {
    match factors.get(place) {
        Some(factor) => product * factor.value(r),
        None => product,
    }
}
