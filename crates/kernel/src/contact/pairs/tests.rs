//! Tests that the code computes the same modal sums, to the last bit, for pairs of modes as for single modes.

use super::*;
use crate::contact::driven::DrivenModes;
use crate::number::complex::Complex;

/// Returns a pseudo-random number between 0.1 and 1.1 for the mode with the given index.
fn scattered(index: usize, salt: usize) -> f64 {
    ((index * 37 + salt * 11) as f64 * 0.618_033_988_749_894_9).fract() + 0.1
}

fn modes<S: Float>(count: usize, zeta: impl Fn(usize) -> f64, driven: usize) -> Vec<Mode<S>> {
    let mode = |index: usize| {
        let zeta = zeta(index);
        let q = (1.0 - zeta * zeta).abs().sqrt();
        let kind = match zeta {
            0.0 => Kind::Undamped,
            zeta if zeta < 0.5 => Kind::Light,
            zeta if zeta < 1.0 => Kind::Heavy,
            _ => Kind::Over,
        };
        let in_contact = driven >> index & 1 == 1;
        let contact = if in_contact { scattered(index, 1) } else { 0.0 };
        let of = S::constant;
        Mode {
            kind,
            in_contact,
            resonance: of(0.5 + index as f64 * 0.5),
            zeta: of(zeta),
            q: of(q),
            q_defect: of(zeta * zeta / (1.0 + q)),
            load: of(scattered(index, 2)),
            contact: of(contact),
            residue: of(contact * scattered(index, 2)),
            contact_squared: of(contact * contact),
            static_residue: of(contact * scattered(index, 3)),
        }
    };
    (0..count).map(mode).collect()
}

/// Returns the bits of all modal sums of a contact and of the functions of all modes. The function first converts `f32`
/// numbers to `f64`.
fn bits<S: Float>(contact: &ContactAt<S>, kept: &[ModeAt<S>]) -> Vec<u64> {
    let of = |z: Complex<S>| [z.re, z.im];
    let ContactAt {
        scale,
        v,
        u,
        g,
        reversal,
        h,
    } = *contact;
    let mut all = vec![scale, u, g, reversal];
    all.extend([of(v), of(h)].concat());
    for at in kept {
        all.extend([at.x, at.u, at.g]);
        all.extend(of(at.response));
    }
    all.iter().map(|value| value.to_f64().to_bits()).collect()
}

/// Compares modal sums that are computed in pairs of modes with sums computed mode by mode. Then compares the limits
/// from gathered constants with the limits from the sums. Returns the number of compared sums and the number of
/// compared limits.
fn agree<S: Float>() -> [usize; 2] {
    let dampings: [fn(usize) -> f64; 4] = [
        |_| 0.0,
        |index| 0.01 + 0.04 * index as f64,
        |index| 0.4 + 0.2 * index as f64,
        |index| if index % 2 == 0 { 0.0 } else { 0.3 },
    ];
    let (mut compared, mut laid_out) = (0, 0);
    for (count, zeta) in (1..=7).flat_map(|count| dampings.map(|zeta| (count, zeta))) {
        for driven in [0b111_1111, 0b101_1101, 0b010_1010, 0] {
            let modes = modes::<S>(count, zeta, driven);
            for on_moving_base in [None, Some(S::constant(-0.3))] {
                let chain = Chain {
                    damped: modes.iter().any(|mode| mode.kind != Kind::Undamped),
                    on_moving_base,
                    inverse_mass: S::constant(0.9),
                    stiction: S::constant(1.2),
                };
                // At some of these 1/r, a mode is on a resonance or a sub-harmonic, or close to it. At the largest 1/r,
                // rounding makes the phase xτ meaningless.
                for inverse_r in [2.0, 1.0, 0.3, 0.7, 6.0, 1.0 + 1e-7, 1e-9, 3e5, 1e17] {
                    let inverse_r = S::constant(inverse_r);
                    let (mut by_two, mut in_turn) = (Vec::new(), Vec::new());
                    let a = chain.contact(&modes, inverse_r, |at| by_two.push(at));
                    let b = chain.in_turn::<true>(&modes, inverse_r, |at| in_turn.push(at));
                    assert_eq!(bits(&a, &by_two), bits(&b, &in_turn), "{modes:?}");
                    let a = chain.contact_without_g(&modes, inverse_r);
                    let b = chain.in_turn::<false>(&modes, inverse_r, |_| ());
                    assert_eq!(bits(&a, &[]), bits(&b, &[]), "{modes:?}");
                    if let Some(driven) = DrivenModes::of(&chain, &modes) {
                        let expected = [
                            chain.continuous_limit(&b, chain.break_away(&b)),
                            chain.sliding_limit(&b),
                            b.h.re,
                        ];
                        let (limits, h) = chain.limits_of_driven(&driven, inverse_r, false);
                        let found = [limits.continuous, limits.sliding, h];
                        let bits = |of: [S; 3]| of.map(|value| value.to_f64().to_bits());
                        assert_eq!(bits(found), bits(expected), "{modes:?}");
                        laid_out += 1;
                    }
                    compared += 1;
                }
            }
        }
    }
    [compared, laid_out]
}

#[test]
fn pairs_of_modes_have_the_bits_of_single_ones() {
    // `DrivenModes` exist for any number of undamped modes (`dampings[0]`), and for a single mode with `dampings[3]`.
    // No `DrivenModes` exist if the contact drives none of the modes.
    let laid_out = ((7 * 4 - (7 + 1)) + (4 - 2)) * 2 * 9;
    assert_eq!(agree::<f64>(), [7 * 4 * 4 * 2 * 9, laid_out]);
    assert_eq!(agree::<f32>(), [7 * 4 * 4 * 2 * 9, laid_out]);
}

#[test]
fn only_few_undamped_modes_are_laid_out() {
    let laid_out = |count: usize, zeta: f64, driven: usize| {
        let modes = modes::<f64>(count, |_| zeta, driven);
        let chain = Chain {
            damped: zeta > 0.0,
            on_moving_base: None,
            inverse_mass: 0.9,
            stiction: 1.2,
        };
        DrivenModes::of(&chain, &modes).is_some()
    };
    assert!(laid_out(1, 0.0, 1) && laid_out(16, 0.0, usize::MAX));
    assert!(laid_out(20, 0.0, 0b1111));
    assert!(!laid_out(17, 0.0, usize::MAX) && !laid_out(3, 0.0, 0) && !laid_out(2, 0.01, 3));
}
