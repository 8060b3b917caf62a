//! Modal sums of the contact at one frequency, multiplied by a scale factor. The factor keeps the sums finite at a
//! resonance.

use crate::contact::quadrature::{InPhase, Quadrature, Quadratures};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::{Mode, ModeResponse};

/// Constants of a chain with its contact that do not belong to a single mode.
#[derive(Clone, Copy, Debug)]
pub struct Chain<S> {
    /// True if any mode of the chain is damped.
    pub damped: bool,
    /// Static relative displacement wᵀK̄⁻¹p − 1 of the contact, if the contact slides on a moving base. `None` for
    /// every other contact.
    pub on_moving_base: Option<S>,
    /// Inverse effective mass of the contact, m* = wᵀΓ⁻¹w.
    pub inverse_mass: S,
    /// Ratio μ of the static to the kinetic friction force.
    pub stiction: S,
}

/// Response and damping functions of one mode at one frequency, multiplied by the scale E of [`ContactAt`].
#[derive(Clone, Copy, Debug)]
pub struct ModeAt<S> {
    /// Natural frequency of the mode divided by the excitation frequency, x = √λ/r. The thesis uses R = 1/x.
    pub x: S,
    /// Response of the mode to a harmonic force, multiplied by the factor E (`ContactAt::scale`) of the chain. The
    /// value is E/(x² − 1 + 2iζx) = E·v/x², with v = x²/(x² − 1 + 2iζx).
    pub response: Complex<S>,
    /// Damping function u (7.11) of the mode: the slope at the reversal of the mode's response to a square wave of
    /// friction. The stored u is multiplied by the factor E (`ContactAt::scale`) of the chain and divided by x².
    pub u: S,
    /// Damping function g (7.12) of the mode: the value at the reversal of the mode's response to a square wave of
    /// friction. The stored g is multiplied by the factor E (`ContactAt::scale`) of the chain.
    pub g: S,
}

impl<S: Scalar> ModeAt<S> {
    /// Creates response and damping functions that are all 0, as the initial content of an array.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            x: zero,
            response: complex::real(zero),
            u: zero,
            g: zero,
        }
    }
}

/// Modal sums of the contact at one frequency. Each sum is the thesis's sum of the same name, multiplied by r² and by
/// the scale E. The factor r² keeps the sum finite for r → ∞, and the scale E keeps it finite at a resonance.
#[derive(Clone, Copy, Debug)]
pub struct ContactAt<S> {
    /// Scale E: the smallest |x² − 1 + 2iζx| of the modes that the contact drives, with |Re| + |Im| as the modulus.
    pub scale: S,
    /// Response V of the relative displacement to the excitation, without friction. V is multiplied by r² and by the
    /// scale E.
    pub v: Complex<S>,
    /// Damping function U of the contact, multiplied by r² and by the scale E. Under a square wave of friction of unit
    /// amplitude, the contact has a response z̄. At the reversal, the slope dz̄/dτ of this response is U.
    pub u: S,
    /// Damping function G of the contact, multiplied by r² and by the scale E. Under a square wave of friction of unit
    /// amplitude, the contact has a response z̄. At the reversal, the value of this response is G.
    pub g: S,
    /// H_c, the contribution of damping to the acceleration of the contact at a reversal. H_c is multiplied by r² and
    /// by the scale E.
    pub reversal: S,
    /// Receptance H of the contact, multiplied by r² and by the scale E. H is the response of the relative displacement
    /// to a harmonic contact force.
    pub h: Complex<S>,
}

impl<S: Scalar> ContactAt<S> {
    /// Returns the term that the compliance of an elastic contact adds to the receptance H. The term is multiplied by
    /// r² and by the scale E.
    #[inline]
    pub(crate) fn compliance(&self, compliance: S, inverse_r: S) -> S {
        compliance * self.scale / (inverse_r * inverse_r)
    }

    /// Creates modal sums of the contact that are all 0. `scale` is the factor E, by which the code multiplies all
    /// sums so that they stay finite at a resonance.
    #[must_use]
    pub fn zero(scale: S) -> Self {
        let zero = S::constant(0.0);
        Self {
            scale,
            v: complex::real(zero),
            u: zero,
            g: zero,
            reversal: zero,
            h: complex::real(zero),
        }
    }
}

impl<S: Scalar> Chain<S> {
    /// Returns the scale E of the modal sums: the smallest |x² − 1| + 2ζx of the modes that the contact drives. If the
    /// contact drives no mode, E is 1.
    pub fn scale<'a>(sizes: impl Iterator<Item = (&'a Mode<S>, S)>) -> S
    where
        S: 'a,
    {
        // A mode that the contact does not drive contributes to no sum of the contact.
        let driven = sizes.filter(|(mode, _)| mode.in_contact);
        let scale = driven.map(|(_, size)| size).reduce(Scalar::min);
        scale.unwrap_or(S::constant(1.0))
    }

    /// Returns the scale E of the modal sums at 1/r: the smallest |x² − 1| + 2ζx of the modes that the contact drives.
    pub(crate) fn scale_at(modes: &[Mode<S>], inverse_r: S) -> S {
        Self::scale(modes.iter().map(|mode| (mode, mode.size(inverse_r))))
    }

    /// Multiplies the response and damping functions of a mode by the scale E of the chain. The caller has computed E
    /// in a first pass over the modes. E is the smallest |x² − 1| + 2ζx among the modes that the contact drives.
    #[inline]
    pub fn at_scale(&self, mode: &ModeResponse<S>, scale: S) -> ModeAt<S> {
        self.scaled(mode, scale, false, 0)
    }

    /// Multiplies the response and damping functions of a mode by the scale E of the chain. Among the modes that the
    /// contact drives, E is the smallest |x² − 1| + 2ζx. The caller has computed E in a first pass over the modes. If
    /// `single` is true, the chain has only this mode. The code then takes E/(|x² − 1| + 2ζx) as exactly 1.
    #[inline]
    pub fn scaled(
        &self,
        mode: &ModeResponse<S>,
        scale: S,
        single: bool,
        index: usize,
    ) -> ModeAt<S> {
        let at = Some(index);
        let one = S::constant(1.0);
        let ModeResponse {
            x,
            denominator,
            size,
            u,
            g,
            reversal: _,
        } = *mode;
        if !self.damped {
            if single {
                return ModeAt {
                    x,
                    response: complex::real(one.copysign(denominator.re)),
                    u,
                    g,
                };
            }
            let response = (scale / denominator.re).named("response", "E/(x² − 1)", at);
            let scale_over_size = response.abs();
            return ModeAt {
                x,
                response: complex::real(response),
                u: (u * scale_over_size).named("u_scaled", "uR²·E", at),
                g,
            };
        }
        let inverse = (one / size).named("inverse_size", "1/size", at);
        let unit = Complex::new(
            (denominator.re * inverse).named("unit_re", "(x² − 1)/size", at),
            (denominator.im * inverse).named("unit_im", "2ζx/size", at),
        );
        let reciprocal = complex::reciprocal_of_unit(unit, at);
        if single {
            let response = Complex::new(
                reciprocal
                    .re
                    .named("response_re", "Re of E/(x² − 1 + 2iζx)", at),
                reciprocal
                    .im
                    .named("response_im", "Im of E/(x² − 1 + 2iζx)", at),
            );
            return ModeAt { x, response, u, g };
        }
        let scale_over_size = (scale * inverse).named("scale_over_size", "E/size", at);
        ModeAt {
            x,
            response: Complex::new(
                (reciprocal.re * scale_over_size).named(
                    "response_re",
                    "Re of E/(x² − 1 + 2iζx)",
                    at,
                ),
                (reciprocal.im * scale_over_size).named(
                    "response_im",
                    "Im of E/(x² − 1 + 2iζx)",
                    at,
                ),
            ),
            u: (u * scale_over_size).named("u_scaled", "uR²·E", at),
            g: (g * scale_over_size).named("g_scaled", "g·E", at),
        }
    }

    /// Computes the modal sums V, H, U, G and H_c of the contact from the functions of the modes (section 3 of
    /// `docs/derivation.md`). The function passes the response and the damping functions of each mode to `keep`, one
    /// mode after the other.
    #[inline]
    pub fn contact_of(
        &self,
        modes: &[Mode<S>],
        responses: impl Iterator<Item = ModeResponse<S>>,
        scale: S,
        inverse_r: S,
        with_g: bool,
        keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        self.contact_loaded((modes, InPhase), responses, scale, inverse_r, with_g, keep)
    }

    /// Computes the modal sums V, H, U, G and H_c of the contact for modes with loads in quadrature (90° out of phase).
    /// Without loads in quadrature, [`contact_of`](Self::contact_of) returns the same sums.
    #[inline]
    pub fn contact_loaded(
        &self,
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        responses: impl Iterator<Item = ModeResponse<S>>,
        scale: S,
        inverse_r: S,
        with_g: bool,
        mut keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        let single = modes.len() == 1;
        let mut sum = ContactAt::zero(scale);
        for (index, (mode, response)) in modes.iter().zip(responses).enumerate() {
            let at = self.scaled(&response, scale, single, index);
            let load = quadratures.of(index);
            let term = self.term(sum.scale, (mode, load), &response, &at, single, with_g);
            sum = self.with_term(&sum, &term, with_g);
            keep(at);
        }
        self.completed(&sum, inverse_r)
    }

    /// Returns the terms of the first mode in the modal sums V, H, U and H_c of the contact. If `with_g` is true, the
    /// result also contains the term in G. Call this function only for a scene with several modes.
    #[inline(always)]
    pub fn begun_by(
        &self,
        scale: S,
        mode: &Mode<S>,
        response: &ModeResponse<S>,
        at: &ModeAt<S>,
        with_g: bool,
    ) -> ContactAt<S> {
        self.term(scale, (mode, None), response, at, false, with_g)
    }

    /// Adds the terms of one mode to the modal sums V, H, U and H_c of the contact, and to G if `with_g` is true.
    #[inline(always)]
    pub fn joined_by(
        &self,
        sum: &ContactAt<S>,
        mode: &Mode<S>,
        response: &ModeResponse<S>,
        at: &ModeAt<S>,
        single: bool,
        with_g: bool,
    ) -> ContactAt<S> {
        let term = self.term(sum.scale, (mode, None), response, at, single, with_g);
        self.with_term(sum, &term, with_g)
    }

    /// Returns the terms of one mode in the modal sums V, H, U, G and H_c of the contact, multiplied by the factor E
    /// (`ContactAt::scale`).
    #[inline(always)]
    pub fn term(
        &self,
        scale: S,
        (mode, quadrature): (&Mode<S>, Option<Quadrature<S>>),
        response: &ModeResponse<S>,
        at: &ModeAt<S>,
        single: bool,
        with_g: bool,
    ) -> ContactAt<S> {
        let mut term = ContactAt::zero(scale);
        term.v = self.load_term(mode, at, quadrature);
        term.h = complex::scale(at.response, mode.contact_squared);
        term.u = mode.contact_squared * at.u;
        if self.damped {
            let scale_over_size = if single {
                S::constant(1.0)
            } else {
                scale / response.size
            };
            if with_g {
                term.g = mode.contact_squared * (at.g / (at.x * at.x));
            }
            term.reversal = mode.contact_squared * (response.reversal * scale_over_size);
        }
        term
    }

    /// Returns the modal sums of the contact, `sum`, with the terms of one more mode added.
    #[inline(always)]
    pub fn with_term(&self, sum: &ContactAt<S>, term: &ContactAt<S>, with_g: bool) -> ContactAt<S> {
        let mut sum = *sum;
        sum.v = self.plus(sum.v, term.v);
        sum.h = self.plus(sum.h, term.h);
        sum.u = sum.u + term.u;
        if self.damped {
            if with_g {
                sum.g = sum.g + term.g;
            }
            sum.reversal = sum.reversal + term.reversal;
        }
        sum
    }

    /// Completes the modal sums of the contact after the last mode. On a moving base, the function adds the static term
    /// to the response V, and multiplies V by r².
    #[inline]
    pub fn completed(&self, sum: &ContactAt<S>, inverse_r: S) -> ContactAt<S> {
        let mut sum = *sum;
        if let Some(at_rest) = self.on_moving_base {
            let r2 = (S::constant(1.0) / (inverse_r * inverse_r)).named("r_squared", "r²", None);
            sum.v = complex::scale(self.plus(sum.v, complex::real(at_rest * sum.scale)), r2);
        }
        sum.v = Complex::new(
            sum.v.re.named("v_re", "Re V·r²E", None),
            sum.v.im.named("v_im", "Im V·r²E", None),
        );
        sum.h = Complex::new(
            sum.h.re.named("h_re", "Re H·r²E", None),
            sum.h.im.named("h_im", "Im H·r²E", None),
        );
        sum.u = sum.u.named("u", "U·r²E", None);
        sum.g = sum.g.named("g_sum", "G·r²E", None);
        sum.reversal = sum.reversal.named("reversal", "H_c·r²E", None);
        sum
    }

    #[inline(always)]
    pub(crate) fn plus(&self, a: Complex<S>, b: Complex<S>) -> Complex<S> {
        if self.damped {
            complex::add(a, b)
        } else {
            complex::real(a.re + b.re)
        }
    }
}
