//! Finds the texts in the sources from which messages are made.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::path::{Path, PathBuf};

/// First words of message texts that no description can cause in these tests, each with the reason.
const NEVER_TOLD: [(&str, &str); 4] = [
    (
        "this is not a scene",
        "stands in for a list of errors, were it empty",
    ),
    (
        "`proof: whole` needs the feature `proof`",
        "these tests have the feature; tables/declared/proven.rs reads a scene without it",
    ),
    (
        "a damping ratio of {ratio}",
        "a warning about a valid description, which the tests of `frictiongen check` show",
    ),
    (
        "mode {mode} has a damping ratio",
        "a warning about a valid description, which the tests of `frictiongen check` show",
    ),
];

/// A string literal that is a message or part of one.
pub struct Text {
    /// File that contains the literal.
    pub file: String,
    /// Text of the literal.
    pub text: String,
    /// Pieces of the text between its `{…}`: first if read as a format string, then if read as plain text.
    readings: [Vec<String>; 2],
}

impl Text {
    fn new(file: &str, text: String) -> Self {
        Self {
            file: file.to_owned(),
            readings: [pieces(&text), vec![text.clone()]],
            text,
        }
    }

    /// Returns `true` if a message contains the text.
    pub fn is_part_of(&self, told: &str) -> bool {
        self.readings
            .iter()
            .any(|pieces| rest_after(pieces, told).is_some())
    }

    /// Returns `true` if the text is a whole message.
    pub fn is_whole(&self, told: &str) -> bool {
        self.readings.iter().any(|pieces| {
            let [first, between @ ..] = pieces.as_slice() else {
                return false;
            };
            let Some(rest) = told.strip_prefix(first.as_str()) else {
                return false;
            };
            match between {
                [] => rest.is_empty(),
                [between @ .., last] => {
                    rest_after(between, rest).is_some_and(|rest| rest.ends_with(last.as_str()))
                }
            }
        })
    }
}

/// Returns the rest of the text `told` after all pieces, which must occur in this order. Returns `None` if one is
/// missing.
fn rest_after<'t>(pieces: &[String], told: &'t str) -> Option<&'t str> {
    pieces.iter().try_fold(told, |rest, piece| {
        rest.split_once(piece.as_str()).map(|(_, rest)| rest)
    })
}

/// Splits a format string at its `{…}`.
fn pieces(text: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        let doubled = signs.next_if_eq(&sign).is_some();
        let piece = pieces.last_mut().expect("there is a piece");
        match (sign, doubled) {
            ('{', false) => {
                while signs.next_if(|sign| *sign != '}').is_some() {}
                signs.next();
                pieces.push(String::new());
            }
            ('{' | '}', true) => piece.push(sign),
            (_, doubled) => {
                piece.push(sign);
                if doubled {
                    piece.push(sign);
                }
            }
        }
    }
    pieces
}

/// Returns every text in the sources that is part of a message.
pub fn texts() -> Vec<Text> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut texts: Vec<Text> = Vec::new();
    for folder in [
        "crates/syntax/src",
        "crates/codegen/src",
        "crates/model/src/validate",
    ] {
        let mut files = Vec::new();
        sources(&root.join(folder), &mut files);
        for file in files {
            let name = file
                .strip_prefix(&root)
                .expect("a file of the project")
                .display()
                .to_string();
            let source = std::fs::read_to_string(&file).expect("a source");
            let tokens: TokenStream = source.parse().expect("Rust");
            each_string(tokens, &mut |_, text| {
                if is_message(&name, &text) && !texts.iter().any(|known| known.text == text) {
                    texts.push(Text::new(&name, text));
                }
            });
        }
    }
    texts
}

/// Returns `true` for a text that consists of words and is a message. Texts of emitted code, and of written C, Rust
/// and descriptions, are not messages.
fn is_message(file: &str, text: &str) -> bool {
    let words = text.contains(' ')
        && pieces(text)
            .iter()
            .any(|piece| piece.contains(char::is_alphabetic));
    let outputs = ["/emit/", "/standalone/", "crates/syntax/src/write.rs"];
    let documents = outputs.iter().any(|output| file.contains(output));
    words && !documents && !NEVER_TOLD.iter().any(|(never, _)| text.starts_with(never))
}

fn sources(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        let is_rust = path.extension().is_some_and(|extension| extension == "rs");
        if path.is_dir() {
            sources(&path, files);
        } else if is_rust && !path.ends_with("tests.rs") {
            files.push(path);
        }
    }
    files.sort();
}

/// Visits each string literal outside attributes, and each string literal in `#[error(…)]`. If the literal is the
/// first argument of a macro or function, `visit` also receives the name of the macro or function.
pub fn each_string(tokens: TokenStream, visit: &mut impl FnMut(&str, String)) {
    strings(tokens, "", visit);
}

fn strings(tokens: TokenStream, caller: &str, visit: &mut impl FnMut(&str, String)) {
    let mut word = String::new();
    let mut after_hash = false;
    for (index, token) in tokens.into_iter().enumerate() {
        match token {
            TokenTree::Ident(ident) => word = ident.to_string(),
            TokenTree::Punct(sign) => {
                let sign = sign.as_char();
                after_hash = sign == '#' || (after_hash && sign == '!');
                continue;
            }
            TokenTree::Literal(literal) => {
                if let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string()) {
                    visit(if index == 0 { caller } else { "" }, text.value());
                }
            }
            TokenTree::Group(group) => {
                let is_attribute = after_hash && group.delimiter() == Delimiter::Bracket;
                let mut inside = group.stream().into_iter();
                let is_error =
                    matches!(inside.next(), Some(TokenTree::Ident(name)) if name == "error");
                if !is_attribute || is_error {
                    strings(group.stream(), &word, visit);
                }
            }
        }
        after_hash = false;
    }
}
