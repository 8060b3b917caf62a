//! Sum of modal motions in a half period, with its derivatives, and with bounds on its size and on its rounding error.
//!
//! A *wave* is the term of one mode in the sum. x is the natural frequency of the mode divided by the excitation
//! frequency.

use crate::modal_sum::mass_controlled;
use crate::number::scalar::Float;
use crate::oscillator::decay::{Basis, Decay, Instant};
use crate::oscillator::mode::Mode;

/// Term of one mode in a modal sum. The term is a linear combination of the functions of time in [`Basis`], over a half
/// period of the excitation.
#[derive(Clone, Copy, Debug)]
pub struct Wave<S, D> {
    /// Natural frequency of the mode divided by the excitation frequency, x = √λ/r. The thesis uses R = 1/x.
    pub x: S,
    /// Damping of the mode, as a type that selects the closed forms.
    pub decay: D,
    /// Coefficient of p, the free displacement of the mode that starts from 0 with unit speed.
    pub free: S,
    /// Coefficient of the term (cos τ − p′). p is the free displacement of the mode that starts from 0 with unit
    /// speed.
    pub forced_slope: S,
    /// Coefficient of the term (sin τ − p). p is the free displacement of the mode that starts from 0 with unit speed.
    pub forced: S,
    /// Coefficient of the term (1 − d)/x², where d is the free motion that starts at rest from the displacement 1.
    pub rise: S,
    /// True for a mode that resonates far below the excitation frequency (a mass-controlled mode). `rise` is then the
    /// coefficient of another function. This function is the response of the mode to a unit force that changes its sign
    /// every half period.
    pub mass_controlled: bool,
    /// Residue φ_k(φᵀw)/r² of the mode, from a force in the contact to the motion of mass k. Only the harmonics of the
    /// motion need this residue.
    pub residue: S,
}

impl<S: Float, D: Decay<S>> Wave<S, D> {
    /// Creates a modal term whose coefficients are all 0.
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

    /// Evaluates the functions of time in [`Basis`] at one instant, such as the free displacement p of the mode.
    #[inline]
    pub(crate) fn basis(&self, at: &Instant<S>) -> Basis<S> {
        if self.mass_controlled {
            mass_controlled::basis(self.x, self.decay.zeta(), at)
        } else {
            self.decay.basis(self.x, at)
        }
    }

    /// Returns the second derivative of (sin τ − p), where p is the free displacement of the mode. Close to the
    /// resonance x = 1, the difference −sin τ − p″ would lose digits. The function therefore uses the equation of
    /// motion that sin τ − p satisfies.
    #[inline]
    pub(crate) fn forced_curve(&self, basis: &Basis<S>, at: &Instant<S>) -> S {
        let (one, x) = (S::constant(1.0), self.x);
        let loss = (self.decay.zeta() + self.decay.zeta()) * x;
        let detuning = (x - one) * (x + one);
        detuning * at.sine + loss * (at.cosine - basis.forced_slope) - x * x * basis.forced
    }

    /// Creates a term whose coefficients are all 0, as a placeholder for `mode` in an array of terms.
    pub fn idle(mode: &Mode<S>) -> Self {
        Self::at_rest(S::constant(0.0), D::of(mode))
    }

    /// Returns true if the phase xτ of the mode is unknown: the rounding of x alone can shift it by a radian before
    /// the free motion has decayed. Also returns true for a mode that the contact does not drive (`forced` and
    /// `forced_slope` are 0).
    pub(crate) fn turns_unknown(&self) -> bool {
        let zero = S::constant(0.0);
        let lasts = S::pi().min(S::constant(1.0) / (self.decay.zeta() * self.x));
        let at_rest = self.forced == zero && self.forced_slope == zero;
        at_rest || S::constant(1.0) < self.x * lasts * S::constant(S::RESOLUTION)
    }

    /// Returns an upper bound on the absolute value of the modal term in the half period.
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
        // The bounds are |p| ≤ min(1/x, π), |p′| ≤ 1 and 0 ≤ (1 − d)/x² ≤ min((2 + 2ζ)/x², π²/2), with p and d as in
        // `Basis`.
        let p = (one / x).min(pi);
        let r = (S::constant(2.0) * (one + self.decay.zeta()) / (x * x)).min(pi * pi);
        free.abs() * p
            + forced_slope.abs() * S::constant(2.0)
            + forced.abs() * (one + p)
            + rise.abs() * r
    }

    /// Returns the amplitudes of cos τ and sin τ in the force on the mode. The constant part of the force is `rise`.
    pub(crate) fn forcing(&self) -> (S, S) {
        let (one, x) = (S::constant(1.0), self.x);
        let loss = (self.decay.zeta() + self.decay.zeta()) * x;
        let detuning = (x - one) * (x + one);
        let (b, c) = (self.forced_slope, self.forced);
        (c * loss + b * detuning, c * detuning - b * loss)
    }

    /// Returns the derivative of the modal term with respect to τ at an instant. `basis` contains the functions of time
    /// at that instant.
    #[inline]
    pub(crate) fn slope(&self, basis: &Basis<S>, at: &Instant<S>) -> S {
        self.free * basis.slope
            + self.forced_slope * self.forced_curve(basis, at)
            + self.forced * basis.forced_slope
            + self.rise * basis.free
    }

    /// Returns the modal term at an instant. `basis` contains the functions of time at that instant.
    #[inline]
    pub fn value(&self, basis: &Basis<S>) -> S {
        self.free * basis.free
            + self.forced_slope * basis.forced_slope
            + self.forced * basis.forced
            + self.rise * basis.rise
    }
}

/// Modal sum: the terms of all modes, plus cosine·cos τ + sine·sin τ.
#[derive(Clone, Copy, Debug)]
pub struct Sum<'a, S, D> {
    /// Terms of the modes, in ascending order of natural frequency.
    pub waves: &'a [Wave<S, D>],
    /// Coefficient of cos τ, in addition to the terms of the modes.
    pub cosine: S,
    /// Coefficient of sin τ, in addition to the terms of the modes.
    pub sine: S,
}

/// Modal sum and its first three derivatives with respect to τ, at one instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SumDerivatives<S> {
    /// Sine of the phase τ at the instant.
    pub sine: S,
    /// Cosine of the phase τ at the instant.
    pub cosine: S,
    pub value: S,
    pub slope: S,
    pub curvature: S,
    pub third: S,
}

impl<S: Float, D: Decay<S>> Sum<'_, S, D> {
    /// Returns the value of the modal sum at an instant.
    pub fn value(&self, at: &Instant<S>) -> S {
        let mut sum = self.cosine * at.cosine + self.sine * at.sine;
        for wave in self.waves {
            sum = sum + wave.value(&wave.basis(at));
        }
        sum
    }

    /// Evaluates the derivative of the modal sum with respect to τ at an instant.
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

    /// Evaluates the modal sum and its first three derivatives at an instant. The second and third derivative follow
    /// from the equation of motion of each mode.
    pub(crate) fn jet(&self, at: &Instant<S>) -> SumDerivatives<S> {
        let Instant { sine, cosine, .. } = *at;
        let value = self.cosine * cosine + self.sine * sine;
        let slope = self.sine * cosine - self.cosine * sine;
        let mut jet = SumDerivatives {
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

    /// Returns the modal sum and its derivative at τ = 0. Besides `cosine` and `sine`, only mass-controlled modes
    /// contribute, which resonate far below the excitation frequency. The terms of all other modes start from rest.
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

    /// Returns the largest x(1 + 2ζ) of the modes in the sum. x is the natural frequency divided by the excitation
    /// frequency, and ζ the damping ratio. No mode oscillates or decays faster than this rate.
    pub(crate) fn fastest(&self) -> S {
        let waves = self.waves.iter();
        fastest(waves.map(|wave| (wave.x, wave.decay.zeta())))
    }

    /// Returns an upper bound on the rounding error of the modal sum. The bound leaves out modes that resonate close to
    /// the excitation frequency. The terms of these modes are small differences with small rounding errors.
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

    /// Returns an upper bound on the rounding error of the modal sum, for a search of sum/sin τ. The phase xτ of each
    /// mode has an error of one rounding for each of its turns.
    pub(crate) fn rounding_over_sine(&self) -> S {
        let quarter = S::constant(0.25);
        let sum = self.over_sine(|x| {
            let p = (S::constant(1.0) / x).min(S::pi());
            (p + quarter, S::constant(2.0) + quarter * x)
        });
        sum * S::constant(S::RESOLUTION)
    }

    /// Returns the sum of |forced|·P + |forced_slope|·Q over all modal terms. The closure `of` returns the factors (P,
    /// Q) of a mode. Its argument is x, the natural frequency of the mode divided by the excitation frequency.
    fn over_sine(&self, of: impl Fn(S) -> (S, S)) -> S {
        let add = |sum: S, wave: &Wave<S, D>| {
            let (p, q) = of(wave.x);
            sum + wave.forced.abs() * p + wave.forced_slope.abs() * q
        };
        self.waves.iter().fold(S::constant(0.0), add)
    }
}

/// Returns the largest x(1 + 2ζ) of several modes (x, ζ). x is the natural frequency divided by the excitation
/// frequency, and ζ the damping ratio. None of these modes oscillates or decays faster than this rate.
pub(crate) fn fastest<S: Float>(modes: impl Iterator<Item = (S, S)>) -> S {
    modes.fold(S::constant(0.0), |most, (x, zeta)| {
        most.max(x * (S::constant(1.0) + (zeta + zeta)))
    })
}

/// Returns the derivatives p″ and p‴ of the free displacement p, from its equation p″ + 2ζx p′ + x²p = 0.
#[inline]
fn curves<S: Float, D: Decay<S>>(wave: &Wave<S, D>, basis: &Basis<S>) -> (S, S) {
    let x = wave.x;
    let two_zeta = wave.decay.zeta() + wave.decay.zeta();
    let curve = -(x * (x * basis.free + two_zeta * basis.slope));
    (curve, -(x * (x * basis.slope + two_zeta * curve)))
}

/// Returns the second and third derivative of sin τ − p, where p is the free displacement of the mode. `(p2, p3)` are
/// the second and third derivative of p. Close to the resonance x = 1, the subtraction of `p2` and `p3` would lose
/// digits. The function then uses the equation of motion that sin τ − p satisfies.
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
