//! Finds the exact instants of maxima of a sum over modes. Each exact instant is near the instant that the code under
//! test returned.

use frictiongen_kernel::number::dd::Dd;
use generated_tests::data::{DataAt, DataMotion};

/// Returns the zero of the function `of` near `from`. Returns `None` if the iteration leaves the neighbourhood of
/// `from` or does not converge. `epsilon` is the accuracy of `from`. The accuracy of the zero is a thousandth of
/// `epsilon`.
fn zero(of: impl Fn(Dd) -> Dd, from: Dd, epsilon: f64) -> Option<Dd> {
    // A second attempt has a wider first step. It serves functions that are flat at their zero.
    [epsilon, 1e6 * epsilon]
        .into_iter()
        .find_map(|first| secant(&of, from, first, 1e-3 * epsilon))
}

/// Largest distance, in rad, between the returned instant and the exact instant of the maximum. A phase that rounding
/// has shifted by a tenth of a radian still belongs to its own maximum.
const ABOUT: f64 = 0.5;

/// Number of rounding units by which the value at the returned instant may exceed the value at the exact instant.
const NEARLY: f64 = 64.0;

/// Finds a zero by the secant method, with the first step `first`, until a step is below `last`.
fn secant(of: impl Fn(Dd) -> Dd, from: Dd, first: f64, last: f64) -> Option<Dd> {
    let (mut before, mut tau) = (from, from + Dd::from(first));
    let mut at_before = of(before);
    for _ in 0..60 {
        let here = of(tau);
        if here.is_zero() {
            return Some(tau);
        }
        let step = here * (tau - before) / (here - at_before);
        (before, at_before, tau) = (tau, here, tau - step);
        if !((tau - from).abs().to_f64() < ABOUT) {
            return None;
        }
        if step.abs().to_f64() <= last {
            return Some(tau);
        }
    }
    None
}

/// Returns the instant near `tau` at which the velocity is zero.
pub fn stationary(motion: &DataMotion<'_, Dd>, tau: Dd, epsilon: f64) -> Option<Dd> {
    zero(|tau| motion.velocity(tau), tau, epsilon)
}

/// Returns the acceleration x̄″ at `tau` from a finite difference, for which the digits of [`Dd`] suffice.
pub fn acceleration(motion: &DataMotion<'_, Dd>, tau: Dd, epsilon: f64) -> Dd {
    let step = Dd::from(1e-3 * epsilon);
    (motion.velocity(tau + step) - motion.velocity(tau - step)) / (step + step)
}

/// Returns the instant of the exact motion's maximum near the returned instant. The returned instant need not be a
/// stationary point.
pub fn largest(motion: &DataMotion<'_, Dd>, found: Option<Dd>, epsilon: f64) -> Dd {
    let Some(found) = found else {
        let places = motion.peak().places;
        let mut places = places.iter().flatten();
        return places.next().map_or(Dd::from(0.0), |place| place.tau);
    };
    let height = |tau: Dd| motion.displacement(tau).abs();
    // A zero of the velocity counts only if it is neither a minimum nor another maximum.
    if let Some(tau) = stationary(motion, found, epsilon)
        && height(found) * Dd::from(1.0 - NEARLY * epsilon) <= height(tau)
    {
        return tau;
    }
    let below = |away: f64| -motion.displacement(found + Dd::from(away)).abs().to_f64();
    found + Dd::from(lowest(below, -ABOUT, ABOUT, f64::NEG_INFINITY))
}

/// Returns the instant of a maximum of the motion, near the instant `tau` of this maximum for other inputs.
pub fn followed(motion: &DataMotion<'_, Dd>, tau: Dd, epsilon: f64) -> Dd {
    let exact = stationary(motion, tau, epsilon);
    higher(|tau| motion.displacement(tau).abs(), exact, tau)
}

/// Returns the instant of the velocity constraint's maximum, near the instant that the search under test has found.
pub fn constraining(at: &DataAt<'_, Dd>, found: Dd, epsilon: f64) -> Dd {
    let exact = zero(|tau| at.constraint_slope(tau), found, epsilon);
    higher(|tau| at.constraint(tau), exact, found)
}

/// Returns the exact instant, or the instant that the library returned if the exact instant belongs to a smaller value.
fn higher(of: impl Fn(Dd) -> Dd, exact: Option<Dd>, found: Dd) -> Dd {
    exact.filter(|tau| of(*tau) > of(found)).unwrap_or(found)
}

/// Returns the minimum of a function with one minimum, by golden section. The search stops at a value of at most
/// `enough`.
pub fn lowest(of: impl Fn(f64) -> f64, from: f64, to: f64, enough: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let (mut low, mut high) = (from, to);
    let inner = |low: f64, high: f64| (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut a, mut b) = inner(low, high);
    let (mut at_a, mut at_b) = (of(a), of(b));
    // 90 steps reduce the interval by 0.618⁹⁰ = 1.5e-19.
    for _ in 0..90 {
        if at_a <= enough || at_b <= enough {
            break;
        }
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = inner(low, high).0;
            at_a = of(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = inner(low, high).1;
            at_b = of(b);
        }
    }
    if at_a < at_b { a } else { b }
}
