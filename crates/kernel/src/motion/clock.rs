//! Phase of the excitation in a long run, and sums of many steps. Rounding errors do not accumulate in the phase and in
//! the sums.

use crate::number::phase::within_cycle;
use crate::number::scalar::Float;

/// A sum of many numbers whose rounding errors do not accumulate (compensated summation).
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Total<S> {
    /// Value of the sum, rounded to the precision of the number type.
    pub value: S,
    /// Rounding error of `value` so far. The exact sum is `value` + `low`.
    low: S,
}

impl<S: Float> Total<S> {
    pub(crate) fn zero() -> Self {
        Self {
            value: S::constant(0.0),
            low: S::constant(0.0),
        }
    }

    /// Returns the sum and its rounding error so far. [`of_parts`](Self::of_parts) creates the same sum from these two
    /// numbers.
    pub(crate) fn parts(self) -> [S; 2] {
        [self.value, self.low]
    }

    pub(crate) const fn of_parts([value, low]: [S; 2]) -> Self {
        Self { value, low }
    }

    /// Returns the sum after `term` has been added.
    pub(crate) fn plus(self, term: S) -> Self {
        let (value, error) = two_sum(self.value, term);
        let (value, low) = two_sum(value, self.low + error);
        Self { value, low }
    }

    /// Returns `value` minus the exact sum, which includes the stored rounding error.
    pub(crate) fn short_of(self, value: S) -> S {
        (value - self.value) - self.low
    }
}

/// Phase of the excitation within its cycle, and the number of completed cycles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock<S> {
    /// Phase of the excitation in half-turns (units of π rad), in [0, 2).
    pub t: S,
    /// Rounding error of `t` so far. The exact phase is `t` + `low`.
    low: S,
    /// Number of excitation cycles that are complete.
    pub cycles: u64,
}

impl<S: Float> Clock<S> {
    /// Returns the clock at the start of a run, which is a maximum of the excitation.
    pub(crate) fn start() -> Self {
        let zero = S::constant(0.0);
        Self {
            t: zero,
            low: zero,
            cycles: 0,
        }
    }

    /// Returns the clock after a further time τ = `passed`, in rad of the excitation.
    pub(crate) fn moved(self, passed: Total<S>) -> Self {
        let (turns, error) = two_product(passed.value, S::inverse_pi());
        let error = error + passed.value * inverse_pi_low() + passed.low * S::inverse_pi();
        let (t, left) = two_sum(self.t, turns);
        let (t, low) = two_sum(t, self.low + left + error);
        let (two, half) = (S::constant(2.0), S::constant(0.5));
        let mut whole = (t * half).floor();
        // Rounding may have increased a number just below a multiple of two to this multiple.
        if (t - whole * two).is_zero() && low < S::constant(0.0) {
            whole = whole - S::constant(1.0);
        }
        let (mut t, mut low) = two_sum(t - whole * two, low);
        if !(t < two) {
            // The phase must be less than two half-turns. A phase that rounds to two becomes the last number below two.
            (t, low) = two_sum(two - S::constant(S::EPSILON), low);
        }
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count that is not negative"
        )]
        let cycles = self.cycles.wrapping_add(whole.to_f64().max(0.0) as u64);
        Self { t, low, cycles }
    }
}

/// Returns sine and cosine of the excitation's angle πt, where `t` is the phase in half-turns (units of π rad).
pub(crate) fn phase<S: Float>(t: S) -> (S, S) {
    t.sin_cos_pi()
}

/// Returns the phase after a time τ in rad of the excitation. Both this phase and the phase `t` before that time are in
/// half-turns (units of π rad) in [0, 2).
pub(crate) fn moved<S: Float>(t: S, tau: S) -> S {
    let two = S::constant(2.0);
    let t = within_cycle(t + tau * S::inverse_pi());
    if t < two { t } else { t - two }
}

/// Returns the exact 1/π minus the rounded 1/π of the number type.
fn inverse_pi_low<S: Float>() -> S {
    S::constant(if is_wide::<S>() {
        0.0
    } else if is_double::<S>() {
        -1.967_867_667_518_248_6e-17
    } else {
        1.284_127_663_345_183e-8
    })
}

/// Returns true if the scalar has at least the digits of an `f64`.
fn is_double<S: Float>() -> bool {
    S::EPSILON < 1e-10
}

/// Returns true if the number type has more digits than an `f64`. Rounding errors of a long run are then negligible.
fn is_wide<S: Float>() -> bool {
    S::EPSILON < 1e-20
}

/// Returns a + b rounded, and the rounding error of the sum (Knuth).
fn two_sum<S: Float>(a: S, b: S) -> (S, S) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// Returns a·b rounded, and the rounding error of the product (Veltkamp, Dekker).
fn two_product<S: Float>(a: S, b: S) -> (S, S) {
    let product = a * b;
    if is_wide::<S>() {
        return (product, S::constant(0.0));
    }
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// Splits a number into the sum of two numbers, each with half of its digits.
fn split<S: Float>(a: S) -> (S, S) {
    let factor = if is_double::<S>() {
        134_217_729.0
    } else {
        4097.0
    };
    let scaled = S::constant(factor) * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::{Clock, Total};

    /// Compares the phase after n steps of 0.01 rad in single precision with the phase 0.01n rad in double precision,
    /// for n up to 200,000. The two phases may differ only by the rounding of the phase itself.
    #[test]
    fn steps_leave_no_rounding_in_the_phase() {
        let (mut clock, mut compared) = (Clock::<f32>::start(), 0);
        for step in 1..=200_000_u32 {
            clock = clock.moved(Total::zero().plus(0.01));
            let turns = f64::from(step) * f64::from(0.01_f32) / core::f64::consts::TAU;
            let cycles = clock.cycles as f64 + 0.5 * f64::from(clock.t);
            assert!(
                (cycles - turns).abs() < 1e-7,
                "{step}: {cycles} for {turns}"
            );
            assert!((0.0..2.0).contains(&clock.t));
            compared += 1;
        }
        assert_eq!((compared, clock.cycles), (200_000, 318));
    }

    /// Checks that a run of exactly three cycles, in many equal steps, counts three cycles. Rounding may make the sum
    /// of the steps slightly smaller or larger than whole cycles.
    #[test]
    fn a_cycle_is_counted_once() {
        for pieces in 1..2000_u32 {
            let mut clock = Clock::<f64>::start();
            let step = core::f64::consts::TAU / f64::from(pieces);
            for _ in 0..3 * pieces {
                clock = clock.moved(Total::zero().plus(step));
            }
            let cycles = clock.cycles as f64 + 0.5 * clock.t;
            assert!(
                (cycles - 3.0).abs() < 1e-15 * f64::from(pieces),
                "{pieces}: {cycles}"
            );
        }
    }

    #[test]
    fn a_sum_keeps_what_its_terms_lose() {
        let mut total = Total::<f32>::zero();
        for _ in 0..1_000_000 {
            total = total.plus(1e-5);
        }
        let exact = 1e6 * f64::from(1e-5_f32);
        assert!(
            (f64::from(total.value) - exact).abs() < 1e-6,
            "{}",
            total.value
        );
        assert!((f64::from(total.short_of(11.0)) - (11.0 - exact)).abs() < 1e-6);
    }
}
