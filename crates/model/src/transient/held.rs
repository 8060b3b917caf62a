//! Held modes, and the participation of the modes of the sliding chain in each held mode. A held mode is a mode of the
//! chain with its contact stuck.
//!
//! A pair of roots of s² + 2αs + ω² is one oscillator (y, u), with u = ẏ/ω in the time t√(k₁/m₁). While only this
//! oscillator moves, mode i of the sliding chain has the modal coordinate η_i = g_i y + h_i u. Mode i has the
//! resonance σ_i = √λ_i, the damping ratio ζ_i and the contact displacement w_i. The participations g_i and h_i follow
//! from w_i/(s² + 2ζ_iσ_i s + λ_i) = g_i + (h_i/ω)s modulo the polynomial of the pair. All numbers are real, also at a
//! double root.

use super::plain::SlidingMode;
use crate::reduced::kind;
use crate::roots::{DrivenMode, pairs};
use frictiongen_kernel::motion::HeldMode;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::{Float, Scalar};

/// Largest relative difference of two squared frequencies that count as equal. It is a thousand rounding units of
/// double-double.
const ROUNDING: f64 = 1e-29;

/// Returns the held modes, which are the modes of the chain with its contact stuck. The second result has the
/// participations (g, h) of every mode of the sliding chain in each held mode.
///
/// `compliance` is k₁ divided by the stiffness of an elastic contact, and 0 for a rigid contact. Before the
/// participations are scaled, the displacement of the contact in a held mode is Σ w_i η_i = −`compliance`·y.
pub(super) fn held<T: Float, S: Scalar>(
    modes: &[&SlidingMode<T>],
    (inverse_mass, compliance): (T, T),
    pairs: &[(T, T)],
    to: &impl Fn(T) -> S,
) -> (Vec<HeldMode<S>>, Vec<[S; 2]>) {
    let (zero, one, two) = (T::constant(0.0), T::constant(1.0), T::constant(2.0));
    let (mut held, mut participations) = (Vec::new(), Vec::new());
    for (omega, zeta) in pairs.iter().copied() {
        let (own, largest) = participations_of(modes, compliance, (omega, zeta));
        // Modes a and b of different pairs are orthogonal in the bilinear form B(a, b) = Σ 2ζσ a b + ȧ b + a ḃ. The sum
        // is over the modes of the sliding chain, with damping ratios ζ and resonances σ.
        let (mut first, mut mixed, mut second) = (zero, zero, zero);
        let mut force = zero;
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
        // The participations in `own` are those for the contact force −y, divided by `largest`. An elastic contact
        // moves in a held mode, so `force` then also contains the inertia of this motion. The code uses `largest`
        // instead.
        let per_y = if compliance.is_zero() {
            force / inverse_mass
        } else {
            one / largest
        };
        held.push(HeldMode {
            kind: kind(zeta),
            frequency: to(omega),
            zeta: to(zeta),
            q: to(((one - zeta) * (one + zeta)).abs().sqrt()),
            force: to(per_y),
            inverse: [
                to(second / determinant),
                to(-(mixed / determinant)),
                to(first / determinant),
            ],
        });
        participations.extend(own.iter().map(|[g, h]| [to(*g), to(*h)]));
    }
    (held, participations)
}

/// Returns the participations (g, h) of every mode of the sliding chain in a held mode, divided by the largest of them,
/// and this largest participation. Before the division, the contact force is −y.
fn participations_of<T: Float>(
    modes: &[&SlidingMode<T>],
    compliance: T,
    (omega, zeta): (T, T),
) -> (Vec<[T; 2]>, T) {
    let (zero, two) = (T::constant(0.0), T::constant(2.0));
    let mut own = vec![[zero; 2]; modes.len()];
    // Finds the mode with the largest term in 1/κ + Σ c_i/(s² + 2ζ_iσ_i s + λ_i) = 0. The denominator of that mode may
    // be only rounding error. The code therefore computes the participation of that mode from those of the other
    // modes, so that the sum is 0.
    let (mut nearest, mut part) = (0, zero);
    for (index, (mode, participation)) in modes.iter().zip(&mut own).enumerate() {
        // The denominator d = s² + 2ζ_iσ_i s + λ_i is as + b modulo s² + 2αs + ω², the polynomial of the pair. The
        // inverse of d is (b − 2αa − as)/R, with R as `resultant`.
        let a = (mode.zeta * mode.resonance - zeta * omega) * two;
        let b = (mode.resonance - omega) * (mode.resonance + omega);
        let resultant = b * b - two * zeta * omega * a * b + omega * omega * a * a;
        let weight = mode.contact / resultant;
        // The squared modulus of this mode's term in the sum over the modes. If the contact hardly drives a mode, the
        // root is so close to the mode that the denominator is only rounding. The term is then meaningless, but the
        // mode is still the nearest mode.
        let own_part = (mode.contact * mode.contact * mode.contact * weight).abs();
        let rounding = T::constant(ROUNDING) * omega * omega;
        if resultant < rounding * rounding {
            (nearest, part) = (index, T::constant(f64::INFINITY));
        } else if !(own_part <= part) {
            (nearest, part) = (index, own_part);
        }
        *participation = [weight * (b - two * zeta * omega * a), -(weight * a * omega)];
    }
    let others = modes.iter().zip(&own).enumerate();
    let others = others.filter(|(index, _)| *index != nearest);
    let balance = others.fold([compliance, zero], |[sum_g, sum_h], (_, (mode, [g, h]))| {
        [sum_g + mode.contact * *g, sum_h + mode.contact * *h]
    });
    if let (Some(mode), Some(participation)) = (modes.get(nearest), own.get_mut(nearest)) {
        *participation = balance.map(|part| -(part / mode.contact));
    }
    let largest = own
        .iter()
        .flatten()
        .fold(zero, |most, participation| most.max(participation.abs()));
    for participation in own.iter_mut().flatten() {
        *participation = *participation / largest;
    }
    (own, largest)
}

/// Returns ω and ζ of the held modes (modes of the chain with its contact stuck), with derivatives. The function makes
/// one Newton step from the known ω and ζ. The unknowns are p and q in s² + ps + q, the polynomial of a pair of roots.
/// At the roots, 1/κ + Σ c_i/(s² + 2ζ_iσ_i s + λ_i) has the remainder 0 modulo this polynomial. `compliance` is 1/κ,
/// the compliance of an elastic contact, and 0 for a rigid contact.
pub(super) fn moving(
    driven: &[DrivenMode],
    modes: &[&SlidingMode<Dual<Dd>>],
    compliance: Dual<Dd>,
) -> Option<Vec<(Dual<Dd>, Dual<Dd>)>> {
    let two = Dd::from(2.0);
    let constants: Vec<[Dual<Dd>; 3]> = modes
        .iter()
        .map(|mode| {
            [
                (mode.zeta + mode.zeta) * mode.resonance,
                mode.resonance * mode.resonance,
                mode.contact * mode.contact,
            ]
        })
        .collect();
    let still: Vec<[Dual<Dd>; 3]> = constants
        .iter()
        .map(|constants| constants.map(|constant| Dual::fixed(constant.value)))
        .collect();
    let root = |pair: crate::roots::Pair| {
        let (p, q) = (two * pair.zeta * pair.omega, pair.omega * pair.omega);
        let slopes = |constants: &[[Dual<Dd>; 3]], p: Dual<Dd>, q: Dual<Dd>| {
            remainder(constants, p, q).map(|part| part.slope)
        };
        let (fixed_p, fixed_q) = (Dual::fixed(p), Dual::fixed(q));
        let mut own = slopes(&constants, fixed_p, fixed_q);
        own[0] = own[0] + compliance.slope;
        let along_p = slopes(&still, Dual::variable(p), fixed_q);
        let along_q = slopes(&still, fixed_p, Dual::variable(q));
        let determinant = along_p[0] * along_q[1] - along_p[1] * along_q[0];
        let size = (along_p[0] * along_q[1]).abs() + (along_p[1] * along_q[0]).abs();
        if !(size * Dd::from(1e-14) < determinant.abs()) {
            return None;
        }
        let p = Dual {
            value: p,
            slope: (own[1] * along_q[0] - own[0] * along_q[1]) / determinant,
        };
        let q = Dual {
            value: q,
            slope: (own[0] * along_p[1] - own[1] * along_p[0]) / determinant,
        };
        let omega = Dual {
            value: pair.omega,
            slope: q.slope / (two * pair.omega),
        };
        let mut zeta = p / (omega + omega);
        zeta.value = pair.zeta;
        let known = [omega.slope, zeta.slope]
            .iter()
            .all(|slope| slope.is_finite());
        known.then_some((omega, zeta))
    };
    let pairs = pairs(driven, compliance.value);
    pairs.into_iter().map(root).collect()
}

/// Returns the constant and the linear term of Σ c_i/(s² + l_i s + λ_i) modulo s² + ps + q. Each entry of `constants`
/// is l, λ and c of one mode.
fn remainder<T: Float>(constants: &[[T; 3]], p: T, q: T) -> [T; 2] {
    let zero = T::constant(0.0);
    constants
        .iter()
        .fold([zero; 2], |[first, second], [loss, lambda, c]| {
            let (a, b) = (*loss - p, *lambda - q);
            let resultant = b * b - p * a * b + q * a * a;
            [
                first + *c * (b - p * a) / resultant,
                second - *c * a / resultant,
            ]
        })
}
