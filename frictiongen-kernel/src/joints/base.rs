//! Displacement of the base as a function of time: a harmonic, or a cubic polynomial between two samples.

use super::run::Motion;
use super::series::Poly;
use super::size::{Size, add, at, set};
use super::state::{FREE, STUCK};
use super::wave::Wave;
use crate::Float;
use crate::errors::Halt;

/// A function of time: w(t) + at² + bt³, where w(t) is a [`Wave`] (a straight line and a harmonic).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Curve<S> {
    /// The straight line and the harmonic, w(t).
    pub wave: Wave<S>,
    /// Coefficient a of t².
    pub square: S,
    /// Coefficient b of t³.
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
    /// Returns the function that is 0 at every instant: the base does not move.
    #[must_use]
    pub fn zero() -> Self {
        Wave::zero().into()
    }

    /// Returns the cubic with given displacements and velocities at the instants 0 and `length`.
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

    /// Returns the straight line with the given displacement and velocity at the instant 0.
    #[must_use]
    pub fn straight([place, velocity]: [S; 2]) -> Self {
        let mut line = Self::zero();
        line.wave.constant = place;
        line.wave.slope = velocity;
        line
    }

    /// Returns true if the value is 0 at every instant.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.wave.is_zero() && !self.bends()
    }

    fn bends(&self) -> bool {
        !self.square.is_zero() || !self.cube.is_zero()
    }

    /// Changes the coefficients so that `time` becomes the instant 0.
    pub(super) fn shift(&mut self, time: S) {
        self.wave.shift(time);
        let three = S::constant(3.0);
        let (square, cube) = (self.square, self.cube * time);
        self.wave.constant = self.wave.constant + (square + cube) * time * time;
        self.wave.slope = self.wave.slope + (S::constant(2.0) * square + three * cube) * time;
        self.square = square + three * cube;
    }

    /// Returns the value of a derivative at an instant. The order `derivative` is 0 (the function itself), 1 or 2.
    #[must_use]
    pub fn value(&self, time: S, derivative: usize) -> S {
        at(&self.terms(time, S::constant(0.0), derivative), 0)
    }

    /// Returns the power series of the function or of a derivative over a stretch. The variable of the series is the
    /// fraction of the stretch, from 0 to 1.
    #[must_use]
    pub fn terms(&self, time: S, length: S, derivative: usize) -> Poly<S> {
        let mut terms = self.wave.terms(time, length, derivative);
        if !self.bends() {
            return terms;
        }
        let (zero, two, three) = (S::constant(0.0), S::constant(2.0), S::constant(3.0));
        let (square, cube) = (self.square, self.cube);
        let slope = (two * square + three * cube * time) * time;
        let bend = square + three * cube * time;
        let bends = match derivative {
            0 => [
                (square + cube * time) * time * time,
                slope * length,
                bend * length * length,
                cube * length * length * length,
            ],
            1 => [
                slope,
                two * bend * length,
                three * cube * length * length,
                zero,
            ],
            _ => [two * bend, S::constant(6.0) * cube * length, zero, zero],
        };
        for (order, bend) in bends.into_iter().enumerate() {
            add(&mut terms, order, bend);
        }
        terms
    }
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Changes the motion of the base from the present instant on. Displacement and velocity of the base must not jump
    /// at this instant.
    pub(super) fn lead_base(&mut self, to: Curve<S>) {
        let jump = to.value(self.time, 2) - self.model.base.value(self.time, 2);
        self.model.base = to;
        if !jump.is_zero() {
            self.accelerations_jump();
        }
    }

    /// Changes the motion of the base from the present instant on. Displacement and velocity of the base may jump. The
    /// masses keep their displacements and velocities. In a contact between a mass and the base, the relative
    /// displacement and velocity jump.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the solver cannot decide which contacts stick.
    pub(super) fn jolt_base(&mut self, to: Curve<S>) -> Result<(), Halt> {
        let zero = S::constant(0.0);
        let (before, after) = (self.model.base.value(self.time, 0), to.value(self.time, 0));
        let rounding = S::constant(4.0 * S::EPSILON) * after.abs();
        let rise = after - before;
        let rise = if rise.abs() <= rounding { zero } else { rise };
        self.model.base = to;
        self.accelerations_jump();
        let (x, v) = self.nodes();
        let base = self.model.base_node();
        for (j, contact) in self.model.contacts().iter().enumerate() {
            if contact.is_free() || contact.minus != base {
                continue;
            }
            let speed = contact.across(v.as_ref());
            let slides = if speed > zero { 1 } else { -1 };
            let phase = match contact.stiffness {
                None if speed.is_zero() => STUCK,
                None => slides,
                Some(stiffness) => {
                    let level = contact.level.constant;
                    let slid = self.state.phase(j) != STUCK;
                    let force = at(self.state.forces.as_ref(), j) - stiffness * rise;
                    let most = if slid {
                        level
                    } else {
                        contact.stiction * level
                    };
                    let breaks = force.abs() > most;
                    let kept = if breaks { level.copysign(force) } else { force };
                    set(self.state.forces.as_mut(), j, kept);
                    let goes = breaks || (slid && kept.abs() >= level);
                    if goes && kept * speed > zero {
                        slides
                    } else {
                        STUCK
                    }
                }
            };
            set(self.state.places.as_mut(), j, contact.across(x.as_ref()));
            if self.state.phase(j) != phase && self.state.phase(j) != FREE {
                self.state.set_zeros(j, (0, phase));
            }
            self.state.set_phase(j, phase);
        }
        self.decide_at_once()
    }
}
