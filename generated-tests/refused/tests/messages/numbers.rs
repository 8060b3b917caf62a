// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_601_missing_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: , upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_602_another_token_for_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: ;, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_604_word_for_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: PI, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_605_quoted_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: "3.27", upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_606_infinity {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: inf, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_607_too_large {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 1e400, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_608_too_small {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 1e-200 * 1e-200, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_609_division_by_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27 / (1 - 1), upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_610_power {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 1.8 ^ 2, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_611_percentage {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 1.2%],
}
}
}

mod case_612_unit {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27 kg, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_613_two_numbers_in_parentheses {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 2 * (1.0, 0.635), upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_614_point_without_a_digit {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: .27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_615_point_without_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: ., upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_616_typed_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27f32, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_617_hexadecimal_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 0x10, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_618_unit_without_a_space {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27kg, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

fn main() {}
