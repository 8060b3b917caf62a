// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_201_nothing {
frictiongen::friction_system! {
}
}

mod case_202_no_struct {
frictiongen::friction_system! {
Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_203_another_item {
frictiongen::friction_system! {
enum Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_204_something_else {
frictiongen::friction_system! {
17 {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_205_bare_fields {
frictiongen::friction_system! {
masses: { lower: 3.27 },
springs: { base - lower: 1190.0 },
contact: lower - wall,
excitation: lower,
}
}

mod case_206_no_name {
frictiongen::friction_system! {
struct {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_207_name_is_missing_at_the_end {
frictiongen::friction_system! {
struct
}
}

mod case_208_keyword_for_a_scene {
frictiongen::friction_system! {
struct Self {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_209_type_parameters {
frictiongen::friction_system! {
struct Frame<T> {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_210_no_braces {
frictiongen::friction_system! {
struct Frame;
}
}

mod case_211_second_scene {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
struct Other {}
}
}

mod case_212_strange_visibility {
frictiongen::friction_system! {
pub(everyone else) struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_213_attribute_that_acts {
frictiongen::friction_system! {
#[derive(PartialEq)]
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_214_inner_attribute {
frictiongen::friction_system! {
#![allow(dead_code)]
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_215_inner_doc_comment {
frictiongen::friction_system! {
//! Two storeys.
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_216_unreadable_attribute {
frictiongen::friction_system! {
#[doc = ]
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_217_lone_hash {
frictiongen::friction_system! {
# struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_218_doc_comment_inside {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    /// Brass on steel.
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_219_call_around_it {
frictiongen::friction_system! {
friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}
}

mod case_220_attribute_and_more {
frictiongen::friction_system! {
#[doc hidden]
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

fn main() {}
