//! Modal sums of the contact for a run-time `System`, computed for two neighbouring modes at the same time.
//!
//! A processor computes two numbers with one packed instruction if the compiler finds the same operation on both
//! numbers. In emitted code the compiler often finds two equal operations, but in a loop over modes it does not. The
//! code therefore evaluates the formulas with `Lanes`, arrays of two numbers. Every operation is the same as for one
//! mode alone, and the sums add one mode after the other. The results are therefore equal to those of emitted code, to
//! the last bit.

use crate::contact::quadrature::{InPhase, Quadratures};
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::number::complex::Complex;
use crate::number::lanes::Lanes;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::{Kind, Mode};

/// Kind of damping that all modes have, as a type parameter. A loop over the modes then does not test the kind of each
/// mode.
pub(super) trait Uniform {
    const KIND: Kind;
    const DAMPED: bool;
}

pub(super) struct UndampedPairs;

impl Uniform for UndampedPairs {
    const KIND: Kind = Kind::Undamped;
    const DAMPED: bool = false;
}

pub(super) struct Light;

impl Uniform for Light {
    const KIND: Kind = Kind::Light;
    const DAMPED: bool = true;
}

impl<S: Float> Chain<S> {
    /// Computes the modal sums V, H, U, G and H_c of the contact (section 3 of `docs/derivation.md`). The function
    /// passes the response and the damping functions of each mode to `keep`, one mode after the other.
    #[inline]
    pub fn contact(
        &self,
        modes: &[Mode<S>],
        inverse_r: S,
        keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        self.summed::<true>(modes, inverse_r, keep)
    }

    /// Computes the modal sums V, H, U and H_c of the contact. The limits β_lim and β*_lim do not need the sum G.
    #[inline]
    pub fn contact_without_g(&self, modes: &[Mode<S>], inverse_r: S) -> ContactAt<S> {
        self.summed::<false>(modes, inverse_r, |_| ())
    }

    #[inline(always)]
    fn summed<const WITH_G: bool>(
        &self,
        modes: &[Mode<S>],
        inverse_r: S,
        keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        match self.common_kind(modes) {
            Some(Kind::Undamped) => self.uniform::<UndampedPairs, WITH_G>(modes, inverse_r, keep),
            Some(_) => self.uniform::<Light, WITH_G>(modes, inverse_r, keep),
            None => self.in_turn::<WITH_G>(modes, inverse_r, keep),
        }
    }

    /// Returns the kind of damping of the modes if the code can compute two modes at the same time. All modes must be
    /// undamped, or all must be lightly damped. The processor must compute with two numbers of the scalar type at the
    /// same time.
    #[inline(always)]
    pub(super) fn common_kind(&self, modes: &[Mode<S>]) -> Option<Kind> {
        if !S::PAIRS {
            None
        } else if !self.damped {
            Some(Kind::Undamped)
        } else {
            let light = modes.iter().all(|mode| mode.kind == Kind::Light);
            light.then_some(Kind::Light)
        }
    }

    /// Computes the modal sums of the contact, one mode after the other. Modes with different kinds of damping need
    /// this form. Programs optimised for size and unoptimised programs (such as a macro) also use this form.
    pub fn in_turn<const WITH_G: bool>(
        &self,
        modes: &[Mode<S>],
        inverse_r: S,
        keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        self.loaded_in_turn::<WITH_G>((modes, InPhase), inverse_r, keep)
    }

    /// Computes the modal sums of the contact, one mode after the other, for modes with loads in quadrature (90° out of
    /// phase). Without loads in quadrature, [`in_turn`](Self::in_turn) returns the same sums.
    pub fn loaded_in_turn<const WITH_G: bool>(
        &self,
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        inverse_r: S,
        keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        let scale = Self::scale_at(modes, inverse_r);
        let responses = modes.iter().map(|mode| {
            if WITH_G {
                // A function call instead of inlined code keeps the code small.
                mode.response(inverse_r, 0)
            } else {
                mode.functions(inverse_r, false)
            }
        });
        let modes = (modes, quadratures);
        self.contact_loaded(modes, responses, scale, inverse_r, WITH_G, keep)
    }

    /// Computes the modal sums of the contact for modes with the same kind of damping `U`, two modes at a time.
    #[inline(always)]
    fn uniform<U: Uniform, const WITH_G: bool>(
        &self,
        modes: &[Mode<S>],
        inverse_r: S,
        mut keep: impl FnMut(ModeAt<S>),
    ) -> ContactAt<S> {
        let chain = Self {
            damped: U::DAMPED,
            ..*self
        };
        if let [mode] = modes {
            let response = mode.functions_of(U::KIND, inverse_r, WITH_G, 0);
            // With a single mode, the scale E is |x² − 1| + 2ζx of this mode.
            let one = S::constant(1.0);
            let scale = if mode.in_contact { response.size } else { one };
            let at = chain.scaled(&response, scale, true, 0);
            let sum = ContactAt::zero(scale);
            let sum = chain.joined_by(&sum, mode, &response, &at, true, WITH_G);
            keep(at);
            return chain.completed(&sum, inverse_r);
        }
        let scale = smallest::<S, U>(modes, inverse_r);
        let zero = Lanes::constant(0.0);
        let (mut terms, mut at) = (ContactAt::zero(zero), ModeAt::zero());
        let mut sum = ContactAt::zero(scale);
        let (pairs, rest) = modes.as_chunks::<2>();
        for pair in pairs {
            of_two::<S, U, WITH_G>(&chain, pair, inverse_r, scale, &mut terms, &mut at);
            let ([first, second], [first_at, second_at]) = (terms.split(), at.split());
            sum = chain.with_term(&sum, &first, WITH_G);
            keep(first_at);
            sum = chain.with_term(&sum, &second, WITH_G);
            keep(second_at);
        }
        for mode in rest {
            let response = mode.functions_of(U::KIND, inverse_r, WITH_G, 0);
            let at = chain.scaled(&response, scale, false, 0);
            sum = chain.joined_by(&sum, mode, &response, &at, false, WITH_G);
            keep(at);
        }
        chain.completed(&sum, inverse_r)
    }

    /// Returns the constants of the chain, each repeated in an array of `N` equal numbers.
    #[inline(always)]
    pub(super) fn in_lanes<const N: usize>(&self) -> Chain<Lanes<S, N>> {
        Chain {
            damped: self.damped,
            on_moving_base: self.on_moving_base.map(Lanes::all),
            inverse_mass: Lanes::all(self.inverse_mass),
            stiction: Lanes::all(self.stiction),
        }
    }
}

/// Returns the scale E of the modal sums: the smallest |x² − 1| + 2ζx among the modes that the contact drives. The
/// order of the modes does not matter, because `Float` scalars contain no derivatives.
#[inline(always)]
fn smallest<S: Float, U: Uniform>(modes: &[Mode<S>], inverse_r: S) -> S {
    let infinite = S::constant(f64::INFINITY);
    let mut least = Lanes::all(infinite);
    let (pairs, rest) = modes.as_chunks::<2>();
    for pair in pairs {
        let size = Mode::beside(U::KIND, pair).size_but_zero(U::KIND, Lanes::all(inverse_r));
        let (Lanes([first, second]), [a, b]) = (size, pair);
        if a.in_contact & b.in_contact {
            least = least.min(size);
        } else if a.in_contact {
            least = least.min(Lanes::all(first));
        } else if b.in_contact {
            least = least.min(Lanes::all(second));
        }
    }
    let Lanes([first, second]) = least;
    let mut least = first.min(second);
    for mode in rest {
        if mode.in_contact {
            least = least.min(mode.size_but_zero(U::KIND, inverse_r));
        }
    }
    // If |x² − 1| of a mode is exactly 0, it is the smallest. The code replaces this 0 by a small number after it has
    // found the smallest. A replacement before the comparison would give the same result, because no other |x² − 1| is
    // as small as the replacement.
    let least = if U::DAMPED {
        least
    } else {
        least.detuning_off_pole()
    };
    S::select(least.lt(infinite), least, S::constant(1.0))
}

/// Computes the terms of two modes in the modal sums of the contact. If `WITH_G` is true, also writes the response and
/// damping functions of both modes, multiplied by the scale E.
///
/// The function is not inlined, so that it stores its results in arrays. The compiler then uses packed instructions.
#[inline(never)]
fn of_two<S: Float, U: Uniform, const WITH_G: bool>(
    chain: &Chain<S>,
    modes: &[Mode<S>; 2],
    inverse_r: S,
    scale: S,
    terms: &mut ContactAt<Lanes<S>>,
    kept: &mut ModeAt<Lanes<S>>,
) {
    let chain = Chain {
        damped: U::DAMPED,
        ..chain.in_lanes()
    };
    let (mode, scale) = (Mode::beside(U::KIND, modes), Lanes::all(scale));
    let response = mode.functions_of(U::KIND, Lanes::all(inverse_r), WITH_G, 0);
    let at = chain.scaled(&response, scale, false, 0);
    let found = chain.term(scale, (&mode, None), &response, &at, false, WITH_G);
    // The code does not write the numbers that stay 0 without damping. It also does not write the numbers that no
    // caller uses.
    terms.v.re = found.v.re;
    terms.h.re = found.h.re;
    terms.u = found.u;
    if U::DAMPED {
        terms.v.im = found.v.im;
        terms.h.im = found.h.im;
        terms.reversal = found.reversal;
    }
    if WITH_G {
        kept.x = at.x;
        kept.response.re = at.response.re;
        kept.u = at.u;
        if U::DAMPED {
            terms.g = found.g;
            kept.response.im = at.response.im;
            kept.g = at.g;
        }
    }
}

impl<S: Float, const N: usize> Mode<Lanes<S, N>> {
    /// Joins `N` modes with the same kind of damping into one mode whose constants are arrays of `N` numbers.
    #[inline(always)]
    pub(super) fn beside(kind: Kind, modes: &[Mode<S>; N]) -> Self {
        let of = |constant: fn(&Mode<S>) -> S| Lanes(modes.each_ref().map(constant));
        Self {
            kind,
            in_contact: modes.iter().any(|mode| mode.in_contact),
            resonance: of(|mode| mode.resonance),
            zeta: of(|mode| mode.zeta),
            q: of(|mode| mode.q),
            q_defect: of(|mode| mode.q_defect),
            load: of(|mode| mode.load),
            contact: of(|mode| mode.contact),
            residue: of(|mode| mode.residue),
            contact_squared: of(|mode| mode.contact_squared),
            static_residue: of(|mode| mode.static_residue),
        }
    }
}

/// Separates the complex numbers of two modes, stored as arrays of two numbers, into one complex number for each mode.
#[inline(always)]
fn complex_apart<S: Float>(value: Complex<Lanes<S>>) -> [Complex<S>; 2] {
    let (Lanes([re, other_re]), Lanes([im, other_im])) = (value.re, value.im);
    [Complex::new(re, im), Complex::new(other_re, other_im)]
}

impl<S: Float> ContactAt<Lanes<S>> {
    /// Separates the terms of two modes in the contact's modal sums, stored as arrays of two numbers, into one set of
    /// terms for each mode.
    #[inline(always)]
    fn split(&self) -> [ContactAt<S>; 2] {
        let ([v, other_v], [h, other_h]) = (complex_apart(self.v), complex_apart(self.h));
        let (Lanes([scale, other_scale]), Lanes([u, other_u])) = (self.scale, self.u);
        let (Lanes([g, other_g]), Lanes([reversal, other_reversal])) = (self.g, self.reversal);
        let first = ContactAt {
            scale,
            v,
            u,
            g,
            reversal,
            h,
        };
        let second = ContactAt {
            scale: other_scale,
            v: other_v,
            u: other_u,
            g: other_g,
            reversal: other_reversal,
            h: other_h,
        };
        [first, second]
    }
}

impl<S: Float> ModeAt<Lanes<S>> {
    /// Separates the response and damping functions of two modes, stored as arrays of two numbers, into one set of
    /// functions for each mode.
    #[inline(always)]
    fn split(&self) -> [ModeAt<S>; 2] {
        let [response, other_response] = complex_apart(self.response);
        let (Lanes([x, other_x]), Lanes([u, other_u])) = (self.x, self.u);
        let Lanes([g, other_g]) = self.g;
        let first = ModeAt { x, response, u, g };
        let second = ModeAt {
            x: other_x,
            response: other_response,
            u: other_u,
            g: other_g,
        };
        [first, second]
    }
}

#[cfg(test)]
mod tests;
