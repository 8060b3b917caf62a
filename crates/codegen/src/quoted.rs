//! Reads the value of a string literal among the compiler's tokens.

use core::iter::Peekable;
use core::str::Chars;
use proc_macro2::Literal;

/// Returns the value of a string literal, plain or raw. Returns `None` for every other literal.
pub(crate) fn value(literal: &Literal) -> Option<String> {
    let text = literal.to_string();
    if let Some(raw) = text.strip_prefix('r') {
        let inside = raw.trim_start_matches('#').strip_prefix('"')?;
        return Some(inside.trim_end_matches('#').strip_suffix('"')?.to_owned());
    }
    let inside = text.strip_prefix('"')?.strip_suffix('"')?;
    let mut value = String::new();
    let mut rest = inside.chars().peekable();
    while let Some(next) = rest.next() {
        if next == '\\' {
            value.extend(escaped(&mut rest)?);
        } else {
            value.push(next);
        }
    }
    Some(value)
}

/// Reads an escape sequence after its backslash. The outer `None` means that Rust does not have this escape. The inner
/// `None` means that the escape produces no character, because it only continues the line.
#[allow(clippy::option_option, reason = "the two have different meanings")]
fn escaped(rest: &mut Peekable<Chars<'_>>) -> Option<Option<char>> {
    Some(Some(match rest.next()? {
        'n' => '\n',
        'r' => '\r',
        't' => '\t',
        '0' => '\0',
        same @ ('\\' | '\'' | '"') => same,
        'x' => code(&rest.by_ref().take(2).collect::<String>())?,
        'u' => {
            let digits = rest.by_ref().skip(1).take_while(|next| *next != '}');
            code(&digits.filter(|next| *next != '_').collect::<String>())?
        }
        '\n' => {
            while rest.next_if(|next| next.is_ascii_whitespace()).is_some() {}
            return Some(None);
        }
        _ => return None,
    }))
}

fn code(digits: &str) -> Option<char> {
    char::from_u32(u32::from_str_radix(digits, 16).ok()?)
}

#[cfg(test)]
mod tests;
