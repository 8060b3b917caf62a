// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_525_friction_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    friction: 0.3,
}
}
}

mod case_526_misspelt_law {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribek(0.1: 0.8),
}
}
}

mod case_527_unknown_law {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    friction: viscous,
}
}
}

mod case_528_stribeck_without_points {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck,
}
}
}

mod case_529_stribeck_point_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(0.1 0.8),
}
}
}

mod case_530_misspelt_input {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    input: held,
}
}
}

mod case_531_force_in_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    force: [lower],
}
}
}

mod case_532_force_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    force: { 1 },
}
}
}

mod case_533_misspelt_proof {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { r: 0.2..2.5 }, proof: hole,
}
}
}

mod case_534_damping_from_elsewhere {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal(0.01),
    damping_from: wall,
}
}
}

fn main() {}
