//! What is told about fields and their forms.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_codegen::{Limits, parse_text, parse_tokens};

const FRAME: &str = "\
/// A frame.
pub struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 1.2,
}
";

/// The errors of the frame after each first string in it has become the second.
fn errors(changes: &[(&str, &str)]) -> Vec<String> {
    let text = changes.iter().fold(FRAME.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from} is not in the frame");
        text.replacen(from, to, 1)
    });
    let diagnostics = parse_text(&text, &Limits::MACRO).expect_err("the text is faulty");
    // The other door, where it can be entered at all: what is no token never reaches a macro.
    if let Ok(tokens) = text.parse() {
        let failure = parse_tokens(tokens, &Limits::MACRO).expect_err("the tokens are faulty");
        let messages: Vec<_> = failure
            .errors
            .into_iter()
            .map(|error| error.to_string())
            .collect();
        let expected: Vec<_> = diagnostics
            .list
            .iter()
            .map(|one| one.message.clone())
            .collect();
        assert_eq!(messages, expected);
    }
    diagnostics.list.iter().map(ToString::to_string).collect()
}

macro_rules! told {
    ($($name:ident: $changes:tt => $expected:tt)*) => {
        $(#[test]
        fn $name() {
            assert_eq!(errors(&$changes), $expected);
        })*
    };
}

told! {
    a_misspelt_field: [("stiction", "sticton")] => [
        "8:5: a scene has no field `sticton`; did you mean `stiction`?",
    ]
    an_unknown_field: [("stiction: 1.2", "colour: red")] => [
        "8:5: a scene has no field `colour`; the fields are masses, springs, contact, excitation, damping, stiction, scalar, provide, accuracy, crate",
    ]
    a_field_twice: [("stiction: 1.2", "contact: lower - wall")] => [
        "8:5: `contact` is there twice; keep one of the two",
    ]
    a_field_without_a_name: [("stiction: 1.2", "1.2")] => [
        "8:5: the name of a field belongs here, not `1.2`; write, for example, `stiction: 1.2`",
    ]
    a_field_without_a_value: [("upper - wall", "")] => [
        "5:5: the field `contact` has no value; write it after the colon",
    ]
    a_field_without_a_value_and_comma: [("upper - wall,", "")] => [
        "5:5: the field `contact` has no value; write it after the colon",
    ]
    an_equals_sign: [("stiction:", "stiction =")] => [
        "8:14: a colon, not `=`, stands between the name of a field and its value; write `:`",
    ]
    a_missing_colon: [("stiction:", "stiction")] => [
        "8:14: a colon stands between the name of a field and its value, but here is `1.2`; write `:`",
    ]
    a_missing_comma: [("upper - wall,", "upper - wall")] => [
        "6:5: a comma is missing before `excitation`; write `,`",
    ]
    a_comma_too_many: [("upper - wall,", "upper - wall,,")] => [
        "5:27: nothing stands before this comma; delete it",
    ]
    something_after_a_value: [("upper - wall,", "upper - wall - base,")] => [
        "5:27: `-` does not belong here; a comma or the end should follow",
    ]
    no_masses: [("masses: { lower: 3.27, upper: 3.25 },", "")] => [
        "2:12: `Frame` lacks the field `masses`; write, for example, `masses: { m1: 1.0 },`",
    ]
    no_springs: [("springs: { base - lower: 1190.0, lower - upper: 1323.0 },", "")] => [
        "2:12: `Frame` lacks the field `springs`; write, for example, `springs: { base - lower: 1.0 },`",
    ]
    no_contact: [("contact: upper - wall,", "")] => [
        "2:12: `Frame` lacks the field `contact`; write, for example, `contact: lower - wall,`",
    ]
    no_excitation: [("excitation: base,", "")] => [
        "2:12: `Frame` lacks the field `excitation`; write, for example, `excitation: lower,`",
    ]
    masses_in_brackets: [("{ lower: 3.27, upper: 3.25 }", "[3.27, 3.25]")] => [
        "3:13: the masses stand in braces, but here is `[`; write, for example, `{ m1: 1.0, m2: 2.0 }`",
    ]
    springs_in_brackets: [("{ base - lower: 1190.0, lower - upper: 1323.0 }", "[1190.0, 1323.0]")] => [
        "4:14: the springs stand in braces, but here is `[`; write, for example, `{ base - m1: 1.0 }`",
    ]
    a_mass_without_a_name: [("lower: 3.27", "(3.27)")] => [
        "3:15: the name of a mass belongs here, not `(`; write, for example, `m1: 1.0`",
    ]
    a_spring_without_a_node: [("base - lower", "base -")] => [
        "4:22: one side of a spring belongs here, a mass, `base` or `wall`, not `:`; write, for example, `base - m1: 1.0`",
    ]
    a_spring_with_an_arrow: [("base - lower", "base > lower")] => [
        "4:21: a hyphen joins the two sides of a spring, but here is `>`; write, for example, `base - m1: 1.0`",
    ]
    a_spring_with_a_real_arrow: [("base - lower", "base -> lower")] => [
        "4:22: a plain hyphen joins the two sides of a spring; delete `>`",
    ]
    a_contact_without_a_hyphen: [("upper - wall", "upper wall")] => [
        "5:20: a hyphen joins the two sides of the contact, but here is `wall`; write, for example, `m1 - wall`",
    ]
    an_excitation_that_is_no_name: [("excitation: base", "excitation: 1.0")] => [
        "6:17: the excitation is a mass, for a force on it, or `base`, for a base motion, not `1.0`; write, for example, `base`",
    ]
    an_excited_wall: [("excitation: base", "excitation: wall")] => [
        "6:17: a wall never moves; write `base` for a base motion, or a mass for a force on it",
    ]
    a_misspelt_mass: [("upper - wall", "uper - wall")] => [
        "5:14: there is no mass `uper`; did you mean `upper`?",
    ]
    a_misspelt_support: [("upper - wall", "upper - wal")] => [
        "5:22: there is no mass `wal`; did you mean `wall`?",
    ]
    an_unknown_mass: [("upper - wall", "x - wall")] => [
        "5:14: there is no mass `x`; the masses are lower, upper",
    ]
    the_ground: [("upper - wall", "upper - ground")] => [
        "5:22: there is no mass `ground`; a support that never moves is called `wall`, one that moves with the excitation `base`",
    ]
    a_number_for_a_damping: [("modal[0.010, 0.012]", "0.01")] => [
        "7:14: the damping is `none`, `modal(ζ)`, `modal[ζ1, ζ2]` or `rayleigh(a, b)`, not `0.01`; write, for example, `modal(0.01)`",
    ]
    a_misspelt_damping: [("modal", "model")] => [
        "7:14: there is no damping `model`; did you mean `modal`?",
    ]
    an_unknown_damping: [("modal[0.010, 0.012]", "viscous(0.1)")] => [
        "7:14: there is no damping `viscous`; write `none`, `modal(0.01)`, `modal[0.01, 0.02]` or `rayleigh(0.1, 0.001)`",
    ]
    a_modal_damping_without_numbers: [("modal[0.010, 0.012]", "modal")] => [
        "7:14: `modal` needs its damping ratios; write `modal(0.01)` for one in all modes, or `modal[0.01, 0.02]` for one in each",
    ]
    a_modal_damping_with_two_numbers: [("modal[0.010, 0.012]", "modal(0.010, 0.012)")] => [
        "7:14: `modal(…)` takes one damping ratio for all modes, not 2; for one in each write square brackets, `modal[0.01, 0.02]`",
    ]
    a_rayleigh_damping_without_numbers: [("modal[0.010, 0.012]", "rayleigh")] => [
        "7:14: `rayleigh` needs two factors in parentheses; write `rayleigh(a, b)` with C = aM + bK, for example `rayleigh(0.1, 0.001)`",
    ]
    a_rayleigh_damping_with_one_number: [("modal[0.010, 0.012]", "rayleigh(0.1)")] => [
        "7:14: `rayleigh` takes two factors, not 1; write `rayleigh(a, b)` with C = aM + bK, for example `rayleigh(0.1, 0.001)`",
    ]
    an_unknown_scalar: [("stiction: 1.2", "scalar: double")] => [
        "8:13: the scalar is `f64` or `f32`, not `double`; write one of the two",
    ]
    a_provide_without_brackets: [("stiction: 1.2", "provide: limits")] => [
        "8:14: what to provide is a list in square brackets, but here is `limits`; write, for example, `[limits, motion]`",
    ]
    a_misspelt_item: [("stiction: 1.2", "provide: [limit]")] => [
        "8:15: `limit` cannot be provided; did you mean `limits`?",
    ]
    an_unknown_item: [("stiction: 1.2", "provide: [everything]")] => [
        "8:15: `everything` cannot be provided; write some of limits, motion, stuck, orbit, simulation",
    ]
    an_item_that_is_no_name: [("stiction: 1.2", "provide: [1]")] => [
        "8:15: `1` cannot be provided; write some of limits, motion, stuck, orbit, simulation",
    ]
    a_motion_of_an_unknown_mass: [("stiction: 1.2", "provide: [motion(middle)]")] => [
        "8:22: there is no mass `middle`; the masses are lower, upper",
    ]
    a_motion_of_a_number: [("stiction: 1.2", "provide: [motion(1)]")] => [
        "8:22: the name of a mass belongs here, not `1`; write, for example, `motion(m1)`",
    ]
    a_motion_of_the_contact: [("stiction: 1.2", "provide: [motion(contact)]")] => [
        "8:22: the motion in the contact is always provided; delete `contact`",
    ]
    a_motion_of_a_mass_twice: [("stiction: 1.2", "provide: [motion(lower, lower)]")] => [
        "8:29: `lower` is named twice; name it once",
    ]
    an_accuracy: [("stiction: 1.2", "accuracy: good")] => [
        "8:15: no accuracy is built yet but `exact`: write `accuracy: exact`, or leave the field out",
    ]
    a_range: [("stiction: 1.2", "range: { r: 0..1 }, accuracy: 1e-6")] => [
        "8:12: `range` belongs to an accuracy, and none is built yet but `exact`, which holds everywhere: leave the field out",
        "8:35: no accuracy is built yet but `exact`: write `accuracy: exact`, or leave the field out",
    ]
    a_stepper: [("stiction: 1.2", "provide: [stepper, limits]")] => [
        "8:15: `stepper` is not built yet: leave it out; the other items are there",
    ]
    a_crate_that_is_no_path: [("stiction: 1.2", "crate: \"frictiongen\"")] => [
        "8:12: `crate` is the path of the library, not `\"frictiongen\"`; write, for example, `::frictiongen`",
    ]
}
