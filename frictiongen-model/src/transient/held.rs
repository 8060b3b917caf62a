//! The modes of the chain with its contact held, and how far the free modes take part in them.
//!
//! A pair of roots s² + 2αs + ω² is one oscillator (y, u), u = ẏ/ω in the time t√(k₁/m₁).  While
//! it alone moves, mode i moves by η_i = g_i y + h_i u, where w_i/(s² + 2ζ_iσ_i s + λ_i) =
//! g_i + (h_i/ω)s modulo the pair's polynomial.  Real throughout, also at a double root.

use super::Plain;
use crate::modal::{Modal, kind};
use crate::roots::{Driven, pairs};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::simulation::HeldMode;

/// The held modes, and the shares (g, h) of every mode in each.
pub(super) fn held<S: Scalar>(
    modes: &[&Plain],
    modal: &Modal,
    to: &impl Fn(Dd) -> S,
) -> (Vec<HeldMode<S>>, Vec<[S; 2]>) {
    let (one, two) = (Dd::ONE, Dd::from(2.0));
    let driven: Vec<Driven> = modes
        .iter()
        .map(|mode| Driven {
            sigma: mode.resonance,
            zeta: mode.zeta,
            inverse_mass: mode.contact * mode.contact,
        })
        .collect();
    let (mut held, mut shares) = (Vec::new(), Vec::new());
    for pair in pairs(&driven) {
        let (omega, zeta) = (pair.omega, pair.zeta);
        let mut own = vec![[Dd::ZERO; 2]; modes.len()];
        // The mode with the largest part in Σ w_i/(s² + 2ζ_iσ_i s + λ_i) = 0, by which the others must be
        // balanced: its own denominator may be all rounding.
        let (mut nearest, mut part) = (0, Dd::ZERO);
        for (index, (mode, share)) in modes.iter().zip(&mut own).enumerate() {
            // d = s² + 2ζ_iσ_i s + λ_i is as + b modulo the polynomial; its inverse is
            // (b − 2αa − as)/R.
            let a = (mode.zeta * mode.resonance - zeta * omega) * two;
            let b = (mode.resonance - omega) * (mode.resonance + omega);
            let resultant = b * b - two * zeta * omega * a * b + omega * omega * a * a;
            let weight = mode.contact / resultant;
            // The square of w_i's part.
            let own_part = (mode.contact * mode.contact * mode.contact * weight).abs();
            if !(own_part <= part) {
                (nearest, part) = (index, own_part);
            }
            *share = [weight * (b - two * zeta * omega * a), -(weight * a * omega)];
        }
        let others = modes.iter().zip(&own).enumerate();
        let others = others.filter(|(index, _)| *index != nearest);
        let balance = others.fold([Dd::ZERO; 2], |[sum_g, sum_h], (_, (mode, [g, h]))| {
            [sum_g + mode.contact * *g, sum_h + mode.contact * *h]
        });
        if let (Some(mode), Some(share)) = (modes.get(nearest), own.get_mut(nearest)) {
            *share = balance.map(|part| -(part / mode.contact));
        }
        let largest = own
            .iter()
            .flatten()
            .fold(Dd::ZERO, |most, share| most.max(share.abs()));
        for share in own.iter_mut().flatten() {
            *share = *share / largest;
        }
        // B(a, b) = Σ 2ζσ a b + ȧ b + a ḃ, in which different pairs are orthogonal.
        let (mut first, mut mixed, mut second) = (Dd::ZERO, Dd::ZERO, Dd::ZERO);
        let mut force = Dd::ZERO;
        for (mode, [g, h]) in modes.iter().zip(&own) {
            let (g, h) = (*g, *h);
            let loss = two * mode.zeta * mode.resonance;
            let (g_rate, h_rate) = (-(omega * h), omega * (g - two * zeta * h));
            first = first + loss * g * g + two * g * g_rate;
            mixed = mixed + loss * g * h + g_rate * h + g * h_rate;
            second = second + loss * h * h + two * h * h_rate;
            let lambda = mode.resonance * mode.resonance;
            force = force + mode.contact * (lambda * g + loss * g_rate);
        }
        let determinant = first * second - mixed * mixed;
        held.push(HeldMode {
            kind: kind(zeta),
            frequency: to(omega),
            zeta: to(zeta),
            q: to(((one - zeta) * (one + zeta)).abs().sqrt()),
            force: to(force / modal.inverse_mass),
            inverse: [
                to(second / determinant),
                to(-(mixed / determinant)),
                to(first / determinant),
            ],
        });
        shares.extend(own.iter().map(|[g, h]| [to(*g), to(*h)]));
    }
    (held, shares)
}
