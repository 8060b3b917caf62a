//! Tests of string literals.

use super::*;

/// Compares the values of literals with the values from `syn`, which knows every literal of the language.
#[test]
fn as_syn_reads_them() {
    for text in [
        r#""""#,
        r#""frame.friction""#,
        r##"r"C:\frames""##,
        r####"r##"a"#b"##"####,
        r#""C:\\a\tb\u{1f_600}\x41\'\"\0\r\n""#,
        "\"one \\\n     line\"",
        "\"ä\"",
    ] {
        let literal: Literal = text.parse().expect("a literal");
        let own: syn::LitStr = syn::parse_str(text).expect("a string");
        assert_eq!(value(&literal), Some(own.value()), "{text}");
    }
    for text in ["1.5", "'a'", "b\"a\"", "c\"a\"", "br\"a\""] {
        let literal: Literal = text.parse().expect("a literal");
        assert_eq!(value(&literal), None, "{text}");
    }
}
