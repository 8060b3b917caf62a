//! A sum of modal motions over the half period, with bounds on what it can still do.

use crate::modal_sum::mass_controlled;
use crate::number::scalar::Float;
use crate::oscillator::decay::{Basis, Decay, Instant};
use crate::oscillator::mode::Mode;

/// One mode's part: coefficients of the functions of [`Basis`].
#[derive(Clone, Copy, Debug)]
pub struct Wave<S, D> {
    /// x = 1/R.
    pub x: S,
    /// How it decays.
    pub decay: D,
    /// Of p, the free displacement.
    pub free: S,
    /// Of cos τ − p′.
    pub forced_slope: S,
    /// Of sin τ − p.
    pub forced: S,
    /// Of (1 − d)/x².
    pub rise: S,
    /// Whether `rise` is of the whole response to a force that changes its sign instead: of a mode far
    /// below the excitation.
    pub mass_controlled: bool,
    /// φ_k(φᵀw)/r², the residue contact → mass; harmonics alone use it.
    pub residue: S,
}

impl<S: Float, D: Decay<S>> Wave<S, D> {
    /// No motion at all.
    pub fn at_rest(x: S, decay: D) -> Self {
        let zero = S::constant(0.0);
        Self {
            x,
            decay,
            free: zero,
            forced_slope: zero,
            forced: zero,
            rise: zero,
            mass_controlled: false,
            residue: zero,
        }
    }

    /// The mode's functions at an instant.
    #[inline]
    pub(crate) fn basis(&self, at: &Instant<S>) -> Basis<S> {
        if self.mass_controlled {
            mass_controlled::basis(self.x, self.decay.zeta(), at)
        } else {
            self.decay.basis(self.x, at)
        }
    }

    /// The second derivative of sin τ − p, which is the slope of cos τ − p′, from what moves it.
    #[inline]
    pub(crate) fn forced_curve(&self, basis: &Basis<S>, at: &Instant<S>) -> S {
        let (one, x) = (S::constant(1.0), self.x);
        let loss = (self.decay.zeta() + self.decay.zeta()) * x;
        let detuning = (x - one) * (x + one);
        detuning * at.sine + loss * (at.cosine - basis.forced_slope) - x * x * basis.forced
    }

    /// No motion yet, in a mode's place.
    pub fn idle(mode: &Mode<S>) -> Self {
        Self::at_rest(S::constant(0.0), D::of(mode))
    }

    /// Whether the rounding of x alone can turn the wave by a radian before it has died out, or it is at
    /// rest.
    pub(crate) fn turns_unknown(&self) -> bool {
        let zero = S::constant(0.0);
        let lasts = S::pi().min(S::constant(1.0) / (self.decay.zeta() * self.x));
        let at_rest = self.forced == zero && self.forced_slope == zero;
        at_rest || S::constant(1.0) < self.x * lasts * S::constant(S::RESOLUTION)
    }

    /// The largest that the wave can be.
    fn amplitude_bound(&self) -> S {
        let one = S::constant(1.0);
        let Self {
            x,
            free,
            forced_slope,
            forced,
            rise,
            ..
        } = *self;
        let pi = S::pi();
        // |p| ≤ min(1/x, π), |p′| ≤ 1, 0 ≤ (1 − d)/x² ≤ min((2 + 2ζ)/x², π²/2).
        let p = (one / x).min(pi);
        let r = (S::constant(2.0) * (one + self.decay.zeta()) / (x * x)).min(pi * pi);
        free.abs() * p
            + forced_slope.abs() * S::constant(2.0)
            + forced.abs() * (one + p)
            + rise.abs() * r
    }

    /// What moves the wave beside `rise`: of cos τ and of sin τ.
    pub(crate) fn forcing(&self) -> (S, S) {
        let (one, x) = (S::constant(1.0), self.x);
        let loss = (self.decay.zeta() + self.decay.zeta()) * x;
        let detuning = (x - one) * (x + one);
        let (b, c) = (self.forced_slope, self.forced);
        (c * loss + b * detuning, c * detuning - b * loss)
    }

    /// The slope at an instant, from the mode's functions there.
    #[inline]
    pub(crate) fn slope(&self, basis: &Basis<S>, at: &Instant<S>) -> S {
        self.free * basis.slope
            + self.forced_slope * self.forced_curve(basis, at)
            + self.forced * basis.forced_slope
            + self.rise * basis.free
    }

    /// The value at an instant, from the mode's functions there.
    #[inline]
    pub fn value(&self, basis: &Basis<S>) -> S {
        self.free * basis.free
            + self.forced_slope * basis.forced_slope
            + self.forced * basis.forced
            + self.rise * basis.rise
    }
}

/// Σ waves + cosine·cos τ + sine·sin τ.
#[derive(Clone, Copy, Debug)]
pub struct Sum<'a, S, D> {
    /// The modes, slowest first.
    pub waves: &'a [Wave<S, D>],
    /// Of cos τ.
    pub cosine: S,
    /// Of sin τ.
    pub sine: S,
}

/// A function about one instant: value and three derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet<S> {
    /// sin τ there.
    pub sine: S,
    /// cos τ there.
    pub cosine: S,
    pub value: S,
    pub slope: S,
    pub curvature: S,
    pub third: S,
}

impl<S: Float, D: Decay<S>> Sum<'_, S, D> {
    /// The value at an instant.
    pub fn value(&self, at: &Instant<S>) -> S {
        let mut sum = self.cosine * at.cosine + self.sine * at.sine;
        for wave in self.waves {
            sum = sum + wave.value(&wave.basis(at));
        }
        sum
    }

    /// The derivative with respect to τ at an instant.
    pub fn slope(&self, at: &Instant<S>) -> S {
        let mut sum = self.sine * at.cosine - self.cosine * at.sine;
        for wave in self.waves {
            let basis = wave.basis(at);
            let (curve, _) = differences(wave, &basis, curves(wave, &basis), at);
            sum = sum
                + wave.free * basis.slope
                + wave.forced_slope * curve
                + wave.forced * basis.forced_slope
                + wave.rise * basis.free;
        }
        sum
    }

    /// The value and three derivatives at an instant: from the second on by the equation that each mode obeys.
    pub(crate) fn jet(&self, at: &Instant<S>) -> Jet<S> {
        let Instant { sine, cosine, .. } = *at;
        let value = self.cosine * cosine + self.sine * sine;
        let slope = self.sine * cosine - self.cosine * sine;
        let mut jet = Jet {
            sine,
            cosine,
            value,
            slope,
            curvature: -value,
            third: -slope,
        };
        for wave in self.waves {
            let basis = wave.basis(at);
            let (x, loss) = (wave.x, (wave.decay.zeta() + wave.decay.zeta()) * wave.x);
            let (of_cosine, of_sine) = wave.forcing();
            let (value, slope) = (wave.value(&basis), wave.slope(&basis, at));
            let square = x * x;
            let force = wave.rise + of_cosine * cosine + of_sine * sine;
            let curvature = force - loss * slope - square * value;
            let force_slope = of_sine * cosine - of_cosine * sine;
            jet.value = jet.value + value;
            jet.slope = jet.slope + slope;
            jet.curvature = jet.curvature + curvature;
            jet.third = jet.third + (force_slope - loss * curvature - square * slope);
        }
        jet
    }

    /// The value and the derivative at τ = 0, where all waves are at rest but the mass-controlled.
    pub(crate) fn start(&self) -> (S, S) {
        let mut value = self.cosine;
        let mut slope = self.sine;
        for wave in self.waves.iter().filter(|wave| wave.mass_controlled) {
            let basis = wave.basis(&Instant::start());
            value = value + wave.rise * basis.rise;
            slope = slope + wave.rise * basis.free;
        }
        (value, slope)
    }

    /// How fast the fastest of its modes moves.
    pub(crate) fn fastest(&self) -> S {
        let waves = self.waves.iter();
        fastest(waves.map(|wave| (wave.x, wave.decay.zeta())))
    }

    /// What rounding leaves of the sum at most: waves beside the excitation's frequency, whose
    /// differences from it are small, do not count.
    pub(crate) fn rounding(&self) -> S {
        let (one, half) = (S::constant(1.0), S::constant(0.5));
        let mut sum = self.cosine.abs() + self.sine.abs();
        for wave in self.waves {
            if half < (wave.x - one).abs() {
                sum = sum + wave.amplitude_bound();
            }
        }
        sum * S::constant(S::RESOLUTION)
    }

    /// What rounding leaves of the same: the angle xτ is off by as many roundings as it has turns.
    pub(crate) fn rounding_over_sine(&self) -> S {
        let quarter = S::constant(0.25);
        let sum = self.over_sine(|x| {
            let p = (S::constant(1.0) / x).min(S::pi());
            (p + quarter, S::constant(2.0) + quarter * x)
        });
        sum * S::constant(S::RESOLUTION)
    }

    /// Σ |forced|·p + |forced_slope|·q with (p, q) by x.
    fn over_sine(&self, of: impl Fn(S) -> (S, S)) -> S {
        let add = |sum: S, wave: &Wave<S, D>| {
            let (p, q) = of(wave.x);
            sum + wave.forced.abs() * p + wave.forced_slope.abs() * q
        };
        self.waves.iter().fold(S::constant(0.0), add)
    }
}

/// The largest x(1 + 2ζ), which bounds how fast a mode of (x, ζ) turns and how fast it decays.
pub(crate) fn fastest<S: Float>(modes: impl Iterator<Item = (S, S)>) -> S {
    modes.fold(S::constant(0.0), |most, (x, zeta)| {
        most.max(x * (S::constant(1.0) + (zeta + zeta)))
    })
}

/// p″ and p‴, from the mode's equation p″ + 2ζx p′ + x²p = 0.
#[inline]
fn curves<S: Float, D: Decay<S>>(wave: &Wave<S, D>, basis: &Basis<S>) -> (S, S) {
    let x = wave.x;
    let two_zeta = wave.decay.zeta() + wave.decay.zeta();
    let curve = -(x * (x * basis.free + two_zeta * basis.slope));
    (curve, -(x * (x * basis.slope + two_zeta * curve)))
}

/// The second and third derivative of sin τ − p, given those of p: from what moves it, where that is small.
#[inline]
fn differences<S: Float, D: Decay<S>>(
    wave: &Wave<S, D>,
    basis: &Basis<S>,
    (p2, p3): (S, S),
    at: &Instant<S>,
) -> (S, S) {
    let (one, half) = (S::constant(1.0), S::constant(0.5));
    let x = wave.x;
    if !((x - one).abs() < half) {
        return (-at.sine - p2, -at.cosine - p3);
    }
    let loss = (wave.decay.zeta() + wave.decay.zeta()) * x;
    let detuning = (x - one) * (x + one);
    let second = wave.forced_curve(basis, at);
    let third = detuning * at.cosine - loss * (at.sine + second) - x * x * basis.forced_slope;
    (second, third)
}

#[cfg(test)]
mod tests;
