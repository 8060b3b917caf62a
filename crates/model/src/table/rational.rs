//! Rational functions of s by their zeros and poles.

use super::zeros::Zero;

/// A rational function of s = ir, given by its zeros and poles up to a constant factor.
#[derive(Clone, Debug)]
pub(super) struct Rational {
    pub zeros: Vec<Zero>,
    pub poles: Vec<Zero>,
}
