//! The force that holds the contact, where masses beyond it absorb: a common zero of V and H.
//!
//! Masses that only the contact joins to the load resonate by themselves while the contact is held.
//! At that frequency V and H vanish together, and V/H, the amplitude of the holding force, is a
//! quotient of what rounding has left.  The zero is divided out here: with s = r² and d = s − s₀
//! from it, V = v₁d − v₂d² + v₃d³ − … where v_n = Σα/(λ − s)^{n+1}, and H likewise.

use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// Roundings of a sum over modes that vanishes, over the sum of its terms' sizes.
const ROUNDINGS: f64 = 64.0;

/// Nearer to a common zero than this, relative to the sums, the series is the more accurate: it leaves out
/// the fourth power of the distance, and the quotient loses a rounding over it.
fn near<S: Float>() -> S {
    S::constant(S::EPSILON).sqrt().sqrt()
}

impl<S: Float> Chain<S> {
    /// Whether H, here its real part times r²E, is so small that V may have its zero in common with it.
    #[inline]
    pub(crate) fn may_absorb(&self, h: S) -> bool {
        !self.damped && !(h.abs() > near::<S>() * self.inverse_mass)
    }

    /// V/H of an undamped chain beside a common zero of both; none elsewhere.
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
            h_size = h_size + mode.inverse_mass * t.abs();
            slope_size = slope_size + (mode.residue * t * t).abs();
            let mut power = t;
            for (v_term, h_term) in v_terms.iter_mut().zip(&mut h_terms) {
                power = power * t;
                *v_term = *v_term + mode.residue * power;
                *h_term = *h_term + mode.inverse_mass * power;
            }
        }
        let ([v1, v2, v3], [h1, h2, h3]) = (v_terms, h_terms);
        if h.abs() > near * h_size || v.abs() > near * slope_size {
            return None;
        }
        // The distance of H's zero, by two steps of its own series.
        let mut d = h / h1;
        for _ in 0..3 {
            d = (h + h2 * d * d - h3 * d * d * d) / h1;
        }
        // V must have the same zero, to rounding.
        let rest = v - d * (v1 - v2 * d + v3 * d * d);
        let noise = S::constant(ROUNDINGS * S::EPSILON) * (v_size + d.abs() * slope_size);
        let truncated = d * d * d * d * slope_size;
        if rest.abs() > noise + truncated {
            return None;
        }
        Some((v1 - v2 * d + v3 * d * d) / (h1 - h2 * d + h3 * d * d))
    }

    /// The amplitude of a mass while the holding force is `force`, from the modes as they stand:
    /// what [`absorbed_force`](Self::absorbed_force) goes with.
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
