//! Tests that a description is kept as it was written.

use super::{of_text, of_tokens, outdented};

#[test]
fn the_documentation_of_the_struct_is_left_out() {
    let text = "\u{feff}// a file\n/// A frame.\n#[must_use]\npub struct Frame { // of steel\n    /// no\n}\n";
    let expected = "// a file\n#[must_use]\npub struct Frame { // of steel\n    /// no\n}";
    assert_eq!(of_text(text), expected);
}

#[test]
fn tokens_keep_comments_and_layout() {
    let text =
        "#[doc = \"x\"]\n    pub struct Frame {\n        a: 1, // kg\n\n            b: 2,\n    }";
    let tokens = text.parse().expect("tokens");
    let expected = "pub struct Frame {\n    a: 1, // kg\n\n        b: 2,\n}";
    assert_eq!(of_tokens(&tokens), expected);
    assert_eq!(outdented("{ a }"), "{ a }");
}
