//! Parses the text before the braces of a description: doc comments, attributes, visibility, `struct` and the name.

use frictiongen_model::validate::is_keyword;

use super::fields;
use super::reader::{Name, TokenReader};
use super::syntax::{Attribute, RustPath, Visibility};
use super::token::{Delimiter, Token, TokenKind};
use crate::diagnostics::{Problems, TokenPosition};

const FORM: &str =
    "write `struct Name { masses: { … }, springs: { … }, contact: …, excitation: … }`";

/// Attributes that may precede a description: documentation, lint levels and deprecation. The parser rejects all
/// others, because the macro replaces the struct by several items, and an attribute would apply to only one of them.
const ATTRIBUTES: [&str; 7] = [
    "doc",
    "allow",
    "expect",
    "warn",
    "deny",
    "forbid",
    "deprecated",
];

/// Parses the doc comments and attributes before the struct of a description.
pub(crate) fn attributes(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Vec<Attribute> {
    let mut attributes = Vec::new();
    loop {
        let place = reader.place();
        match reader.peek(0).map(|token| &token.kind) {
            Some(TokenKind::Doc(text)) => {
                reader.next();
                attributes.push(Attribute::Doc {
                    text: text.clone(),
                    place,
                });
            }
            Some(TokenKind::InnerDoc) => {
                reader.next();
                problems.report(
                    place,
                    "an inner doc comment or attribute has no meaning here; write `///` or `#[…]` before `struct`",
                );
            }
            Some(TokenKind::Punct('#')) => {
                reader.next();
                attribute(reader, place, problems, &mut attributes);
            }
            _ => return attributes,
        }
    }
}

/// Parses an attribute after its `#`.
fn attribute(
    reader: &mut TokenReader<'_>,
    place: TokenPosition,
    problems: &mut Problems,
    attributes: &mut Vec<Attribute>,
) {
    if reader.take_punct('!') {
        reader.take_group(Delimiter::Bracket);
        problems.report(
            place,
            "an inner doc comment or attribute has no meaning here; write `///` or `#[…]` before `struct`",
        );
        return;
    }
    let group = reader.peek(0);
    let (Some(group), Some(inside)) = (group, reader.take_group(Delimiter::Bracket)) else {
        problems.report(
            place,
            "`#` means nothing here; a comment begins with `//`, a line of documentation with `///`",
        );
        return;
    };
    let name = match inside.reader.peek(0) {
        Some(Token {
            kind: TokenKind::Word(text),
            ..
        }) => text.as_str(),
        _ => "",
    };
    if !ATTRIBUTES.contains(&name) {
        problems.report(
            place,
            "only doc comments, lint levels and `deprecated` are allowed before a scene; put this attribute on a module around it",
        );
    } else if let Some(reason) = fault(inside.reader) {
        problems.report(place, format!("this attribute cannot be read: {reason}"));
    } else {
        attributes.push(Attribute::Other {
            group: group.clone(),
            place,
        });
    }
}

/// Returns the reason, in the words of `syn`, why the form of an attribute is wrong. The function ignores numbers and
/// comments. It does not check the expression after `=`, because this expression appears only in emitted code.
fn fault(mut reader: TokenReader<'_>) -> Option<&'static str> {
    reader.next();
    let ignored = |token: &&Token| {
        matches!(
            token.kind,
            TokenKind::Number(_) | TokenKind::Doc(_) | TokenKind::InnerDoc
        )
    };
    let mut rest = reader.rest().iter().filter(|token| !ignored(token));
    match (rest.next().map(|token| &token.kind), rest.next()) {
        (Some(TokenKind::Punct('=')), None) => {
            Some("unexpected end of input, expected an expression")
        }
        (None | Some(TokenKind::Punct('=' | ':')), _) | (Some(TokenKind::Group { .. }), None) => {
            None
        }
        _ => Some("unexpected token, expected `]`"),
    }
}

/// Returns true if Rust accepts this path in `pub(path)`, without `in`.
fn is_short(path: &RustPath) -> bool {
    match path.segments.as_slice() {
        [(None, word)] => ["crate", "self", "super"].contains(&word.text.as_str()),
        _ => false,
    }
}

/// Parses the visibility of the struct: `pub`, `pub(crate)`, `pub(in path)` or nothing.
pub(crate) fn visibility(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Visibility {
    let place = reader.place();
    if !is_word(reader, 0, "pub") {
        return Visibility::Inherited;
    }
    reader.next();
    let Some(mut inside) = reader.take_group(Delimiter::Parenthesis) else {
        return Visibility::Public(place);
    };
    let is_in = is_word(&inside.reader, 0, "in");
    if is_in {
        inside.reader.next();
    }
    match fields::path(&mut inside.reader) {
        Some(path) if inside.reader.is_empty() && (is_in || is_short(&path)) => {
            Visibility::Restricted {
                place,
                bracket: inside.place,
                is_in,
                path,
            }
        }
        _ => {
            problems.report(
                inside.place,
                "a visibility is `pub`, `pub(crate)`, `pub(super)` or `pub(in path)`; write one of these",
            );
            Visibility::Public(place)
        }
    }
}

/// Parses `struct Name`. Returns `None` if the text that follows cannot be a description. Returns `Some(None)` if only
/// the name is missing or not usable.
pub(crate) fn name(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Option<Option<Name>> {
    let place = reader.place();
    if is_word(reader, 0, "struct") {
        reader.next();
    } else if reader.is_empty() {
        problems.report(place, format!("there is no scene here; {FORM}"));
        return None;
    } else if fields::begins(reader) {
        problems.report(
            place,
            "the fields of a scene must be inside `struct Name { … }`; write it around them",
        );
        return Some(None);
    } else {
        let found = reader.found();
        let is_kind = reader.is_word(1);
        let is_name = !is_kind && reader.is_word(0);
        problems.report(
            place,
            if is_kind {
                format!("a scene is a `struct`, but here is {found}; write `struct` instead")
            } else if is_name {
                format!("`struct` is missing before {found}; write it there")
            } else {
                format!("a scene begins with `struct`, but here is {found}; {FORM}")
            },
        );
        // The user probably means a struct by `enum Name {` or `Name {`. The parser reports the error and continues.
        if is_kind {
            reader.next();
        } else if !is_name {
            return None;
        }
    }
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = format!(
            "the name of the scene belongs here, not {}; write, for example, `struct Frame`",
            reader.found()
        );
        problems.report(place, message);
        return (!reader.is_empty()).then_some(None);
    };
    if is_keyword(&name.text) || name.text.starts_with("r#") {
        problems.report(
            place,
            format!(
                "`{}` is a keyword of Rust and cannot name a scene; write, for example, `Frame`",
                name.text
            ),
        );
        return Some(None);
    }
    Some(Some(name))
}

fn is_word(reader: &TokenReader<'_>, ahead: usize, word: &str) -> bool {
    matches!(reader.peek(ahead), Some(Token { kind: TokenKind::Word(text), .. }) if text == word)
}
