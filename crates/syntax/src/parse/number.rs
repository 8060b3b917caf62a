//! Parses the numbers of a description: literals joined by `+ - * / ( )`, which are evaluated in double precision.

use super::reader::{Read, TokenReader};
use super::token::{Delimiter, Token, TokenKind};
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// A number, and the position at which it begins. The value is `None` if the parser could not read the number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number {
    pub(crate) value: Option<f64>,
    pub(crate) place: TokenPosition,
}

/// Parses a number. If the number has an error, the result has a position but no value.
pub(crate) fn number(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<Number> {
    let place = reader.place();
    let result = sum(reader, problems).and_then(|value| {
        check_after(reader, value, problems)?;
        Ok(value)
    });
    Read {
        value: Some(Number {
            value: result.ok(),
            place,
        }),
        clean: result.is_ok(),
    }
}

fn sum(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Result<f64, Reported> {
    let mut total = product(reader, problems)?;
    loop {
        let place = reader.place();
        if reader.take_punct('+') {
            total = checked(total + product(reader, problems)?, place, problems)?;
        } else if reader.take_punct('-') {
            total = checked(total - product(reader, problems)?, place, problems)?;
        } else {
            return Ok(total);
        }
    }
}

fn product(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Result<f64, Reported> {
    let mut total = signed(reader, problems)?;
    loop {
        let place = reader.place();
        if reader.is_punct(0, '*') && reader.is_punct(1, '*') {
            return Err(problems.report(place, NO_POWERS));
        }
        if reader.take_punct('*') {
            let factor = signed(reader, problems)?;
            total = nonzero(
                total * factor,
                total != 0.0 && factor != 0.0,
                place,
                problems,
            )?;
        } else if reader.take_punct('/') {
            let divisor = signed(reader, problems)?;
            if divisor == 0.0 {
                return Err(problems.report(place, "this divides by zero; write another divisor"));
            }
            total = nonzero(total / divisor, total != 0.0, place, problems)?;
        } else {
            return Ok(total);
        }
    }
}

/// Parses a number with any signs before it. The function reads the signs in a loop, because recursion over a million
/// signs would exhaust the stack.
fn signed(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Result<f64, Reported> {
    let mut negative = false;
    loop {
        if reader.take_punct('-') {
            negative = !negative;
        } else if !reader.take_punct('+') {
            break;
        }
    }
    let value = single(reader, problems)?;
    Ok(if negative { -value } else { value })
}

fn single(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Result<f64, Reported> {
    let place = reader.place();
    if let Some(mut inside) = reader.take_group(Delimiter::Parenthesis) {
        let value = sum(&mut inside.reader, problems)?;
        if !inside.reader.is_empty() {
            check_after(&mut inside.reader, value, problems)?;
            let message = format!(
                "{} does not belong in a number; delete it",
                inside.reader.found()
            );
            return Err(problems.report(inside.reader.place(), message));
        }
        return Ok(value);
    }
    let message = match reader.peek(0).map(|token| &token.kind) {
        Some(TokenKind::Number(text)) => {
            reader.next();
            return literal(text, place, problems);
        }
        Some(TokenKind::Word(text))
            if ["inf", "infinity", "nan", "∞"].contains(&text.to_lowercase().as_str()) =>
        {
            format!("`{text}` is not finite; write a finite number")
        }
        Some(TokenKind::Word(text)) => format!(
            "`{text}` is not a number, and a description cannot use constants of Rust; write the number itself, or literals joined by `+ - * / ( )`, for example `2.0 * 3.27`"
        ),
        Some(TokenKind::Quoted { .. }) => "a number has no quotation marks; delete them".to_owned(),
        Some(TokenKind::Punct('.')) => match reader.peek(1).map(|token| &token.kind) {
            Some(TokenKind::Number(text)) => {
                format!("a digit is missing before the point; write `0.{text}`")
            }
            _ => "a number is missing before the point; write, for example, `0.5`".to_owned(),
        },
        None | Some(TokenKind::Punct(',')) => {
            "a number is missing here; write, for example, `1.0`".to_owned()
        }
        Some(_) => {
            format!(
                "a number belongs here, not {}; write, for example, `1.0`",
                reader.found()
            )
        }
    };
    Err(problems.report(place, message))
}

const NO_POWERS: &str =
    "there are no powers in a number; multiply instead, for example `2.0 * 2.0`";

/// Reports frequent errors directly after the number `value`, such as a unit, each with advice.
fn check_after(
    reader: &mut TokenReader<'_>,
    value: f64,
    problems: &mut Problems,
) -> Result<(), Reported> {
    let Some(Token { kind, place }) = reader.peek(0) else {
        return Ok(());
    };
    let message = match kind {
        TokenKind::Punct('^') => NO_POWERS.to_owned(),
        TokenKind::Punct('%') => format!(
            "a percentage is written as a fraction; write `{}` for {value} %",
            hundredth(value)
        ),
        // A name before a colon or a hyphen begins the next entry, because the comma before the name is missing. The
        // name is not a unit.
        TokenKind::Word(text) if !reader.is_punct(1, ':') && !reader.is_punct(1, '-') => {
            no_unit(text)
        }
        _ => return Ok(()),
    };
    Err(problems.report(*place, message))
}

/// Returns the message for a unit that follows a number.
fn no_unit(unit: &str) -> String {
    format!(
        "`{unit}` does not belong after a number; delete it, because a description has no units (use a consistent set, for example kg and N/m)"
    )
}

/// Returns a number divided by 100. The function shifts the decimal point in the text of the number, so that 7 gives
/// exactly 0.07.
pub(crate) fn hundredth(value: f64) -> f64 {
    format!("{value}e-2").parse().unwrap_or(value / 100.0)
}

/// Splits `1.5mm` into the number and its unit. A unit has only letters, and an exponent such as `e6` is not a unit.
fn unit_of(digits: &str) -> Option<&str> {
    let end = digits.find(|sign: char| sign.is_ascii_alphabetic())?;
    let (number, unit) = digits.split_at_checked(end)?;
    let (number, unit) = match unit.strip_prefix(['e', 'E']) {
        // In `2e6N` the letter e belongs to the exponent, and the unit begins after it.
        Some(rest) => {
            let power = rest.find(|sign: char| sign.is_ascii_alphabetic())?;
            digits.split_at_checked(number.len() + 1 + power)?
        }
        None => (number, unit),
    };
    let letters = unit.chars().all(|sign| sign.is_ascii_alphabetic());
    (letters && number.parse::<f64>().is_ok()).then_some(unit)
}

fn literal(text: &str, place: TokenPosition, problems: &mut Problems) -> Result<f64, Reported> {
    let digits: String = text.chars().filter(|&digit| digit != '_').collect();
    if let Some(end) = ["f32", "f64"].into_iter().find(|end| digits.ends_with(end))
        && !digits.starts_with("0x")
    {
        let bare = digits.strip_suffix(end).unwrap_or(&digits);
        return Err(problems.report(
            place,
            format!("a number has no type here; write `{bare}`, and add the field `scalar: {end}` if you need that type"),
        ));
    }
    let Ok(value) = digits.parse::<f64>() else {
        let message = unit_of(&digits).map_or_else(
            || format!("`{text}` is not a decimal number; write, for example, `12.5` or `1.25e1`"),
            no_unit,
        );
        return Err(problems.report(place, message));
    };
    let mantissa = digits.split(['e', 'E']).next().unwrap_or_default();
    let is_zero = !mantissa.contains(|digit: char| ('1'..='9').contains(&digit));
    nonzero(value, !is_zero, place, problems)
}

/// Reports an error if a computation overflows, or if its nonzero result underflows to zero.
fn nonzero(
    value: f64,
    expected: bool,
    place: TokenPosition,
    problems: &mut Problems,
) -> Result<f64, Reported> {
    if value == 0.0 && expected {
        return Err(problems.report(
            place,
            "this is smaller than the smallest number of double precision, about 5e-324; write 0 or choose other units",
        ));
    }
    checked(value, place, problems)
}

fn checked(value: f64, place: TokenPosition, problems: &mut Problems) -> Result<f64, Reported> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(problems.report(
            place,
            "this is larger than the largest number of double precision, about 1.8e308; choose other units",
        ))
    }
}
