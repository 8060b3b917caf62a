//! Tests further causes of messages in the catalogue (`generated-tests/tests/messages`): a nested comment, a second
//! position, the other bound of a range.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_codegen::{SizeLimits, parse_text, parse_tokens};

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

/// Returns the errors of the frame after the first string of each pair is replaced by the second.
fn errors(changes: &[(&str, &str)]) -> Vec<String> {
    let text = changes.iter().fold(FRAME.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from} is not in the frame");
        text.replacen(from, to, 1)
    });
    let diagnostics = parse_text(&text, &SizeLimits::MACRO).expect_err("the text is faulty");
    // A text that does not consist of Rust tokens never reaches the token parser.
    if let Ok(tokens) = text.parse() {
        let failure = parse_tokens(tokens, &SizeLimits::MACRO).expect_err("the tokens are faulty");
        let errors = failure.errors.list.into_iter();
        let messages: Vec<_> = errors.map(|(_, message)| message).collect();
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
    a_comment_that_does_not_close: [("stiction", "/* /* */ stiction")] => [
        "8:5: this comment is never closed; write `*/` where it ends",
    ]
    a_stray_sign: [("3.27", "3.27 \\\\")] => [
        "3:27: `\\` means nothing in a scene; delete it",
        "3:28: `\\` means nothing in a scene; delete it",
    ]
    a_field_without_a_value_and_comma: [("upper - wall,", "")] => [
        "5:5: the field `contact` has no value; write it after the colon",
    ]
    an_abbreviated_field: [("damping:", "damp:")] => [
        "7:5: a scene has no field `damp`; did you mean `damping`?",
    ]
    a_misspelt_support: [("upper - wall", "upper - wal")] => [
        "5:22: there is no mass `wal`; did you mean `wall`?",
    ]
    a_motion_of_an_unknown_mass: [("stiction: 1.2", "provide: [motion(middle)]")] => [
        "8:22: there is no mass `middle`; the masses are lower, upper",
    ]
    a_range: [("stiction: 1.2", "range: { r: 0..1 }, accuracy: 1e-6")] => [
        "8:17: a range a..b of frequency ratios needs 0 < a < b, both finite, not 0.0..1.0; write, for example, `r: 0.2..2.5`",
    ]
    a_literal_too_small: [("3.27", "1e-400")] => [
        "3:22: this is smaller than the smallest number of double precision, about 5e-324; write 0 or choose other units",
    ]
    a_sum_too_large: [("3.27", "1.7e308 + 1e308")] => [
        "3:30: this is larger than the largest number of double precision, about 1.8e308; choose other units",
    ]
    a_product_too_large: [("3.27", "1e200 * 1e200")] => [
        "3:28: this is larger than the largest number of double precision, about 1.8e308; choose other units",
    ]
    a_power_with_stars: [("3.27", "2.0 ** 2")] => [
        "3:26: there are no powers in a number; multiply instead, for example `2.0 * 2.0`",
    ]
    a_unit_in_parentheses: [("3.27", "2 * (3.27 kg)")] => [
        "3:32: `kg` does not belong after a number; delete it, because a description has no units (use a consistent set, for example kg and N/m)",
    ]
    two_numbers_in_parentheses: [("3.27", "(1.0 2.0)")] => [
        "3:27: `2.0` does not belong in a number; delete it",
    ]
    empty_parentheses: [("3.27", "()")] => [
        "3:23: a number is missing here; write, for example, `1.0`",
    ]
    an_exponent_without_digits: [("3.27", "3e")] => [
        "3:22: `3e` is not a decimal number; write, for example, `12.5` or `1.25e1`",
    ]
    a_negative_mass: [("3.27", "-3.27")] => [
        "3:22: the mass `lower` is -3.27: a mass must be greater than zero; write a positive number, or leave the mass out",
    ]
    a_stiffness_of_zero: [("1323.0", "0")] => [
        "4:53: the spring `lower - upper` has the stiffness 0.0: a stiffness must be greater than zero; write a positive number, or leave the spring out",
    ]
    a_tiny_stiffness: [("1323.0", "1e-61")] => [
        "4:53: the stiffness of `lower - upper` is 1e-61, which is not between 1e-60 and 1e60; choose other units, or another number",
    ]
    springs_side_by_side_of_unknown_sum: [("lower - upper: 1323.0", "lower - upper: 1000.0, upper - lower: x")] => [
        "4:61: there is already a spring between `upper` and `lower`; parallel springs act as one, so add their stiffnesses and write a single spring",
        "4:76: `x` is not a number, and a description cannot use constants of Rust; write the number itself, or literals joined by `+ - * / ( )`, for example `2.0 * 3.27`",
    ]
    too_many_damping_ratios: [("[0.010, 0.012]", "[0.010, 0.012, 0.013]")] => [
        "7:34: a damping list needs one ratio for each mode, here 2, not 3; write `modal(0.01)` for the same ratio in every mode",
    ]
    an_enormous_damping: [("0.012", "1e61")] => [
        "7:27: a modal damping ratio is 1e61, which is not between 1e-60 and 1e60; choose other units, or another number",
    ]
}
