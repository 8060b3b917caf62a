//! A rational function of r as a product over its zeros and poles, as a table stores it.

use frictiongen_kernel::Float;
use frictiongen_kernel::table::{Factor, Quotient};

/// Rational function of r as a product over its zeros and poles, in owned vectors. The kernel reads it as a
/// [`Quotient`].
#[derive(Clone, Debug)]
pub struct Product<S> {
    /// Constant factor of the function.
    pub gain: S,
    /// True if the factors belong to the square of the function. The function is then the square root of the product.
    pub squared: bool,
    /// Factors of the numerator, one for each zero or pair of zeros.
    pub numerator: Vec<Factor<S>>,
    /// Factors of the denominator, one for each pole or pair of poles.
    pub denominator: Vec<Factor<S>>,
}

impl<S: Float> Product<S> {
    /// Returns the function as [`Quotient`] of the kernel crate.
    #[must_use]
    pub fn quotient(&self) -> Quotient<'_, S> {
        Quotient {
            gain: self.gain,
            squared: self.squared,
            numerator: &self.numerator,
            denominator: &self.denominator,
        }
    }

    /// Returns the operations of one evaluation of the product: the number of additions and multiplications, of
    /// divisions, and of square roots.
    #[must_use]
    pub fn operations(&self) -> (usize, usize, usize) {
        let factors = self.numerator.iter().chain(&self.denominator);
        // Each count includes the operations of the factor itself and its multiplication with the other factors.
        let plain = factors.map(|factor| match factor {
            Factor::Zero { .. } => 5,
            Factor::Pair { .. } => 8,
            Factor::Real { .. } => 3,
        });
        let divisions = usize::from(!self.denominator.is_empty());
        (
            1 + plain.sum::<usize>(),
            divisions,
            usize::from(self.squared),
        )
    }

    /// Returns the number of numbers that the product stores.
    #[must_use]
    pub fn numbers(&self) -> usize {
        let factors = self.numerator.iter().chain(&self.denominator);
        1 + factors
            .map(|factor| match factor {
                Factor::Zero { .. } => 2,
                Factor::Pair { .. } => 4,
                Factor::Real { .. } => 1,
            })
            .sum::<usize>()
    }
}
