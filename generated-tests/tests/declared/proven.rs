//! What is proven of β_lim, at points that neither builder nor proof looked at.

use super::random;
use super::scenes::scenes;
use frictiongen::System;
use frictiongen::study::scene::Side;
use frictiongen::study::table::{Evidence, Request, TableError, Tables, Work};
use fuzzing::Random;

const RANGE: (f64, f64) = (0.2, 2.5);
/// What a sum in double precision may be off by itself.
const ROUNDING: f64 = 1e-9;

/// One table: how much is open, and whether a random r outside of that exceeds the bound.
fn held(name: &str, text: &str, accuracy: f64, points: usize, random: &mut Random) -> Option<f64> {
    let system: System = text.parse().expect("a scene");
    let request = Request {
        r: RANGE,
        accuracy,
        side: Side::Near,
        motion: false,
    };
    let tables = match Tables::<f64>::build(system.modal(), request) {
        Ok(tables) => tables.proven(system.modal(), Work::WHOLE),
        Err(TableError::NotMet { .. }) => return None,
        Err(error) => panic!("{name}: {error}"),
    };
    let proof = &tables.proof;
    println!(
        "{name}, {accuracy:e}: {} pieces; {} work; {}",
        tables.pieces.len(),
        proof.work.0,
        proof.told()
    );
    assert!(proof.bound.error <= accuracy, "{name}: {}", proof.told());
    if proof.evidence == Evidence::Checked {
        return Some(1.0);
    }
    let mut looked = 0;
    for _ in 0..points {
        let r = random.between(RANGE.0, RANGE.1);
        if proof.open.iter().any(|(from, to)| *from <= r && r <= *to) {
            continue;
        }
        let place = tables.pieces.partition_point(|piece| piece.from <= r);
        let own = tables.pieces[place.saturating_sub(1)].value(0, r);
        let limit = system.at(r).expect("in the domain").continuous_limit();
        let error = (own / limit - 1.0).abs();
        assert!(
            error <= proof.bound.error + ROUNDING,
            "{name}, {accuracy:e}, r = {r:?}: {error:e} in place of {:e}",
            proof.bound.error
        );
        looked += 1;
    }
    let open = proof.open_length() / (RANGE.1 - RANGE.0);
    assert!(
        looked as f64 >= (1.0 - open) * points as f64 * 0.8,
        "{name}"
    );
    Some(open)
}

fn chains(accuracy: f64, masses: &[&str], most: f64, points: usize) {
    let mut random = Random(44);
    let mut seen = 0;
    for (name, text) in scenes("f64") {
        if !masses
            .iter()
            .any(|count| name.contains(&format!("{count},")))
        {
            continue;
        }
        let open = held(&name, &text, accuracy, points, &mut random).expect("a table");
        let most = if name.contains("none") { most } else { 0.0 };
        assert!(open <= most, "{name}: {open:e} of the range is open");
        seen += 1;
    }
    assert!(seen >= 8 * masses.len(), "{seen}");
}

/// Chains of one and two masses are proven: whole with damping, undamped but for zeros and a piece about a resonance.
#[test]
fn of_small_chains() {
    chains(1e-3, &["1", "2"], 0.2, 500);
}

#[test]
#[ignore = "a minute: chains of up to five masses to 1e-4"]
fn of_chains_whole() {
    chains(1e-4, &["1", "2", "5"], 0.03, 20_000);
}

/// Random scenes: whatever is proven holds.
#[test]
fn of_random_scenes() {
    let mut scenes = Random(20_261_123);
    let mut random = Random(7);
    let (mut tables, mut open) = (0, 0.0);
    while tables < 8 {
        let text = random::scene(&mut scenes);
        if text.matches("m4: ").count() > 0 {
            continue;
        }
        let name = format!("scene {tables}");
        if let Some(own) = held(&name, &text, 1e-3, 1000, &mut random) {
            open += own;
            tables += 1;
        }
    }
    assert!(open / f64::from(tables) < 0.25, "{open} of {tables}");
}
