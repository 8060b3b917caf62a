//! Scenes whose histories the tests compare.

use frictiongen::{Of, System};

/// One mass on a wall, undamped.
pub const BLOCK: &str = "struct Block {
    masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block }";

/// One mass on a wall, with a modal damping ratio of 0.05.
pub const DAMPED: &str = "struct Block {
    masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block,
    damping: modal(0.05) }";

/// Two masses on a moving base.
pub const SHAKEN: &str = "struct Shaken {
    masses: { a: 1, b: 0.7 }, springs: { base - a: 1, a - b: 2 }, contact: b - base,
    excitation: base, damping: rayleigh(0.05, 0.04), stiction: 1.3 }";

/// Two masses that rub on each other.
pub const BETWEEN: &str = "struct Between {
    masses: { a: 1, b: 2, c: 0.5 },
    springs: { wall - a: 1, a - b: 0.8, b - c: 1.7, c - wall: 0.4 },
    contact: a - b, excitation: c, damping: rayleigh(0.05, 0.06) }";

/// Two storeys on a moving base, the upper one on a wall.
pub const FRAME: &str = "struct Frame {
    masses: { lower: 1, upper: 1.1 }, springs: { base - lower: 1, lower - upper: 1.2 },
    contact: upper - wall, excitation: base, damping: rayleigh(0.03, 0.05), stiction: 1.2 }";

/// Two masses on a moving base, with an elastic contact.
pub const ELASTIC: &str = "struct Elastic {
    masses: { a: 1, b: 0.7 }, springs: { base - a: 1, a - b: 2 }, contact: b - base, stiffness: 1.5,
    excitation: base, damping: rayleigh(0.05, 0.04), stiction: 1.3 }";

/// Scenes of each contact, with points (r, β) in each regime.
pub const SCENES: [(&str, &[(f64, f64)]); 5] = [
    (BLOCK, &[(0.3, 0.4), (0.5, 0.6), (1.4, 0.3)]),
    (DAMPED, &[(0.3, 0.4), (0.8, 0.2), (2.0, 0.1)]),
    (SHAKEN, &[(0.4, 0.2), (0.6, 0.3), (1.1, 0.4)]),
    (BETWEEN, &[(0.4, 0.3), (0.9, 0.1), (1.6, 0.2)]),
    (FRAME, &[(0.3, 0.4), (0.5, 0.5), (0.9, 0.5)]),
];

pub fn system(text: &str) -> System {
    text.parse().expect("a sound scene")
}

/// Returns the contact and every mass.
pub fn all(system: &System) -> Vec<Of> {
    let masses = (0..system.scene().masses.len()).map(Of::Mass);
    std::iter::once(Of::Contact).chain(masses).collect()
}
