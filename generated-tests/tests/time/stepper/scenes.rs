//! The scenes of the tests, in SI units.

/// Three masses on a wall, with the same damping ratio in each mode.
pub const WALL: &str = "struct Wall { masses: { a: 2, b: 3, c: 1.5 },
    springs: { base - a: 50, a - b: 40, b - c: 60, c - wall: 20 },
    contact: b - wall, excitation: a, damping: modal(0.02) }";
/// Two masses with Rayleigh damping, the upper one of which rubs on the moving base.
pub const BASE: &str = "struct Base { masses: { low: 0.8, up: 2 },
    springs: { base - low: 100, low - up: 150, up - base: 30 },
    contact: up - base, excitation: base, damping: rayleigh(0.1, 0.002) }";
/// Two masses that rub on each other, with another damping ratio in each mode.
pub const PAIR: &str = "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15 },
    contact: b - a, excitation: a, damping: modal[0.08, 0.03] }";
/// One mass without damping.
pub const ONE: &str = "struct One { masses: { m: 1.5 }, springs: { base - m: 600 },
    contact: m - wall, excitation: m }";
/// One mass on the moving base.
pub const ONE_ON_BASE: &str = "struct OneOnBase { masses: { m: 1.5 }, springs: { base - m: 600 },
    contact: m - base, excitation: base, damping: modal(0.05) }";
/// Two masses on a moving base, with the contact on the wall.
pub const WALL_BASE: &str = "struct WallBase { masses: { a: 1, b: 1 },
    springs: { base - a: 80, a - b: 70 },
    contact: b - wall, excitation: base, damping: modal(0.01) }";

/// Returns the scene with damping that acts on velocities relative to the moving base.
pub fn from_base(text: &str) -> String {
    let body = text.trim_end().strip_suffix('}').expect("a scene");
    format!("{body}, damping_from: base }}")
}

/// Two masses between a moving base and a wall, which rub on each other, with another damping ratio in each mode.
pub const PAIR_BASE: &str = "struct PairBase { masses: { a: 1, b: 2 },
    springs: { base - a: 10, a - b: 15, b - wall: 4 },
    contact: b - a, excitation: base, damping: modal[0.08, 0.03] }";

/// Returns the scene with another μ.
pub fn sticky(text: &str, mu: f64) -> String {
    let body = text.trim_end().strip_suffix('}').expect("a scene");
    format!("{body}, stiction: {mu} }}")
}

/// Ten masses between base and wall, with Rayleigh damping.
pub const TEN: &str = "struct Ten { masses: { m1: 1, m2: 1.2, m3: 0.8, m4: 1, m5: 1.5, m6: 1, m7: 1, m8: 0.7, m9: 1, m10: 1 },
    springs: { base - m1: 100, m1 - m2: 90, m2 - m3: 110, m3 - m4: 100, m4 - m5: 80, m5 - m6: 100, m6 - m7: 120,
        m7 - m8: 100, m8 - m9: 100, m9 - m10: 95 },
    contact: m10 - wall, excitation: m1, damping: rayleigh(0.05, 0.002) }";
