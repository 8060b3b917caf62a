//! Tokens of a description with their positions. The tokens come from the compiler or from a text.

use crate::TokenPosition;

/// Largest depth to which brackets may be nested. Without this limit an input could exhaust the stack.
pub const DEEPEST: usize = 64;

/// The message for brackets that are nested too deeply.
pub const TOO_DEEP: &str = "brackets are nested more than 64 deep here; compute the innermost numbers and write their results";

/// A token of a description, or a group of tokens in brackets.
#[derive(Clone, Debug)]
pub struct Token {
    /// Kind of the token, with its text or its group.
    pub kind: TokenKind,
    /// The position of the token. For a group it is the position of the opening bracket.
    pub place: TokenPosition,
}

/// The kinds of tokens.
#[derive(Clone, Debug)]
pub enum TokenKind {
    /// A word, which may be a keyword. A raw identifier has its `r#`.
    Word(String),
    /// A number, as written in the description.
    Number(String),
    /// A string, a character or a byte.
    Quoted {
        /// The string, character or byte, as written in the description.
        text: String,
        /// The value of a string in a text. For a token of a macro call this value is empty, because the compiler's
        /// token contains the value.
        value: String,
    },
    /// A single character of punctuation.
    Punct(char),
    /// Tokens in brackets.
    Group {
        /// The kind of the group's brackets.
        bracket: Delimiter,
        /// The tokens between the brackets.
        tokens: Vec<Token>,
        /// The position of the closing bracket.
        close: TokenPosition,
    },
    /// A doc comment (`///`) for the item that follows, in a text.
    Doc(String),
    /// A doc comment (`//!`) for the item that contains it, in a text.
    InnerDoc,
}

/// The kinds of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// Round brackets, `( … )`.
    Parenthesis,
    /// Square brackets, `[ … ]`.
    Bracket,
    /// Braces, `{ … }`.
    Brace,
}

impl Token {
    /// Returns the description of the token for a message.
    pub(crate) fn describe(&self) -> String {
        match &self.kind {
            TokenKind::Word(text) | TokenKind::Number(text) | TokenKind::Quoted { text, .. } => {
                format!("`{text}`")
            }
            TokenKind::Punct(sign) => format!("`{sign}`"),
            TokenKind::Group { bracket, .. } => match bracket {
                Delimiter::Brace => "`{`".to_owned(),
                Delimiter::Bracket => "`[`".to_owned(),
                Delimiter::Parenthesis => "`(`".to_owned(),
            },
            TokenKind::Doc(_) | TokenKind::InnerDoc => "a doc comment".to_owned(),
        }
    }

    /// Returns true if this token is the punctuation character `sign`.
    #[must_use]
    pub fn is_punct(&self, sign: char) -> bool {
        matches!(self.kind, TokenKind::Punct(own) if own == sign)
    }
}
