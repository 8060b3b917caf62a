//! Tests the proven bounds on β_lim, at points that neither the builder of the table nor the proof used.

use super::random;
use super::scenes::{scene, scenes};
use frictiongen::System;
use frictiongen::study::scene::Side;
use frictiongen::study::table::{Evidence, Proof, ProofWork, Request, TableError, Tables};
use frictiongen_codegen::{Description, ProofAt, SceneTables, SizeLimits, parse_text, pretty};
use frictiongen_kernel::Float;
use fuzzing::Random;
use std::time::Instant;

const RANGE: (f64, f64) = (0.2, 2.5);
/// Relative rounding error of a sum in double precision.
const ROUNDING: f64 = 1e-9;

/// Builds a table and proves it. Checks that at no random r outside the open intervals the error exceeds the proven
/// bound. Returns the fraction of the range without a proof, or `None` if no table can be built.
fn held(name: &str, text: &str, accuracy: f64, points: usize, random: &mut Random) -> Option<f64> {
    let system: System = text.parse().expect("a scene");
    let request = Request {
        r: RANGE,
        accuracy,
        side: Side::Near,
        motion: false,
        stuck: false,
    };
    let tables = match Tables::<f64>::build(system.modal(), request) {
        Ok(mut tables) => {
            frictiongen_proof::prove(&mut tables, system.modal(), ProofWork::WHOLE);
            tables
        }
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

/// Largest fraction of the range of an undamped chain that may remain without a proof.
const OPEN: f64 = 0.004;

/// Checks the proven bounds of one of every `step` chains.
fn chains(accuracy: f64, points: usize, step: usize) {
    let (mut random, mut seen) = (Random(44), 0);
    for (name, text) in scenes("f64").into_iter().step_by(step) {
        let open = held(&name, &text, accuracy, points, &mut random).expect("a table");
        let most = if name.contains("none") { OPEN } else { 0.0 };
        assert!(open <= most, "{name}: {open:e} of the range is open");
        seen += 1;
    }
    assert_eq!(seen, 44_usize.div_ceil(step));
}

/// Checks that damped chains are proven over the whole range of r. Undamped chains are proven except near zeros and
/// near one or two resonances.
#[test]
fn of_some_chains() {
    chains(1e-3, 500, 5);
}

#[test]
#[ignore = "seconds, optimised: many points, to 1e-4"]
fn of_all_chains() {
    chains(1e-3, 500, 1);
    chains(1e-4, 20_000, 1);
}

/// Checks that the proven bounds of random scenes are right.
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

/// Checks that the bounds are right that are proven for scenes whose damping acts relative to the moving base.
#[test]
fn of_damping_from_the_base() {
    let mut scenes = Random(20_261_126);
    let mut random = Random(8);
    let (mut tables, mut open) = (0, 0.0);
    while tables < 5 {
        let text = random::damped_from_base(&mut scenes);
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

/// Prints the fraction of the range without a proof and the work of the proof, each as minimum and maximum over the
/// chains of a kind. β*_lim is always proven over the whole range.
fn measured<S: Float>(accuracies: &[f64]) -> usize {
    let scalar = if S::EPSILON > 1e-10 { "f32" } else { "f64" };
    let mut seen = 0;
    for accuracy in accuracies {
        for count in ["1", "2", "5", "10"] {
            for damping in ["none", "modal(0.02)"] {
                let (mut open, mut work) = ([1.0_f64, 0.0], [usize::MAX, 0]);
                let (mut of_motion, mut sliding) = ([1.0_f64, 0.0], 0.0_f64);
                let clock = Instant::now();
                for (name, text) in scenes(scalar) {
                    let kind = name.split(',').next().unwrap_or("");
                    if &kind[4..] != count || !name.contains(damping) {
                        continue;
                    }
                    let system: System<S> = text.parse().expect("a scene");
                    let Ok(compiled) = system.compile(RANGE.0..RANGE.1, *accuracy) else {
                        continue;
                    };
                    let compiled = compiled.proven(ProofWork::WHOLE);
                    let proof = compiled.proof();
                    let share = proof.open_length() / (RANGE.1 - RANGE.0);
                    open = [open[0].min(share), open[1].max(share)];
                    let tables = compiled.tables();
                    let share = tables.motion_proof.open_length() / (RANGE.1 - RANGE.0);
                    of_motion = [of_motion[0].min(share), of_motion[1].max(share)];
                    sliding = sliding.max(tables.sliding_proof.bound.error);
                    assert!(tables.motion_proof.bound.error <= *accuracy, "{name}");
                    assert_eq!(tables.sliding_proof.open_length(), 0.0, "{name}");
                    work = [work[0].min(proof.work.0), work[1].max(proof.work.0)];
                    assert!(proof.bound.error <= *accuracy, "{name}");
                    seen += 1;
                }
                println!(
                    "{scalar}, {accuracy:e}, {count} masses, {damping}: open {:.1e} to {:.1e} of the range, of the motion {:.1e} to {:.1e}; sliding limit within {sliding:.1e}; work {} to {}; {:.1} s a chain",
                    open[0],
                    open[1],
                    of_motion[0],
                    of_motion[1],
                    work[0],
                    work[1],
                    clock.elapsed().as_secs_f64() / 6.0,
                );
            }
        }
    }
    seen
}

#[test]
#[ignore = "two minutes; prints how much of each kind of chain is proven"]
fn how_much() {
    let f64s = measured::<f64>(&[1e-2, 1e-4, 1e-6]);
    let f32s = measured::<f32>(&[1e-2, 1e-4, 1e-5]);
    assert_eq!((f64s, f32s), (3 * 44, 3 * 44));
}

/// Checks that the macro proves as much as the command for the same table, if the scene requests a proof.
#[test]
fn where_the_scene_asks() {
    let read = |text: &str| parse_text(text, &SizeLimits::MACRO).expect("a scene");
    for (kind, damping, scalar, accuracy) in [
        ("Wall", "none", "f64", "1e-4"),
        ("Pair", "none", "f32", "1e-4"),
    ] {
        let text = scene(kind, 10, damping, "1.2", scalar);
        let name = format!("{kind}, {damping}");
        let end = text.rfind('}').expect("a scene");
        let with = |proof: &str| {
            let fields = format!("accuracy: {accuracy}, range: {{ r: 0.2..2.5 }}, {proof}");
            read(&format!("{}, {fields} }}", &text[..end]))
        };
        let (quick, whole) = (with(""), with("proof: whole"));
        let source = pretty(&whole).unwrap();
        // The documentation quotes the description, which differs between the scenes, so it is left out.
        let code = |read: &Description| {
            let text = pretty(read).unwrap();
            let lines = text
                .lines()
                .filter(|line| !line.trim_start().starts_with("///"));
            lines.collect::<Vec<_>>().join("\n")
        };
        assert_eq!(code(&quick), code(&with("proof: quick")));
        let [checked, proven] = [quick, whole].map(|read| (read.tables.unwrap(), read.scene));
        let mut by_a_command = checked.0.clone();
        by_a_command.prove(&checked.1, ProofWork::WHOLE);
        let (checked, proven) = (known(&checked.0), known(&proven.0));
        assert_eq!(checked.0[0].evidence, Evidence::Checked, "{name}");
        assert_eq!(proven, known(&by_a_command), "{name}");
        assert_eq!(proven.1, checked.1, "{name}");
        for proof in &proven.0 {
            assert_ne!(proof.evidence, Evidence::Checked, "{name}");
            // A file in f32 prints each r with as few digits as f32 needs.
            let told = match scalar {
                "f32" => proof.told_in::<f32>(),
                _ => proof.told_in::<f64>(),
            };
            assert!(source.contains(&told), "{name}");
        }
    }
}

/// Checks what the macro proves without a request: chains of one to five masses, and damped chains of ten, as far as
/// the command proves them. Among the longer chains it checks those with a contact between two masses.
#[test]
fn unasked() {
    assert_eq!(
        unasked_where(|name| name.starts_with("Pair")
            || name.contains("1,")
            || name.contains("2,")),
        4 + 6 + 2 + 1
    );
}

#[test]
#[ignore = "half a minute: every contact"]
fn unasked_whole() {
    assert_eq!(unasked_where(|_| true), 4 + 6 + 6 + 3);
}

/// Checks the chains whose names `chosen` selects, and returns their number.
fn unasked_where(chosen: impl Fn(&str) -> bool) -> usize {
    let mut seen = 0;
    for (name, text) in scenes("f64") {
        let ten_undamped = name.contains("10,") && !name.contains("modal");
        if ten_undamped || !name.ends_with("1.2") || !chosen(&name) {
            continue;
        }
        let end = text.rfind('}').expect("a scene");
        let text = format!(
            "{}, accuracy: 1e-4, range: {{ r: 0.2..2.5 }} }}",
            &text[..end]
        );
        let read = parse_text(&text, &SizeLimits::MACRO).expect("a scene");
        let (tables, scene) = (read.tables.expect("tables"), read.scene);
        let mut whole = tables.clone();
        whole.prove(&scene, ProofWork::WHOLE);
        assert_eq!(known(&tables), known(&whole), "{name}");
        let ([limit, motion], _) = known(&tables);
        for proof in [limit, motion] {
            assert_ne!(proof.evidence, Evidence::Checked, "{name}");
            assert!(proof.open_length() < 0.01, "{name}: {}", proof.told());
        }
        seen += 1;
    }
    seen
}

/// Checks that without the feature `proof` a macro checks the same table, and refuses `proof: whole` at the value
/// `whole`.
#[test]
fn without_the_feature() {
    let limits = SizeLimits {
        proof: ProofAt::Missing,
        ..SizeLimits::MACRO
    };
    let text = scene("Wall", 2, "modal(0.02)", "1.2", "f64");
    let end = text.rfind('}').expect("a scene");
    let with = |proof: &str| {
        let fields = format!("accuracy: 1e-4,\nrange: {{ r: 0.2..2.5 }},\n{proof}");
        format!("{}, {fields} }}", &text[..end])
    };
    for proof in ["", "proof: quick"] {
        let read = parse_text(&with(proof), &limits).expect("a scene");
        let own = known(&read.tables.expect("tables"));
        let proven = parse_text(&with(proof), &SizeLimits::MACRO).expect("a scene");
        let proven = known(&proven.tables.expect("tables"));
        assert_eq!(own.1, proven.1);
        for (own, proven) in own.0.iter().zip(&proven.0) {
            assert_eq!(own.evidence, Evidence::Checked);
            assert_eq!(proven.evidence, Evidence::Proven);
        }
    }
    let refused = parse_text(&with("proof: whole"), &limits).expect_err("no feature");
    let told = refused.to_string();
    let expected = "`proof: whole` needs the feature `proof` of frictiongen";
    assert!(told.contains(expected), "{told}");
    let line = with("proof: whole").lines().count();
    assert!(told.starts_with(&format!("{line}:8:")), "{told}");
}

/// Checks a byte budget in place of an accuracy. The macro must use no table that can be checked but not proven.
#[test]
fn within_a_budget() {
    let text = scene("Wall", 1, "modal(0.02)", "1", "f64");
    let end = text.rfind('}').expect("a scene");
    let with = |proof: &str| {
        let fields = format!("provide: [limits], budget: 8192, range: {{ r: 0.2..2.5 }}, {proof}");
        let read = parse_text(
            &format!("{}, {fields} }}", &text[..end]),
            &SizeLimits::MACRO,
        );
        match read.expect("a scene").tables.expect("tables") {
            SceneTables::Double(tables) => (tables.request.accuracy, tables.proof.evidence),
            SceneTables::Single(_) => unreachable!("double precision"),
        }
    };
    assert_eq!(with("").1, Evidence::Checked);
    assert_eq!(with("proof: whole"), (1e-6, Evidence::Proven));
}

/// Returns the proofs of β_lim and of the motion, and the numbers of the table as text.
fn known(tables: &SceneTables) -> ([Proof; 2], String) {
    fn of<S: Float>(tables: &Tables<S>) -> ([Proof; 2], String) {
        (
            [tables.proof.clone(), tables.motion_proof.clone()],
            format!("{:?}{:?}", tables.pieces, tables.index),
        )
    }
    match tables {
        SceneTables::Double(tables) => of(tables),
        SceneTables::Single(tables) => of(tables),
    }
}
