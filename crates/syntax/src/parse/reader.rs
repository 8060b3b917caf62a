//! Reads the tokens of a bracket in order, and finds the next entry after an error.

use super::token::{Delimiter, Token, TokenKind};
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// A word of a description, with its position.
#[derive(Clone, Debug)]
pub struct Name {
    /// The word, with the `r#` of a raw identifier.
    pub text: String,
    /// The position of the word.
    pub place: TokenPosition,
}

/// The unread tokens in a bracket, or in the whole description.
#[derive(Clone, Copy)]
pub(crate) struct TokenReader<'t> {
    rest: &'t [Token],
    end: TokenPosition,
}

/// Tokens inside a bracket, and the position of the opening bracket.
pub(crate) struct Inside<'t> {
    pub(crate) reader: TokenReader<'t>,
    pub(crate) place: TokenPosition,
}

/// A parsed item. `clean` is false if the reader may not be at the end of the item, because of an error.
pub(crate) struct Read<T> {
    pub(crate) value: Option<T>,
    pub(crate) clean: bool,
}

impl<T> Read<T> {
    pub(crate) fn clean(value: T) -> Self {
        Self {
            value: Some(value),
            clean: true,
        }
    }

    pub(crate) fn lost() -> Self {
        Self {
            value: None,
            clean: false,
        }
    }
}

impl<T> From<Result<T, Reported>> for Read<T> {
    fn from(result: Result<T, Reported>) -> Self {
        result.map_or_else(|Reported| Self::lost(), Self::clean)
    }
}

/// A parsed list. `complete` is true if the parser could read every entry.
pub(crate) struct List<T> {
    pub(crate) entries: Vec<T>,
    pub(crate) complete: bool,
}

impl<'t> TokenReader<'t> {
    pub(crate) fn new(rest: &'t [Token], end: TokenPosition) -> Self {
        Self { rest, end }
    }

    pub(crate) fn peek(&self, ahead: usize) -> Option<&'t Token> {
        self.rest.get(ahead)
    }

    pub(crate) fn next(&mut self) -> Option<&'t Token> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(first)
    }

    pub(crate) fn rest(&self) -> &'t [Token] {
        self.rest
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// Returns the number of unread tokens, by which a caller can check that a function has read any tokens.
    pub(crate) fn left(&self) -> usize {
        self.rest.len()
    }

    /// Returns the position of the next token, or of the closing bracket.
    pub(crate) fn place(&self) -> TokenPosition {
        self.peek(0).map_or(self.end, |token| token.place)
    }

    /// Describes the next token for a message.
    pub(crate) fn found(&self) -> String {
        self.peek(0)
            .map_or_else(|| "the end".to_owned(), Token::describe)
    }

    /// Returns advice about a decimal comma, for an error where a number follows although a name is expected. The
    /// parser reads `1,2` as two entries.
    pub(crate) fn comma_hint(&self) -> &'static str {
        match self.peek(0).map(|token| &token.kind) {
            Some(TokenKind::Number(_)) => {
                "; if this number is a decimal fraction, write a point instead of the comma"
            }
            _ => "",
        }
    }

    pub(crate) fn is_punct(&self, ahead: usize, sign: char) -> bool {
        self.peek(ahead).is_some_and(|token| token.is_punct(sign))
    }

    pub(crate) fn is_word(&self, ahead: usize) -> bool {
        matches!(
            self.peek(ahead),
            Some(Token {
                kind: TokenKind::Word(_),
                ..
            })
        )
    }

    pub(crate) fn take_punct(&mut self, sign: char) -> bool {
        let found = self.is_punct(0, sign);
        if found {
            self.next();
        }
        found
    }

    pub(crate) fn take_word(&mut self) -> Option<Name> {
        let token = self.peek(0)?;
        let TokenKind::Word(text) = &token.kind else {
            return None;
        };
        self.next();
        Some(Name {
            text: text.clone(),
            place: token.place,
        })
    }

    /// If the next token is a bracket of the type `wanted`, returns the tokens inside the bracket.
    pub(crate) fn take_group(&mut self, wanted: Delimiter) -> Option<Inside<'t>> {
        let token = self.peek(0)?;
        match &token.kind {
            TokenKind::Group {
                bracket,
                tokens,
                close,
            } if *bracket == wanted => {
                self.next();
                Some(Inside {
                    reader: TokenReader::new(tokens, *close),
                    place: token.place,
                })
            }
            _ => None,
        }
    }

    /// Reads the colon between a name and its value. If the text has `=` instead of the colon, the function reports the
    /// error and continues.
    pub(crate) fn take_colon(
        &mut self,
        problems: &mut Problems,
        what: &str,
    ) -> Result<(), Reported> {
        if self.take_punct(':') {
            return Ok(());
        }
        let place = self.place();
        if self.take_punct('=') {
            problems.report(
                place,
                format!("a colon, not `=`, must separate {what}; write `:`"),
            );
            return Ok(());
        }
        Err(problems.report(
            place,
            format!(
                "a colon must separate {what}, but here is {}; write `:`",
                self.found()
            ),
        ))
    }

    /// Skips tokens up to the next comma, or up to the start of an entry. `begins` returns true at such a start.
    fn recover(&mut self, begins: impl Fn(&Self) -> bool) {
        while !self.is_empty() && !self.is_punct(0, ',') && !begins(self) {
            self.next();
        }
    }

    /// Skips doc comments and attributes in a position where they have no meaning, and reports an error for each.
    fn skip_attributes(&mut self, problems: &mut Problems) {
        loop {
            let place = self.place();
            let is_doc = matches!(
                self.peek(0),
                Some(Token {
                    kind: TokenKind::Doc(_) | TokenKind::InnerDoc,
                    ..
                })
            );
            let is_attribute = self.is_punct(0, '#');
            if !is_doc && !is_attribute {
                return;
            }
            self.next();
            if is_attribute {
                self.take_punct('!');
                self.take_group(Delimiter::Bracket);
            }
            problems.report(
                place,
                "doc comments and attributes are allowed only before `struct`; write a comment with `//` here",
            );
        }
    }

    /// Parses entries that are separated by commas. After an entry with an error, the function continues with the next
    /// entry. `begins` returns true if an entry begins at the next token although the comma is missing.
    /// `begins_after_error` replaces `begins` after an error that leaves the position of the reader uncertain.
    pub(crate) fn list<T>(
        &mut self,
        problems: &mut Problems,
        begins: impl Fn(&Self) -> bool,
        begins_after_error: impl Fn(&Self) -> bool,
        mut read: impl FnMut(&mut Self, &mut Problems) -> Read<T>,
    ) -> List<T> {
        let mut list = List {
            entries: Vec::new(),
            complete: true,
        };
        loop {
            self.skip_attributes(problems);
            if self.is_empty() {
                return list;
            }
            let left = self.left();
            if self.is_punct(0, ',') {
                problems.report(
                    self.place(),
                    "there is no entry before this comma; delete it",
                );
            } else {
                let entry = read(self, problems);
                list.complete &= entry.value.is_some();
                list.entries.extend(entry.value);
                if !entry.clean {
                    self.recover(&begins_after_error);
                } else if !self.is_empty() && !self.is_punct(0, ',') {
                    if begins(self) {
                        let message =
                            format!("a comma is missing before {}; write `,`", self.found());
                        problems.report(self.place(), message);
                    } else {
                        let message = format!(
                            "{} does not belong after a complete entry; delete it, or write a comma",
                            self.found()
                        );
                        problems.report(self.place(), message);
                        self.next();
                        self.recover(&begins_after_error);
                    }
                }
            }
            self.take_punct(',');
            if self.left() == left {
                self.next();
            }
        }
    }
}
