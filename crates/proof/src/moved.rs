//! Tests the proof of amplitude and phase against exact values, and with small and large errors in the polynomials'
//! coefficients.

use crate::{prove, prove_piece};
use frictiongen_kernel::Float;
use frictiongen_kernel::table::ContactTable;
use frictiongen_model::modal::Modal;
use frictiongen_model::samples::{random, request, scene};
use frictiongen_model::scene::Side;
use frictiongen_model::table::FRICTION_SHARES;
use frictiongen_model::table::building::Exact;
use frictiongen_model::table::{Evidence, ProofWork, Request, Tables};
use std::f64::consts::PI;

const KINDS: [(&str, usize, f64, f64); 8] = [
    ("Wall", 2, -0.02, 1.1),
    ("Wall", 1, 0.0, 1.0),
    ("Base", 1, 0.02, 1.0),
    ("Wall", 2, 0.0, 1.2),
    ("Pair", 2, 0.02, 1.2),
    ("Wall", 2, 1.0, 1.1),
    ("Base", 2, 1.7, 1.0),
    ("Pair", 5, 0.02, 1.0),
];

fn tables<S: Float>(modal: &Modal, accuracy: f64, side: Side) -> Tables<S> {
    let asked = Request {
        motion: true,
        ..request(accuracy, side)
    };
    Tables::build(modal, asked).unwrap()
}

/// Returns the errors of β_lim (relative), amplitude (relative) and phase (rad) of a table at one r. The errors of
/// amplitude and phase are the largest over the tested friction ratios.
fn errors<S: Float>(tables: &Tables<S>, place: usize, exact: &mut Exact<'_>, r: S) -> [f64; 3] {
    let piece = &tables.pieces[place];
    let of = |function: usize| piece.value(function, r);
    let excitation = tables.excitation.as_ref();
    let excitation = excitation.map(|product| product.quotient().value(r));
    let own = match (excitation, tables.functions) {
        (None, _) => ContactTable::tabled([of(0), of(1), of(2), of(3), of(4)]),
        (Some(excitation), 4) => ContactTable::damped([of(0), of(1), of(2), of(3)], excitation),
        (Some(excitation), _) => ContactTable::undamped([of(0), of(1)], excitation),
    };
    let r = r.to_f64();
    let sample = exact.at(r).unwrap();
    let known = exact.contact(&sample, r);
    let (mut amplitude, mut phase) = (0.0_f64, 0.0_f64);
    for share in FRICTION_SHARES {
        let beta = S::constant(share * known.limit);
        let expected = known.amplitude(beta.to_f64());
        amplitude = amplitude.max((own.amplitude(beta).to_f64() / expected - 1.0).abs());
        let turned = own.phase(beta).to_f64() - known.phase(beta.to_f64());
        phase = phase.max((turned - (turned / (2.0 * PI)).round() * 2.0 * PI).abs());
    }
    [(of(0).to_f64() / known.limit - 1.0).abs(), amplitude, phase]
}

fn agreeing<S: Float>(accuracy: f64, side: Side) -> usize {
    let mut compared = 0;
    for (kind, count, zeta, stiction) in KINDS {
        let modal = scene(kind, count, zeta, stiction);
        let mut tables = tables::<S>(&modal, accuracy, side);
        prove(&mut tables, &modal, ProofWork::WHOLE);
        let proof = &tables.motion_proof;
        let name = format!("{kind}{count}, {zeta}, {accuracy:e}: {}", proof.told());
        assert!(proof.evidence != Evidence::Checked, "{name}");
        assert!(proof.bound.error <= accuracy, "{name}");
        // In an undamped chain, the proof may omit only neighbourhoods of zeros. If only some modes are damped, it may
        // also omit the motion over short intervals of r near a resonance divided by 3, 5, 7 and so on.
        let most = if zeta > 0.0 {
            0.0
        } else if zeta < 0.0 {
            1e-4
        } else {
            1e-6
        };
        assert!(proof.open_length() <= most, "{side:?} {name}");
        let mut exact = Exact::new(&modal);
        let mut state = 9;
        for _ in 0..1000 {
            let r = S::constant(0.2 + 2.3 * random(&mut state));
            let own = r.to_f64();
            if proof
                .open
                .iter()
                .any(|(from, to)| *from <= own && own <= *to)
            {
                continue;
            }
            let place = tables.pieces.partition_point(|piece| piece.from <= r);
            let [_, amplitude, phase] = errors(&tables, place.saturating_sub(1), &mut exact, r);
            // The tolerance covers the rounding errors of the exact values.
            let allowed = proof.bound.error + 1e-10;
            assert!(
                amplitude <= allowed && phase <= allowed,
                "{name} at {r:?}: {amplitude:e}, {phase:e}"
            );
            compared += 1;
        }
    }
    compared
}

/// Checks the proven bound at random r, for friction ratios up to 0.98 β_lim.
#[test]
fn the_bound_holds() {
    let double = agreeing::<f64>(1e-2, Side::Near)
        + agreeing::<f64>(1e-4, Side::Near)
        + agreeing::<f64>(1e-3, Side::Safe);
    let single = agreeing::<f32>(1e-3, Side::Near);
    assert!(
        double > 3 * 7 * 980 && single > 6 * 980,
        "{double}, {single}"
    );
}

/// Returns the largest errors of a table in a piece, at many r, divided by the accuracy.
fn largest(
    tables: &Tables<f64>,
    place: usize,
    ends: (f64, f64),
    exact: &mut Exact<'_>,
) -> [f64; 2] {
    let (mut limit, mut motion) = (0.0_f64, 0.0_f64);
    for k in 0..120 {
        let r = ends.0 + (ends.1 - ends.0) * (k as f64 + 0.5) / 120.0;
        let [own, amplitude, phase] = errors(tables, place, exact, r);
        limit = limit.max(own);
        motion = motion.max(amplitude).max(phase);
    }
    [limit, motion].map(|error| error / tables.request.accuracy)
}

/// Checks that the proof rejects every piece with a wrong coefficient. The test changes each coefficient of each
/// function of several pieces by ten times the accuracy. A second change of each coefficient is smaller. The error then
/// exceeds the accuracy only slightly, at one r.
#[test]
fn wrong_coefficients_are_not_proven() {
    let (mut little, mut much) = (0, 0);
    for (kind, count, zeta, accuracy) in [
        ("Wall", 1, 0.0, 1e-3),
        ("Base", 1, 0.02, 1e-2),
        ("Pair", 2, 0.02, 1e-4),
        ("Wall", 2, 1.7, 1e-6),
    ] {
        let modal = scene(kind, count, zeta, 1.2);
        let mut exact = Exact::new(&modal);
        let mut tables = tables::<f64>(&modal, accuracy, Side::Near);
        let last = tables.pieces.len() - 1;
        for place in [0, last / 2, last] {
            let next = tables.pieces.get(place + 1).map_or(2.5, |next| next.from);
            let piece = &tables.pieces[place];
            let ends = (piece.from, next);
            let far = (next - piece.origin)
                .abs()
                .max((ends.0 - piece.origin).abs());
            let middle = 0.5 * (ends.0 + next);
            let sizes = [0, 4].map(|function| piece.value(function, middle).abs());
            let [limit, motion] = prove_piece(&tables, &modal, place, ProofWork(300_000));
            let most = 1e-3 * (next - ends.0);
            assert!(
                limit.open_length() < most && motion.open_length() < most,
                "{kind}{count}: piece {place}"
            );
            for function in 0..tables.functions {
                // Errors of β_lim and |V| are relative errors.
                let scale = match function {
                    0 => sizes[0],
                    4 => sizes[1],
                    _ => 1.0,
                };
                for power in 0..tables.terms {
                    let sound = tables.pieces[place].coefficients[function][power];
                    let mut is_found = false;
                    for times in [1.0, -1.0, 1.5, 2.0, -2.0, 3.0, 5.0, 10.0] {
                        let wrong = times * accuracy * scale / far.powi(power as i32);
                        tables.pieces[place].coefficients[function][power] = sound + wrong;
                        let seen = largest(&tables, place, ends, &mut exact);
                        let is_much = times == 10.0;
                        let is_little = !is_found && (seen[0] > 1.02 || seen[1] > 1.02);
                        if !is_little && !is_much {
                            continue;
                        }
                        is_found = true;
                        let proofs = prove_piece(&tables, &modal, place, ProofWork(60_000));
                        for (which, (seen, proof)) in seen.into_iter().zip(&proofs).enumerate() {
                            let open = proof.open_length();
                            let told = format!(
                                "{kind}{count}, {accuracy:e}: {times} accuracies in power {power} of function {function} of piece {place}: {seen} in {which}, open {open:e}"
                            );
                            assert!(seen <= 1.02 || open > 0.0, "{told}");
                            little += usize::from(seen > 1.02 && seen < 2.0);
                            much += usize::from(seen >= 2.0);
                            // With a large error, a large fraction of the piece must stay unproven.
                            assert!(seen < 5.0 || open > 0.02 * (next - ends.0), "{told}");
                        }
                    }
                    tables.pieces[place].coefficients[function][power] = sound;
                }
            }
        }
    }
    println!("{little} by little, {much} by much");
    assert!(little > 150 && much > 200, "{little}, {much}");
}
