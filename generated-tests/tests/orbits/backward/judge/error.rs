//! How far an answer is off what is exact.

use super::Answer;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Complex, Float};

/// An angle's distance, within half a turn.
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

/// A limit grows without bound beside a zero of what it is divided by: there its reciprocal is compared.
pub(super) fn may_be_infinite(answer: &Answer) -> bool {
    answer.watched.asked.is_limit() && answer.got.re.to_f64() == f64::INFINITY
}

/// How far an answer is off; of what may be infinite, 1/got − 1/exact, times exact².
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

/// The sign of its derivatives in [`error`].
pub(super) fn sense(answer: &Answer) -> f64 {
    if may_be_infinite(answer) { -1.0 } else { 1.0 }
}
