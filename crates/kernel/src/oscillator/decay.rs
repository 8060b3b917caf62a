//! Free motion of one mode as a function of time. Each kind of damping has its own closed form. Two forms agree where
//! their ranges of the damping ratio ζ meet.
//!
//! The free displacement that starts with unit speed from 0 is p = e^{−ζxτ}·sin(qxτ)/(qx). Here ζ is the damping ratio,
//! q = √(1 − ζ²), x the natural frequency divided by the excitation frequency, and τ the time in rad of the excitation.
//! The motion of a mode in a half period is a combination of p, its derivative p′ and three differences ([`Basis`]).
//! Some of the differences vanish where p vanishes, others at the resonance of the mode. The code computes all
//! differences without cancellation.

use super::mode::{Kind, Mode};
pub(crate) use super::values::Turn;
pub use super::values::{Basis, Instant};
use super::{critical, overdamped, undamped, underdamped};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;
use crate::number::special::versine_beside;

impl<S: Float> Instant<S> {
    /// Creates the instant τ = πt from the phase t in half-turns (π rad).
    #[inline]
    pub fn new(t: S) -> Self {
        let (sine, cosine) = t.sin_cos_pi();
        Self {
            t,
            tau: t * S::pi(),
            sine,
            cosine,
            versine: versine_beside(t, cosine),
        }
    }

    /// Creates the instant τ = 0, the start of the half period.
    #[inline]
    pub(crate) fn start() -> Self {
        let zero = S::constant(0.0);
        Self {
            t: zero,
            tau: zero,
            sine: zero,
            cosine: S::constant(1.0),
            versine: zero,
        }
    }

    /// Creates the instant τ from the phase in rad. For τ = 0 the code evaluates no sine.
    #[inline]
    pub(crate) fn from_start(tau: S) -> Self {
        if tau.is_zero() {
            Self::start()
        } else {
            Self::new(tau * S::inverse_pi())
        }
    }
}

/// Damping of the modes of a scene. The damping is a type parameter, so that the code for undamped scenes contains no
/// exponentials.
pub trait Decay<S: Float>: Copy {
    /// Creates the damping of a mode from its kind of damping and its damping ratio.
    fn of(mode: &Mode<S>) -> Self;
    /// Returns the kind of damping of the mode: undamped, underdamped, critical or overdamped. The kind selects the
    /// closed form.
    fn kind(&self) -> Kind;
    /// Returns the modal damping ratio ζ of the mode.
    fn zeta(&self) -> S;
    /// Evaluates the functions of time in [`Basis`] of a mode at one instant. x is the natural frequency divided by the
    /// excitation frequency.
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S>;
    /// Evaluates the free displacement p and its derivative p′ of a mode at one instant, without the other functions of
    /// [`Basis`]. x is the natural frequency divided by the excitation frequency.
    fn free(&self, x: S, at: &Instant<S>) -> (S, S);
}

/// Damping of a mode with the damping ratio ζ = 0, for scenes without damping.
#[derive(Clone, Copy, Debug, Default)]
pub struct Undamped;

/// Damping of a mode with any damping ratio ζ, including 0.
#[derive(Clone, Copy, Debug)]
pub struct Damped<S> {
    kind: Kind,
    zeta: S,
    q: S,
    q_defect: S,
}

impl<S: Float> Decay<S> for Undamped {
    #[inline(always)]
    fn of(_: &Mode<S>) -> Self {
        Self
    }
    #[inline(always)]
    fn kind(&self) -> Kind {
        Kind::Undamped
    }
    #[inline(always)]
    fn zeta(&self) -> S {
        S::constant(0.0)
    }
    #[inline]
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S> {
        undamped::basis(x, at)
    }
    #[inline]
    fn free(&self, x: S, at: &Instant<S>) -> (S, S) {
        let turn = undamped::turn(x, at.t);
        (turn.s / x, turn.c)
    }
}

impl<S: Float> Decay<S> for Damped<S> {
    #[inline(always)]
    fn of(mode: &Mode<S>) -> Self {
        Self {
            kind: mode.kind,
            zeta: mode.zeta,
            q: mode.q,
            q_defect: mode.q_defect,
        }
    }
    #[inline(always)]
    fn kind(&self) -> Kind {
        self.kind
    }
    #[inline(always)]
    fn zeta(&self) -> S {
        self.zeta
    }
    #[inline]
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S> {
        match self.kind {
            Kind::Undamped => undamped::basis(x, at),
            Kind::Light => underdamped::light(x, self.zeta, self.q, self.q_defect, at),
            Kind::Heavy => underdamped::heavy(x, self.zeta, self.q, at),
            Kind::Critical => critical::basis(x, self.zeta, at),
            Kind::Over => overdamped::basis(x, self.zeta, self.q, at),
        }
    }
    #[inline]
    fn free(&self, x: S, at: &Instant<S>) -> (S, S) {
        let turn = turn(self.kind, self.zeta, self.q, x, (at.t, at.tau));
        (turn.s / x, turn.c - self.zeta * turn.s)
    }
}

impl<S: Float> Damped<S> {
    /// Creates the damping of a mode from its kind of damping, its damping ratio ζ, and q = √|1 − ζ²|.
    pub(crate) fn new(kind: Kind, zeta: S, q: S) -> Self {
        Self {
            kind,
            zeta,
            q,
            q_defect: zeta * zeta / (S::constant(1.0) + q),
        }
    }
}

/// Returns the free motion of a mode during the time τ = πt, in rad of the excitation. The natural frequency of the
/// mode is x times the excitation frequency.
#[inline]
pub(crate) fn turn<S: Float>(kind: Kind, zeta: S, q: S, x: S, (t, tau): (S, S)) -> Turn<S> {
    match kind {
        Kind::Undamped => undamped::turn(x, t),
        Kind::Light | Kind::Heavy => underdamped::turn(x, zeta, q, t, tau),
        Kind::Critical => critical::turn(x, tau),
        Kind::Over => overdamped::turn(x, zeta, q, tau),
    }
}

/// Returns the two factors e^{x(−ζ ± iq)τ} by which the two complex solutions of a mode's free motion change during
/// the time τ. x is the natural frequency divided by the excitation frequency, and τ is the time of the argument
/// `turn`.
pub(crate) fn multipliers<S: Float>(kind: Kind, q: S, turn: &Turn<S>) -> [Complex<S>; 2] {
    let im = q * turn.s;
    match kind {
        Kind::Undamped | Kind::Light | Kind::Heavy => [im, -im].map(|im| Complex::new(turn.c, im)),
        Kind::Critical => [complex::real(turn.c); 2],
        Kind::Over => [turn.c + im, turn.c - im].map(complex::real),
    }
}
