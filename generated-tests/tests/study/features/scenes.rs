//! Defines scenes by name, and random scenes.

use frictiongen::System;
use fuzzing::Random;
use std::fmt::Write;

/// Returns a chain of masses m1, m2, … that begins at the base.
pub fn chain(
    masses: &[f64],
    springs: &[f64],
    contact: &str,
    excitation: &str,
    rest: &str,
) -> System {
    let text = text(masses, springs, contact, excitation, rest);
    text.parse()
        .unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn text(masses: &[f64], springs: &[f64], contact: &str, excitation: &str, rest: &str) -> String {
    let mut text = String::from("struct Chain { masses: { ");
    for (i, mass) in masses.iter().enumerate() {
        let _ = write!(text, "m{}: {mass:?}, ", i + 1);
    }
    text.push_str("}, springs: { ");
    for (i, spring) in springs.iter().enumerate() {
        let below = if i == 0 {
            "base".to_owned()
        } else {
            format!("m{i}")
        };
        let _ = write!(text, "{below} - m{}: {spring:?}, ", i + 1);
    }
    let _ = write!(
        text,
        "}}, contact: {contact}, excitation: {excitation}, {rest} }}"
    );
    text
}

pub fn unit(n: usize, contact: &str, excitation: &str) -> System {
    chain(&vec![1.0; n], &vec![1.0; n], contact, excitation, "")
}

/// Returns a random scene of 1 to `most` masses with every contact, both excitations, and μ = 1 or larger.
pub fn random(random: &mut Random, most: usize, damped: bool) -> System {
    let n = 1 + random.below(most);
    let mut draw = || -> Vec<f64> { (0..n).map(|_| random.log_uniform(0.3, 3.0)).collect() };
    let (masses, springs) = (draw(), draw());
    let own = 1 + random.below(n);
    let contact = match random.below(3) {
        0 => format!("m{own} - wall"),
        1 => format!("m{own} - base"),
        _ if 1 < n => {
            let other = 1 + (own + random.below(n - 1)) % n;
            format!("m{own} - m{other}")
        }
        _ => "m1 - wall".to_owned(),
    };
    let excitation = if random.once_in(2) {
        "base".to_owned()
    } else {
        format!("m{}", 1 + random.below(n))
    };
    let mut rest = String::new();
    if damped {
        let zeta = random.log_uniform(1e-3, 0.2);
        let _ = write!(rest, "damping: modal({zeta:?}), ");
    }
    if random.once_in(2) {
        let _ = write!(rest, "stiction: {:?}", random.between(1.0, 2.0));
    }
    chain(&masses, &springs, &contact, &excitation, &rest)
}

/// Returns the description of a scene for the message of a failed test.
pub fn shown(system: &System) -> String {
    format!("{:?}", system.scene())
}
