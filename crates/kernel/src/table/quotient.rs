//! Real rational functions of the frequency ratio r. Each function is stored as a quotient of products over its zeros
//! and poles. Close to a zero or pole, each factor keeps its digits.

use crate::number::scalar::Float;

/// Real factor in the numerator or the denominator of a rational function of r², where r is the frequency ratio. The
/// factor belongs to one zero or pole of the function, or to a pair of them. A zero or pole is given as s = x + iy,
/// where s = ir. In a damped chain the rational function is the squared absolute value of a response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor<S> {
    /// Factor (r − y)(r + y) of a zero on the imaginary axis of s. The variant stores y as a rounded value and its
    /// rounding error, so that r − y keeps its digits close to the zero.
    Zero {
        /// Imaginary part y of the zero, rounded to the number type.
        at: S,
        /// Rounding error of y: the exact y minus the rounded y.
        rest: S,
    },
    /// Factor ((r − y)(r + y) + x²)² + 4x²y² of a pair of zeros s = x ± iy off the imaginary axis.
    Pair {
        /// Imaginary part y of the zeros, rounded to the number type.
        at: S,
        /// Rounding error of y: the exact y minus the rounded y.
        rest: S,
        /// x², the square of the real part of the zeros.
        off: S,
        /// Constant term 4x²y² of the factor, where x and y are the real and the imaginary part of the zeros.
        least: S,
    },
    /// Factor r² + x² of a real zero s = x.
    Real {
        /// x², the square of the real zero.
        off: S,
    },
}

impl<S: Float> Factor<S> {
    /// Returns the factor at the frequency ratio r.
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

/// Rational function of the frequency ratio r. The function is `gain` times the product of the factors in `numerator`,
/// divided by the product of the factors in `denominator`. If `squared` is true, the function is `gain` times the
/// square root of this quotient.
#[derive(Clone, Copy, Debug)]
pub struct Quotient<'a, S> {
    /// Constant factor of the function.
    pub gain: S,
    /// True if the factors belong to the square of the function. The code then takes the square root of the quotient.
    pub squared: bool,
    /// Factors of the numerator, one for each zero or pair of zeros of the function.
    pub numerator: &'a [Factor<S>],
    /// Factors of the denominator, one for each pole or pair of poles of the function.
    pub denominator: &'a [Factor<S>],
}

impl<S: Float> Quotient<'_, S> {
    /// Returns the absolute value of the function at the frequency ratio r.
    #[inline(always)]
    #[must_use]
    pub fn magnitude(&self, r: S) -> S {
        self.value(r).abs()
    }

    /// Returns the function at the frequency ratio r. At a pole the result is infinite. The result may be negative,
    /// unless the function is a square root.
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

/// Returns the product of all factors at the frequency ratio r. The code multiplies the first twelve factors without a
/// loop, so that factors known at compile time become plain arithmetic.
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

/// Multiplies `product` by the factor at the index `place` of the list. If the list has no factor at this index,
/// `product` is returned unchanged.
#[inline(always)]
fn times<S: Float>(product: S, factors: &[Factor<S>], place: usize, r: S) -> S {
    match factors.get(place) {
        Some(factor) => product * factor.value(r),
        None => product,
    }
}
