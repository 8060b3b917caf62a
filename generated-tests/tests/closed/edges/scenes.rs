//! Defines scenes, frequency ratios, and neighbouring numbers of a scalar type, for tests of accuracy at extremes.

use frictiongen::study::System;
use frictiongen_kernel::Float;

/// Scenes of 1 to 5 masses, with contacts to wall, base and mass. They are undamped, or have modal damping
/// (under-critical, critical, over-critical, or mixed with none) or Rayleigh damping, with μ = 1 and above.
pub const SCENES: &[(&str, &str)] = &[
    (
        "block",
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a, }",
    ),
    (
        "block on base",
        "struct A { masses: { a: 2.0 }, springs: { base - a: 50.0 }, contact: a - base,
         excitation: base, stiction: 1.3, }",
    ),
    (
        "light block",
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a,
         damping: modal(0.05), stiction: 1.2, }",
    ),
    (
        "critical block on base",
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - base,
         excitation: base, damping: modal(1), stiction: 1.1, }",
    ),
    (
        "over-damped block",
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a,
         damping: modal(1.5), }",
    ),
    (
        "pair",
        "struct A { masses: { a: 1.0, b: 1.0 }, springs: { base - a: 1.0, a - b: 1.0 },
         contact: b - wall, excitation: a, }",
    ),
    (
        "pair on base",
        "struct A { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190.0, a - b: 1323.0 },
         contact: a - base, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, }",
    ),
    (
        "rubbing pair",
        "struct A { masses: { a: 1.0, b: 0.5 }, springs: { base - a: 1.0, a - b: 0.5 },
         contact: a - b, excitation: a, stiction: 1.2, }",
    ),
    (
        "absorber",
        "struct A { masses: { a: 1.0, b: 0.3 }, springs: { base - a: 1.0, a - b: 0.2 },
         contact: a - wall, excitation: a, stiction: 1.4, }",
    ),
    (
        "three",
        "struct A { masses: { a: 1.0, b: 1.0, c: 1.0 },
         springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0 }, contact: b - wall, excitation: a, }",
    ),
    (
        "braced three",
        "struct A { masses: { a: 1.0, b: 0.4, c: 1.7 },
         springs: { base - a: 1.0, a - b: 0.34, b - c: 0.8, a - wall: 0.41, base - c: 0.25 },
         contact: c - wall, excitation: base, damping: rayleigh(0.0037, 0.17), stiction: 1.5, }",
    ),
    (
        "symmetric three",
        "struct A { masses: { a: 1.0, b: 1.0, c: 1.0 },
         springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - wall: 1.0 }, contact: b - wall,
         excitation: a, }",
    ),
    (
        "mixed four",
        "struct A { masses: { a: 1.0, b: 2.0, c: 0.7, d: 1.3 },
         springs: { base - a: 1.0, a - b: 0.4, b - c: 1.5, c - d: 0.9 }, contact: b - d,
         excitation: base, damping: modal[0, 0.01, 1, 2], stiction: 1.3, }",
    ),
    (
        "undamped five",
        "struct A { masses: { a: 1.0, b: 0.883, c: 0.183, d: 1.57, e: 2.43 },
         springs: { base - a: 1.0, a - b: 0.381, b - c: 0.685, c - d: 0.209, d - e: 0.187 },
         contact: c - e, excitation: base, stiction: 2.0, }",
    ),
    (
        "damped five",
        "struct A { masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
         springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
         contact: a - wall, excitation: e, damping: modal(0.01), }",
    ),
];

/// Reads a scene as a system in the precision `S`.
pub fn system<S: Float>(text: &str) -> System<S> {
    text.parse().expect("a valid scene")
}

/// A scalar type whose numbers have a next larger and a next smaller number.
pub trait Rounded: Float {
    fn up(self) -> Self;
    fn down(self) -> Self;
}

impl Rounded for f64 {
    fn up(self) -> Self {
        self.next_up()
    }
    fn down(self) -> Self {
        self.next_down()
    }
}

impl Rounded for f32 {
    fn up(self) -> Self {
        self.next_up()
    }
    fn down(self) -> Self {
        self.next_down()
    }
}

/// Returns the ratios √λ/n, n = 1 … 9, which are resonances and odd and even subharmonics. With each ratio come its
/// two neighbouring numbers, and ratios at relative distances down to the rounding unit of the scalar type. The list
/// also has some ratios between resonances, and some far away from them.
pub fn ratios<S: Rounded>(resonances: &[S]) -> Vec<S> {
    let mut ratios: Vec<S> = [1e-3, 0.17, 0.83, 1.37, 40.0].map(S::constant).into();
    for pole in resonances {
        for n in 1..=9 {
            let on = *pole / S::constant(f64::from(n));
            ratios.extend([on, on.up(), on.down()]);
            let mut distance = 4.0 * S::EPSILON;
            while distance < 0.1 {
                for side in [-1.0, 1.0] {
                    ratios.push(on * S::constant(1.0 + side * distance));
                }
                distance *= 11.0;
            }
        }
    }
    ratios
}
