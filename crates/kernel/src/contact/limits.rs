//! Formulas of the limits β_lim and β*_lim from the modal sums of the contact (section 4 of `docs/derivation.md`).

use crate::contact::sums::{Chain, ContactAt};
use crate::number::complex;
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

impl<S: Scalar + PartialEq> Chain<S> {
    /// Returns true if the load acts on the mass that slides on the support. V, the response of the contact to the
    /// load, then equals H, its receptance.
    #[must_use]
    pub fn loads_contact(&self, modes: &[Mode<S>]) -> bool {
        let mut modes = modes.iter();
        self.on_moving_base.is_none() && modes.all(|mode| mode.residue == mode.contact_squared)
    }

    /// Returns true if β*_lim = |V|/(μ|H|) is exactly 1. β*_lim is exactly 1 if μ = 1 and the response V of the contact
    /// to the load equals its receptance H. For μ ≠ 1 the quotient has a rounding error.
    #[must_use]
    pub fn sliding_limit_is_one(&self, modes: &[Mode<S>]) -> bool {
        self.stiction == S::constant(1.0) && self.loads_contact(modes)
    }
}

impl<S: Scalar> Chain<S> {
    /// Returns the limit of the velocity constraint for τ → 0, multiplied by r² and by the scale E. The result is (m* +
    /// H_c r²)·E, with the inverse effective mass m* and the damping term H_c (5.58, 7.52).
    #[inline]
    pub fn start_constraint(&self, contact: &ContactAt<S>) -> S {
        if self.damped {
            contact.reversal + self.inverse_mass * contact.scale
        } else {
            self.inverse_mass * contact.scale
        }
    }

    /// Returns the break-away term H_c + μm*/r², multiplied by r² and by the scale E (5.63, 7.47). The contact breaks
    /// away at a reversal if Z + βG exceeds β times this term. Z is the amplitude of the contact's motion and G its
    /// damping function. Because μ ≥ 1, the result is never less than [`start_constraint`](Self::start_constraint).
    #[inline]
    pub fn break_away(&self, contact: &ContactAt<S>) -> S {
        let inverse_mass = self.stiction * self.inverse_mass * contact.scale;
        if self.damped {
            contact.reversal + inverse_mass
        } else {
            inverse_mass
        }
    }

    /// Returns the limit of continuous motion, β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²). `constraint` is the maximum
    /// in this formula, multiplied by r² and by the scale E (5.65, 5.80, 5.96, 7.49).
    #[inline]
    pub fn continuous_limit(&self, contact: &ContactAt<S>, constraint: S) -> S {
        let modulus_v =
            complex::modulus(contact.v, self.damped).named("modulus_v", "|V|·r²E", None);
        modulus_v / (contact.u * contact.u + constraint * constraint).sqrt()
    }

    /// Returns the limit of sliding β*_lim = |V|/(μ|H|), with the response V to the load and the receptance H. For β ≥
    /// β*_lim a stuck state exists (6.11, 6.27, 6.33). For damped chains, section 7.4.3 of the thesis has another
    /// formula, which neglects that damping couples the masses on both sides of a stuck mass.
    #[inline]
    pub fn sliding_limit(&self, contact: &ContactAt<S>) -> S {
        let modulus_v =
            complex::modulus(contact.v, self.damped).named("modulus_v", "|V|·r²E", None);
        let modulus_h =
            complex::modulus(contact.h, self.damped).named("modulus_h", "|H|·r²E", None);
        modulus_v / (self.stiction * modulus_h)
    }
}
