//! Texts that are safe in comments of emitted code.

/// Returns a text that is safe in a comment of Rust. The text contains no control characters, and no characters that
/// change the text direction, which the compiler refuses.
pub(crate) fn rust_text(text: &str) -> String {
    let turns = |letter| matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '\t' => out.push_str("    "),
            _ if letter.is_control() || turns(letter) => out.extend(letter.escape_unicode()),
            _ => out.push(letter),
        }
    }
    out
}
