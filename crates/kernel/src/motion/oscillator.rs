//! One oscillator between two events: a mode of the chain while the contact slides, or a mode of the chain with its
//! contact stuck.
//!
//! The oscillator has the displacement y and the scaled velocity u = y′/x, where x is its natural frequency divided by
//! the excitation frequency. In free motion y and u oscillate and decay together ([`Turn`]).

use super::dynamics::{HeldMode, rotated};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Damped, Decay, Instant, Turn, multipliers, turn};
use crate::oscillator::mode::{Kind, Mode};

/// Bound of the region near a resonance, in which |x² − 1| + 2ζx < NEAR·x². x is the natural frequency divided by the
/// excitation frequency, and ζ the damping ratio. In this region the code computes the forced motion from differences
/// that vanish at the resonance. Outside the region, the forced motion is the sum of the steady motion and a free
/// motion. This sum loses at most a factor 1/NEAR of the precision.
const NEAR: f64 = 0.02;
/// Smallest 1 − ζ², with the damping ratio ζ, at which the amplitude of a free motion is a good bound on the motion.
const OSCILLATES: f64 = 0.05;

/// One oscillator between two events of the contact: a mode of the chain, or a mode of the chain with its contact
/// stuck.
#[derive(Clone, Copy, Debug)]
pub struct Part<S> {
    pub(crate) kind: Kind,
    /// Undamped natural frequency of the oscillator divided by the excitation frequency: x = σ/r, with the field
    /// `sigma`.
    pub(crate) x: S,
    pub(crate) zeta: S,
    /// q = √|1 − ζ²|, where ζ is the damping ratio of the oscillator.
    q: S,
    /// 1 − ζ², where ζ is the damping ratio of the oscillator.
    pub(crate) q2: S,
    /// Undamped natural frequency σ of the oscillator, as a frequency ratio.
    sigma: S,
    /// Complex amplitude of the steady displacement: y = Re(steady·e^{iτ_e}). If `near` is true, the field is the
    /// complex amplitude of the force on the oscillator instead.
    steady: Complex<S>,
    /// Complex amplitude of φ/x = Re(direct·e^{iτ_e}), where φ is a velocity that the excitation adds directly to the
    /// velocity y′. The scaled velocity is then u = (y′ − φ)/x.
    direct: Complex<S>,
    /// True if a load acts whose frequency is near the resonance. The code then computes the forced motion from
    /// differences that vanish at the resonance.
    pub(crate) near: bool,
    /// Displacement about which the oscillator moves. The constant forces cause this displacement.
    pub(crate) centre: S,
    /// Displacement y of the oscillator at the present instant, or at the start of the segment.
    pub(crate) y: S,
    /// Scaled velocity u = y′/x at the same instant as the displacement y. x is the natural frequency divided by the
    /// excitation frequency.
    pub(crate) u: S,
    /// Displacement y and scaled velocity u of the free motion, at the start of the segment.
    pub(crate) free: [S; 2],
    /// Coefficients of the decaying cosine c and the decaying sine s ([`Turn`]) in the function whose zero a search
    /// finds. `slope` contains the coefficients in the derivative of that function.
    pub(crate) value: [S; 2],
    pub(crate) slope: [S; 2],
    /// Upper bound, at the start, on the oscillator's term in the third derivative of the function that a search
    /// examines. The bound of an oscillation decays as e^{−ζxτ}.
    pub(crate) bound: S,
    /// Weights of the displacement y and the scaled velocity u in the function that a search examines.
    pub(crate) weight: [S; 2],
}

impl<S: Float> Part<S> {
    /// Returns an undamped oscillator at rest without a load, to initialise arrays. Its natural frequency is 1.
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

    /// Creates the oscillator of a mode at the frequency ratio r, driven by a load of complex amplitude `load`.
    pub(crate) fn from_mode(mode: &Mode<S>, load: Complex<S>, r: S) -> Self {
        let mut part = Self::empty();
        part.kind = mode.kind;
        (part.zeta, part.q, part.sigma) = (mode.zeta, mode.q, mode.resonance);
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        part.tuned(r, load, one, complex::real(zero));
        part
    }

    /// Creates the oscillator of a mode of the chain with its contact stuck, at the frequency ratio r. `drive` contains
    /// two complex amplitudes, each multiplied by r. The first is the amplitude of the direct change of the velocity.
    /// The second is the amplitude of the force on the mode.
    pub(crate) fn from_stuck_mode(mode: &HeldMode<S>, r: S, drive: [Complex<S>; 2]) -> Self {
        let mut part = Self::empty();
        part.kind = mode.kind;
        (part.zeta, part.q, part.sigma) = (mode.zeta, mode.q, mode.frequency);
        let [first, second] = drive;
        // The equation of motion of the displacement y alone has the force Ψ, with r²Ψ = ωφ₂ + (2ζω + ir)φ₁. φ₁ and φ₂
        // are the two numbers in `drive`, and ω is the natural frequency. The code computes rΨ, because r³ may overflow
        // or underflow.
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

    /// Sets the oscillator to the frequency ratio r. `force`·`unit` is the complex amplitude of the force. `direct` is
    /// the complex amplitude of the velocity that the excitation adds directly to the oscillator's velocity, divided by
    /// the field `x`.
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

    /// Multiplies the present displacement and velocity by `factor`, and the load by `load`.
    pub(crate) fn scale(&mut self, factor: S, load: S) {
        (self.y, self.u) = (self.y * factor, self.u * factor);
        self.steady = complex::scale(self.steady, load);
        self.direct = complex::scale(self.direct, load);
        self.near = self.near && !load.is_zero();
    }

    /// Returns the coefficients of the free motion after the time τ = πt, with t in half-turns.
    #[inline]
    pub(crate) fn turn(&self, t: S, tau: S) -> Turn<S> {
        turn(self.kind, self.zeta, self.q, self.x, (t, tau))
    }

    /// Returns the state [y, u] (displacement and scaled velocity) of a free motion after a time. `free` is the state
    /// before this time, and `turn` contains the coefficients of the free motion for this time.
    #[inline]
    pub(crate) fn turned(&self, free: [S; 2], turn: &Turn<S>) -> [S; 2] {
        turn.moved(self.zeta, free)
    }

    /// Returns the displacement y and the scaled velocity u of the steady motion. The argument contains sine and cosine
    /// of the excitation's phase. Near the resonance, the result leaves out the forced displacement, which
    /// [`grown`](Self::grown) returns.
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

    /// Sets the free motion at the start of a segment. The displacement y and the scaled velocity u of the free motion
    /// are the present y and u, minus y and u of the steady motion.
    #[inline]
    pub(crate) fn start(&mut self, phase: (S, S)) {
        let [y, u] = self.carried(phase);
        self.free = [self.y - y, self.u - u];
    }

    /// Returns the displacement y and the scaled velocity u a time τ after the start of the segment. `from` and `phase`
    /// are sine and cosine of the excitation's phase at the start and after τ.
    #[inline]
    pub(crate) fn at(&self, turn: &Turn<S>, t: S, from: (S, S), phase: (S, S)) -> [S; 2] {
        let [free_y, free_u] = self.turned(self.free, turn);
        let [y, u] = self.carried(phase);
        if self.near {
            let [value, slope, ..] = self.grown(t, from);
            return [free_y + y + value, free_u + u + slope / self.x];
        }
        [free_y + y, free_u + u]
    }

    /// Returns the displacement y and its first three derivatives in a motion that starts from rest. This motion obeys
    /// y″ + 2ζxy′ + x²y = Re(force·e^{i(θ + τ)}). Call this function only if the excitation is near the resonance. `t`
    /// is τ/π, and `phase` is (sin θ, cos θ).
    pub(crate) fn grown(&self, t: S, phase: (S, S)) -> [S; 4] {
        let at = Instant::new(t);
        let (x, one) = (self.x, S::constant(1.0));
        let loss = (self.zeta + self.zeta) * x;
        let detuning = (x - one) * (x + one);
        // The real part of k is the response to cos τ. The imaginary part of k is the response to sin τ.
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

    /// Returns the force on the oscillator as a complex number re + i·im. The force at the phase τ is re·cos τ + im·sin
    /// τ. `sine` and `cosine` belong to the excitation's phase at τ = 0.
    fn force_from(&self, (sine, cosine): (S, S)) -> Complex<S> {
        Complex::new(
            self.steady.re * cosine - self.steady.im * sine,
            -(self.steady.re * sine) - self.steady.im * cosine,
        )
    }

    /// Adds the forced motion of [`grown`](Self::grown) to the derivatives of the function that a search examines, at
    /// the start of the segment.
    pub(crate) fn grown_series(&self, phase: (S, S), terms: &mut [S]) {
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

    /// Returns an upper bound on |`steady`|. Near the resonance, `steady` is the complex amplitude of the force.
    pub(crate) fn push(&self) -> S {
        self.steady.re.abs() + self.steady.im.abs()
    }

    /// Returns the complex amplitude of the steady displacement, or `None` on an undamped resonance.
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

    /// Returns the complex amplitudes of the displacement y and the scaled velocity u in the steady motion about 0, or
    /// `None` on an undamped resonance.
    pub(crate) fn steady_state(&self) -> Option<[Complex<S>; 2]> {
        let y = self.steady()?;
        let slope = complex::scale(Complex::new(-y.im, y.re), S::constant(1.0) / self.x);
        let direct = complex::scale(self.direct, S::constant(-1.0));
        Some([y, complex::add(slope, direct)])
    }

    /// Returns the displacement y and the scaled velocity u of the steady motion about 0, or `None` on an undamped
    /// resonance. The argument contains sine and cosine of the excitation's phase.
    fn settled(&self, (sine, cosine): (S, S)) -> Option<[S; 2]> {
        let steady = self.steady()?;
        let y = rotated(steady, sine, cosine);
        let slope = -(steady.re * sine) - steady.im * cosine;
        Some([y, slope / self.x - rotated(self.direct, sine, cosine)])
    }

    /// Sets the oscillator to its steady motion about 0. Returns `None` on an undamped resonance.
    pub(crate) fn settle(&mut self, phase: (S, S)) -> Option<()> {
        self.centre = S::constant(0.0);
        [self.y, self.u] = self.settled(phase)?;
        Some(())
    }

    /// Returns an upper bound on the contribution of the free vibration to the function that a search examines. The
    /// bound holds at any later time. The free vibration is the present motion minus the steady motion. On an undamped
    /// resonance no steady motion exists. The bound is then `f64::MAX`, converted to the number type.
    pub(crate) fn free_amplitude(&self, phase: (S, S)) -> S {
        let Some([y, u]) = self.settled(phase) else {
            return S::constant(f64::MAX);
        };
        let [a, b] = self.weighted([self.y - self.centre - y, self.u - u]);
        if self.oscillates() {
            (a * a + b * b / self.q2).sqrt()
        } else {
            // The free motion is a·c + b·s, with |c| ≤ 1. For ζ above 0.4, s = e^{−ζxτ}sin(qxτ)/q stays less than 1.
            a.abs() + b.abs()
        }
    }

    /// Returns true if the free vibration of the oscillator never decays.
    pub(crate) fn is_undamped(&self) -> bool {
        self.kind == Kind::Undamped
    }

    /// Returns the coefficients of the decaying cosine c and sine s in `weight`·(y, u) of a free motion. y is the
    /// displacement and u the scaled velocity.
    #[inline]
    fn weighted(&self, [y, u]: [S; 2]) -> [S; 2] {
        let ([of_y, of_u], zeta) = (self.weight, self.zeta);
        [
            of_y * y + of_u * u,
            of_y * (zeta * y + u) - of_u * (zeta * u + y),
        ]
    }

    /// Returns the two factors e^{x(−ζ ± iq)τ} by which the free motion grows or decays during the time τ. x, ζ and q
    /// are the fields `x`, `zeta` and `q`.
    pub(crate) fn multipliers(&self, tau: S) -> [Complex<S>; 2] {
        let turn = self.turn(tau * S::inverse_pi(), tau);
        multipliers(self.kind, self.q, &turn)
    }

    /// Returns the oscillator's contribution to the fundamental of the function that a search examines. The result is
    /// the complex amplitude of e^{iτ_e} in this function.
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

    /// Prepares a search of the function `weight`·(y, u), where y is the displacement and u the scaled velocity.
    /// Computes the coefficients of the decaying cosine c and sine s in this function and in its derivative. Also
    /// computes the bound on the third derivative of the function.
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

    /// Returns true if the free motion is a decaying oscillation, whose amplitude bounds the motion. If the result is
    /// false, the free motion is a sum of exponential functions that may nearly cancel.
    pub(crate) fn oscillates(&self) -> bool {
        S::constant(OSCILLATES) < self.q2
    }

    /// Returns the coefficients of the decaying cosine c and sine s in the derivative of a·c + b·s.
    #[inline]
    pub(crate) fn derived(&self, [a, b]: [S; 2]) -> [S; 2] {
        [
            self.x * (b - self.zeta * a),
            -(self.x * (self.q2 * a + self.zeta * b)),
        ]
    }
}

/// Advances all oscillators by τ from the start of the segment. `from` and `to` are sine and cosine of the excitation's
/// phase at the start and at the end.
pub(crate) fn advanced<S: Float>(parts: &mut [Part<S>], tau: S, from: (S, S), to: (S, S)) {
    let t = tau * S::inverse_pi();
    for part in parts {
        let turn: Turn<S> = part.turn(t, tau);
        let [y, u] = part.at(&turn, t, from, to);
        (part.y, part.u) = (y, u);
    }
}

#[cfg(test)]
mod tests;
