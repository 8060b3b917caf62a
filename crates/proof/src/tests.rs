//! Tests the proof against the exact search, and with faults that the proof has to find.

use crate::cells::CellData;
use crate::certify::certified;
use crate::found::Budget;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, ORDER, singular};
use crate::witness::{Witness, WitnessInstant};
use crate::{early, force, of_pieces, prove, prove_piece};
use frictiongen_kernel::Float;
use frictiongen_model::interval::Interval;
use frictiongen_model::modal::Modal;
use frictiongen_model::samples::{random, request, scene};
use frictiongen_model::scene::Side;
use frictiongen_model::table::building::Exact;
use frictiongen_model::table::{Evidence, Proof, ProofWork, Tables};

/// Proves the β_lim of tables, and returns its proof.
fn limit_of<S: Float>(tables: &Tables<S>, modal: &Modal, work: ProofWork) -> Proof {
    let [limit, _] = of_pieces(tables, modal, 0..tables.pieces.len(), work);
    limit
}

/// Checks that a table agrees with the exact search within the proven bound, at random r. The test omits r in the
/// intervals that the proof left open. No bound is proven there.
#[test]
fn the_bound_holds() {
    let mut points = 0;
    for (kind, count, zeta, stiction) in [
        ("Wall", 1, 0.0, 1.0),
        ("Base", 1, 0.02, 1.0),
        ("Wall", 2, 0.0, 1.2),
        ("Pair", 2, 0.02, 1.2),
        ("Base", 2, 1.7, 1.0),
        ("Wall", 2, 1.0, 1.1),
        ("Wall", 3, 0.3, 1.0),
    ] {
        let modal = scene(kind, count, zeta, stiction);
        for (accuracy, side) in [(1e-3, Side::Near), (1e-3, Side::Safe), (1e-4, Side::Near)] {
            let tables = Tables::<f64>::build(&modal, request(accuracy, side)).unwrap();
            let proof = limit_of(&tables, &modal, ProofWork(1_000_000));
            let name = format!(
                "{kind}{count}, {zeta}, {stiction}, {accuracy:e}, {side:?}: {}",
                proof.told()
            );
            assert!(proof.evidence != Evidence::Checked, "{name}");
            // The proof may omit only the neighbourhoods of zeros of β_lim in undamped chains.
            let most = if zeta > 0.0 { 0.0 } else { 1e-6 };
            assert!(proof.open_length() <= most, "{name}");
            assert!(proof.bound.error <= accuracy, "{name}");
            let mut exact = Exact::new(&modal);
            let mut state = 77 + count as u64;
            for _ in 0..2000 {
                let r = 0.2 + 2.3 * random(&mut state);
                if proof.open.iter().any(|(from, to)| *from <= r && r <= *to) {
                    continue;
                }
                let piece = tables.pieces.iter().rev().find(|piece| piece.from <= r);
                let value = piece.unwrap_or(&tables.pieces[0]).value(0, r);
                let limit = exact.at(r).unwrap().limit;
                // The tolerance covers the rounding errors of the search and of the sums in double precision.
                let error = value / limit - 1.0;
                assert!(
                    error.abs() <= proof.bound.error + 1e-9,
                    "{name} at {r}: {error:e}"
                );
                assert!(
                    side == Side::Near || error <= 1e-9,
                    "{name} at {r}: {error:e}"
                );
                points += 1;
            }
        }
    }
    assert!(points > 7 * 3 * 1800, "{points}");
}

/// Checks that a piece of a table is not proven if one coefficient is wrong by ten times the accuracy. The proof must
/// fail at the r at which the error matters.
#[test]
fn a_wrong_coefficient_is_not_proven() {
    let mut found = 0;
    for (kind, count, zeta, accuracy) in [
        ("Wall", 1, 0.0, 1e-2),
        ("Base", 1, 0.02, 1e-4),
        ("Pair", 2, 0.02, 1e-4),
        ("Wall", 1, 0.02, 1e-6),
    ] {
        let modal = scene(kind, count, zeta, 1.2);
        let mut tables = Tables::<f64>::build(&modal, request(accuracy, Side::Near)).unwrap();
        for place in [1, tables.pieces.len() / 2, tables.pieces.len() - 1] {
            let work = ProofWork(300_000);
            let [sound, _] = prove_piece(&tables, &modal, place, work);
            let next = tables.pieces.get(place + 1).map_or(2.5, |next| next.from);
            let piece = &tables.pieces[place];
            let (from, middle) = (piece.from, 0.5 * (piece.from + next));
            let far = (next - piece.origin).abs().max((from - piece.origin).abs());
            let limit = piece.value(0, middle).abs();
            assert!(
                sound.open_length() < 1e-3 * (next - from),
                "{}",
                sound.told()
            );
            for power in 0..tables.terms {
                let coefficient = tables.pieces[place].coefficients[0][power];
                let wrong = 10.0 * accuracy * limit / far.powi(power as i32);
                tables.pieces[place].coefficients[0][power] = coefficient + wrong;
                let [wrong, _] = prove_piece(&tables, &modal, place, ProofWork(50_000));
                let open = wrong.open_length();
                // A coefficient that is wrong by ten times the accuracy at the far end is wrong by more than the
                // accuracy over a large fraction of the piece.
                assert!(
                    open > 0.05 * (next - from),
                    "{kind}{count} {accuracy:e}: coefficient {power} of piece {place} passes but for {open:e}"
                );
                tables.pieces[place].coefficients[0][power] = coefficient;
                found += 1;
            }
        }
    }
    assert_eq!(found, 3 * (4 + 6 + 6 + 6));
}

/// Checks that with `side: safe` a table above β_lim is not proven, even if the table exceeds β_lim by less than the
/// accuracy.
#[test]
fn above_the_limit_is_not_safe() {
    let accuracy = 1e-3;
    for (kind, count, zeta) in [("Wall", 1, 0.02), ("Base", 2, 0.02), ("Wall", 1, 0.0)] {
        let modal = scene(kind, count, zeta, 1.2);
        let mut tables = Tables::<f64>::build(&modal, request(accuracy, Side::Safe)).unwrap();
        let place = tables.pieces.len() / 2;
        let next = tables.pieces.get(place + 1).map_or(2.5, |next| next.from);
        let length = next - tables.pieces[place].from;
        let open = |tables: &Tables<f64>| {
            let [proof, _] = prove_piece(tables, &modal, place, ProofWork(300_000));
            proof.open_length() / length
        };
        assert!(open(&tables) < 1e-3, "{kind}{count}");
        // The factor shifts the piece from below β_lim to above it, by less than the accuracy.
        for coefficient in &mut tables.pieces[place].coefficients[0] {
            *coefficient *= 1.0 + 0.97 * accuracy;
        }
        assert!(open(&tables) > 0.5, "{kind}{count}: {}", open(&tables));
    }
}

/// Checks that a proof in single precision includes the rounding errors of the polynomial's evaluation.
#[test]
fn single_precision() {
    let modal = scene("Wall", 1, 0.02, 1.2);
    let tables = Tables::<f32>::build(&modal, request(1e-4, Side::Near)).unwrap();
    let proof = limit_of(&tables, &modal, ProofWork(1_000_000));
    assert_eq!(proof.evidence, Evidence::Proven, "{}", proof.told());
    let mut exact = Exact::new(&modal);
    let mut state = 5;
    for _ in 0..5000 {
        let r = (0.2 + 2.3 * random(&mut state)) as f32;
        let piece = tables.pieces.iter().rev().find(|piece| piece.from <= r);
        let value = f64::from(piece.unwrap_or(&tables.pieces[0]).value(0, r));
        let limit = exact.at(f64::from(r)).unwrap().limit;
        assert!((value / limit - 1.0).abs() <= proof.bound.error, "r = {r}");
    }
}

/// Checks that a table reports that it is only checked, not proven. The test has two cases, a proof without permitted
/// work and an accuracy below 1e-6.
#[test]
fn what_is_not_proven_says_so() {
    let modal = scene("Wall", 1, 0.02, 1.2);
    let tables = Tables::<f64>::build(&modal, request(1e-4, Side::Near)).unwrap();
    assert_eq!(tables.proof.evidence, Evidence::Checked);
    assert_eq!(
        limit_of(&tables, &modal, ProofWork(0)).evidence,
        Evidence::Checked
    );
    let little = limit_of(&tables, &modal, ProofWork(20_000));
    assert_eq!(little.evidence, Evidence::Partly);
    assert!(little.open_length() > 0.1 && little.work.0 < 30_000);
    assert!(
        little.told().contains("Only checked in"),
        "{}",
        little.told()
    );
    let mut fine = Tables::<f64>::build(&modal, request(1e-7, Side::Near)).unwrap();
    prove(&mut fine, &modal, ProofWork::WHOLE);
    assert_eq!(fine.proof.evidence, Evidence::Checked);
    assert!(fine.proof.told().starts_with("Checked, not proven"));
}

/// Checks that the proof rejects a witness, an assumed instant of the largest velocity constraint, if it is not near
/// the largest constraint. The proof must accept most witnesses that are at the largest constraint.
#[test]
fn witnesses_that_are_none() {
    let (mut refused, mut accepted, mut largest) = (0, 0, 0);
    for (kind, count, zeta, stiction) in [
        ("Wall", 1, 0.02, 1.0),
        ("Pair", 2, 0.0, 1.0),
        ("Wall", 3, 0.05, 1.2),
        ("Base", 2, 1.5, 1.0),
    ] {
        let modal = scene(kind, count, zeta, stiction);
        let (chain, mut exact) = (IntervalChain::of(&modal), Exact::new(&modal));
        let mut state = 11;
        for turn in 0..400 {
            let r = 0.2 + 1.5 * random(&mut state);
            let all = Interval::new(r * (1.0 - 2e-5), r * (1.0 + 2e-5));
            let tau = exact.at(r).unwrap().tau;
            // The instant of the `Witness` is at the largest velocity constraint, near it, anywhere, or at the start of
            // the half period.
            let t = match (turn % 4, tau) {
                (0, Some(tau)) => Some(tau / std::f64::consts::PI),
                (1, Some(tau)) => {
                    Some(tau / std::f64::consts::PI * (0.8 + 0.4 * random(&mut state)))
                }
                (2, _) => Some(random(&mut state)),
                _ => None,
            };
            let witness = t.map_or(Witness::BreakAway, |t| Witness::Instant(vec![t]));
            let singular = singular(&chain, r);
            let at = ChainStage::<ORDER>::over(&chain, Interval::point(r), &singular);
            let over = ChainStage::<ORDER>::over(&chain, all, &singular);
            let away = all - Interval::point(r);
            let none = [Interval::ZERO; 2];
            let seen_at = WitnessInstant::of(&witness, &at, Interval::ZERO, none);
            let seen_over = WitnessInstant::of(&witness, &over, away, none);
            let share = 1e-3;
            let part = CellData {
                chain: &chain,
                witness: &witness,
                away,
                at: &at,
                over: &over,
                seen_at: &seen_at,
                seen_over: &seen_over,
                share,
            };
            let mut budget = Budget::of(1_000_000);
            let shown = certified(&part, &mut budget);
            // The test compares the β_lim that follows from the `Witness` with the exact β_lim.
            let [re, im] = at.excitation.map(|part| part.value().middle());
            let own = re.hypot(im) / seen_at.size.value().middle().sqrt();
            let missed = own / exact.at(r).unwrap().limit - 1.0;
            if missed > share * 1.01 {
                assert!(
                    !shown,
                    "{kind}{count}, {zeta}: {t:?} at r = {r} misses {missed:e}"
                );
                refused += 1;
            } else if missed.abs() < 1e-6 {
                largest += 1;
                accepted += usize::from(shown);
            }
        }
    }
    assert!(refused > 400, "{refused}");
    assert!(
        accepted * 10 > largest * 8 && largest > 200,
        "{accepted} of {largest}"
    );
}

/// Checks that near the start of the half period the Taylor series in τ agrees with F/sin τ from the sum over the
/// modes. The test has modes of every kind of damping, and includes slopes in r.
#[test]
fn early_as_anywhere() {
    let mut state = 5;
    let mut widest = 0.0_f64;
    for zeta in [0.0, 0.02, -0.3, 1.0, 1.7] {
        let modal = scene("Pair", 3, zeta, 1.0);
        let chain = IntervalChain::of(&modal);
        for _ in 0..200 {
            let r = 0.6 + 1.9 * random(&mut state);
            let stage = ChainStage::<3>::over(&chain, Interval::point(r), &singular(&chain, r));
            let fastest = chain.modes.iter().map(|mode| mode.sigma.high / r);
            let fastest = fastest.fold(1.0, f64::max) * (1.0 + zeta.abs());
            let t = (0.05 + 0.1 * random(&mut state)) / fastest;
            let path = IntervalSeries::<3>::fixed(Interval::point(t));
            let tau = path.times(Interval::pi());
            let rest = early::rest(&stage, t).map(IntervalSeries::fixed);
            let (value, slope) = early::over_tau(&stage, &tau);
            let (value, slope) = (value + rest[0], slope + rest[1]);
            let (sine, cosine) = path.sine_cosine();
            let motions = force::motions(&stage, &path);
            let own = force::value(&stage, &motions, &cosine) / tau;
            let own_slope = (force::slope(&stage, &motions, &sine) - own) / tau;
            for (a, b) in [(value, own), (slope, own_slope)] {
                for (k, (a, b)) in a.terms.iter().zip(&b.terms).enumerate() {
                    let apart = (a.low - b.high).max(b.low - a.high);
                    // The remainder bounds only values, so slopes in r get a tolerance.
                    let slack = if k == 0 { 0.0 } else { 1e-7 * (1.0 + a.size()) };
                    assert!(
                        apart <= slack,
                        "ζ = {zeta}, r = {r}, t = {t}: {k}, {a:?}, {b:?}"
                    );
                    widest = widest.max(a.high - a.low);
                }
            }
        }
    }
    assert!(widest < 1e-3, "{widest:e}");
}
