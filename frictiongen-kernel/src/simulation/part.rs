//! One oscillator between two events: a mode while the contact slides, a held mode while it sticks.
//!
//! Displacement y and scaled velocity u = y′/x; free, they turn and decay together ([`Turn`]).

use super::{HeldMode, rotated};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Damped, Decay, Instant, Turn, multipliers, turn};
use crate::oscillator::mode::{Kind, Mode};

/// Nearer to a resonance than this, |D| < NEAR·x², the forced motion is formed from differences that
/// vanish with D; elsewhere as the steady motion plus a free one, which loses at most 1/NEAR of the
/// precision.
const NEAR: f64 = 0.02;
/// With 1 − ζ² above this a part counts as an oscillation, whose amplitude bounds it.
const OSCILLATES: f64 = 0.05;

/// One oscillator.
#[derive(Clone, Copy, Debug)]
pub struct Part<S> {
    pub(super) kind: Kind,
    /// x, its undamped frequency over the excitation's.
    pub(crate) x: S,
    pub(super) zeta: S,
    /// √|1 − ζ²|.
    q: S,
    /// 1 − ζ².
    pub(super) q2: S,
    /// Its frequency for r = 1.
    sigma: S,
    /// The part of its steady displacement, y = Re(steady·e^{iτ_e}); the force itself if `near`.
    steady: Complex<S>,
    /// The part of u = (y′ − φ)/x that the drive takes directly, φ/x = Re(direct·e^{iτ_e}).
    direct: Complex<S>,
    /// Whether the excitation is so near its resonance that differences are used.
    pub(super) near: bool,
    /// The displacement about which it moves.
    pub(crate) centre: S,
    /// y and u now, at the start of the segment.
    pub(crate) y: S,
    pub(crate) u: S,
    /// The free part of both at the start of the segment.
    pub(super) free: [S; 2],
    /// Of c and s, in the function whose zero is sought, and in its derivative.
    pub(super) value: [S; 2],
    pub(super) slope: [S; 2],
    /// What its third derivative cannot exceed: times e^{−ζxτ} for an oscillation.
    pub(super) bound: S,
    /// In the function whose zero is sought: weights of y and u.
    pub(crate) weight: [S; 2],
}

impl<S: Float> Part<S> {
    /// Nothing yet: what an array starts from.
    #[must_use]
    pub fn empty() -> Self {
        let zero = S::constant(0.0);
        Self {
            kind: Kind::Undamped,
            x: S::constant(1.0),
            zeta: zero,
            q: S::constant(1.0),
            q2: S::constant(1.0),
            sigma: S::constant(1.0),
            steady: complex::real(zero),
            direct: complex::real(zero),
            near: false,
            centre: zero,
            y: zero,
            u: zero,
            free: [zero; 2],
            value: [zero; 2],
            slope: [zero; 2],
            bound: zero,
            weight: [zero; 2],
        }
    }

    /// A mode at 1/r, driven by the load.
    pub(super) fn of_mode(mode: &Mode<S>, r: S) -> Self {
        let mut part = Self::empty();
        part.kind = mode.kind;
        (part.zeta, part.q, part.sigma) = (mode.zeta, mode.q, mode.resonance);
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        part.tuned(r, complex::real(mode.load), one, complex::real(zero));
        part
    }

    /// A held mode at 1/r; `drive` are the two components of what drives it, times r.
    pub(super) fn of_held(mode: &HeldMode<S>, r: S, drive: [Complex<S>; 2]) -> Self {
        let mut part = Self::empty();
        part.kind = mode.kind;
        (part.zeta, part.q, part.sigma) = (mode.zeta, mode.q, mode.frequency);
        let [first, second] = drive;
        // r²Ψ = ωφ₂ + (2ζω + ir)φ₁, the force on y alone; over r, as r³ may be out of range.
        let over_r = mode.frequency / r;
        let loss = (mode.zeta + mode.zeta) * over_r;
        let force = Complex::new(
            over_r * second.re + loss * first.re - first.im,
            over_r * second.im + loss * first.im + first.re,
        );
        let direct = complex::scale(first, S::constant(1.0) / mode.frequency);
        part.tuned(r, force, r, direct);
        part
    }

    /// Driven at r by `force` times `unit`, and by `direct`.
    fn tuned(&mut self, r: S, force: Complex<S>, unit: S, direct: Complex<S>) {
        let one = S::constant(1.0);
        self.x = self.sigma / r;
        self.q2 = (one - self.zeta) * (one + self.zeta);
        self.direct = direct;
        let detuning = (self.sigma - r) * (self.sigma + r);
        let loss = (self.zeta + self.zeta) * self.sigma * r;
        let lambda = self.sigma * self.sigma;
        self.near = detuning.abs() + loss < S::constant(NEAR) * lambda;
        let driven = !(force.re.is_zero() && force.im.is_zero());
        self.near = self.near && driven;
        self.steady = if self.near {
            complex::scale(force, unit / (r * r))
        } else if driven {
            let inverse = complex::reciprocal(Complex::new(detuning, loss), true);
            complex::mul(force, complex::scale(inverse, unit), true)
        } else {
            force
        };
    }

    /// Its free motion over τ = πt.
    #[inline]
    pub(crate) fn turn(&self, t: S, tau: S) -> Turn<S> {
        turn(self.kind, self.zeta, self.q, self.x, (t, tau))
    }

    /// A free displacement and velocity after that.
    #[inline]
    pub(crate) fn turned(&self, free: [S; 2], turn: &Turn<S>) -> [S; 2] {
        turn.moved(self.zeta, free)
    }

    /// The steady part of y and u where the excitation's cosine and sine are these.
    #[inline]
    fn carried(&self, (sine, cosine): (S, S)) -> [S; 2] {
        if self.near {
            return [self.centre, -rotated(self.direct, sine, cosine)];
        }
        let y = rotated(self.steady, sine, cosine);
        let slope = -(self.steady.re * sine) - self.steady.im * cosine;
        [
            self.centre + y,
            slope / self.x - rotated(self.direct, sine, cosine),
        ]
    }

    /// The free part at the start of a segment, from y and u there.
    #[inline]
    pub(super) fn start(&mut self, phase: (S, S)) {
        let [y, u] = self.carried(phase);
        self.free = [self.y - y, self.u - u];
    }

    /// y and u after τ; the excitation has `from` at the start and `phase` then.
    #[inline]
    pub(super) fn at(&self, turn: &Turn<S>, t: S, from: (S, S), phase: (S, S)) -> [S; 2] {
        let [free_y, free_u] = self.turned(self.free, turn);
        let [y, u] = self.carried(phase);
        if self.near {
            let [value, slope, ..] = self.grown(t, from);
            return [free_y + y + value, free_u + u + slope / self.x];
        }
        [free_y + y, free_u + u]
    }

    /// y″ + 2ζxy′ + x²y = Re(force·e^{i(θ + τ)}) from rest, beside the resonance: y and three
    /// derivatives.
    pub(super) fn grown(&self, t: S, phase: (S, S)) -> [S; 4] {
        let at = Instant::new(t);
        let (x, one) = (self.x, S::constant(1.0));
        let loss = (self.zeta + self.zeta) * x;
        let detuning = (x - one) * (x + one);
        // The answers to cos τ and sin τ are the real and the negative imaginary part of k.
        let (k, k_slope) = if detuning.is_zero() && loss.is_zero() {
            let half = S::constant(0.5);
            let grown = at.tau * half;
            let lag = (at.sine - at.tau * at.cosine) * half;
            let lead = (at.sine + at.tau * at.cosine) * half;
            (
                Complex::new(grown * at.sine, lag),
                Complex::new(lead, grown * at.sine),
            )
        } else {
            let basis = Damped::new(self.kind, self.zeta, self.q).basis(x, &at);
            let inverse = complex::reciprocal(Complex::new(detuning, loss), true);
            let k = Complex::new(basis.forced_slope - loss * basis.free, basis.forced);
            let k_slope = Complex::new(detuning * basis.free - basis.forced, basis.forced_slope);
            (
                complex::mul(k, inverse, true),
                complex::mul(k_slope, inverse, true),
            )
        };
        let force = self.force_from(phase);
        let value = force.re * k.re + force.im * k.im;
        let slope = force.re * k_slope.re + force.im * k_slope.im;
        let push = force.re * at.cosine + force.im * at.sine;
        let push_slope = force.im * at.cosine - force.re * at.sine;
        let curve = push - loss * slope - x * x * value;
        let third = push_slope - loss * curve - x * x * slope;
        [value, slope, curve, third]
    }

    /// The force as re·cos τ + im·sin τ from a start where the excitation has this sine and cosine.
    fn force_from(&self, (sine, cosine): (S, S)) -> Complex<S> {
        Complex::new(
            self.steady.re * cosine - self.steady.im * sine,
            -(self.steady.re * sine) - self.steady.im * cosine,
        )
    }

    /// Adds the derivatives of `grown`, in the function sought, at the start.
    pub(super) fn grown_series(&self, phase: (S, S), terms: &mut [S]) {
        let zero = S::constant(0.0);
        let [of_y, of_u] = self.weight;
        let (of_slope, loss) = (of_u / self.x, (self.zeta + self.zeta) * self.x);
        let mut push = self.force_from(phase);
        let (mut value, mut slope) = (zero, zero);
        for term in terms {
            let curve = push.re - loss * slope - self.x * self.x * value;
            *term = *term + of_y * value + of_slope * slope;
            (value, slope) = (slope, curve);
            push = Complex::new(push.im, -push.re);
        }
    }

    /// The force on it beside its resonance, |steady|.
    pub(super) fn push(&self) -> S {
        self.steady.re.abs() + self.steady.im.abs()
    }

    /// The complex amplitude of its steady displacement; none on an undamped resonance.
    fn steady(&self) -> Option<Complex<S>> {
        Some(if self.near {
            let x = self.x;
            let one = S::constant(1.0);
            let loss = (self.zeta + self.zeta) * x;
            let d = Complex::new((x - one) * (x + one), loss);
            if d.re.is_zero() && d.im.is_zero() {
                return None;
            }
            complex::mul(self.steady, complex::reciprocal(d, true), true)
        } else {
            self.steady
        })
    }

    /// y and u of its steady motion about 0; none on an undamped resonance.
    fn settled(&self, (sine, cosine): (S, S)) -> Option<[S; 2]> {
        let steady = self.steady()?;
        let y = rotated(steady, sine, cosine);
        let slope = -(steady.re * sine) - steady.im * cosine;
        Some([y, slope / self.x - rotated(self.direct, sine, cosine)])
    }

    /// Sets it to its steady motion; none on an undamped resonance.
    pub(crate) fn settle(&mut self, phase: (S, S)) -> Option<()> {
        self.centre = S::constant(0.0);
        [self.y, self.u] = self.settled(phase)?;
        Some(())
    }

    /// Bound on what its free vibration, its motion now less the steady one, adds to the function sought at any later
    /// time.  The largest number of the scalar on an undamped resonance, where no motion is steady.
    pub(crate) fn free_amplitude(&self, phase: (S, S)) -> S {
        let Some([y, u]) = self.settled(phase) else {
            return S::constant(f64::MAX);
        };
        let [a, b] = self.weighted([self.y - self.centre - y, self.u - u]);
        if self.oscillates() {
            (a * a + b * b / self.q2).sqrt()
        } else {
            // e^{−ζxτ}sin(qxτ)/q stays below 1 for ζ beyond 0.4.
            a.abs() + b.abs()
        }
    }

    /// Whether its free vibration never dies.
    pub(crate) fn is_undamped(&self) -> bool {
        self.kind == Kind::Undamped
    }

    /// The coefficients of c and s in weight·(y, u) of a free motion.
    #[inline]
    fn weighted(&self, [y, u]: [S; 2]) -> [S; 2] {
        let ([of_y, of_u], zeta) = (self.weight, self.zeta);
        [
            of_y * y + of_u * u,
            of_y * (zeta * y + u) - of_u * (zeta * u + y),
        ]
    }

    /// By what its free motion is multiplied in τ: e^{x(−ζ ± iq)τ}.
    pub(crate) fn multipliers(&self, tau: S) -> [Complex<S>; 2] {
        let turn = self.turn(tau * S::inverse_pi(), tau);
        multipliers(self.kind, self.q, &turn)
    }

    /// What it adds to the fundamental component of the function sought: complex amplitude over e^{iτ_e}.
    pub(crate) fn fundamental(&self) -> Complex<S> {
        let [of_y, of_u] = self.weight;
        let direct = complex::scale(self.direct, -of_u);
        if self.near {
            return direct;
        }
        let slope = of_u / self.x;
        Complex::new(
            of_y * self.steady.re - slope * self.steady.im + direct.re,
            of_y * self.steady.im + slope * self.steady.re + direct.im,
        )
    }

    /// The coefficients of c and s in weight·(y, u), of its derivative, and the bound on its third.
    #[inline]
    pub(crate) fn aim(&mut self) {
        let zeta = self.zeta;
        self.value = self.weighted(self.free);
        self.slope = self.derived(self.value);
        let cube = self.x * self.x * self.x;
        let [a, b] = self.value;
        self.bound = if self.oscillates() {
            let turned = b * b / self.q2;
            (a * a + turned).sqrt() * cube
        } else {
            let reach = self.x * (zeta + (S::constant(1.0) + zeta * zeta).sqrt());
            let [slope, _] = self.slope;
            (self.x * self.x * a * a + slope * slope).sqrt() * reach * reach
        };
    }

    /// Whether its amplitude is that of a decaying oscillation, rather than a sum of decays that
    /// may cancel.
    pub(super) fn oscillates(&self) -> bool {
        S::constant(OSCILLATES) < self.q2
    }

    /// The coefficients of c and s of a function's derivative.
    #[inline]
    pub(super) fn derived(&self, [a, b]: [S; 2]) -> [S; 2] {
        [
            self.x * (b - self.zeta * a),
            -(self.x * (self.q2 * a + self.zeta * b)),
        ]
    }
}

/// How a held displacement of the contact lifts a mode.
pub(crate) fn lift<S: Float>(mode: &Mode<S>, receptance: S) -> S {
    mode.contact / (mode.resonance * mode.resonance * receptance)
}

#[cfg(test)]
mod tests;
