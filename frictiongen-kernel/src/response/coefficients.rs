//! Coefficients of the exact continuous motion at one friction ratio (section 4 of `docs/derivation.md`).
//!
//! The response of mode i has a term with V, the response to the load, and a term with friction. Both terms have a pole
//! where the mode resonates, and the poles cancel partly. The formulas therefore use ν = p v/V and κ = (p v U − w u
//! V)/V. They take U and V without mode i wherever the terms of mode i would cancel. Then nothing is left to cancel:
//! x̄_k = Re[Q ρ e^{iτ}] + β Im[κ e^{iτ}] + β Σ φ_k w [ (1 − d) − g d + uR²(sin τ − …) ], with ρ = V_k/V and Q = √(|V|²
//! − β²U²).
//!
//! Close to a damped resonance g d and Qρ are large and nearly proportional to cos τ. The code therefore moves −g cos τ
//! into the fundamental component, and keeps g (cos τ − d), which is small.

use crate::contact::dominant::{DominantParts, DominantSums, Partner};
use crate::contact::quadrature::{InPhase, Quadratures};
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::mass_controlled::is_mass_controlled;
use crate::number::complex::{self, Complex};
use crate::number::phase::wrapped;
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// Amplitude and phase of the contact's relative motion at one friction ratio, with intermediate results.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S> {
    /// Friction ratio β = F/P.
    pub beta: S,
    /// In-phase term Q = √(|V|² − (βU)²) of the contact's relative motion. V is the response of the contact to the
    /// load, and βU its velocity term from friction. Q is multiplied by r² and by the scale E of [`ContactAt`].
    pub root: S,
    /// Amplitude Z of the contact's relative motion, in units of P/k₁ (for base motion Y).
    pub amplitude: S,
    /// Lag φ of the contact's relative motion behind the excitation, rad, in (−π, π].
    pub phase: S,
    /// Factor 1/(r²E) that turns sums over the modes into displacements. E is the scale of [`ContactAt`].
    pub unscale: S,
}

/// Fundamental component of a motion, which has the frequency of the excitation: its coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Fundamental<S> {
    /// Coefficient of cos τ in the displacement.
    pub cosine: S,
    /// Coefficient of sin τ in the displacement.
    pub sine: S,
    /// Complex response V_k of the mass to the load, without friction.
    pub response: Complex<S>,
}

impl<S: Scalar> Fundamental<S> {
    /// Returns zero coefficients, for a mass that does not move.
    #[inline]
    #[must_use]
    pub fn at_rest() -> Self {
        let zero = S::constant(0.0);
        Self {
            cosine: zero,
            sine: zero,
            response: complex::real(zero),
        }
    }
}

/// Coefficients of one mode's functions of τ in a motion. The functions are d and q̃, the free vibration of the mode
/// after a unit displacement and after a unit velocity.
#[derive(Clone, Copy, Debug)]
pub struct ModalCoefficients<S> {
    /// Coefficient of (1 − d)/x², the mode's response from rest to a constant force. Here x = 1/R is the natural
    /// frequency of the mode divided by the frequency of the excitation.
    pub rise: S,
    /// Coefficient of cos τ − d, by which the mode's static displacement lags behind the excitation. The cos τ that
    /// this term adds is subtracted from the fundamental component. The coefficient is 0 without damping.
    pub fall: S,
    /// Coefficient of sin τ − R q̃, by which the mode lags behind the excitation. R is the frequency of the excitation
    /// divided by the natural frequency of the mode.
    pub forced: S,
    /// φ_k(φᵀw)/r², the residue of the mode in the response of mass k to a force in the contact. Only the harmonics
    /// need it.
    pub residue: S,
}

/// Factor 2^24, which turns the smallest positive `f32` into a number with a finite reciprocal.
const INTO_RANGE: f64 = (1_u32 << 24) as f64;

/// Gives names to the real and the imaginary part of a complex value. Emitted code binds each part to a variable of
/// that name.
#[inline(always)]
fn named<S: Scalar>(
    value: Complex<S>,
    names: [&'static str; 2],
    mode: Option<usize>,
) -> Complex<S> {
    let [re, im] = names;
    Complex::new(value.re.named(re, mode), value.im.named(im, mode))
}

impl<S: Scalar> Chain<S> {
    /// Returns the amplitude Z and the phase φ of the contact's relative motion at β (2.21, 5.35, 5.38, 7.20, 7.21).
    #[inline]
    pub fn friction(&self, contact: &ContactAt<S>, inverse_r: S, beta: S) -> Friction<S> {
        let modulus_v = complex::modulus(contact.v, self.damped).named("modulus_v", None);
        let velocity_part = (beta * contact.u).named("friction_quadrature", None);
        // The formula takes the root of a product. Close to a limit, a difference of squares would lose its digits.
        let zero = S::constant(0.0);
        let less = (modulus_v - velocity_part).max(zero);
        let more = (modulus_v + velocity_part).max(zero);
        let root = if self.damped || self.on_moving_base.is_some() {
            // On a moving base both factors grow as r⁴, and with damping V may almost vanish. The product would then
            // overflow or underflow, so each factor gets its own root.
            less.sqrt() * more.sqrt()
        } else {
            (less * more).sqrt()
        };
        let root = root.named("in_phase", None);
        let unscale = (inverse_r * inverse_r / contact.scale).named("unscale", None);
        let amplitude = if self.damped {
            root - beta * contact.g
        } else {
            root
        };
        let direction = if self.damped {
            contact.v.im.atan2(contact.v.re)
        } else {
            S::select(contact.v.re.lt(zero), S::pi(), zero)
        };
        let lag = (-velocity_part).atan2(root) - direction;
        Friction {
            beta,
            root,
            amplitude: (amplitude * unscale).named("amplitude", None),
            phase: wrapped(lag.named("lag", None)),
            unscale,
        }
    }

    /// Returns the fundamental component of the contact's own motion. At τ = 0 the contact is at its maximum, so only
    /// the cosine with the contact's amplitude remains.
    #[inline]
    pub fn contact_fundamental(
        &self,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
    ) -> Fundamental<S> {
        Fundamental {
            cosine: friction.amplitude,
            sine: S::constant(0.0),
            response: complex::scale(contact.v, friction.unscale),
        }
    }

    /// Returns the coefficients of one mode in a motion. `residue` is φ_k(φᵀw) for mass k, or (φᵀw)² for the contact.
    #[inline]
    pub fn modal_coefficients(
        &self,
        at: &ModeAt<S>,
        residue: S,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
        index: usize,
    ) -> ModalCoefficients<S> {
        let weight = (friction.beta * friction.unscale).named("friction_weight", None);
        let force = (weight * residue).named("friction_force", Some(index));
        let fall = if self.damped {
            (force * (at.g / (at.x * at.x))).named("fall", Some(index))
        } else {
            S::constant(0.0)
        };
        ModalCoefficients {
            rise: (force * contact.scale).named("rise", Some(index)),
            fall,
            forced: (force * at.u).named("forced", Some(index)),
            residue: residue * inverse_r * inverse_r,
        }
    }

    /// Returns the coefficients of one mode in the motion of a mass, for
    /// [`mass_wave`](crate::response::motion::mass_wave). If the mode is mass-controlled (resonance far below the
    /// excitation), its response is kept as one function, so that no cancelling terms are added (see
    /// `modal_sum::mass_controlled`).
    #[inline]
    #[allow(clippy::too_many_arguments, reason = "a mode, and all it rests on")]
    pub fn mass_coefficients(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        residue: S,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
        index: usize,
    ) -> ModalCoefficients<S> {
        let at = self.without_parts(mode, at, index);
        self.modal_coefficients(&at, residue, contact, friction, inverse_r, index)
    }

    /// Returns the functions u and g of a mode, with both set to 0 for a mass-controlled mode (resonance far below the
    /// excitation). Such a mode has its whole response in one function, so u and g must not add to the response again.
    fn without_parts(&self, mode: &Mode<S>, at: &ModeAt<S>, index: usize) -> ModeAt<S> {
        let (slow, zero) = (
            is_mass_controlled(mode.kind, mode.zeta, at.x),
            S::constant(0.0),
        );
        let g = if self.damped {
            S::select(slow, zero, at.g).named("offset", Some(index))
        } else {
            at.g
        };
        ModeAt {
            u: S::select(slow, zero, at.u).named("u_in_sum", Some(index)),
            g,
            ..*at
        }
    }

    /// Returns the fundamental component of the motion of mass k. `shape` has the component of mass k in each mode
    /// shape.
    pub fn fundamental(
        &self,
        shape: &[S],
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Fundamental<S> {
        self.fundamental_loaded(shape, (modes, InPhase), at, contact, friction, inverse_r)
    }

    /// Returns the fundamental component as [`fundamental`](Self::fundamental) does, with loads in quadrature.
    pub fn fundamental_loaded(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Fundamental<S> {
        let known = modes.iter().zip(at.iter().copied());
        let loaded = (known.clone(), quadratures);
        let sums = self.dominant_sums(loaded, Partner::U, contact, inverse_r);
        let known = shape.iter().zip(known).enumerate();
        let parts = known.map(|(index, (component, (mode, at)))| (index, *component, mode, at));
        self.fundamental_of((parts, quadratures), &sums, contact, friction)
    }

    /// Returns the fundamental component of a mass's motion, summed over the given modes. Each entry of `parts` is the
    /// index of a mode, the component of the mass in the mode shape, the constants of the mode, and its functions at r.
    pub(crate) fn fundamental_of<'a>(
        &self,
        (parts, quadratures): (
            impl Iterator<Item = (usize, S, &'a Mode<S>, ModeAt<S>)>,
            impl Quadratures<S>,
        ),
        sums: &DominantSums<S>,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
    ) -> Fundamental<S>
    where
        S: 'a,
    {
        let (mut driven, mut rubbed) = (DominantParts::zero(), DominantParts::zero());
        let mut damped_back = S::constant(0.0);
        for (index, component, mode, at) in parts {
            let free = mode.driven(&at, component, quadratures.of(index));
            let free = named(free, ["driven_re", "driven_im"], Some(index));
            driven = driven.with(self, sums, index, free);
            let residue = component * mode.contact;
            let at = self.without_parts(mode, &at, index);
            let back = (-(residue * at.u)).named("rubbed_back", Some(index));
            rubbed = rubbed.with(self, sums, index, complex::real(back));
            if self.damped {
                let offset = (at.g / (at.x * at.x)).named("fall_per_force", Some(index));
                damped_back = damped_back - residue * offset;
            }
        }
        let ratio = self.plus(driven.own, driven.others);
        // On a moving base V grows as r², and products with V could overflow or underflow.
        let on_base = self.on_moving_base.is_some();
        let one = S::constant(1.0);
        let (lower, raise_back) = if on_base {
            (S::constant(1.0 / INTO_RANGE), S::constant(INTO_RANGE))
        } else {
            (one, one)
        };
        // The code multiplies sums instead of ratios. A mass far from the contact moves by V_k U − U_k V, and the
        // factors common to both terms must stay exactly equal.
        let part = |driven, u: S, rubbed: Complex<S>, v| {
            let (u, rubbed) = ((u * lower).named("u_in_range", None), rubbed.re * lower);
            self.plus(complex::scale(driven, u), complex::scale(v, rubbed))
        };
        let mismatch = self.plus(
            part(driven.own, sums.own.u, rubbed.own, sums.own.v),
            part(driven.others, sums.others.u, rubbed.others, sums.others.v),
        );
        let ratio = named(ratio, ["response_re", "response_im"], None);
        let mismatch = named(mismatch, ["mismatch_re", "mismatch_im"], None);
        // On a moving base V does not vanish, and β may be as large as the number format allows.
        let vanishes = self.damped && !on_base;
        let raise = if vanishes {
            S::constant(INTO_RANGE)
        } else {
            one
        };
        let v = complex::scale(contact.v, raise);
        let v = named(v, ["v_in_range_re", "v_in_range_im"], None);
        let inverse_v = complex::reciprocal(v, self.damped);
        let response = complex::scale(ratio, friction.unscale);
        let ratio = complex::mul(ratio, inverse_v, self.damped);
        let mismatch = complex::mul(mismatch, inverse_v, self.damped);
        let Friction {
            beta,
            root,
            unscale,
            ..
        } = *friction;
        let root = (root * lower * raise).named("root_in_range", None);
        let raised = (unscale * raise_back).named("unscale_in_range", None);
        if self.damped {
            let weight = (beta * unscale).named("friction_weight", None);
            let beta = (beta * raise).named("beta_in_range", None);
            let (_, (near, far)) = complex::inverse(v);
            let turned = |driven: Complex<S>, v: Complex<S>| {
                let v = complex::scale(complex::scale(v, raise), far);
                driven.im * v.re - driven.re * v.im
            };
            let (own, others) = sums.turning(contact);
            let lag = turned(driven.own, own) + turned(driven.others, others);
            let in_phase = (root * near).named("in_phase_over_v", None);
            Fundamental {
                cosine: (root * ratio.re + beta * mismatch.im) * raised + damped_back * weight,
                sine: (beta * mismatch.re - in_phase * lag) * raised,
                response,
            }
        } else {
            Fundamental {
                cosine: root * ratio.re * raised,
                sine: beta * mismatch.re * raised,
                response,
            }
        }
    }

    /// Returns x̄*_k = V_k − H_k V/H, the complex amplitude of mass k while the contact is stuck (P/k₁; for base motion
    /// Y). V/H is the force that keeps the contact stuck, and H_k the response of mass k to a unit force in the
    /// contact.
    pub fn stuck(
        &self,
        shape: &[S],
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> Complex<S> {
        self.stuck_loaded(shape, (modes, InPhase), at, contact, inverse_r)
    }

    /// Returns the complex amplitude as [`stuck`](Self::stuck) does, with loads in quadrature.
    pub fn stuck_loaded(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> Complex<S> {
        let known = modes.iter().zip(at.iter().copied());
        let loaded = (known.clone(), quadratures);
        let sums = self.dominant_sums(loaded, Partner::H, contact, inverse_r);
        let (mut driven, mut rubbed) = (DominantParts::zero(), DominantParts::zero());
        for (index, (component, (mode, at))) in shape.iter().zip(known).enumerate() {
            let free = mode.driven(&at, *component, quadratures.of(index));
            let free = named(free, ["driven_re", "driven_im"], Some(index));
            driven = driven.with(self, &sums, index, free);
            let back = complex::scale(at.response, -(*component * mode.contact));
            let back = named(back, ["held_back_re", "held_back_im"], Some(index));
            rubbed = rubbed.with(self, &sums, index, back);
        }
        let part = |driven, h, rubbed, v| {
            let mul = |a, b| complex::mul(a, b, self.damped);
            self.plus(mul(driven, h), mul(rubbed, v))
        };
        let sum = self.plus(
            part(driven.own, sums.own.h, rubbed.own, sums.own.v),
            part(driven.others, sums.others.h, rubbed.others, sums.others.v),
        );
        let sum = named(sum, ["numerator_re", "numerator_im"], None);
        let inverse_h = complex::reciprocal(contact.h, self.damped);
        let unscale = (inverse_r * inverse_r / contact.scale).named("unscale", None);
        complex::scale(complex::mul(sum, inverse_h, self.damped), unscale)
    }
}
