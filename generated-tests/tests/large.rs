//! Run-time scenes beyond 64 masses, whose modal analysis is in double precision.

use frictiongen::System;
use frictiongen_codegen::{Limits, parse_text};
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

/// Against the double-double analysis of the same scene: frequencies to 1e-13 of themselves, also
/// where masses and stiffnesses spread over eight decades.
#[test]
fn frequencies_and_limits_of_80_masses() {
    for spread in [10.0, 1e8] {
        let text = chain(80, spread);
        let system: System = text.parse().expect("a valid scene");
        let scene = parse_text(&text, &Limits::RUN_TIME)
            .expect("a valid scene")
            .scene;
        let exact = Modal::of(&scene);
        let mut worst: f64 = 0.0;
        for (got, want) in system.resonances().iter().zip(&exact.resonances) {
            worst = worst.max((got / want.to_f64() - 1.0).abs());
        }
        println!("spread {spread:e}: frequencies off by {worst:e}");
        assert!(
            worst < 1e-13,
            "spread {spread:e}: frequencies off by {worst:e}"
        );
    }
    // The limits of 64 masses, and of the same with a mass too light and soft to matter: the contact
    // is beside the load, so that no sum over modes cancels.
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

/// `cargo test --release -p generated-tests --test large -- --ignored --nocapture`
#[test]
#[ignore = "a thousand masses take some seconds"]
fn a_thousand_masses() {
    let text = chain(1000, 10.0);
    let clock = std::time::Instant::now();
    let system: System = text.parse().expect("a valid scene");
    println!("1000 masses: {:.2?}", clock.elapsed());
    let at = system.at(0.5).expect("in the domain");
    let clock = std::time::Instant::now();
    println!(
        "limits {} {} in {:.2?}",
        at.continuous_limit(),
        at.sliding_limit(),
        clock.elapsed()
    );
    assert!(at.continuous_limit() > 0.0);
}
