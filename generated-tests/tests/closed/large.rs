//! Run-time scenes beyond 64 masses, whose modal analysis is in double precision.

use frictiongen::System;
use frictiongen_codegen::{SizeLimits, parse_text};
use frictiongen_model::modal::Modal;
use std::fmt::Write;

fn chain(masses: usize, spread: f64) -> String {
    let value = |index: usize| spread.powf(((index * 7919) % 1000) as f64 / 1000.0 - 0.5);
    let mut text = String::from("struct Chain { masses: {");
    for mass in 0..masses {
        write!(text, " m{mass}: {:e},", value(mass)).expect("a string");
    }
    text.push_str("}, springs: { base - m0: 1.0,");
    for mass in 1..masses {
        write!(text, " m{} - m{mass}: {:e},", mass - 1, value(mass + 500)).expect("a string");
    }
    write!(
        text,
        "}}, contact: m1 - wall, excitation: m0, damping: modal(0.02) }}"
    )
    .expect("a string");
    text
}

/// Checks that the modal analysis in double-double gives the same frequencies to a relative 1e-13, even if masses and
/// stiffnesses spread over eight decades.
#[test]
fn frequencies_and_limits_of_80_masses() {
    for spread in [10.0, 1e8] {
        let text = chain(80, spread);
        let system: System = text.parse().expect("a valid scene");
        let scene = parse_text(&text, &SizeLimits::RUN_TIME)
            .expect("a valid scene")
            .scene;
        let exact = Modal::of(&scene);
        let mut worst: f64 = 0.0;
        assert_eq!(
            (system.resonances().len(), exact.resonances.len()),
            (80, 80)
        );
        for (got, want) in system.resonances().iter().zip(&exact.resonances) {
            worst = worst.max((got / want.to_f64() - 1.0).abs());
        }
        println!("spread {spread:e}: frequencies off by {worst:e}");
        assert!(
            worst < 1e-13,
            "spread {spread:e}: frequencies off by {worst:e}"
        );
    }
    // A chain of 64 masses has the same limits as the chain with one more mass that is too light and soft to matter.
    // The contact is next to the load, so no sum over modes cancels.
    let text = chain(64, 10.0);
    let (small, large) = (
        text.clone(),
        text.replace("}, springs", " far: 1.0 }, springs"),
    );
    let large = large.replace("}, contact", " m63 - far: 1e-20 }, contact");
    let small: System = small.parse().expect("a valid scene");
    let large: System = large.parse().expect("a valid scene");
    for r in [0.2, 0.7, 1.9] {
        let small = small.at(r).expect("in the domain").sliding_limit();
        let large = large.at(r).expect("in the domain").sliding_limit();
        assert!(
            (small / large - 1.0).abs() < 1e-10,
            "r = {r}: {small} against {large}"
        );
    }
}

/// Returns a chain of equal masses and springs from the base to a free end, with the contact next to the load.
fn uniform(masses: usize) -> System {
    let mut text = String::from("struct Uniform { masses: {");
    for mass in 0..masses {
        write!(text, " m{mass}: 1,").expect("a string");
    }
    text.push_str("}, springs: { base - m0: 1,");
    for mass in 1..masses {
        write!(text, " m{} - m{mass}: 1,", mass - 1).expect("a string");
    }
    text.push_str("}, contact: m1 - wall, excitation: m0 }");
    text.parse().expect("a valid scene")
}

/// Compares frequencies with 2 sin((2i − 1)π/(4N + 2)), to a relative 1e-13. Compares β*_lim with 1/|2 − r²| of the one
/// mass that stays free while the contact sticks.
fn compare_uniform(masses: usize) {
    let system = uniform(masses);
    assert_eq!(system.resonances().len(), masses);
    let mut worst = 0.0_f64;
    for (index, got) in system.resonances().iter().enumerate() {
        let angle = std::f64::consts::PI * (2 * index + 1) as f64 / (4 * masses + 2) as f64;
        worst = worst.max((got / (2.0 * angle.sin()) - 1.0).abs());
    }
    println!(
        "{masses} masses: {masses} frequencies compared, none skipped; off by {worst:.1e} at most"
    );
    assert!(worst < 1e-13, "frequencies off by {worst:e}");
    for r in [0.5, 1.2, 3.0] {
        let limit = system.at(r).expect("in the domain").sliding_limit();
        let error = (limit * (2.0 - r * r).abs() - 1.0).abs();
        println!("r = {r}: sliding limit off by {error:.1e}");
        // Poles have a relative distance of about 1/N, so an error of 1e-13 in a frequency causes an error of 1e-10
        // near a pole.
        assert!(error < 1e-13 * (10 * masses) as f64, "r = {r}: {error:e}");
    }
}

#[test]
fn a_uniform_chain_of_100_masses() {
    compare_uniform(100);
}

/// Measures chains of a thousand masses. Run it with `cargo test --release -p generated-tests --test closed large:: --
/// --ignored --nocapture`.
#[test]
#[ignore = "a thousand masses take some seconds"]
fn a_thousand_masses() {
    compare_uniform(1000);
    let text = chain(1000, 10.0);
    let clock = std::time::Instant::now();
    let system: System = text.parse().expect("a valid scene");
    println!("1000 different masses: {:.2?}", clock.elapsed());
    let at = system.at(0.5).expect("in the domain");
    let clock = std::time::Instant::now();
    let limits = (at.continuous_limit(), at.sliding_limit());
    println!("limits {limits:?} in {:.2?}", clock.elapsed());
    assert!(limits.0 > 0.0 && limits.0 < limits.1);
}
