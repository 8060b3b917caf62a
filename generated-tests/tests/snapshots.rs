//! Snapshots of the emitted source of the scenes in `generated_tests::shown`, for reviewers.

#[path = "snapshots/wrong_digits.rs"]
mod wrong_digits;

use frictiongen_codegen::{SizeLimits, parse_text, pretty};
use generated_tests::shown::SCENES;
use std::fmt::Write;
use std::path::Path;

/// Scenes whose emitted source is kept whole, for reviewers: the smallest one, a stepper, an orbit, tables, and two
/// contacts.
const KEPT: [&str; 5] = [
    "SdofWall",
    "Pushed",
    "Stopping",
    "DeclaredLimits",
    "TwoContacts",
];

/// Compares the source of the scenes in [`KEPT`], and lines, functions and a digest of all others. The test writes all
/// sources into a folder, where `diff` shows what a change of the generator does to them.
#[test]
fn emitted_source() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted");
    std::fs::create_dir_all(&folder).expect("a folder");
    let mut digests = String::new();
    for (name, text) in SCENES.iter().chain(&TABLED).chain([&JOINED]) {
        let description = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
        let source = pretty(&description).expect("emitted Rust");
        std::fs::write(folder.join(format!("{name}.rs")), &source).expect("a file");
        if KEPT.contains(name) {
            // The snapshots are Rust files, so that a page for reviewers highlights them as Rust.
            insta::with_settings!({ description => *text, omit_expression => true }, {
                insta::assert_binary_snapshot!(&format!("{name}.rs"), source.into_bytes());
            });
            continue;
        }
        let functions = source.matches("fn ").count();
        let lines = source.lines().count();
        let digest = fnv1a(source.as_bytes());
        writeln!(
            digests,
            "{name}: {lines} lines, {functions} functions, {digest:016x}"
        )
        .unwrap();
    }
    insta::with_settings!({ description => "the sources are in target/tmp/emitted", omit_expression => true }, {
        insta::assert_snapshot!("digests", digests);
    });
}

/// FNV-1a, 64 bits.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Scenes that declare an accuracy, whose snapshots show their tables.
const TABLED: [(&str, &str); 3] = [
    (
        "DeclaredLimits",
        "/// Two masses and their limits, to a hundredth.
        pub struct DeclaredLimits {
            masses: { lower: 1.0, upper: 1.0 },
            springs: { base - lower: 1.0, lower - upper: 1.0 },
            contact: upper - wall,
            excitation: lower,
            damping: modal(0.05),
            scalar: f32,
            provide: [limits],
            accuracy: 1e-2,
            range: { r: 0.5..2.0 },
        }",
    ),
    (
        "DeclaredMotion",
        "/// One mass and its motion, to a thousandth.
        pub struct DeclaredMotion {
            masses: { block: 1.0 },
            springs: { base - block: 1.0 },
            contact: block - base,
            excitation: base,
            stiction: 1.2,
            accuracy: 1e-3,
            range: { r: 0.5..2.0, beta: 0..2 },
            beyond: exact,
        }",
    ),
    (
        "DeclaredStuck",
        "/// Two masses while their contact is stuck, to a hundredth.
        pub struct DeclaredStuck {
            masses: { lower: 1.0, upper: 1.0 },
            springs: { base - lower: 1.0, lower - upper: 1.0 },
            contact: lower - upper,
            excitation: base,
            damping: modal[0.05, 0.02],
            scalar: f32,
            provide: [limits, stuck],
            accuracy: 1e-2,
            range: { r: 0.5..2.0 },
            proof: whole,
        }",
    ),
];

/// A scene with two contacts and a dashpot.
const JOINED: (&str, &str) = (
    "TwoContacts",
    "/// Two storeys with a brace and pads, under a force on the upper one.
        pub struct TwoContacts {
            masses: { lower: 2000, upper: 1500 },
            springs: { base - lower: 1.5e6, lower - upper: 1.2e6 },
            contacts: {
                brace: base - lower { stiffness: 5.0e6 },
                pads: lower - upper { share: 0.6, stiction: 1.2 },
            },
            dampers: { lower - upper: 1200.0 },
            excitation: upper,
            damping: modal(0.01),
            provide: [stepper, simulation, stuck, orbit],
        }",
);

/// Checks that a change of a description's layout changes only the copy of the description in the documentation.
#[test]
fn emission_is_deterministic() {
    for (_, text) in SCENES {
        let read = |text: &str| {
            let description = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
            let source = pretty(&description).expect("emitted Rust");
            let (before, rest) = source.split_once("/// ```text\n").expect("a description");
            let (_, after) = rest.split_once("/// ```\n").expect("an end");
            format!("{before}{after}")
        };
        let (documentation, scene) = text.split_at(text.find("pub struct").expect("a struct"));
        let spread = scene.replace(',', " ,\n ").replace('{', "\n{ ");
        let spread = format!("{documentation}{spread}");
        assert_eq!(read(text), read(&spread));
    }
}

/// Checks that the emitted source contains no code that a specialisation leaves out.
#[test]
fn specialised_away() {
    let source = |wanted: &str| {
        let (_, text) = SCENES
            .iter()
            .find(|(name, _)| *name == wanted)
            .expect("a scene");
        pretty(&parse_text(text, &SizeLimits::MACRO).expect("a valid scene")).expect("emitted Rust")
    };
    for undamped in [
        "SdofWall",
        "SdofBase",
        "PairWall",
        "PairMasses",
        "Thesis",
        "Single",
    ] {
        let source = source(undamped);
        // Comments and reasons of lints may contain words with the searched letters.
        let is_code = |line: &&str| {
            let line = line.trim_start();
            !["///", "reason", "clippy::"]
                .iter()
                .any(|start| line.starts_with(start))
        };
        let code: Vec<&str> = source.lines().filter(is_code).collect();
        let source = code.join("\n");
        assert!(!source.contains("exp"), "{undamped} has exponentials");
        assert!(!source.contains(".im *"), "{undamped} has imaginary parts");
    }
    for single in ["Single", "LimitsOnly"] {
        assert!(!source(single).contains("f64"), "{single} names f64");
    }
    let limits = source("LimitsOnly");
    assert!(!limits.contains("fn motion(") && !limits.contains("fn stuck("));
    let one = source("OneMotion");
    assert!(one.contains("fn m3(") && !one.contains("fn m1(") && !one.contains("fn stuck("));
    // The scene has three masses and two driven modes.
    let symmetric = source("Symmetric");
    assert!(symmetric.contains("MODES: [Mode<f64>; 2]") && !symmetric.contains("mode_3"));
    assert!(symmetric.contains("RESONANCES: [f64; 3]"));
}
