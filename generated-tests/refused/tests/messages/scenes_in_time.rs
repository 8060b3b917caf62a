// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_753_step_without_a_stepper {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [limits], step: 1e-3, input: hold, force: { lower },
}
}
}

mod case_754_stribeck_without_a_motion_in_time {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    friction: stribeck(0.1: 0.8),
}
}
}

mod case_755_stribeck_beside_closed_forms {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    friction: stribeck(0.1: 0.8),
    provide: [stepper, simulation, motion, orbit],
}
}
}

mod case_756_stribeck_of_no_point {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(),
}
}
}

mod case_757_stribeck_descending {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(0.2: 0.8, 0.1: 0.9),
}
}
}

mod case_758_stribeck_at_rest {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(0: 0.9, 0.1: 0.8),
}
}
}

mod case_759_stribeck_negative {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(0.1: -0.2),
}
}
}

mod case_760_stribeck_above_static {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    stiction: 1.2, friction: stribeck(0.1: 0.8, 1: 1.5),
}
}
}

mod case_761_step_of_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    step: 0,
}
}
}

mod case_762_step_too_short {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    scalar: f32, provide: [stepper], step: 1e-61,
}
}
}

mod case_763_force_on_the_excitation {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: lower,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    force: { lower },
}
}
}

mod case_764_force_twice {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    force: { lower, lower },
}
}
}

mod case_765_accuracy_of_a_stepper {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper], accuracy: 1e-4, range: { r: 0.2..2.5 },
}
}
}

mod case_766_enormous_stribeck_point {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    friction: stribeck(1e70: 1e70),
}
}
}

mod case_767_step_too_long {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [stepper],
    step: 100,
}
}
}

mod case_768_modes_beyond_critical_damping {
frictiongen::friction_system! {
struct Tower {
    masses: { a: 1.0, b: 1.6, c: 2.2, d: 1.3, e: 1.9, f: 1.0, g: 1.6, h: 2.2 },
    springs: {
        base - a: 1.0, a - b: 0.7, b - c: 0.8, c - d: 0.9, d - e: 1.0, e - f: 0.7, f - g: 0.8, g - h: 0.9,
    },
    contact: e - wall,
    excitation: h,
    damping: modal(1.5),
    scalar: f32,
    provide: [simulation],
}
}
}

mod case_769_proof_too_fine {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-9, range: { r: 0.2..2.5 }, proof: whole,
}
}
}

mod case_770_proof_without_an_accuracy {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    proof: whole,
}
}
}

mod case_771_damping_from_a_base_at_rest {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: lower,
    damping: modal(0.01),
    damping_from: base,
}
}
}

mod case_773_stiffness_of_the_contact_is_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 0,
    provide: [orbit, simulation],
}
}
}

mod case_774_stiffness_of_the_contact_loses_digits {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 1e20,
    provide: [orbit, simulation],
}
}
}

mod case_775_elastic_contact_with_stribeck {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
    friction: stribeck(0.1: 0.8),
    provide: [simulation],
}
}
}

mod case_776_tables_with_an_elastic_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
    accuracy: 1e-4,
    range: { r: 0.2..2.5 },
    provide: [orbit],
}
}
}

mod case_777_elastic_contact_without_a_motion {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
}
}
}

mod case_778_limits_of_an_elastic_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
    provide: [orbit, limits],
}
}
}

fn main() {}
