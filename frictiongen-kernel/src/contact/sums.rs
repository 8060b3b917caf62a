//! The chain at one frequency, with sums over modes, multiplied by a scale that keeps them finite.

use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::{Mode, ModeResponse};

/// Constants of a scene that do not belong to one mode.
#[derive(Clone, Copy, Debug)]
pub struct Chain<S> {
    /// True if any mode is damped.
    pub damped: bool,
    /// wᵀK̄⁻¹p − 1, the static relative motion, if the contact slides on the moving base; `None` otherwise.
    pub on_moving_base: Option<S>,
    /// m* = wᵀΓ⁻¹w, the inverse effective mass of the contact.
    pub inverse_mass: S,
    /// μ, the ratio of static to kinetic friction force.
    pub stiction: S,
}

/// Functions of one mode at one frequency, as the sums use them.
#[derive(Clone, Copy, Debug)]
pub struct ModeAt<S> {
    /// Resonance of the mode over the excitation, x = √λ/r = 1/R.
    pub x: S,
    /// Scaled response E/(x² − 1 + 2iζx) = E·v/x².
    pub response: Complex<S>,
    /// Scaled half-period function of the velocity, E·u/x².
    pub u: S,
    /// Scaled half-period function of the displacement, E·g.
    pub g: S,
}

impl<S: Scalar> ModeAt<S> {
    /// Creates functions of zeros, as the initial value of an array of modes.
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

/// Sums of the contact at one frequency. Every sum is r² times the one of its name in the thesis, so that it stays
/// finite as r → ∞. It is also multiplied by the scale E, so that it stays finite on a resonance.
#[derive(Clone, Copy, Debug)]
pub struct ContactAt<S> {
    /// E, the smallest |x² − 1 + 2iζx| of the chain, with |Re| + |Im| as the modulus.
    pub scale: S,
    /// V, the response of the relative motion to the excitation, without friction.
    pub v: Complex<S>,
    /// U, the half-period damping function of the contact for the velocity.
    pub u: S,
    /// G, the half-period damping function of the contact for the displacement.
    pub g: S,
    /// H_c r², the contribution of damping to the acceleration at a reversal.
    pub reversal: S,
    /// H, the response of the relative motion to a harmonic force in the contact.
    pub h: Complex<S>,
}

impl<S: Scalar> ContactAt<S> {
    /// Creates sums that are zero.
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
    /// Returns the scale E, the smallest size among the modes that the contact drives.
    pub fn scale<'a>(sizes: impl Iterator<Item = (&'a Mode<S>, S)>) -> S
    where
        S: 'a,
    {
        // A mode that the contact does not drive contributes to none of its sums.
        let driven = sizes.filter(|(mode, _)| mode.in_contact);
        let scale = driven.map(|(_, size)| size).reduce(Scalar::min);
        scale.unwrap_or(S::constant(1.0))
    }

    /// Returns the scale E at 1/r.
    pub(crate) fn scale_at(modes: &[Mode<S>], inverse_r: S) -> S {
        Self::scale(modes.iter().map(|mode| (mode, mode.size(inverse_r))))
    }

    /// Returns the functions of one of several modes, multiplied by the scale. This is the second pass over the modes.
    #[inline]
    pub fn at_scale(&self, mode: &ModeResponse<S>, scale: S) -> ModeAt<S> {
        self.scaled(mode, scale, false, 0)
    }

    /// Returns a mode's functions, multiplied by the scale. This is the second pass over the modes. A single mode is
    /// the scale itself, and the quotient of both is then a sign.
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
            let response = (scale / denominator.re).named("response", at);
            let scale_over_size = response.abs();
            return ModeAt {
                x,
                response: complex::real(response),
                u: (u * scale_over_size).named("u_scaled", at),
                g,
            };
        }
        let inverse = (one / size).named("inverse_size", at);
        let unit = Complex::new(
            (denominator.re * inverse).named("unit_re", at),
            (denominator.im * inverse).named("unit_im", at),
        );
        let reciprocal = complex::reciprocal_of_unit(unit, at);
        if single {
            let response = Complex::new(
                reciprocal.re.named("response_re", at),
                reciprocal.im.named("response_im", at),
            );
            return ModeAt { x, response, u, g };
        }
        let scale_over_size = (scale * inverse).named("scale_over_size", at);
        ModeAt {
            x,
            response: Complex::new(
                (reciprocal.re * scale_over_size).named("response_re", at),
                (reciprocal.im * scale_over_size).named("response_im", at),
            ),
            u: (u * scale_over_size).named("u_scaled", at),
            g: (g * scale_over_size).named("g_scaled", at),
        }
    }

    /// Returns the contact's sums over all modes from the modes' own functions (section 3 of `docs/derivation.md`: V,
    /// H, U, G, H_c). It passes the functions of one mode after the other to `keep`.
    #[inline]
    pub fn contact_of(
        &self,
        modes: &[Mode<S>],
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
            sum = self.joined_by(&sum, mode, &response, &at, single, with_g);
            keep(at);
        }
        self.completed(&sum, inverse_r)
    }

    /// Adds one mode to the sums, to G only if `with_g`.
    #[inline]
    pub fn joined_by(
        &self,
        sum: &ContactAt<S>,
        mode: &Mode<S>,
        response: &ModeResponse<S>,
        at: &ModeAt<S>,
        single: bool,
        with_g: bool,
    ) -> ContactAt<S> {
        let term = self.term(sum.scale, mode, response, at, single, with_g);
        self.with_term(sum, &term, with_g)
    }

    /// Returns a mode's term of each sum, multiplied by the scale.
    #[inline(always)]
    pub(super) fn term(
        &self,
        scale: S,
        mode: &Mode<S>,
        response: &ModeResponse<S>,
        at: &ModeAt<S>,
        single: bool,
        with_g: bool,
    ) -> ContactAt<S> {
        let mut term = ContactAt::zero(scale);
        term.v = self.load_term(mode, at);
        term.h = complex::scale(at.response, mode.inverse_mass);
        term.u = mode.inverse_mass * at.u;
        if self.damped {
            let scale_over_size = if single {
                S::constant(1.0)
            } else {
                scale / response.size
            };
            if with_g {
                term.g = mode.inverse_mass * (at.g / (at.x * at.x));
            }
            term.reversal = mode.inverse_mass * (response.reversal * scale_over_size);
        }
        term
    }

    /// Returns the sums plus a term of each.
    #[inline(always)]
    pub(super) fn with_term(
        &self,
        sum: &ContactAt<S>,
        term: &ContactAt<S>,
        with_g: bool,
    ) -> ContactAt<S> {
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

    /// Completes the sums. On a moving base it adds the static term of V, and multiplies V by r².
    #[inline]
    pub fn completed(&self, sum: &ContactAt<S>, inverse_r: S) -> ContactAt<S> {
        let mut sum = *sum;
        if let Some(at_rest) = self.on_moving_base {
            let r2 = (S::constant(1.0) / (inverse_r * inverse_r)).named("r_squared", None);
            sum.v = complex::scale(self.plus(sum.v, complex::real(at_rest * sum.scale)), r2);
        }
        sum.v = Complex::new(sum.v.re.named("v_re", None), sum.v.im.named("v_im", None));
        sum.h = Complex::new(sum.h.re.named("h_re", None), sum.h.im.named("h_im", None));
        sum.u = sum.u.named("u", None);
        sum.g = sum.g.named("g_sum", None);
        sum.reversal = sum.reversal.named("reversal", None);
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

    /// Returns a mode's term of V. On a moving base the relative motion counts, and v − 1 = (1 − 2iζx)/(x² − 1 + 2iζx)
    /// replaces v. The base motion is then never subtracted.
    #[inline]
    pub(crate) fn load_term(&self, mode: &Mode<S>, at: &ModeAt<S>) -> Complex<S> {
        if self.on_moving_base.is_none() {
            return complex::scale(at.response, mode.residue);
        }
        let lag = Complex::new(S::constant(1.0), -(S::constant(2.0) * mode.zeta * at.x));
        complex::scale(
            complex::mul(at.response, lag, self.damped),
            mode.static_residue,
        )
    }
}
