//! What is told about numbers.
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
    a_number_that_is_missing: [("3.27", "")] => [
        "3:22: a number is missing here; write, for example, `1.0`",
    ]
    a_number_that_is_another_token: [("3.27", ";")] => [
        "3:22: a number belongs here, not `;`; write, for example, `1.0`",
    ]
    a_word_for_a_number: [("3.27", "PI")] => [
        "3:22: `PI` is not a number, and a description cannot see the value of a constant: write the number itself; numbers are literals joined by `+ - * / ( )`, for example `2.0 * 3.27`",
    ]
    a_number_in_quotation_marks: [("3.27", "\"3.27\"")] => [
        "3:22: a number stands without quotation marks; delete them",
    ]
    infinity: [("3.27", "inf")] => [
        "3:22: `inf` is not finite; write a finite number",
    ]
    a_literal_too_large: [("3.27", "1e400")] => [
        "3:22: this is larger than the largest number of double precision, about 1.8e308; choose other units",
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
    a_product_too_small: [("3.27", "1e-200 * 1e-200")] => [
        "3:29: this is smaller than the smallest number of double precision, about 5e-324; write 0 or choose other units",
    ]
    a_division_by_zero: [("3.27", "3.27 / (1 - 1)")] => [
        "3:27: this divides by zero; write another divisor",
    ]
    a_power_with_a_caret: [("3.27", "2.0 ^ 2")] => [
        "3:26: there are no powers in a number; multiply instead, for example `2.0 * 2.0`",
    ]
    a_power_with_stars: [("3.27", "2.0 ** 2")] => [
        "3:26: there are no powers in a number; multiply instead, for example `2.0 * 2.0`",
    ]
    a_percentage: [("0.012", "1.2%")] => [
        "7:30: a percentage is written as a fraction, for example `0.01` for 1 %",
    ]
    a_unit: [("3.27", "3.27 kg")] => [
        "3:27: `kg` does not belong behind a number: units are not written, any consistent set will do (SI: kg, N/m); delete it",
    ]
    a_unit_in_parentheses: [("3.27", "2 * (3.27 kg)")] => [
        "3:32: `kg` does not belong behind a number: units are not written, any consistent set will do (SI: kg, N/m); delete it",
    ]
    two_numbers_in_parentheses: [("3.27", "(1.0 2.0)")] => [
        "3:27: `2.0` does not belong into a number; delete it",
    ]
    a_comma_in_parentheses: [("3.27", "(1.0, 2.0)")] => [
        "3:26: `,` does not belong into a number; delete it",
    ]
    empty_parentheses: [("3.27", "()")] => [
        "3:23: a number is missing here; write, for example, `1.0`",
    ]
    a_decimal_comma: [("3.27", "3,27")] => [
        "3:24: a mass has a name before its value, for example `m1: 27`; if this is a decimal, write a point, not a comma",
    ]
    a_point_without_a_digit: [("3.27", ".27")] => [
        "3:22: a digit is missing before the point; write `0.27`",
    ]
    a_point_without_a_number: [("3.27", ".")] => [
        "3:22: a number is missing before the point; write, for example, `0.5`",
    ]
    a_typed_number: [("3.27", "3.27f32")] => [
        "3:22: a number bears no type here; write `3.27`, and `scalar: f32` as a field if you need it",
    ]
    a_hexadecimal_number: [("3.27", "0x10")] => [
        "3:22: `0x10` is not a decimal number; write, for example, `12.5` or `1.25e1`",
    ]
    an_exponent_without_digits: [("3.27", "3e")] => [
        "3:22: `3e` is not a decimal number; write, for example, `12.5` or `1.25e1`",
    ]
    parentheses_too_deep: [("3.27", "((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))")] => [
        "3:84: brackets nest more than 64 deep here; work out the innermost numbers and write their results",
    ]
}
