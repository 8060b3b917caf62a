//! The steady continuous motion as something to ask: exact velocity constraint, exact amplitudes,
//! displacement at any time, harmonics.  Run-time systems and emitted solvers share it.

use crate::chain::{Chain, ContactAt, ModeAt, Others};
use crate::complex::Complex;
pub use crate::decay::Decay;
use crate::decay::Instant;
use crate::errors::{NotContinuous, OutOfDomain, Regime, StuckResonance};
use crate::mode::Mode;
use crate::motion::{Carrier, Friction, Share};
use crate::scalar::Float;
use crate::search::{self, Peak, Question, Weight};
use crate::wave::{Sum, Wave};
use core::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// r, checked: NaN and negative values are out of the domain, 0 and ∞ are not.
#[inline]
pub fn check_ratio<S: Float>(value: S, argument: &'static str) -> Result<S, OutOfDomain> {
    if value >= S::constant(0.0) {
        Ok(value)
    } else {
        Err(OutOfDomain { argument })
    }
}

/// β, checked: NaN, negative and infinite values are out of the domain.
#[inline]
pub fn check_beta<S: Float>(beta: S) -> Result<S, OutOfDomain> {
    if beta >= S::constant(0.0) && beta.is_finite() {
        Ok(beta)
    } else {
        Err(OutOfDomain { argument: "beta" })
    }
}

/// The regime of β between the two limits.
#[inline]
pub fn regime<S: Float>(beta: S, continuous: S, sliding: S) -> Regime {
    if !(beta < sliding) {
        Regime::Stuck
    } else if beta < continuous {
        Regime::Continuous
    } else {
        Regime::StickSlip
    }
}

/// β/min(β_lim, β*_lim) − 1: negative in the continuous regime; 0 where β and the limit both are.
#[inline]
pub fn margin<S: Float>(beta: S, continuous: S, sliding: S) -> S {
    let limit = continuous.min(sliding);
    if beta == limit {
        S::constant(0.0)
    } else {
        beta / limit - S::constant(1.0)
    }
}

/// A limit with its values at r = 0 and r = ∞, where the sums themselves have none.
#[inline]
pub fn with_ends<S: Float>(r: S, limit: S, at_rest: S, at_infinity: S) -> S {
    if r == S::constant(0.0) {
        at_rest
    } else if r.is_finite() {
        limit
    } else {
        at_infinity
    }
}

impl<S: Float> Chain<S> {
    /// r²E·max(S, H_c + μm*/r²): the velocity constraint by a guaranteed search over the half
    /// period (5.54, 7.36, with the maximum of the sum), started at the break-away term.
    /// `waves` is working space, one for each mode.
    pub fn velocity_constraint<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> Peak<S> {
        for ((mode, at), wave) in modes.iter().zip(at).zip(waves.iter_mut()) {
            *wave = constraint_wave(mode, at, contact, mode.mobility);
        }
        let floor = self.break_away(contact);
        self.constraint_above(contact, at, waves, floor)
    }

    fn constraint_above<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        at: &[ModeAt<S>],
        waves: &[Wave<S, D>],
        floor: S,
    ) -> Peak<S> {
        // Undamped and with every R ≥ 1/2 the start of the half period decides.
        if !self.damped && at.iter().all(|at| at.x <= S::constant(2.0)) {
            return Peak {
                value: floor,
                places: [None; 4],
                evaluations: 0,
            };
        }
        let zero = S::constant(0.0);
        let sum = Sum {
            waves,
            constant: zero,
            cosine: zero,
            sine: zero,
        };
        // β_lim knows S by U² + S²: where U is the larger, S is needed to fewer digits.
        let ratio = contact.u / floor;
        let tolerance = S::constant(4.0 * S::EPSILON) * (S::constant(1.0) + ratio * ratio);
        search::largest(
            sum,
            Question {
                weight: Weight::Sine,
                both_signs: !self.damped,
                end: S::constant(if self.damped { PI } else { FRAC_PI_2 }),
                floor,
                tolerance: tolerance.min(S::constant(0.125)),
            },
        )
    }

    /// The same with the sum of each mode's own maximum in place of S (5.55, 7.37): an upper
    /// bound on S, as the thesis prints it.
    pub fn constraint_per_mode<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
    ) -> S {
        let mut sum = S::constant(0.0);
        for (mode, at) in modes.iter().zip(at) {
            if mode.in_contact {
                let wave: Wave<S, D> = constraint_wave(mode, at, contact, S::constant(1.0));
                let two_zeta = mode.zeta + mode.zeta;
                // The mode's own 1 + g + 2ζRu, its quotient for τ → 0.
                let floor = contact.scale + at.g + two_zeta * at.u * at.x;
                sum = sum
                    + mode.mobility
                        * self
                            .constraint_above(contact, core::slice::from_ref(at), &[wave], floor)
                            .value;
            }
        }
        sum.max(self.break_away(contact))
    }

    /// Whether β is below the exact continuous limit.  Most β are settled by a search that only
    /// asks whether the constraint exceeds what β allows.
    pub fn is_continuous<D: Decay<S>>(
        &self,
        beta: S,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> bool {
        if !(beta < self.continuous_limit(contact, self.break_away(contact))) {
            return false;
        }
        for ((mode, at), wave) in modes.iter().zip(at).zip(waves.iter_mut()) {
            *wave = constraint_wave(mode, at, contact, mode.mobility);
        }
        let break_away = self.break_away(contact);
        let excitation = crate::complex::modulus(contact.v, self.damped);
        let quadrature = beta * contact.u;
        let root = ((excitation - quadrature) * (excitation + quadrature)).sqrt();
        let allowed = S::constant(1.0 - 1e-3) * root / beta;
        if break_away < allowed && allowed.is_finite() {
            let peak = self.constraint_above(contact, at, waves, allowed);
            if peak.value <= allowed {
                return true;
            }
        }
        let constraint = self.constraint_above(contact, at, waves, break_away).value;
        beta < self.continuous_limit(contact, constraint)
    }
}

impl<S: Float> Chain<S> {
    /// β, if the motion at it is continuous and bounded; else which regime it is instead.
    /// `unbounded` are the undamped resonances that the load drives.
    ///
    /// # Errors
    /// Every [`NotContinuous`].
    #[allow(clippy::too_many_arguments, reason = "one question on one frequency")]
    pub fn admitted<D: Decay<S>>(
        &self,
        r: S,
        beta: S,
        sliding: S,
        unbounded: &[S],
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> Result<S, NotContinuous> {
        let beta = check_beta(beta)?;
        if !(beta < sliding) {
            return Err(NotContinuous::Stuck);
        }
        if !(S::constant(0.0) < r && self.is_continuous(beta, contact, modes, at, waves)) {
            return Err(NotContinuous::StickSlip);
        }
        if unbounded.contains(&r) {
            return Err(NotContinuous::Unbounded);
        }
        Ok(beta)
    }

    /// The sums without each mode, for an array of modes.
    pub fn others<const N: usize>(
        &self,
        modes: &[Mode<S>; N],
        at: &[ModeAt<S>; N],
        scale: S,
        inverse_r: S,
    ) -> [Others<S>; N] {
        let mut others = [Others::zero(); N];
        self.without_each(modes, at, scale, inverse_r, &mut others);
        others
    }

    /// The waves of a motion, for an array of modes; `residue` takes a mode and the component of
    /// its shape.
    #[allow(
        clippy::too_many_arguments,
        reason = "everything that one motion rests on"
    )]
    pub fn waves<D: Decay<S>, const N: usize>(
        &self,
        residue: impl Fn(&Mode<S>, S) -> S,
        modes: &[Mode<S>; N],
        shape: &[S; N],
        at: &[ModeAt<S>; N],
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> [Wave<S, D>; N] {
        let mut waves = modes.map(|mode| Wave::idle(&mode));
        for (((wave, mode), at), component) in waves.iter_mut().zip(modes).zip(at).zip(shape) {
            wave.x = at.x;
            if mode.in_contact {
                let share = self.share(
                    at,
                    residue(mode, *component),
                    contact,
                    friction,
                    inverse_r,
                    0,
                );
                *wave = motion_wave(at.x, wave.decay, share);
            }
        }
        waves
    }

    /// Nothing, unless the chain with its contact stuck resonates at r.  `invisible` are the
    /// undamped resonances that the load drives and the contact does not touch.
    ///
    /// # Errors
    /// [`StuckResonance`].
    pub fn stuck_admitted(
        &self,
        r: S,
        contact: &ContactAt<S>,
        invisible: &[S],
    ) -> Result<(), StuckResonance> {
        let zero = S::constant(0.0);
        if (contact.h.re == zero && contact.h.im == zero) || invisible.contains(&r) {
            return Err(StuckResonance);
        }
        Ok(())
    }
}

fn constraint_wave<S: Float, D: Decay<S>>(
    mode: &Mode<S>,
    at: &ModeAt<S>,
    contact: &ContactAt<S>,
    mobility: S,
) -> Wave<S, D> {
    let mut wave = Wave::rest(at.x, D::of(mode));
    if mode.in_contact {
        wave.free = mobility * (contact.scale + at.g);
        wave.swing_slope = mobility * at.u;
    }
    wave
}

/// The steady motion of one mass, or of the contact, in the continuous regime.
///
/// `W` holds the waves: an array in emitted code, a vector at run time.
#[derive(Clone, Copy, Debug)]
pub struct Motion<S, D, W> {
    friction: Friction<S>,
    carrier: Carrier<S>,
    waves: W,
    is_contact: bool,
    decay: core::marker::PhantomData<D>,
}

/// A mode's wave in a motion.
pub fn motion_wave<S: Float, D: Decay<S>>(x: S, decay: D, share: Share<S>) -> Wave<S, D> {
    let mut wave = Wave::rest(x, decay);
    wave.rise = share.rise;
    wave.swing = share.swing;
    wave.gain = share.gain;
    wave
}

impl<S: Float, D: Decay<S>, W: AsRef<[Wave<S, D>]>> Motion<S, D, W> {
    /// The relative motion in the contact.
    pub fn of_contact(friction: Friction<S>, carrier: Carrier<S>, waves: W) -> Self {
        Self {
            friction,
            carrier,
            waves,
            is_contact: true,
            decay: core::marker::PhantomData,
        }
    }

    /// The motion of a mass.
    pub fn of_mass(friction: Friction<S>, carrier: Carrier<S>, waves: W) -> Self {
        Self {
            friction,
            carrier,
            waves,
            is_contact: false,
            decay: core::marker::PhantomData,
        }
    }

    fn sum(&self) -> Sum<'_, S, D> {
        Sum {
            waves: self.waves.as_ref(),
            constant: self.carrier.constant,
            cosine: self.carrier.cosine,
            sine: self.carrier.sine,
        }
    }

    /// The exact maximum of |x̄| over the period (P/k₁; for base motion Y).
    pub fn amplitude(&self) -> S {
        if self.is_contact {
            self.friction.amplitude
        } else {
            self.peak().value
        }
    }

    /// √(x̄₀² + x̄₀′²), the estimate 5.50, 7.33 from the start of the half period.
    pub fn amplitude_monoharmonic(&self) -> S {
        if self.is_contact {
            return self.friction.amplitude;
        }
        let (c, s) = self.start();
        let large = c.abs().max(s.abs());
        if large == S::constant(0.0) {
            return large;
        }
        let ratio = c.abs().min(s.abs()) / large;
        large * (S::constant(1.0) + ratio * ratio).sqrt()
    }

    /// x̄ and x̄′ at τ = 0, where the modes are at rest with the contact.
    fn start(&self) -> (S, S) {
        (
            self.carrier.constant + self.carrier.cosine,
            self.carrier.sine,
        )
    }

    /// The search for the exact maximum of |x̄|.
    pub fn peak(&self) -> Peak<S> {
        let zero = S::constant(0.0);
        let (c, s) = self.start();
        let guess = s.atan2(c);
        let guess = if guess < zero {
            guess + S::constant(PI)
        } else {
            guess
        };
        search::largest_from(
            self.sum(),
            Question {
                weight: Weight::One,
                both_signs: true,
                end: S::constant(PI),
                floor: zero,
                tolerance: S::constant(4.0 * S::EPSILON),
            },
            guess,
        )
    }

    /// The lag of the motion's maximum behind the excitation's, rad, in (−π, π].  Of equal maxima
    /// the one of the smallest |lag| counts, then the positive one.
    pub fn phase(&self) -> S {
        if self.is_contact {
            return self.friction.phase;
        }
        let mut best: Option<S> = None;
        for place in self.peak().places.into_iter().flatten() {
            let shift = if place.negative {
                S::constant(PI)
            } else {
                S::constant(0.0)
            };
            let lag = wrap(self.friction.phase + place.tau + shift);
            best = Some(match best {
                Some(known) if known.abs() < lag.abs() => known,
                Some(known) if known.abs() == lag.abs() => known.max(lag),
                _ => lag,
            });
        }
        best.unwrap_or(self.friction.phase)
    }

    /// x̄ at τ, counted from a maximum of the contact's relative motion.
    pub fn displacement(&self, tau: S) -> S {
        let (at, negative) = instant(tau);
        let value = self.sum().value(&at);
        if negative { -value } else { value }
    }

    /// dx̄/dτ at τ, counted from a maximum of the contact's relative motion.
    pub fn velocity(&self, tau: S) -> S {
        let (at, negative) = instant(tau);
        let value = self.sum().slope(&at);
        if negative { -value } else { value }
    }

    /// X_n, with x̄ = Re Σ X_n e^{inτ_e} and τ_e from a maximum of the excitation (section 5).
    /// Even n, and n = 0, are 0: the motion repeats with the opposite sign after half a period.
    pub fn harmonic(&self, n: u32) -> Complex<S> {
        let zero = S::constant(0.0);
        if n % 2 == 0 {
            return Complex::new(zero, zero);
        }
        let order = S::constant(f64::from(n));
        let mut sum = Complex::new(zero, zero);
        for wave in self.waves.as_ref() {
            let re = (wave.x - order) * (wave.x + order);
            let im = S::constant(2.0) * wave.decay.zeta() * order * wave.x;
            let size = re.abs() + im;
            if wave.gain == zero || size == zero {
                continue;
            }
            let (re, im) = (re / size, im / size);
            let weight = wave.gain / (size * (re * re + im * im));
            sum = Complex::new(sum.re + weight * re, sum.im - weight * im);
        }
        // −(4iβ/πn) e^{−inφ}
        let (sine, cosine) = (self.friction.phase * S::constant(FRAC_1_PI) * order).sin_cos_pi();
        let k = S::constant(4.0 * FRAC_1_PI) * self.friction.beta / order;
        let factor = Complex::new(-(k * sine), -(k * cosine));
        let mut harmonic = Complex::new(
            factor.re * sum.re - factor.im * sum.im,
            factor.re * sum.im + factor.im * sum.re,
        );
        if n == 1 {
            harmonic = Complex::new(
                harmonic.re + self.carrier.response.re,
                harmonic.im + self.carrier.response.im,
            );
        }
        harmonic
    }
}

/// An angle moved into (−π, π].
fn wrap<S: Float>(mut angle: S) -> S {
    let (pi, turn) = (S::constant(PI), S::constant(2.0 * PI));
    while pi < angle {
        angle = angle - turn;
    }
    while angle <= -pi {
        angle = angle + turn;
    }
    angle
}

/// τ as an instant of the half period, and whether the motion has the opposite sign there.
fn instant<S: Float>(tau: S) -> (Instant<S>, bool) {
    let half_turns = tau * S::constant(FRAC_1_PI);
    let whole = half_turns.floor();
    let odd = (whole * S::constant(0.5)).floor() * S::constant(2.0) != whole;
    (Instant::new(half_turns - whole), odd)
}
