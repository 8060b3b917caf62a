//! Exact decimal numbers for labels: digits and a power of ten.

use crate::label::Label;

/// Returns the power of ten of the first digit of a positive number, such as −2 for 0.03.
pub(crate) fn exponent(value: f64) -> i32 {
    let text = format!("{value:e}");
    let after = text.split_once('e').map(|(_, after)| after.parse());
    after.and_then(Result::ok).unwrap_or(0)
}

/// Returns the floating-point number nearest to `digits` times a power of ten.
pub(crate) fn decimal(digits: i64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(0.0)
}

/// Formats `digits` times a power of ten as a label, without trailing zeros.
pub(crate) fn number(digits: i64, power: i32) -> Label {
    let (digits, power) = shortest(digits, power);
    let length = digits.unsigned_abs().to_string().len() as i32;
    if digits == 0 {
        return Label::verbatim("0");
    }
    // The label of a very large or very small number has a power of ten. Such a number has more than five digits before
    // the decimal point, or more than six after it.
    if 5 < power + length || power < -6 {
        return scientific(digits, power);
    }
    let all = digits.unsigned_abs().to_string();
    let text = if 0 <= power {
        format!("{all}{}", "0".repeat(power as usize))
    } else {
        let places = power.unsigned_abs() as usize;
        let all = format!("{all:0>width$}", width = places + 1);
        let (before, after) = all.split_at(all.len() - places);
        format!("{before}.{after}")
    };
    Label::verbatim(&format!("{}{text}", if digits < 0 { "−" } else { "" }))
}

/// Formats `digits` times a power of ten in scientific notation. A factor of 1 before the power is left out.
pub(crate) fn scientific(digits: i64, power: i32) -> Label {
    let (digits, power) = shortest(digits, power);
    let sign = if digits < 0 { "−" } else { "" };
    let all = digits.unsigned_abs().to_string();
    let (first, rest) = all.split_at(1);
    let power = power + rest.len() as i32;
    let point = if rest.is_empty() { "" } else { "." };
    let size = if all == "1" {
        String::new()
    } else {
        format!("{first}{point}{rest}×")
    };
    let minus = if power < 0 { "−" } else { "" };
    Label::new(&format!(
        "{sign}{size}10^{{{minus}{}}}",
        power.unsigned_abs()
    ))
}

fn shortest(mut digits: i64, mut power: i32) -> (i64, i32) {
    while digits != 0 && digits % 10 == 0 {
        digits /= 10;
        power += 1;
    }
    (digits, power)
}

/// Formats the fraction `up`/`down` times π.
pub(crate) fn of_pi(up: i64, down: i64) -> Label {
    let shared = greatest_divisor(up.unsigned_abs(), down.unsigned_abs()).max(1) as i64;
    let (up, down) = (up / shared, down / shared);
    let sign = if up < 0 { "−" } else { "" };
    let size = if up.unsigned_abs() == 1 {
        String::new()
    } else {
        up.unsigned_abs().to_string()
    };
    match (up, down) {
        (0, _) => Label::verbatim("0"),
        (_, 1) => Label::verbatim(&format!("{sign}{size}π")),
        _ => Label::verbatim(&format!("{sign}{size}π/{down}")),
    }
}

fn greatest_divisor(a: u64, b: u64) -> u64 {
    if b == 0 {
        a
    } else {
        greatest_divisor(b, a % b)
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(10, -1).plain(), "1");
        assert_eq!(number(-5, -2).plain(), "−0.05");
        assert_eq!(number(15, -1).plain(), "1.5");
        assert_eq!(number(0, 5).plain(), "0");
        assert_eq!(number(12, 3).plain(), "12000");
        assert_eq!(number(1, -6).plain(), "0.000001");
        assert_eq!(number(-1, 7).plain(), "−107");
    }
}
