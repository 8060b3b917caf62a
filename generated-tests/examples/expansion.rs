//! How long the macro takes for scenes of 1, 8 and 64 masses.  `scripts/expansion-times` builds it as
//! a user's build builds the macro, without optimisation.

use frictiongen_codegen::{Limits, emit, parse_text};
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
            let description = parse_text(&text, &Limits::MACRO).expect("a valid scene");
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
}
