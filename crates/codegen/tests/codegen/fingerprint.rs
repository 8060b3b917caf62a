//! Tests that the fingerprint in emitted code depends on every field of a scene, and on nothing else.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_codegen::standalone::{Origin, Source, c_source};
use frictiongen_codegen::{SceneTables, SizeLimits, emit, parse_text, pretty};
use std::collections::HashSet;

/// Returns the fingerprint in the code of a description.
fn fingerprint(text: &str) -> String {
    let limits = SizeLimits {
        tables: false,
        ..SizeLimits::CHECK
    };
    let code = emit(&parse_text(text, &limits).expect(text)).to_string();
    let (_, rest) = code.split_once("from scene ").expect("a fingerprint");
    rest.chars().take(16).collect()
}

const SCENE: &str = "struct S { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 }, contact: b - wall, \
    excitation: a, provide: [limits, motion(a), stuck, simulation, stepper], stiction: 1.5 }";

#[test]
fn every_field_counts() {
    let mut seen = HashSet::from([fingerprint(SCENE)]);
    for (from, to) in [
        ("struct S", "struct T"),
        ("a: 1, b: 2 }", "a: 1, b: 3 }"),
        ("a: 1, b: 2 }", "b: 2, a: 1 }"),
        ("base - a: 1", "base - a: 2"),
        ("base - a: 1", "a - base: 1"),
        ("base - a: 1", "wall - a: 1"),
        ("b - wall", "wall - b"),
        ("b - wall", "b - base"),
        ("b - wall", "a - wall"),
        ("excitation: a", "excitation: b"),
        ("excitation: a", "excitation: base"),
        ("excitation: a", "excitation: a, damping: modal(0.1)"),
        ("excitation: a", "excitation: a, damping: modal[0.1, 0.1]"),
        ("excitation: a", "excitation: a, damping: modal[0.1, 0.2]"),
        (
            "excitation: a",
            "excitation: a, damping: rayleigh(0.1, 0.1)",
        ),
        (
            "excitation: a",
            "excitation: a, damping: rayleigh(0.1, 0.2)",
        ),
        ("1.5", "1.6"),
        ("1.5", "1.5, scalar: f32"),
        ("motion(a)", "motion"),
        ("motion(a)", "motion(b)"),
        ("motion(a)", "motion(a, b)"),
        ("motion(a), ", ""),
        ("stuck, ", ""),
        ("stuck", "orbit"),
        ("simulation, ", ""),
        (", stepper", ""),
        (", stepper", ", stepper, self_check"),
        ("1.5", "1.5, accuracy: 1e-4, range: { r: 0.2..2.5 }"),
        ("1.5", "1.5, accuracy: 1e-5, range: { r: 0.2..2.5 }"),
        ("1.5", "1.5, accuracy: 1e-4, range: { r: 0.3..2.5 }"),
        ("1.5", "1.5, accuracy: 1e-4, range: { r: 0.2..2.6 }"),
        (
            "1.5",
            "1.5, accuracy: 1e-4, range: { r: 0.2..2.5, beta: 0..1 }",
        ),
        (
            "1.5",
            "1.5, accuracy: 1e-4, range: { r: 0.2..2.5, beta: 0..2 }",
        ),
        (
            "1.5",
            "1.5, accuracy: 1e-4, range: { r: 0.2..2.5 }, side: safe",
        ),
        (
            "1.5",
            "1.5, accuracy: 1e-4, range: { r: 0.2..2.5 }, beyond: exact",
        ),
        (
            "1.5",
            "1.5, accuracy: 1e-4, range: { r: 0.2..2.5 }, proof: whole",
        ),
        ("1.5", "1.5, budget: 4096, range: { r: 0.2..2.5 }"),
        ("1.5", "1.5, budget: 4097, range: { r: 0.2..2.5 }"),
        ("1.5", "1.5, step: 0.1"),
        ("1.5", "1.5, step: 0.2"),
        ("1.5", "1.5, input: hold"),
        ("1.5", "1.5, force: { b }"),
        (
            "provide: [limits, motion(a), stuck, simulation, stepper]",
            "provide: [stepper], friction: stribeck(0.1: 0.8)",
        ),
        (
            "provide: [limits, motion(a), stuck, simulation, stepper]",
            "provide: [stepper], friction: stribeck(0.1: 0.7)",
        ),
        (
            "provide: [limits, motion(a), stuck, simulation, stepper]",
            "provide: [stepper], friction: stribeck(0.1: 0.8, 0.2: 0.8)",
        ),
        (
            "provide: [limits, motion(a), stuck, simulation, stepper]",
            "provide: [stepper]",
        ),
    ] {
        assert!(SCENE.contains(from), "{from}");
        let changed = fingerprint(&SCENE.replacen(from, to, 1));
        assert!(seen.insert(changed), "{from} -> {to}");
    }
}

/// Checks that each number of a belt, of stops and of constant forces counts, and that a speed of 0 does not.
#[test]
fn stops_and_constant_forces_count() {
    let scene = |fields: &str| {
        format!(
            "struct S {{ masses: {{ a: 1, b: 2 }}, springs: {{ base - a: 1, a - b: 1 }}, excitation: a,
            provide: [stepper], {fields} }}"
        )
    };
    let mut seen = HashSet::new();
    for fields in [
        "contacts: { p: b - wall { share: 2 } }",
        "contacts: { p: b - wall { share: 2, speed: 0.1 } }",
        "contacts: { p: b - wall { share: 2, speed: -0.1 } }",
        "contact: b - wall, dampers: { a - b: 1 }",
        "contact: b - wall, stops: { s: a - b { gap: 1, stiffness: 1 } }",
        "contact: b - wall, stops: { t: a - b { gap: 1, stiffness: 1 } }",
        "contact: b - wall, stops: { s: b - a { gap: 1, stiffness: 1 } }",
        "contact: b - wall, stops: { s: a - b { gap: 2, stiffness: 1 } }",
        "contact: b - wall, stops: { s: a - b { gap: 1, stiffness: 2 } }",
        "contact: b - wall, stops: { s: a - b { gap: 1, stiffness: 1, damping: 1 } }",
        "contact: b - wall, stops: { s: a - b { gap: 1, restitution: 1 } }",
        "contact: b - wall, stops: { s: a - b { gap: 1, restitution: 0 } }",
        "contact: b - wall, constant: { a: 1 }",
        "contact: b - wall, constant: { b: 1 }",
        "contact: b - wall, constant: { a: 2 }",
    ] {
        assert!(seen.insert(fingerprint(&scene(fields))), "{fields}");
    }
    let still = scene("contacts: { p: b - wall { share: 2, speed: 0 } }");
    assert!(seen.contains(&fingerprint(&still)));
}

#[test]
fn the_layout_does_not_count() {
    let same = format!("/// A scene.\npub {}", SCENE.replace(", ", ",\n"))
        .replace("stiction: 1.5", "stiction: 3 / 2, damping: none,");
    assert_eq!(fingerprint(SCENE), fingerprint(&same));
}

/// Checks that the macro's code and the C from the same tables have the same checksum of the table, so that a reader can
/// match them. The macro's line is from its tokens, that of the C from the tables.
#[test]
fn the_table_has_one_checksum() {
    let text = "struct S { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 }, contact: b - wall, \
        excitation: base, damping: modal(0.05), scalar: f32, provide: [limits, motion(b)], \
        accuracy: 1e-2, range: { r: 0.4..2.0 } }";
    let description = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
    let Some(SceneTables::Single(tables)) = &description.tables else {
        panic!("tables in f32");
    };
    let source = Source {
        scene: &description.scene,
        tables,
        origin: Origin {
            description: text,
            command: "test",
        },
    };
    let of = |code: &str| -> String {
        let mut lines = code
            .lines()
            .filter_map(|line| line.split_once("joined by commas: "));
        let (before, sum) = lines.next().expect("a checksum");
        let (_, count) = before
            .split_once(" numbers")
            .map(|(count, _)| count.rsplit_once(' ').unwrap_or_default())
            .expect("a count");
        format!("{count} {}", sum.get(..8).expect("eight digits"))
    };
    let rust = pretty(&description).expect("Rust");
    let (_, rust) = rust.split_once("Tables: numbers alone").expect("tables");
    assert_eq!(of(rust), of(&c_source(&source, "s", None).expect("C")));
}
