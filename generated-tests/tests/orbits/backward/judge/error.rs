//! Computes the error of an answer against the exact value.

use super::Answer;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Complex, Float};

/// Returns the difference of two angles, reduced to at most half a turn.
pub fn angle(difference: Dd) -> Dd {
    let turn = Dd::PI + Dd::PI;
    let turns = Float::floor(difference / turn + Dd::from(0.5));
    difference - turns * turn
}

pub fn modulus(value: Complex<Dd>) -> Dd {
    complex::modulus(value, true)
}

pub(super) fn is_finite(value: Complex<Dd>) -> bool {
    value.re.to_f64().is_finite() && value.im.to_f64().is_finite()
}

pub(super) fn same(a: Complex<Dd>, b: Complex<Dd>) -> bool {
    a.re == b.re && a.im == b.im
}

/// Returns true if an answer is a limit and infinite. Near a zero of its denominator a limit grows without bound, so
/// its reciprocal is compared.
pub(super) fn may_be_infinite(answer: &Answer) -> bool {
    answer.watched.asked.is_limit() && answer.got.re.to_f64() == f64::INFINITY
}

/// Returns the error of an answer. For an infinite limit it is 1/got − 1/exact, multiplied by exact².
pub(super) fn error(answer: &Answer, exact: Complex<Dd>) -> Complex<Dd> {
    let (got, zero) = (answer.got, Dd::from(0.0));
    if may_be_infinite(answer) {
        Complex::new(-exact.re, zero)
    } else if answer.watched.asked.is_angle() {
        Complex::new(angle(got.re - exact.re), zero)
    } else {
        Complex::new(got.re - exact.re, got.im - exact.im)
    }
}

/// Returns the sign that the derivatives of an answer have in [`error`].
pub(super) fn sense(answer: &Answer) -> f64 {
    if may_be_infinite(answer) { -1.0 } else { 1.0 }
}
