//! Safe steps by a Taylor series, where value, slope and curvature are not enough.
//!
//! Where the waves of a sum cancel (a mass far from load and contact above all resonances), or where
//! the sum is nearly a multiple of sin τ (the velocity constraint beside a resonance), bounds wave by
//! wave on the second or third derivative are far above what the sum does, and steps by them become
//! tiny.  The derivatives themselves cancel as the sum does; only the bound on the last one, of a high
//! order, does not, and weighs little.

use crate::modal_sum::wave::{Sum, Wave};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Basis, Decay, Instant};

/// The order of the derivative that is only bounded.
const ORDER: usize = 14;
/// Bisections of the step: far more than its use justifies, and cheap beside an evaluation.
const HALVINGS: usize = 12;

/// Σ cⱼuʲ + O(bound·u^ORDER), the sum about an instant with τ = instant + unit·u.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<S> {
    coefficients: [S; ORDER],
    bound: S,
    pub unit: S,
}

impl<S: Float> Series<S> {
    /// The sum about an instant.
    pub fn of<D: Decay<S>>(sum: &Sum<'_, S, D>, at: &Instant<S>) -> Self {
        let zero = S::constant(0.0);
        let unit = sum.unit();
        let mut series = Self {
            coefficients: [zero; ORDER],
            bound: zero,
            unit,
        };
        series.add_turning(sum.cosine, sum.sine, at);
        for wave in sum.waves {
            series.add_wave(wave, at);
        }
        series
    }

    /// Adds c·cos τ + s·sin τ.
    pub fn add_turning(&mut self, c: S, s: S, at: &Instant<S>) {
        let (mut value, mut slope) = (c * at.cosine + s * at.sine, s * at.cosine - c * at.sine);
        let mut weight = S::constant(1.0);
        let mut order = S::constant(0.0);
        for coefficient in &mut self.coefficients {
            *coefficient = *coefficient + value * weight;
            (value, slope) = (slope, -value);
            order = order + S::constant(1.0);
            weight = weight * self.unit / order;
        }
        self.bound = self.bound + (c.abs() + s.abs()) * weight;
    }

    /// Adds a wave, by the equation that its parts obey: with f the forcing of each part,
    /// y″ + 2ζx y′ + x²y = f.
    fn add_wave<D: Decay<S>>(&mut self, wave: &Wave<S, D>, at: &Instant<S>) {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let basis = wave.basis(at);
        let (x, zeta) = (wave.x, wave.decay.zeta());
        let (loss, apart) = (two * zeta * x, (x - one) * (x + one));
        let slope_of_slope = wave.swing_curve(&basis, at);
        // The sum of free and rise: y of p, and of the return, whose forcing is 1.
        let value = wave.value(&basis);
        let slope = wave.free * basis.slope
            + wave.swing_slope * slope_of_slope
            + wave.swing * basis.swing_slope
            + wave.rise * basis.free;
        // Forcing: of cos τ − p′ it is apart·cos τ − loss·sin τ, of sin τ − p apart·sin τ + loss·cos τ.
        let (b, c) = (wave.swing_slope, wave.swing);
        let cosine = b * apart + c * loss;
        let sine = c * apart - b * loss;
        let mut force = cosine * at.cosine + sine * at.sine;
        let mut force_slope = sine * at.cosine - cosine * at.sine;
        let u = self.unit;
        let (mut low, mut high) = (value, slope * u);
        let mut order = S::constant(0.0);
        let mut weight = u * u;
        let mut steady = wave.rise;
        for coefficient in &mut self.coefficients {
            *coefficient = *coefficient + low;
            let next = order + one;
            let after = (force + steady) * weight - u * (loss * next * high + u * x * x * low);
            (low, high) = (high, after / (next * (next + one)));
            (force, force_slope) = (force_slope, -force);
            steady = S::constant(0.0);
            order = next;
            weight = weight * u / order;
        }
        self.bound = self.bound + self.last(wave, &basis, slope_of_slope, weight / (u * u));
    }

    /// A bound on the wave's last term from the instant on; `weight` is unitⁿ/n!.
    fn last<D: Decay<S>>(
        &self,
        wave: &Wave<S, D>,
        basis: &Basis<S>,
        slope_of_slope: S,
        weight: S,
    ) -> S {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let order = S::constant(ORDER as f64);
        let x = wave.x;
        let rate = wave.rate();
        // rateⁿ unitⁿ/n!, which cannot overflow.
        let scaled = |power: usize| {
            let mut product = weight;
            for _ in 0..power {
                product = product * rate;
            }
            product
        };
        let hypot = |a: S, b: S| (a * a + b * b).sqrt();
        let energy = hypot(x * basis.free, basis.slope);
        // p⁽ⁿ⁾ ≤ energy·rateⁿ⁻¹; the return's nth derivative is p's one before.
        let free = energy * scaled(ORDER - 1);
        let rise = energy * scaled(ORDER - 2);
        let forcing = (x * x - one).abs() + two * wave.decay.zeta() * x;
        let near = |energy: S| {
            let top = scaled(ORDER - 1).max(weight);
            (energy + (S::pi() + order) * forcing) * top
        };
        let swing_slope = (weight + energy * scaled(ORDER))
            .min(near(hypot(x * basis.swing_slope, slope_of_slope)));
        let swing = (weight + free).min(near(hypot(x * basis.swing, basis.swing_slope)));
        wave.free.abs() * free
            + wave.swing_slope.abs() * swing_slope
            + wave.swing.abs() * swing
            + wave.rise.abs() * rise
    }

    /// ±sum − level·weight.
    pub fn excess(&self, negative: bool, level: S, sine: bool, at: &Instant<S>) -> Self {
        let mut excess = *self;
        if negative {
            for coefficient in &mut excess.coefficients {
                *coefficient = -*coefficient;
            }
        }
        if sine {
            excess.add_turning(S::constant(0.0), -level, at);
        } else {
            excess = excess.less(level);
        }
        excess
    }

    /// Less a constant.
    pub fn less(mut self, constant: S) -> Self {
        let [value, ..] = &mut self.coefficients;
        *value = *value - constant;
        self
    }

    /// The excess that vanishes at the instant, looked at backwards, with `bound` for what lies there.
    pub fn backwards(&self, bound: S) -> Self {
        let mut backwards = *self;
        let mut negative = false;
        for coefficient in &mut backwards.coefficients {
            if negative {
                *coefficient = -*coefficient;
            }
            negative = !negative;
        }
        let [value, ..] = &mut backwards.coefficients;
        *value = S::constant(0.0);
        Self { bound, ..backwards }
    }

    /// The bound on the last term.
    pub fn bound(&self) -> S {
        self.bound
    }

    /// How far the series stays at or below 0, or somewhat less.
    pub fn reach(&self) -> S {
        let mut reach = S::constant(2.0);
        for _ in 0..HALVINGS {
            if self.stays_below(reach) {
                return reach * self.unit;
            }
            reach = reach * S::constant(0.5);
        }
        S::constant(0.0)
    }

    /// Whether the series is at or below 0 from 0 to `end`: value, slope and curvature as they are,
    /// all higher terms by what they can add to the curvature's.
    fn stays_below(&self, end: S) -> bool {
        let zero = S::constant(0.0);
        let [value, slope, curvature, higher @ ..] = &self.coefficients;
        let mut rise = self.bound;
        for coefficient in higher.iter().rev() {
            rise = rise * end + coefficient.max(zero);
        }
        let curvature = *curvature + rise * end;
        // The top of a parabola that bends down, if it is reached before the end.
        let top = -*slope / (curvature + curvature);
        if curvature < zero && zero < top && top < end {
            return *value + *slope * top * S::constant(0.5) <= zero;
        }
        value.max(*value + end * (*slope + end * curvature)) <= zero
    }
}

#[cfg(test)]
mod tests;
