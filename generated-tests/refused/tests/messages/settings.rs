// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_501_damping_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: 0.01,
}
}
}

mod case_502_misspelt_damping {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: model[0.010, 0.012],
}
}
}

mod case_503_unknown_damping {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: viscous(0.1),
}
}
}

mod case_504_modal_without_ratios {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal,
}
}
}

mod case_505_modal_with_two_ratios {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal(0.010, 0.012),
}
}
}

mod case_506_rayleigh_without_factors {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: rayleigh,
}
}
}

mod case_507_rayleigh_with_one_factor {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: rayleigh(0.1),
}
}
}

mod case_508_provide_without_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: limits,
}
}
}

mod case_509_misspelt_item {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [limit],
}
}
}

mod case_510_unknown_item {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [everything],
}
}
}

mod case_511_item_that_is_no_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [1],
}
}
}

mod case_512_motion_of_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [motion(1)],
}
}
}

mod case_513_motion_of_the_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [motion(contact)],
}
}
}

mod case_514_motion_of_a_mass_twice {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    provide: [motion(lower, lower)],
}
}
}

mod case_515_accuracy_that_is_a_word {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: good, range: { r: 0.2..2.5 },
}
}
}

mod case_516_range_without_braces {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: 0.2..2.5,
}
}
}

mod case_517_range_of_something_else {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { frequency: 0.2..2.5 },
}
}
}

mod case_518_range_with_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { r: 0.2:2.5 },
}
}
}

mod case_519_range_without_ratios {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { beta: 0..1 },
}
}
}

mod case_520_misspelt_side {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { r: 0.2..2.5 }, side: save,
}
}
}

mod case_521_beyond_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { r: 0.2..2.5 }, beyond: 1,
}
}
}

mod case_522_range_without_a_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { 0.2..2.5 },
}
}
}

mod case_523_range_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    accuracy: 1e-4, range: { r 0.2..2.5 },
}
}
}

mod case_524_damping_by_a_percentage {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: 2 %,
}
}
}

fn main() {}
