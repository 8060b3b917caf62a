//! What is told about scenes that make no physical sense.
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
    no_mass: [("{ lower: 3.27, upper: 3.25 }", "{}")] => [
        "3:13: a scene needs at least one mass: write, for example, `m1: 1.0`",
    ]
    no_spring: [("{ base - lower: 1190.0, lower - upper: 1323.0 }", "{}")] => [
        "4:14: a scene needs at least one spring to hold its masses: write, for example, `base - m1: 1.0`",
    ]
    a_keyword_for_a_mass: [("upper: 3.25", "upper: 3.25, type: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: `type` is a keyword of Rust and cannot name a mass; write, for example, `type_1`",
    ]
    a_reserved_word_for_a_mass: [("upper: 3.25", "upper: 3.25, contact: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: `contact` already means something else in a scene or in its results and cannot name a mass; write, for example, `contact_1`",
    ]
    a_method_for_a_mass: [("lower - upper: 1323.0", "lower - upper: 1.0, base - amplitude: 1.0"), ("upper: 3.25", "upper: 3.25, amplitude: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: `amplitude` already means something else in a scene or in its results and cannot name a mass; write, for example, `amplitude_1`",
    ]
    a_raw_name: [("upper: 3.25", "upper: 3.25, r#type: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: `r#type` cannot name a mass: leave the `r#` out, and choose a name that is not a keyword of Rust",
    ]
    two_masses_of_one_name: [("upper: 3.25", "upper: 3.25, lower: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: two masses are called `lower`; give this one a name of its own",
    ]
    a_mass_of_zero: [("3.27", "0")] => [
        "3:22: the mass `lower` is 0.0: a mass must be greater than zero; write a positive number, or leave the mass out",
    ]
    a_negative_mass: [("3.27", "-3.27")] => [
        "3:22: the mass `lower` is -3.27: a mass must be greater than zero; write a positive number, or leave the mass out",
    ]
    an_enormous_mass: [("3.27", "1e61")] => [
        "3:22: the mass `lower` is 1e61, too far from one for double precision; choose units that bring it between 1e-60 and 1e60",
    ]
    a_stiffness_of_zero: [("1323.0", "0")] => [
        "4:53: the spring `lower - upper` has the stiffness 0.0: a stiffness must be greater than zero; where there is no spring, leave it out",
    ]
    a_tiny_stiffness: [("1323.0", "1e-61")] => [
        "4:53: the stiffness of `lower - upper` is 1e-61, too far from one for double precision; choose units that bring it between 1e-60 and 1e60",
    ]
    a_spring_to_itself: [("lower - upper: 1323.0", "lower - upper: 1323.0, upper - upper: 1.0")] => [
        "4:69: this spring joins `upper` to itself and never stretches; join it to another mass, to `base` or to `wall`",
    ]
    a_spring_between_supports: [("lower - upper: 1323.0", "lower - upper: 1323.0, base - wall: 1.0")] => [
        "4:61: this spring joins two supports and touches no mass; leave it out, or join one of its ends to a mass",
    ]
    springs_side_by_side: [("lower - upper: 1323.0", "lower - upper: 1000.0, upper - lower: 323.0")] => [
        "4:61: there is already a spring between `upper` and `lower`; springs side by side act as one, so add them up and write a single spring of 1323.0",
    ]
    springs_side_by_side_of_unknown_sum: [("lower - upper: 1323.0", "lower - upper: 1000.0, upper - lower: x")] => [
        "4:61: there is already a spring between `upper` and `lower`; springs side by side act as one, so add them up and write a single spring",
        "4:76: `x` is not a number, and a description cannot see the value of a constant: write the number itself; numbers are literals joined by `+ - * / ( )`, for example `2.0 * 3.27`",
    ]
    a_mass_that_nothing_holds: [("lower - upper", "lower - wall")] => [
        "3:28: nothing holds the mass `upper`: no springs lead from it to `base` or `wall`, so it would drift away; add, for example, `base - upper: 1.0`",
    ]
    masses_that_nothing_holds: [("base - lower: 1190.0, ", "")] => [
        "3:15: nothing holds the mass `lower` and those joined to it (`upper`): no springs lead from them to `base` or `wall`, so they would drift away; add, for example, `base - lower: 1.0`",
    ]
    a_contact_with_itself: [("upper - wall", "upper - upper")] => [
        "5:22: the contact rubs `upper` on itself; name two different sides, for example `upper - wall`",
    ]
    a_contact_between_supports: [("upper - wall", "base - wall")] => [
        "5:14: the contact lies between two supports; one of its sides must be a mass",
    ]
    a_base_that_moves_nothing: [("base - lower", "wall - lower")] => [
        "6:17: the base moves, but no spring joins a mass to it, so nothing is excited; join a spring to `base`, or put a force on a mass",
    ]
    a_contact_that_a_force_never_reaches: [("lower - upper", "wall - upper"), ("excitation: base", "excitation: lower")] => [
        "5:14: the contact `upper - wall` can never slide: no springs lead to it from the mass `lower`, where the force acts, except through a support; join them by a spring, or move the contact or the excitation",
    ]
    a_contact_that_the_base_never_reaches: [("lower - upper", "wall - upper")] => [
        "5:14: the contact `upper - wall` can never slide: no springs lead to it from the moving base except through a support; join them by a spring, or move the contact or the excitation",
    ]
    a_mass_called_wall: [("upper: 3.25", "upper: 3.25, wall: 1.0"), ("modal[0.010, 0.012]", "none")] => [
        "3:41: `wall` already means something else in a scene or in its results and cannot name a mass; write, for example, `wall_1`",
    ]
    too_few_damping_ratios: [("[0.010, 0.012]", "[0.010]")] => [
        "7:14: a damping list holds one ratio for each mode, here 2, not 1; or write `modal(0.01)` for the same in every mode",
    ]
    too_many_damping_ratios: [("[0.010, 0.012]", "[0.010, 0.012, 0.013]")] => [
        "7:34: a damping list holds one ratio for each mode, here 2, not 3; or write `modal(0.01)` for the same in every mode",
    ]
    a_negative_damping_ratio: [("0.012", "-0.012")] => [
        "7:27: a modal damping ratio is -0.012: negative damping would feed energy in; write zero or more",
    ]
    a_negative_rayleigh_factor: [("modal[0.010, 0.012]", "rayleigh(0.1, -0.1)")] => [
        "7:28: the factor of the stiffness matrix is -0.1: negative damping would feed energy in; write zero or more",
    ]
    an_enormous_damping: [("0.012", "1e61")] => [
        "7:27: a modal damping ratio is 1e61, too far from one for double precision; choose units that bring it between 1e-60 and 1e60",
    ]
    a_stiction_below_one: [("1.2,", "0.8,")] => [
        "8:15: the stiction μ is 0.8, but static friction is never smaller than kinetic; write 1 or more",
    ]
    an_enormous_stiction: [("1.2,", "1e61,")] => [
        "8:15: μ is 1e61, too far from one for double precision; choose units that bring it between 1e-60 and 1e60",
    ]
    nothing_to_provide: [("stiction: 1.2", "provide: []")] => [
        "8:14: an empty list provides nothing; write, for example, `[limits, motion]`",
    ]
    an_item_twice: [("stiction: 1.2", "provide: [motion, limits, motion(lower)]")] => [
        "8:31: `motion` is asked for twice; name it once",
    ]
    a_motion_of_nothing: [("stiction: 1.2", "provide: [motion()]")] => [
        "8:15: `motion()` names no mass; write `motion` for all masses, or name some in the parentheses",
    ]
}
