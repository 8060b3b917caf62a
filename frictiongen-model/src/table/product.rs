//! A product over zeros and poles, as a table stores it.

use frictiongen_kernel::Float;
use frictiongen_kernel::table::{Factor, Quotient};

/// The kernel's [`Quotient`], with owned vectors.
#[derive(Clone, Debug)]
pub struct Product<S> {
    /// The constant factor of the product.
    pub gain: S,
    /// True if the factors describe the square of the function.
    pub squared: bool,
    /// The zeros of the product, as factors.
    pub numerator: Vec<Factor<S>>,
    /// The poles of the product, as factors.
    pub denominator: Vec<Factor<S>>,
}

impl<S: Float> Product<S> {
    /// Returns the product as the kernel reads it.
    #[must_use]
    pub fn quotient(&self) -> Quotient<'_, S> {
        Quotient {
            gain: self.gain,
            squared: self.squared,
            numerator: &self.numerator,
            denominator: &self.denominator,
        }
    }

    /// Returns the numbers of additions and multiplications, of divisions, and of roots in one
    /// evaluation.
    #[must_use]
    pub fn operations(&self) -> (usize, usize, usize) {
        let factors = self.numerator.iter().chain(&self.denominator);
        // Each count includes the operations of the factor and the product with the others.
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

    /// Returns the number of stored numbers.
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
