//! Shows how a change of the scene, or of frictiongen, changes a user's solver: see docs/firmware.md.

use frictiongen_codegen::{SizeLimits, parse_text, pretty};
use snapshots::{Mount, transmissibility};
use std::fmt::Write;

/// Records the code that the macro emits, as a Rust file that a review page highlights.
#[test]
fn emitted() {
    let text = include_str!("../scenes/mount.friction");
    let description = parse_text(text, &SizeLimits::MACRO).expect("the scene is sound");
    let source = pretty(&description).expect("Rust");
    insta::assert_binary_snapshot!("emitted.rs", source.into_bytes());
}

/// Records important results to nine digits: one point in each regime, and both sides of the first resonance.
#[test]
fn answers() {
    let mut text = String::new();
    let points = [
        (0.3, 0.1),
        (0.5, 0.05),
        (0.5, 0.2),
        (0.9, 0.3),
        (1.1, 0.3),
        (2.0, 1.0),
    ];
    for (r, beta) in points {
        let regime = Mount::at(r)
            .and_then(|at| at.regime(beta))
            .expect("in the domain");
        let amplitude = transmissibility(r, beta).expect("a steady state");
        writeln!(text, "r {r}, β {beta}: {regime:?}, {amplitude:.9}").expect("a string");
    }
    insta::assert_snapshot!(text);
}
