//! Displacement of the base as a function of time. The function is a harmonic, or a cubic polynomial between two
//! samples.

use super::poly::Poly;
use super::size::add;
use super::wave::Wave;
use crate::Float;

/// A function of time t: w(t) + at² + bt³, where w(t) is a [`Wave`] (a straight line and a harmonic). Chains with
/// several contacts use it as the displacement of the base.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Curve<S> {
    /// The straight line and the harmonic, w(t), in the function w(t) + at² + bt³.
    pub wave: Wave<S>,
    /// Coefficient a of t² in the function w(t) + at² + bt³.
    pub square: S,
    /// Coefficient b of t³ in the function w(t) + at² + bt³.
    pub cube: S,
}

impl<S: Float> From<Wave<S>> for Curve<S> {
    fn from(wave: Wave<S>) -> Self {
        Self {
            wave,
            square: S::constant(0.0),
            cube: S::constant(0.0),
        }
    }
}

impl<S: Float> Curve<S> {
    /// Returns the function that is 0 at every instant, for a base that does not move.
    #[must_use]
    pub fn zero() -> Self {
        Wave::zero().into()
    }

    /// Returns the cubic polynomial through two samples. It has the displacement and velocity [y0, v0] at the instant
    /// 0, and [y1, v1] at the instant `length`.
    #[must_use]
    pub fn through([y0, v0]: [S; 2], [y1, v1]: [S; 2], length: S) -> Self {
        let (two, three) = (S::constant(2.0), S::constant(3.0));
        let mean = (y1 - y0) / length;
        Self {
            square: (three * mean - two * v0 - v1) / length,
            cube: (v0 + v1 - two * mean) / length / length,
            ..Self::straight([y0, v0])
        }
    }

    /// Returns the straight line that has the given displacement and velocity at the instant 0.
    #[must_use]
    pub fn straight([place, velocity]: [S; 2]) -> Self {
        let mut line = Self::zero();
        line.wave.constant = place;
        line.wave.slope = velocity;
        line
    }

    /// Returns true if the function is 0 at every instant.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.wave.is_zero() && !self.bends()
    }

    /// Returns true if the value of the function half a period later is always the opposite value. The period is
    /// 2π/`omega`.
    pub(super) fn is_odd(&self, omega: S) -> bool {
        self.wave.is_odd(omega) && !self.bends()
    }

    pub(super) fn bends(&self) -> bool {
        !self.square.is_zero() || !self.cube.is_zero()
    }

    /// Returns at² + bt³ at the instant `time`, its derivative, and half its second derivative.
    fn bend(&self, time: S) -> [S; 3] {
        let (two, three) = (S::constant(2.0), S::constant(3.0));
        let (square, cube) = (self.square, self.cube);
        [
            (square + cube * time) * time * time,
            (two * square + three * cube * time) * time,
            square + three * cube * time,
        ]
    }

    /// Returns the coefficients of the powers of t − `time`, from the constant to the cube, without the harmonic.
    pub(super) fn about(&self, time: S) -> [S; 4] {
        let [bend, slope, square] = self.bend(time);
        let line = &self.wave;
        let place = line.constant + line.slope * time;
        [place + bend, line.slope + slope, square, self.cube]
    }

    /// Changes the coefficients of the function so that the instant `time` becomes the instant 0.
    pub(super) fn shift(&mut self, time: S) {
        self.wave.shift(time);
        let three = S::constant(3.0);
        let (square, cube) = (self.square, self.cube * time);
        self.wave.constant = self.wave.constant + (square + cube) * time * time;
        self.wave.slope = self.wave.slope + (S::constant(2.0) * square + three * cube) * time;
        self.square = square + three * cube;
    }

    /// Returns the value of the function or of a derivative at the instant `time`. `derivative` is the order of the
    /// derivative: 0 (the function itself), 1 or 2.
    #[must_use]
    pub fn value(&self, time: S, derivative: usize) -> S {
        let wave = self.wave.value(time, derivative);
        if !self.bends() {
            return wave;
        }
        let [bend, slope, square] = self.bend(time);
        wave + match derivative {
            0 => bend,
            1 => slope,
            _ => S::constant(2.0) * square,
        }
    }

    /// Returns the power series of the function or of a derivative over a time interval. The variable of the series is
    /// the elapsed fraction of the interval, from 0 to 1.
    #[must_use]
    pub fn terms(&self, time: S, length: S, derivative: usize) -> Poly<S> {
        let mut terms = self.wave.terms(time, length, derivative);
        if !self.bends() {
            return terms;
        }
        let (zero, two, three) = (S::constant(0.0), S::constant(2.0), S::constant(3.0));
        let ([bend, slope, square], cube) = (self.bend(time), self.cube);
        let bends = match derivative {
            0 => [
                bend,
                slope * length,
                square * length * length,
                cube * length * length * length,
            ],
            1 => [
                slope,
                two * square * length,
                three * cube * length * length,
                zero,
            ],
            _ => [two * square, S::constant(6.0) * cube * length, zero, zero],
        };
        for (order, bend) in bends.into_iter().enumerate() {
            add(&mut terms, order, bend);
        }
        terms
    }
}
