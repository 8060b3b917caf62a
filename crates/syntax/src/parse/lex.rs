//! Splits the text of a description into tokens.
//!
//! The module does not use the compiler's lexer. Within a macro, that lexer gives every token of a text the position of
//! the macro call. Outside a macro it keeps every text in memory, and its errors have no messages.

use core::str::Chars;

use unicode_ident::{is_xid_continue, is_xid_start};

use super::token::{DEEPEST, Delimiter, TOO_DEEP, Token, TokenKind};
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// Returns the tokens of a text, and the position of the end of the text. Fails only if a bracket or a comment is not
/// closed. Reports and skips stray characters.
pub(crate) fn lex(
    text: &str,
    problems: &mut Problems,
) -> Result<(Vec<Token>, TokenPosition), Reported> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lexer = Lexer {
        rest: text.chars(),
        line: 1,
        column: 1,
        problems,
    };
    let tokens = lexer.run()?;
    Ok((tokens, lexer.place()))
}

struct Lexer<'t, 'p> {
    rest: Chars<'t>,
    line: usize,
    column: usize,
    problems: &'p mut Problems,
}

/// A bracket that is open at the current position.
struct Open {
    bracket: Delimiter,
    place: TokenPosition,
    /// The tokens before this bracket, in the list that contains the bracket.
    before: Vec<Token>,
}

impl Lexer<'_, '_> {
    fn run(&mut self) -> Result<Vec<Token>, Reported> {
        let mut open: Vec<Open> = Vec::new();
        let mut tokens = Vec::new();
        // A valid description nests braces at most two deep. At a third level, the user has probably forgotten to close
        // the second brace.
        let mut suspect = None;
        while let Some(next) = self.peek(0) {
            let place = self.place();
            if next.is_whitespace() {
                self.bump();
            } else if self.starts_with("//") {
                self.line_comment(place, &mut tokens);
            } else if self.starts_with("/*") {
                self.block_comment(place, &mut tokens)?;
            } else if let Some(bracket) = opening(next) {
                self.bump();
                if open.len() >= DEEPEST {
                    return Err(self.problems.report(place, TOO_DEEP));
                }
                if let [.., _, second] = open.as_slice()
                    && bracket == Delimiter::Brace
                    && second.bracket == Delimiter::Brace
                {
                    suspect = suspect.or(Some(second.place));
                }
                open.push(Open {
                    bracket,
                    place,
                    before: core::mem::take(&mut tokens),
                });
            } else if let Some(bracket) = closing(next) {
                self.bump();
                match open.pop() {
                    Some(last) if last.bracket == bracket => {
                        let inner = core::mem::replace(&mut tokens, last.before);
                        let kind = TokenKind::Group {
                            bracket,
                            tokens: inner,
                            close: place,
                        };
                        tokens.push(Token {
                            kind,
                            place: last.place,
                        });
                    }
                    last => return Err(self.mismatch(next, place, last)),
                }
            } else {
                self.leaf(next, place, &mut tokens)?;
            }
        }
        match open.last() {
            None => Ok(tokens),
            Some(last) => {
                let (sign, close) = signs(last.bracket);
                Err(match suspect {
                    Some(place) => self.problems.report(
                        place,
                        "this `{` is not closed where its list ends; write `}` after the last entry",
                    ),
                    None => self.problems.report(
                        last.place,
                        format!("this `{sign}` is never closed; write `{close}` where it ends"),
                    ),
                })
            }
        }
    }

    fn mismatch(&mut self, found: char, place: TokenPosition, open: Option<Open>) -> Reported {
        let message = match open {
            None => format!("this `{found}` closes nothing; delete it"),
            Some(Open { bracket, place, .. }) => {
                let (sign, close) = signs(bracket);
                format!(
                    "this `{found}` comes before the `{sign}` (line {}, column {}) is closed; write `{close}` first",
                    place.line, place.column
                )
            }
        };
        self.problems.report(place, message)
    }

    /// Reads one token that is not a bracket: a word, a number, a string or a punctuation character. Reports and
    /// skips a stray character.
    fn leaf(
        &mut self,
        next: char,
        place: TokenPosition,
        out: &mut Vec<Token>,
    ) -> Result<(), Reported> {
        if is_start(next) {
            if let Ok(kind) = self.word(place) {
                out.push(Token { kind, place });
            }
        } else if next.is_ascii_digit() {
            let kind = TokenKind::Number(self.number());
            out.push(Token { kind, place });
        } else if next == '"' {
            let kind = self.string(place)?;
            out.push(Token { kind, place });
        } else if "~!@#$%^&*-=+|;:,<.>/?".contains(next) {
            self.bump();
            out.push(Token {
                kind: TokenKind::Punct(next),
                place,
            });
        } else {
            self.bump();
            let meant = match next {
                '−' | '–' | '—' | '‐' | '‑' => Some('-'),
                '×' | '·' | '⋅' => Some('*'),
                '÷' => Some('/'),
                _ => None,
            };
            if let Some(sign) = meant {
                self.problems.report(
                    place,
                    format!("`{next}` is typographic; write the plain `{sign}`"),
                );
                out.push(Token {
                    kind: TokenKind::Punct(sign),
                    place,
                });
            } else {
                self.stray(next, place);
            }
        }
        Ok(())
    }

    fn stray(&mut self, found: char, place: TokenPosition) -> Reported {
        let code = u32::from(found);
        let message = if found.is_ascii_graphic() {
            format!("`{found}` means nothing in a scene; delete it")
        } else {
            format!(
                "the character `{}` (U+{code:04X}) means nothing in a scene; delete it",
                found.escape_debug()
            )
        };
        self.problems.report(place, message)
    }

    fn word(&mut self, place: TokenPosition) -> Result<TokenKind, Reported> {
        let raw = self.starts_with("r#") && self.peek(2).is_some_and(is_start);
        if raw {
            self.bump();
            self.bump();
        }
        let name = self.take_while(is_continue);
        if !is_identifier(&name) {
            return Err(self.problems.report(
                place,
                format!("`{name}` is not a name; make names of letters, digits and `_`"),
            ));
        }
        Ok(TokenKind::Word(if raw {
            format!("r#{name}")
        } else {
            name
        }))
    }

    /// Reads a number as Rust does: `0..2` contains two numbers, and `1.5.x` begins with the number `1.5`.
    fn number(&mut self) -> String {
        let mut text = self.take_while(|next| next.is_ascii_digit() || next == '_');
        if self.peek(0) == Some('.')
            && !self
                .peek(1)
                .is_some_and(|next| next == '.' || is_start(next))
        {
            text.push('.');
            self.bump();
            text.push_str(&self.take_while(|next| next.is_ascii_digit() || next == '_'));
        }
        if let Some(exponent @ ('e' | 'E')) = self.peek(0)
            && let Some(sign @ ('+' | '-')) = self.peek(1)
            && self.peek(2).is_some_and(|next| next.is_ascii_digit())
        {
            self.bump();
            self.bump();
            text.extend([exponent, sign]);
        }
        text.push_str(&self.take_while(|next| next == '_' || next.is_ascii_alphanumeric()));
        text
    }

    fn string(&mut self, place: TokenPosition) -> Result<TokenKind, Reported> {
        self.bump();
        let (mut text, mut value) = ("\"".to_owned(), String::new());
        while let Some(next) = self.bump() {
            text.push(next);
            match next {
                '"' => {
                    return Ok(TokenKind::Quoted { text, value });
                }
                '\\' => {
                    let Some(escaped) = self.bump() else { break };
                    text.push(escaped);
                    value.push(if escaped == 'n' { '\n' } else { escaped });
                }
                _ => value.push(next),
            }
        }
        Err(self.problems.report(
            place,
            "this quotation mark is never closed; delete it, because a scene needs no quotation marks",
        ))
    }

    fn line_comment(&mut self, place: TokenPosition, out: &mut Vec<Token>) {
        let line = self.take_while(|next| next != '\n');
        if line.starts_with("//!") {
            out.push(Token {
                kind: TokenKind::InnerDoc,
                place,
            });
        } else if let Some(doc) = line.strip_prefix("///").filter(|doc| !doc.starts_with('/')) {
            let doc = doc.strip_suffix('\r').unwrap_or(doc).to_owned();
            out.push(Token {
                kind: TokenKind::Doc(doc),
                place,
            });
        }
    }

    fn block_comment(
        &mut self,
        place: TokenPosition,
        out: &mut Vec<Token>,
    ) -> Result<(), Reported> {
        let whole = self.rest.as_str();
        let mut depth = 0_usize;
        let mut text = String::new();
        loop {
            let pair = if self.starts_with("/*") {
                depth += 1;
                true
            } else if self.starts_with("*/") {
                depth -= 1;
                true
            } else {
                false
            };
            for _ in 0..if pair { 2 } else { 1 } {
                let Some(next) = self.bump() else {
                    return Err(self.problems.report(
                        place,
                        "this comment is never closed; write `*/` where it ends",
                    ));
                };
                text.push(next);
            }
            if depth == 0 {
                break;
            }
        }
        if whole.starts_with("/*!") {
            out.push(Token {
                kind: TokenKind::InnerDoc,
                place,
            });
        } else if whole.starts_with("/**")
            && !whole.starts_with("/***")
            && let Some(doc) = text.get(3..text.len().saturating_sub(2))
        {
            out.push(Token {
                kind: TokenKind::Doc(doc.to_owned()),
                place,
            });
        }
        Ok(())
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> String {
        let mut taken = String::new();
        while let Some(next) = self.peek(0).filter(|&next| wanted(next)) {
            taken.push(next);
            self.bump();
        }
        taken
    }

    fn starts_with(&self, sign: &str) -> bool {
        self.rest.as_str().starts_with(sign)
    }

    fn peek(&self, ahead: usize) -> Option<char> {
        self.rest.clone().nth(ahead)
    }

    fn bump(&mut self) -> Option<char> {
        let next = self.rest.next()?;
        if next == '\n' {
            self.line += 1;
            self.column = 1;
        } else {
            self.column += 1;
        }
        Some(next)
    }

    fn place(&self) -> TokenPosition {
        TokenPosition {
            line: self.line,
            column: self.column,
            token: None,
        }
    }
}

fn is_start(letter: char) -> bool {
    letter == '_' || letter.is_ascii_alphabetic() || (!letter.is_ascii() && letter.is_alphabetic())
}

fn is_continue(letter: char) -> bool {
    is_start(letter) || letter.is_ascii_digit()
}

/// Returns true if the compiler reads a word of letters, digits and `_` as one identifier.
fn is_identifier(word: &str) -> bool {
    let mut letters = word.chars();
    letters
        .next()
        .is_some_and(|first| first == '_' || is_xid_start(first))
        && letters.all(is_xid_continue)
}

fn opening(sign: char) -> Option<Delimiter> {
    match sign {
        '(' => Some(Delimiter::Parenthesis),
        '[' => Some(Delimiter::Bracket),
        '{' => Some(Delimiter::Brace),
        _ => None,
    }
}

fn closing(sign: char) -> Option<Delimiter> {
    match sign {
        ')' => Some(Delimiter::Parenthesis),
        ']' => Some(Delimiter::Bracket),
        '}' => Some(Delimiter::Brace),
        _ => None,
    }
}

fn signs(bracket: Delimiter) -> (char, char) {
    match bracket {
        Delimiter::Bracket => ('[', ']'),
        Delimiter::Brace => ('{', '}'),
        Delimiter::Parenthesis => ('(', ')'),
    }
}
