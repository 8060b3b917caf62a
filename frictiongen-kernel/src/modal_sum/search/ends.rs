//! Where the walk for a quotient by sin τ begins and ends: at 0 and π sum and sine both vanish, and their
//! derivatives there decide.

use super::series::Series;
use super::walk::safe_step;
use super::{Search, Weight};
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::decay::{Decay, Instant};

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// The beginning of the walk for a quotient by sin τ, which both vanish at 0: by their
    /// derivatives there.
    pub(super) fn start(&mut self, signs: &[bool]) -> S {
        let zero = S::constant(0.0);
        let (local, _) = self.local(zero);
        let mut reach = self.question.end;
        for &negative in signs {
            let mut excess = self.excess(&local, negative, self.level());
            if zero < excess.curvature {
                // It rises from the start: climb from within the rise.
                let tau = (excess.curvature / excess.third_bound).min(self.question.end);
                let (local, _) = self.local(tau);
                if zero < self.excess(&local, negative, self.level()).value {
                    self.climb(tau, local, negative);
                }
                excess = self.excess(&local, negative, self.level());
            }
            excess.value = zero;
            let mut step = safe_step(&excess);
            if excess.curvature <= zero && excess.slope <= zero {
                let (third, fourth, unit) = self.third_at_start(negative);
                // slope·τ + curvature·τ²/2 + third·τ³/6 + fourth·τ⁴/24 ≤ 0, with τ = unit·u.
                let b = third / fourth * S::constant(2.0);
                let c = excess.curvature / fourth * S::constant(12.0);
                let root = (b * b - c).max(zero).sqrt();
                step = step.max((root - b) * unit);
            }
            reach = reach.min(step);
        }
        reach
    }

    /// The excess's third derivative at τ = 0 and a bound on the fourth, for a time in units that
    /// are the last: third·unit, fourth·unit².
    fn third_at_start(&self, negative: bool) -> (S, S, S) {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let unit = self.sum.unit();
        let level = self.signed(self.level(), negative);
        // Of sine·sin τ.
        let mut third = -(self.sum.sine * unit);
        let mut fourth = (self.sum.sine.abs() + level) * unit * unit;
        for wave in self.sum.waves {
            let x = wave.x;
            let two_zeta = two * wave.decay.zeta();
            let (rate, x_unit) = (wave.rate(), x * unit);
            // p′ = 1, p″ = −2ζx, p‴ = −x²(1 − 4ζ²), p⁗ = 4ζx³(1 − 2ζ²) at τ = 0; of sin τ − p, −1 − p‴.
            let apart = (x - one) * (x + one) * unit - two_zeta * two_zeta * x * x_unit;
            let p4 = two_zeta * x * x * x_unit * (two - two_zeta * two_zeta);
            third = third + wave.swing * apart - wave.swing_slope * p4;
            let turned = rate * unit;
            // What moves sin τ − p is small beside x = 1.
            let forcing = (x * x - one).abs() + two_zeta * x;
            let plain = unit * unit + rate * turned * turned;
            let near = S::constant(8.0) * forcing * (unit * unit).max(rate * turned * turned);
            fourth = fourth
                + wave.swing.abs() * plain.min(near)
                + wave.swing_slope.abs() * (unit * unit + rate * rate * turned * turned);
        }
        let level = level * unit;
        if negative {
            (level - third, fourth, unit)
        } else {
            (third + level, fourth, unit)
        }
    }

    /// The end of the walk: before π, where sum and sine vanish again, by the slope there.
    pub(super) fn last(&mut self, signs: &[bool]) -> S {
        let zero = S::constant(0.0);
        let end = self.question.end;
        if end < S::pi() * S::constant(0.75) {
            return end;
        }
        let (at_end, _) = self.local(end);
        // Bounds from the start on hold over the last stretch.
        let (at_start, _) = self.local(zero);
        let mut stretch = end;
        for &negative in signs {
            let slope = self.excess(&at_end, negative, self.level()).slope;
            let bound = self
                .excess(&at_start, negative, self.level())
                .curvature_bound;
            stretch = stretch.min(slope.max(zero) * S::constant(2.0) / bound);
        }
        end - stretch
    }

    /// The same by the series, whose bounds from the start on hold at the end as well.
    pub(super) fn last_by_series(&mut self, signs: &[bool]) -> S {
        let end = self.question.end;
        if self.question.weight == Weight::One || end < S::pi() * S::constant(0.75) {
            return end;
        }
        self.peak.evaluations += 2;
        let (start, at) = (
            Instant::new(S::constant(0.0)),
            Instant::new(end * S::inverse_pi()),
        );
        let (before, here) = (Series::of(&self.sum, &start), Series::of(&self.sum, &at));
        let reach = |&negative: &bool| {
            let level = self.signed(self.level(), negative);
            let bound = before.excess(negative, level, true, &start).bound();
            here.excess(negative, level, true, &at)
                .backwards(bound)
                .reach()
        };
        end - signs.iter().map(reach).fold(end, Scalar::min)
    }
}

#[cfg(test)]
mod tests;
