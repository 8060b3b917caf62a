//! Contact force in the stuck state, at a frequency at which masses beyond the contact act as an absorber.
//!
//! Some masses may be connected to the load through the contact alone. At the frequency at which these masses resonate
//! while the contact is stuck, V and H vanish together. V is the response of the contact to the load, and H is its
//! receptance (response to a contact force). The amplitude V/H of the contact force would then be a quotient of
//! rounding errors. This module therefore writes V and H as series in the distance from this frequency, and cancels
//! their common factor.
//!
//! V and H vanish at s = s₀, where s = r². Let d = s − s₀ be the distance from this zero. Then V = v₁d − v₂d² + v₃d³ −
//! …, where v_n = Σ α/(λ − s)^{n+1}. The sum is over the modes. α = (φᵀw)(φᵀp) is the residue of a mode and λ its
//! squared frequency ratio. H has a series of the same form.

use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// Number of rounding errors by which V may differ from its series at an absorber frequency. V is the response of the
/// contact to the load, as a sum over the modes. One rounding error is the rounding unit times the sum of the moduli
/// of the terms of V and of its series.
const ROUNDINGS: f64 = 64.0;

/// Returns the largest relative distance from an absorber frequency at which the series is more accurate than the
/// quotient V/H. At an absorber frequency, V (response to the load) and H (receptance) are both zero.
///
/// The code uses three terms of the series. The relative error of the series is therefore about the third power of the
/// distance. The relative error of the quotient is about one rounding unit divided by the distance.
fn near<S: Float>() -> S {
    S::constant(S::EPSILON).sqrt().sqrt()
}

impl<S: Float> Chain<S> {
    /// Returns true if the chain is undamped and the receptance H of the contact is nearly zero. An absorber frequency
    /// may then be near, at which H and V (the response to the load) are both zero.
    ///
    /// H is also zero at resonances of the stuck chain where V is not zero. [`absorbed_force`](Self::absorbed_force)
    /// therefore also tests V. `h` is the real part of H, multiplied by r² and by the scale E of [`ContactAt`].
    #[inline]
    pub(crate) fn may_absorb(&self, h: S) -> bool {
        !self.damped && !(h.abs() > near::<S>() * self.inverse_mass)
    }

    /// Returns the amplitude V/H of the contact force in the stuck state of an undamped chain, close to an absorber
    /// frequency. V is the response to the load, and H the receptance. At an absorber frequency V and H are both zero.
    /// Returns `None` at all other frequencies.
    #[must_use]
    pub fn absorbed_force(
        &self,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
    ) -> Option<S> {
        let (zero, near) = (S::constant(0.0), near::<S>());
        let (v, h) = (contact.v.re, contact.h.re);
        if !self.may_absorb(h) {
            return None;
        }
        let (mut v_terms, mut h_terms) = ([zero; 3], [zero; 3]);
        let (mut v_size, mut h_size, mut slope_size) = (zero, zero, zero);
        for (mode, at) in modes.iter().zip(at) {
            let t = at.response.re;
            v_size = v_size + (mode.residue * t).abs();
            h_size = h_size + mode.contact_squared * t.abs();
            slope_size = slope_size + (mode.residue * t * t).abs();
            let mut power = t;
            for (v_term, h_term) in v_terms.iter_mut().zip(&mut h_terms) {
                power = power * t;
                *v_term = *v_term + mode.residue * power;
                *h_term = *h_term + mode.contact_squared * power;
            }
        }
        let ([v1, v2, v3], [h1, h2, h3]) = (v_terms, h_terms);
        if h.abs() > near * h_size || v.abs() > near * slope_size {
            return None;
        }
        // Three fixed-point iterations with the series of the receptance H give d, the distance of r² from the zero of
        // H.
        let mut d = h / h1;
        for _ in 0..3 {
            d = (h + h2 * d * d - h3 * d * d * d) / h1;
        }
        // At an absorber frequency, the response V to the load must vanish at the same distance d as the receptance H,
        // except for rounding.
        let rest = v - d * (v1 - v2 * d + v3 * d * d);
        let noise = S::constant(ROUNDINGS * S::EPSILON) * (v_size + d.abs() * slope_size);
        let truncated = d * d * d * d * slope_size;
        if rest.abs() > noise + truncated {
            return None;
        }
        Some((v1 - v2 * d + v3 * d * d) / (h1 - h2 * d + h3 * d * d))
    }

    /// Returns the displacement amplitude of a mass in the stuck state, under a contact force of amplitude `force`.
    /// [`absorbed_force`](Self::absorbed_force) computes `force`. Close to an absorber frequency the receptance H is
    /// nearly zero. The formula therefore does not divide by H.
    #[must_use]
    pub fn stuck_under(
        &self,
        force: S,
        shape: &[S],
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> S {
        let mut sum = S::constant(0.0);
        for ((component, mode), at) in shape.iter().zip(modes).zip(at) {
            sum = sum + *component * at.response.re * (mode.load - mode.contact * force);
        }
        sum * inverse_r * inverse_r / contact.scale
    }
}
