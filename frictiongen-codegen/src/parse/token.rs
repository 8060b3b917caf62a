//! Defines tokens with positions, from the compiler or from a text.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};

use crate::diagnostics::{Place, Problems};

/// Largest nesting depth of brackets, so that no input can exhaust the stack.
pub(crate) const DEEPEST: usize = 64;

/// The message for brackets that nest too deep.
pub(crate) const TOO_DEEP: &str = "brackets are nested more than 64 deep here; compute the innermost numbers and write their results";

/// A token or a bracketed group of tokens.
#[derive(Clone, Debug)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) place: Place,
}

#[derive(Clone, Debug)]
pub(crate) enum Kind {
    /// A word, which may be a keyword. `text` keeps the `r#` of a raw identifier.
    Word { text: String, ident: Ident },
    /// A number as written.
    Number(String),
    /// A string, a character or a byte, as written.
    Quoted { text: String, literal: Literal },
    /// A single character of punctuation.
    Punct(char),
    /// A bracketed group. Invisible brackets (from `macro_rules!`) count as parentheses.
    Group {
        bracket: Delimiter,
        tokens: Vec<Token>,
        close: Place,
    },
    /// A doc comment on the following item, in a text.
    Doc(String),
    /// A doc comment on the enclosing item, in a text.
    InnerDoc,
}

impl Token {
    /// Returns the description of the token for a message.
    pub(crate) fn describe(&self) -> String {
        match &self.kind {
            Kind::Word { text, .. } | Kind::Number(text) | Kind::Quoted { text, .. } => {
                format!("`{text}`")
            }
            Kind::Punct(sign) => format!("`{sign}`"),
            Kind::Group {
                bracket: Delimiter::Brace,
                ..
            } => "`{`".to_owned(),
            Kind::Group {
                bracket: Delimiter::Bracket,
                ..
            } => "`[`".to_owned(),
            Kind::Group { .. } => "`(`".to_owned(),
            Kind::Doc(_) | Kind::InnerDoc => "a doc comment".to_owned(),
        }
    }

    /// Returns whether this token is the given punctuation.
    pub(crate) fn is_punct(&self, sign: char) -> bool {
        matches!(self.kind, Kind::Punct(own) if own == sign)
    }
}

/// Converts the compiler's tokens. Returns false after reporting that brackets nest too deep.
pub(crate) fn from_stream(
    stream: TokenStream,
    depth: usize,
    out: &mut Vec<Token>,
    problems: &mut Problems,
) -> bool {
    let mut sound = true;
    for tree in stream {
        let place = Place::Span(tree.span());
        match tree {
            TokenTree::Ident(ident) => {
                out.push(Token {
                    kind: Kind::Word {
                        text: ident.to_string(),
                        ident,
                    },
                    place,
                });
            }
            TokenTree::Punct(punct) => out.push(Token {
                kind: Kind::Punct(punct.as_char()),
                place,
            }),
            TokenTree::Literal(literal) => push_literal(literal, place, out),
            TokenTree::Group(group) => sound &= push_group(&group, depth, out, problems),
        }
    }
    sound
}

fn push_literal(literal: Literal, place: Place, out: &mut Vec<Token>) {
    let text = literal.to_string();
    // Another macro may create a negative literal, which no source text can contain.
    let (sign, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest.to_owned()),
        None => (false, text),
    };
    if sign {
        out.push(Token {
            kind: Kind::Punct('-'),
            place,
        });
    }
    let is_number = text.starts_with(|first: char| first.is_ascii_digit());
    let kind = if is_number {
        Kind::Number(text)
    } else {
        Kind::Quoted { text, literal }
    };
    out.push(Token { kind, place });
}

fn push_group(group: &Group, depth: usize, out: &mut Vec<Token>, problems: &mut Problems) -> bool {
    let place = Place::Span(group.span_open());
    if depth >= DEEPEST {
        problems.report(place, TOO_DEEP);
        return false;
    }
    let mut tokens = Vec::new();
    let sound = from_stream(group.stream(), depth + 1, &mut tokens, problems);
    // A group of tokens from `macro_rules!` keeps its invisible brackets only around arithmetic,
    // where they matter.
    let is_sum = || {
        tokens.iter().any(|token| {
            ['+', '-', '*', '/']
                .iter()
                .any(|&sign| token.is_punct(sign))
        })
    };
    if group.delimiter() == Delimiter::None && !is_sum() {
        out.append(&mut tokens);
    } else {
        let bracket = match group.delimiter() {
            Delimiter::None => Delimiter::Parenthesis,
            other => other,
        };
        let close = Place::Span(group.span_close());
        out.push(Token {
            kind: Kind::Group {
                bracket,
                tokens,
                close,
            },
            place,
        });
    }
    sound
}

/// Converts tokens back to the compiler's, for the attributes that `syn` parses. Attributes contain
/// no numbers.
pub(crate) fn to_stream(tokens: &[Token]) -> TokenStream {
    tokens
        .iter()
        .filter_map(|token| {
            let span = token.place.span();
            let mut tree = match &token.kind {
                Kind::Word { ident, .. } => TokenTree::Ident(ident.clone()),
                Kind::Punct(sign) => TokenTree::Punct(Punct::new(*sign, Spacing::Joint)),
                Kind::Quoted { literal, .. } => TokenTree::Literal(literal.clone()),
                Kind::Group {
                    bracket, tokens, ..
                } => TokenTree::Group(Group::new(*bracket, to_stream(tokens))),
                Kind::Number(_) | Kind::Doc(_) | Kind::InnerDoc => return None,
            };
            tree.set_span(span);
            Some(tree)
        })
        .collect()
}
