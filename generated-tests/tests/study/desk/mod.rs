//! Tests of responses in any regime, curves, maps, states and sweeps.

mod curves;
mod locked;
mod maps;
mod responses;
mod states;
mod sweeps;

use frictiongen::System;

/// Descriptions of chains with every contact, undamped and damped. Some scenes have μ > 1.
const SCENES: [(&str, &str); 7] = [
    (
        "one mass, wall",
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a }",
    ),
    (
        "one mass on its base",
        "struct S { masses: { a: 2 }, springs: { base - a: 3 }, contact: a - base, excitation: base, stiction: 1.2 }",
    ),
    (
        "two masses, wall",
        "struct S { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1.5 }, contact: a - wall, excitation: b }",
    ),
    (
        "two masses, base motion",
        "struct S { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190, a - b: 1323 }, contact: b - wall,
         excitation: base }",
    ),
    (
        "two masses, between them",
        "struct S { masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 }, contact: a - b, excitation: a }",
    ),
    (
        "two masses, damped",
        "struct S { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190, a - b: 1323 }, contact: b - wall,
         excitation: base, damping: modal[0.010, 0.012] }",
    ),
    (
        "five masses, damped",
        "struct S { masses: { a: 1, b: 1, c: 1, d: 1, e: 1 },
         springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 }, contact: c - wall, excitation: base,
         damping: modal(0.02), stiction: 1.3 }",
    ),
];

fn system(text: &str) -> System {
    text.parse().unwrap()
}
