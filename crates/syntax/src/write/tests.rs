//! Tests that a written description defines the same scene as the scene from which it was written.

use super::written;
use crate::read_scene;

/// Descriptions that together have every field, and every form of a field.
const EVERY_FIELD: [&str; 12] = [
    "pub struct Plain { masses: { a: 3.27 }, springs: { base - a: 1190.0 }, contact: a - wall, excitation: a,
        provide: [orbit, limits] }",
    "struct Frame { masses: { lower: 0.1 + 0.2, upper: 1e-7 }, springs: { base - lower: 1e9, lower - upper: 1323 / 7 },
        contact: upper - lower, excitation: base, damping: modal[0.010, 0.012], damping_from: base, stiction: 1.2,
        provide: [motion(upper), stuck, simulation, stepper, self_check, limits], scalar: f32, step: 1e-3,
        input: hold, force: { upper } }",
    "struct Tabled { masses: { a: 2 }, springs: { base - a: 50 }, contact: a - base, excitation: a, damping: modal(0.01),
        accuracy: 1e-4, range: { r: 0.2..2.5 }, side: safe, beyond: exact, proof: whole }",
    "struct Fitting { masses: { a: 2 }, springs: { base - a: 50 }, contact: a - base, excitation: a,
        budget: 2048, range: { r: 0.2..2.5, beta: 0..0.7 } }",
    "struct Elastic { masses: { a: 2 }, springs: { base - a: 50, a - wall: 3 }, contact: a - wall, stiffness: 1e5 / 3,
        excitation: a, damping: rayleigh(0.4, 1e-5), provide: [orbit] }",
    "struct Bowed { masses: { string: 0.01 }, springs: { base - string: 1e5 }, contact: string - base,
        excitation: base, friction: stribeck(0.02: 0.5, 0.2: 0.3), provide: [stepper] }",
    "struct Storeys { masses: { f1: 2, f2: 3 }, springs: { base - f1: 5, f1 - f2: 6 },
        contacts: { brace: base - f1 { stiffness: 5e6 }, pads: f1 - f2 { share: 0.6, stiction: 1.2 }, wall_pad: f2 - wall },
        dampers: { f1 - f2: 12.5, base - f1: 1 }, excitation: base, provide: [stuck] }",
    "struct Belt { masses: { a: 2 }, springs: { base - a: 50 }, contacts: { belt: a - wall { speed: -0.2, share: 0.5 } },
        excitation: a, provide: [simulation] }",
    "struct Bumpers { masses: { a: 2, b: 3 }, springs: { base - a: 50, a - b: 7 }, contact: b - wall, stiction: 1.3,
        stops: { bumper: a - b { gap: 0.002, stiffness: 1e6, damping: 50 }, back: b - a { gap: -1e-3, stiffness: 2e6 },
        rigid: b - wall { restitution: 4 / 5, gap: 0.01 } }, constant: { b: -9.81, a: 0 }, excitation: base }",
    "struct Loose { masses: { a: 2 }, contact: a - wall, constant: { a: 3 }, excitation: a }",
    "struct Named { masses: { a: 2 }, springs: { base - a: 50 }, contacts: { pads: a - wall { stiction: 1.3 } },
        excitation: a, damping: modal(0.02) }",
    "struct Springy { masses: { a: 2 }, springs: { base - a: 50 }, contacts: { pads: a - wall { stiffness: 7 } },
        excitation: a }",
];

#[test]
fn reading_what_is_written_returns_the_same_scene() {
    for text in EVERY_FIELD {
        let scene = read_scene(text).unwrap_or_else(|errors| panic!("{errors}\n{text}"));
        let again = written(&scene);
        let read = read_scene(&again).unwrap_or_else(|errors| panic!("{errors}\n{again}"));
        assert_eq!(read, scene, "{again}");
    }
}

#[test]
fn a_description_has_a_line_for_each_field_that_differs_from_its_default() {
    let scene = read_scene(EVERY_FIELD[6]).unwrap();
    assert_eq!(
        written(&scene),
        "struct Storeys {
    masses: { f1: 2.0, f2: 3.0 },
    springs: { base - f1: 5.0, f1 - f2: 6.0 },
    contacts: { brace: base - f1 { stiffness: 5000000.0 }, pads: f1 - f2 { stiction: 1.2, share: 0.6 }, wall_pad: f2 - wall },
    dampers: { f1 - f2: 12.5, base - f1: 1.0 },
    excitation: base,
    provide: [stuck],
}
"
    );
}

#[test]
fn stops_and_constant_forces_are_written_with_what_differs_from_its_default() {
    let scene = read_scene(EVERY_FIELD[8]).unwrap();
    assert_eq!(
        written(&scene),
        "struct Bumpers {
    masses: { a: 2.0, b: 3.0 },
    springs: { base - a: 50.0, a - b: 7.0 },
    contact: b - wall,
    stops: { bumper: a - b { gap: 0.002, stiffness: 1000000.0, damping: 50.0 }, back: b - a { gap: -0.001, stiffness: 2000000.0 }, rigid: b - wall { gap: 0.01, restitution: 0.8 } },
    constant: { b: -9.81, a: 0.0 },
    excitation: base,
    stiction: 1.3,
}
"
    );
    let scene = read_scene(EVERY_FIELD[7]).unwrap();
    assert!(written(&scene).contains("belt: a - wall { share: 0.5, speed: -0.2 }"));
}
