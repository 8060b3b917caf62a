//! Steady continuous motion: its exact amplitude, its displacement at any time, and its harmonics. Run-time systems and
//! emitted solvers use this module together.

use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::mass_controlled::is_mass_controlled;
use crate::modal_sum::search::{self, Effort, Neighbour, Peak, SearchSettings, Weight};
use crate::modal_sum::wave::{Sum, Wave};
use crate::number::complex::Complex;
use crate::number::phase::wrapped;
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};
use crate::oscillator::mode::Mode;
use crate::response::coefficients::{Friction, Fundamental, ModalCoefficients};

/// Largest difference at which two lags are treated as equal, in rounding units of 1 rad. The phase of the contact and
/// the instant of a maximum each have an error of a few rounding units.
const ALIKE: f64 = 64.0;

/// Steady motion of one mass, or steady relative motion of the contact, while the contact slides all the time.
///
/// The type `W` stores the term of each mode. `W` is an array in emitted code and a vector at run time.
#[derive(Clone, Copy, Debug)]
pub struct Motion<S, D, W> {
    friction: Friction<S>,
    fundamental: Fundamental<S>,
    waves: W,
    is_contact: bool,
    decay: core::marker::PhantomData<D>,
}

/// Largest displacement of a motion. The struct also has the phase of this displacement, and the number of evaluations
/// in the search for it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Largest<S> {
    /// Exact maximum of |x̄| in a period, in units of P/k₁ (of Y for base motion).
    pub amplitude: S,
    /// Lag of the motion's maximum behind the maximum of the excitation, in rad, in (−π, π].
    pub phase: S,
    /// Number of evaluations of the modal sum in the search.
    pub effort: Effort,
}

/// Returns the term of one mode in the modal sum of a motion, as a [`Wave`]. `x` is the natural frequency of the mode
/// divided by the excitation frequency.
pub fn motion_wave<S: Float, D: Decay<S>>(
    x: S,
    decay: D,
    coefficients: ModalCoefficients<S>,
) -> Wave<S, D> {
    let mut wave = Wave::at_rest(x, decay);
    wave.rise = coefficients.rise;
    // The term cos τ − d equals (cos τ − p′) − 2ζx·p, because d = p′ + 2ζx·p.
    wave.forced_slope = coefficients.fall;
    wave.free = -((decay.zeta() + decay.zeta()) * x * coefficients.fall);
    wave.forced = coefficients.forced;
    wave.residue = coefficients.harmonic;
    wave
}

/// Returns the term of one mode in the modal sum for the motion of a mass. `x` is the natural frequency of the mode
/// divided by the excitation frequency. The argument `coefficients` comes from [`Chain::mass_coefficients`].
pub fn mass_wave<S: Float, D: Decay<S>>(
    x: S,
    decay: D,
    coefficients: ModalCoefficients<S>,
) -> Wave<S, D> {
    Wave {
        mass_controlled: is_mass_controlled(decay.kind(), decay.zeta(), x),
        ..motion_wave(x, decay, coefficients)
    }
}

impl<S: Float, D: Decay<S>, W: AsRef<[Wave<S, D>]>> Motion<S, D, W> {
    /// Creates the relative motion of the contact. `waves` contains one term for each mode.
    pub fn of_contact(friction: Friction<S>, fundamental: Fundamental<S>, waves: W) -> Self {
        Self {
            friction,
            fundamental,
            waves,
            is_contact: true,
            decay: core::marker::PhantomData,
        }
    }

    /// Creates the motion of a mass. `waves` contains one term for each mode.
    pub fn of_mass(friction: Friction<S>, fundamental: Fundamental<S>, waves: W) -> Self {
        Self {
            friction,
            fundamental,
            waves,
            is_contact: false,
            decay: core::marker::PhantomData,
        }
    }

    fn sum(&self) -> Sum<'_, S, D> {
        Sum {
            waves: self.waves.as_ref(),
            cosine: self.fundamental.cosine,
            sine: self.fundamental.sine,
        }
    }

    /// Returns the amplitude and the phase of this motion from one search, and the number of evaluations in the search.
    ///
    /// [`At::most_evaluations`](crate::response::At::most_evaluations) returns an upper bound on the number of
    /// evaluations. The motion of the contact needs no search.
    pub fn largest(&self) -> Largest<S> {
        if self.is_contact {
            return Largest {
                amplitude: self.friction.amplitude,
                phase: self.friction.phase,
                effort: Effort::Bounded(0),
            };
        }
        self.largest_of(&self.peak())
    }

    /// Returns the amplitude and the phase of this motion from a search that starts at a predicted maximum. `neighbour`
    /// makes the prediction from previous searches of a sweep over r or β.
    ///
    /// A sweep with smaller steps needs fewer evaluations for each search. The result is still the largest value in the
    /// whole period. The amplitude may differ from that of [`largest`](Self::largest) by four rounding units of the
    /// motion's modal terms.
    pub fn largest_near(&self, neighbour: &mut Neighbour<S>) -> Largest<S> {
        if self.is_contact {
            return self.largest();
        }
        self.largest_of(&search::largest_near(
            self.sum(),
            Self::problem(),
            neighbour,
        ))
    }

    fn largest_of(&self, peak: &Peak<S>) -> Largest<S> {
        Largest {
            amplitude: peak.value,
            phase: self.lag(peak),
            effort: peak.effort(),
        }
    }

    /// Returns the exact maximum of |x̄| in a period, in units of P/k₁ (of Y for base motion). Each call makes a new
    /// search. [`largest`](Self::largest) also reports whether the search is complete.
    pub fn amplitude(&self) -> S {
        if self.is_contact {
            self.friction.amplitude
        } else {
            self.peak().value
        }
    }

    /// Returns √(x̄₀² + x̄₀′²), the monoharmonic estimate of the amplitude (5.50), (7.33). x̄₀ is the displacement at
    /// the start of the half period, and x̄₀′ = dx̄/dτ the velocity.
    pub fn amplitude_monoharmonic(&self) -> S {
        if self.is_contact {
            return self.friction.amplitude;
        }
        let (c, s) = self.sum().start();
        let large = c.abs().max(s.abs());
        if large == S::constant(0.0) {
            return large;
        }
        let ratio = c.abs().min(s.abs()) / large;
        large * (S::constant(1.0) + ratio * ratio).sqrt()
    }

    /// Searches for the exact maximum of |x̄| in a period of this motion.
    pub fn peak(&self) -> Peak<S> {
        search::largest(self.sum(), Self::problem())
    }

    fn problem() -> SearchSettings<S> {
        let zero = S::constant(0.0);
        SearchSettings {
            weight: Weight::One,
            both_signs: true,
            end: S::pi(),
            floor: zero,
            start: zero,
            tolerance: S::constant(4.0 * S::RESOLUTION),
        }
    }

    /// Returns the lag of the motion's maximum behind the maximum of the excitation, in rad, in (−π, π]. If several
    /// maxima are equal, the function returns the lag of smallest size. If two lags of equal size have opposite signs,
    /// it returns the positive lag. Each call makes a new search, as [`largest`](Self::largest) does.
    pub fn phase(&self) -> S {
        if self.is_contact {
            return self.friction.phase;
        }
        self.lag(&self.peak())
    }

    fn lag(&self, peak: &Peak<S>) -> S {
        let mut best: Option<S> = None;
        for place in peak.places.into_iter().flatten() {
            let shift = if place.negative {
                S::pi()
            } else {
                S::constant(0.0)
            };
            let lag = wrapped(self.friction.phase + place.tau + shift);
            // If two lags differ only in their sign, rounding errors must not decide between them.
            let near = S::constant(ALIKE * S::RESOLUTION);
            best = Some(match best {
                Some(known) if known.abs() + near < lag.abs() => known,
                Some(known) if (known.abs() - lag.abs()).abs() <= near => known.max(lag),
                _ => lag,
            });
        }
        best.unwrap_or(self.friction.phase)
    }

    /// Returns the displacement x̄ at the phase τ in rad, in units of P/k₁ (of Y for base motion). At τ = 0 the
    /// contact's relative motion has its maximum.
    pub fn displacement(&self, tau: S) -> S {
        let (at, negative) = instant(tau);
        let value = self.sum().value(&at);
        if negative { -value } else { value }
    }

    /// Returns the velocity dx̄/dτ at the phase τ in rad. At τ = 0 the contact's relative motion has its maximum.
    pub fn velocity(&self, tau: S) -> S {
        let (at, negative) = instant(tau);
        let value = self.sum().slope(&at);
        if negative { -value } else { value }
    }

    /// Returns the acceleration d²x̄/dτ² at the phase τ in rad. At τ = 0 the contact's relative motion has its maximum.
    /// The acceleration jumps when the contact reverses. At a jump the function returns the value just after the jump.
    pub fn acceleration(&self, tau: S) -> S {
        let (at, negative) = instant(tau);
        let value = self.sum().jet(&at).curvature;
        if negative { -value } else { value }
    }

    /// Returns X_n, the complex amplitude of harmonic n. The harmonics are defined by x̄ = Re Σ X_n e^{inτ_e} (section
    /// 5 of `docs/derivation.md`). The phase τ_e is 0 at a maximum of the excitation. X_n is 0 for n = 0 and for even
    /// n, because the motion repeats with the opposite sign after half a period.
    pub fn harmonic(&self, n: u32) -> Complex<S> {
        let zero = S::constant(0.0);
        if n.is_multiple_of(2) {
            return Complex::new(zero, zero);
        }
        let order = S::constant(f64::from(n));
        let mut sum = Complex::new(zero, zero);
        for wave in self.waves.as_ref() {
            let re = (wave.x - order) * (wave.x + order);
            let im = S::constant(2.0) * wave.decay.zeta() * order * wave.x;
            let size = re.abs() + im;
            if wave.residue.vanishes() || size == zero {
                continue;
            }
            let (re, im) = (re / size, im / size);
            let weight = wave.residue / (size * (re * re + im * im));
            sum = Complex::new(sum.re + weight * re, sum.im - weight * im);
        }
        // `factor` is −(4iβ/πn) e^{−inφ}, where φ is the phase of the contact.
        let (sine, cosine) = (self.friction.phase * S::inverse_pi() * order).sin_cos_pi();
        let k = S::constant(4.0) * S::inverse_pi() * self.friction.beta / order;
        let factor = Complex::new(-(k * sine), -(k * cosine));
        let mut harmonic = Complex::new(
            factor.re * sum.re - factor.im * sum.im,
            factor.re * sum.im + factor.im * sum.re,
        );
        if n == 1 {
            harmonic = Complex::new(
                harmonic.re + self.fundamental.response.re,
                harmonic.im + self.fundamental.response.im,
            );
        }
        harmonic
    }
}

/// Returns the instant of the half period from 0 to π that corresponds to the phase τ. The second result is true if τ
/// is between π and 2π, apart from whole turns. In this half period the motion has the opposite sign.
fn instant<S: Float>(tau: S) -> (Instant<S>, bool) {
    let half_turns = tau * S::inverse_pi();
    let whole = half_turns.floor();
    let odd = (whole * S::constant(0.5)).floor() * S::constant(2.0) != whole;
    (Instant::new(half_turns - whole), odd)
}

impl<S: Float> Chain<S> {
    /// Returns the term of one mode in the modal sum for the contact's relative motion.
    pub fn contact_wave<D: Decay<S>>(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Wave<S, D> {
        let decay = D::of(mode);
        if !mode.in_contact {
            return Wave::at_rest(at.x, decay);
        }
        let coefficients =
            self.modal_coefficients(at, mode.contact_squared, contact, friction, inverse_r, 0);
        motion_wave(at.x, decay, coefficients)
    }

    /// Returns the term of one mode in the modal sum for the motion of a mass. `component` is the component of the mass
    /// in the mode shape.
    pub fn mass_wave<D: Decay<S>>(
        &self,
        mode: &Mode<S>,
        component: S,
        at: &ModeAt<S>,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Wave<S, D> {
        let decay = D::of(mode);
        if !mode.in_contact {
            return Wave::at_rest(at.x, decay);
        }
        let residue = component * mode.contact;
        let coefficients =
            self.mass_coefficients(mode, at, residue, contact, friction, inverse_r, 0);
        mass_wave(at.x, decay, coefficients)
    }
}
