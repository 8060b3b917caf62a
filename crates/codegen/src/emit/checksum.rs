//! Checksums of emitted tables. A reviewer sees from the checksum whether a table has changed.

use proc_macro2::{TokenStream, TokenTree};

/// Returns the documentation line with the checksum of a table.
pub(crate) fn about(table: &TokenStream) -> String {
    let mut numbers = Vec::new();
    collect(table, &mut numbers);
    let plural = if numbers.len() == 1 { "" } else { "s" };
    format!(
        " {} number{plural}; CRC-32 of their text, joined by commas: {:08x}.",
        numbers.len(),
        crc(numbers.join(",").as_bytes())
    )
}

/// Collects the texts of all number literals, each with its sign, in the order of the tokens.
fn collect(tokens: &TokenStream, numbers: &mut Vec<String>) {
    let mut negative = false;
    for token in tokens.clone() {
        match &token {
            TokenTree::Literal(literal) => {
                let (sign, text) = (if negative { "-" } else { "" }, literal.to_string());
                // The texts of doc comments are literals too, but they do not begin with a digit.
                if text.starts_with(|first: char| first.is_ascii_digit()) {
                    numbers.push(format!("{sign}{text}"));
                }
            }
            TokenTree::Group(group) => collect(&group.stream(), numbers),
            TokenTree::Ident(_) | TokenTree::Punct(_) => {}
        }
        negative = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '-');
    }
}

/// Returns the CRC-32 of `bytes`, as zip and Ethernet define it.
fn crc(bytes: &[u8]) -> u32 {
    let crc = bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    });
    !crc
}

#[cfg(test)]
mod tests {
    use super::{about, crc};

    /// Checks that the function reproduces the check value of CRC-32 in the catalogue of CRC algorithms.
    #[test]
    fn check_value() {
        assert_eq!(crc(b"123456789"), 0xcbf4_3926);
    }

    #[test]
    fn a_digit_or_a_sign_changes_the_checksum() {
        let of = |text: &str| about(&text.parse().expect("tokens"));
        let table = of("T { a: [1.5, -2.0], b: 3 }");
        assert!(table.starts_with(" 3 numbers;"), "{table}");
        assert!(table.ends_with(&format!("{:08x}.", crc(b"1.5,-2.0,3"))));
        assert_eq!(table, of("T { #[doc = \"2 numbers\"] c: [1.5, -2.0, 3] }"));
        for other in ["1.5, 2.0, 3", "1.5, -2.1, 3", "1.5, 3, -2.0"] {
            assert_ne!(table, of(other));
        }
    }
}
