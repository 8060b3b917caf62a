//! Prints the time of the macro for scenes of 1, 8 and 64 masses, and for limits from tables with an accuracy of 1e-4
//! for 1 to 10 masses. `scripts/expansion-times` builds this program without optimisation, as a user's build builds
//! the macro.

use frictiongen_codegen::{SceneTables, SizeLimits, emit, parse_text};
use frictiongen_model::modal::Modal;
use frictiongen_model::table::Tables;
use std::fmt::Write;
use std::time::Instant;

fn scene(masses: usize, damping: &str) -> String {
    let mut text = String::from("struct Scene { masses: {");
    for mass in 1..=masses {
        let _ = write!(text, " m{mass}: {},", 1.0 + 0.1 * (mass * 7 % 10) as f64);
    }
    text.push_str("}, springs: { base - m1: 1.0,");
    for mass in 2..=masses {
        let _ = write!(
            text,
            " m{} - m{mass}: {},",
            mass - 1,
            1.0 + 0.1 * (mass * 3 % 10) as f64
        );
    }
    let _ = write!(
        text,
        "}}, contact: m{masses} - wall, excitation: m1, damping: {damping},"
    );
    text.push_str("provide: [limits, motion, stuck] }");
    text
}

fn main() {
    for damping in ["none", "modal(0.01)"] {
        for masses in [1, 8, 64] {
            let text = scene(masses, damping);
            let clock = Instant::now();
            let description = parse_text(&text, &SizeLimits::MACRO).expect("a valid scene");
            let parsed = clock.elapsed();
            let tokens = emit(&description).to_string().len();
            println!(
                "{masses:3} masses, damping {damping:11}: {:8.1?} ({:.1?} to parse), {} kB of tokens",
                clock.elapsed(),
                parsed,
                tokens / 1024
            );
        }
    }
    for damping in ["none", "modal(0.02)"] {
        for masses in [1, 2, 5, 10] {
            told_with_stuck(masses, damping);
            limits_and_proof(masses, damping);
            proven_whole(masses, damping);
        }
    }
}

/// Returns the description of a scene with tables, and with the given `provide` list.
fn tabled(masses: usize, damping: &str, provide: &str) -> String {
    scene(masses, damping).replace(
        "provide: [limits, motion, stuck]",
        &format!("provide: [{provide}], accuracy: 1e-4, range: {{ r: 0.2..2.5 }}"),
    )
}

fn told_with_stuck(masses: usize, damping: &str) {
    let text = tabled(masses, damping, "limits, stuck");
    let clock = Instant::now();
    let description = parse_text(&text, &SizeLimits::MACRO).expect("a valid scene");
    let tokens = emit(&description).to_string().len();
    println!(
        "{masses:3} masses, damping {damping:11}, limits and stuck responses to 1e-4: {:8.1?}, {} kB of tokens",
        clock.elapsed(),
        tokens / 1024
    );
}

fn limits_and_proof(masses: usize, damping: &str) {
    let text = tabled(masses, damping, "limits");
    let clock = Instant::now();
    let description = parse_text(&text, &SizeLimits::MACRO).expect("a valid scene");
    let told = clock.elapsed();
    let Some(SceneTables::Double(tables)) = &description.tables else {
        return;
    };
    let modal = Modal::of(&description.scene);
    let clock = Instant::now();
    let built = Tables::<f64>::build(&modal, tables.request).map(|tables| tables.pieces.len());
    println!(
        "{masses:3} masses, damping {damping:11}, limits to 1e-4: {told:8.1?}, {} by {} evaluations, open {:.1e}; {:.1?} to build {built:?} pieces",
        tables.proof.evidence.word(),
        tables.proof.work.0,
        tables.proof.open_length(),
        clock.elapsed(),
    );
}

/// Prints the time of the macro for a scene that requests the complete proof of its tables.
fn proven_whole(masses: usize, damping: &str) {
    let text = tabled(masses, damping, "limits").replace("2.5 }", "2.5 }, proof: whole");
    let clock = Instant::now();
    let description = parse_text(&text, &SizeLimits::MACRO).expect("a valid scene");
    let told = clock.elapsed();
    let Some(SceneTables::Double(tables)) = &description.tables else {
        return;
    };
    println!(
        "{masses:3} masses, damping {damping:11}, limits to 1e-4 with `proof: whole`: {told:8.1?}, {} evaluations, open {:.1e}",
        tables.proof.work.0,
        tables.proof.open_length(),
    );
}
