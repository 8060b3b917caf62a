//! A function of time that is the sum of a straight line and one harmonic.

use super::poly::{Poly, TERMS, terms_of};
use super::size::at;
use crate::Float;

/// A straight line plus one harmonic: c + bt + a cos(ωt + φ), where t is the time.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Wave<S> {
    /// Constant c in the function c + bt + a cos(ωt + φ).
    pub constant: S,
    /// Slope b of the straight line in c + bt + a cos(ωt + φ), in its unit divided by the unit of time.
    pub slope: S,
    /// Amplitude a of the harmonic in c + bt + a cos(ωt + φ).
    pub amplitude: S,
    /// Angular frequency ω of the harmonic in c + bt + a cos(ωt + φ), in rad per unit of time.
    pub omega: S,
    /// Phase φ of the harmonic in c + bt + a cos(ωt + φ), in rad.
    pub phase: S,
}

impl<S: Float> Wave<S> {
    /// Returns the function that is 0 at every instant.
    #[must_use]
    pub fn zero() -> Self {
        Self::constant(S::constant(0.0))
    }

    /// Returns the function that has the value `constant` at every instant.
    #[must_use]
    pub fn constant(constant: S) -> Self {
        let zero = S::constant(0.0);
        Self {
            constant,
            slope: zero,
            amplitude: zero,
            omega: zero,
            phase: zero,
        }
    }

    /// Returns the function a cos ωt, with the amplitude a and the angular frequency ω.
    #[must_use]
    pub fn harmonic(amplitude: S, omega: S) -> Self {
        Self {
            amplitude,
            omega,
            ..Self::zero()
        }
    }

    /// Returns the straight line through two samples. Each sample is a pair (time, value).
    #[must_use]
    pub fn line((start, first): (S, S), (end, last): (S, S)) -> Self {
        let slope = (last - first) / (end - start);
        Self {
            slope,
            ..Self::constant(first - slope * start)
        }
    }

    /// Returns true if the function is 0 at every instant.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.constant.is_zero() && self.slope.is_zero() && self.amplitude.is_zero()
    }

    /// Returns true if the function is a constant load of the chain, which is written as a harmonic of the frequency 0. The
    /// input of a stepper does not change it.
    pub(super) fn is_constant_load(&self) -> bool {
        self.omega.is_zero() && !self.amplitude.is_zero()
    }

    /// Returns true if the value of the function half a period later is always the opposite value. The period is
    /// 2π/`omega`.
    pub(super) fn is_odd(&self, omega: S) -> bool {
        let follows = self.amplitude.is_zero() || self.omega == omega;
        self.constant.is_zero() && self.slope.is_zero() && follows
    }

    /// Returns true if all coefficients of the function are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let numbers = [
            self.constant,
            self.slope,
            self.amplitude,
            self.omega,
            self.phase,
        ];
        numbers.iter().all(|number| number.is_finite())
    }

    /// Changes the coefficients of the function so that the instant `time` becomes the instant 0.
    pub(super) fn shift(&mut self, time: S) {
        self.constant = self.constant + self.slope * time;
        self.phase = self.phase + self.omega * time;
    }

    /// Returns the value of the function or of a derivative at the instant `time`. `derivative` is the order of the
    /// derivative: 0 (the function itself), 1 or 2.
    #[must_use]
    #[inline]
    pub fn value(&self, time: S, derivative: usize) -> S {
        let line = match derivative {
            0 => self.constant + self.slope * time,
            1 => self.slope,
            _ => S::constant(0.0),
        };
        if self.amplitude.is_zero() {
            return line;
        }
        line + self.harmonic_value(time, derivative)
    }

    #[inline(never)]
    fn harmonic_value(&self, time: S, derivative: usize) -> S {
        let [cosine, sine] = self.quadrature(time);
        match derivative {
            0 => cosine,
            1 => -self.omega * sine,
            _ => -self.omega * self.omega * cosine,
        }
    }

    /// Returns the power series of the function, or of its first or second derivative, over a time interval. The
    /// variable of the series is the elapsed fraction of the interval, from 0 to 1.
    #[must_use]
    pub fn terms(&self, time: S, length: S, derivative: usize) -> Poly<S> {
        let mut terms = [S::constant(0.0); TERMS];
        if !self.amplitude.is_zero() {
            let angle = self.omega * time + self.phase;
            let (sin, cos) = (angle * S::inverse_pi()).sin_cos_pi();
            let derivatives = [cos, -sin, -cos, sin];
            let powers = core::iter::repeat_n(self.omega, derivative);
            let power = powers.fold(S::constant(1.0), |power, omega| power * omega);
            let mut factor = self.amplitude * power;
            for (order, term) in terms.iter_mut().enumerate().take(terms_of::<S>()) {
                *term = factor * at(&derivatives, (order + derivative) % 4);
                factor = factor * (self.omega * length / S::whole(order + 1));
            }
        }
        let zero = S::constant(0.0);
        let line = match derivative {
            0 => [self.constant + self.slope * time, self.slope * length],
            1 => [self.slope, zero],
            _ => [zero, zero],
        };
        for (term, line) in terms.iter_mut().zip(line) {
            *term = *term + line;
        }
        terms
    }

    /// Returns [a cos θ, a sin θ] of the harmonic at the instant `time`, where θ = ωt + φ.
    pub(super) fn quadrature(&self, time: S) -> [S; 2] {
        if self.amplitude.is_zero() {
            return [S::constant(0.0); 2];
        }
        let angle = self.omega * time + self.phase;
        let (sin, cos) = (angle * S::inverse_pi()).sin_cos_pi();
        [self.amplitude * cos, self.amplitude * sin]
    }

    /// Returns the time in which the phase of the harmonic advances by 1 rad. In this time the power series of the
    /// function converges at least as fast as that of the motion.
    pub(super) fn longest_stretch(&self) -> S {
        S::constant(1.0) / self.fastest()
    }

    /// Returns |ω| of the harmonic, or 0 if the function has no harmonic.
    pub(super) fn fastest(&self) -> S {
        if self.amplitude.is_zero() {
            S::constant(0.0)
        } else {
            self.omega.abs()
        }
    }
}
