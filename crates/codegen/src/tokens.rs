//! Passes the compiler's tokens to the parser, and keeps their spans.

use crate::diagnostics::Errors;
use frictiongen_syntax::{
    DEEPEST, Delimiter, Name, Problem, Problems, Syntax, TOO_DEEP, Token, TokenKind, TokenPosition,
    parse_faulty, parse_tokens,
};
use proc_macro2::{Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// The compiler's tokens. The field `token` of a [`TokenPosition`] is an index in this list. The list is empty for a
/// text.
#[derive(Default)]
pub(crate) struct Sources {
    list: Vec<TokenSource>,
}

/// The span of one token of the compiler, and the token itself if it is a word or a literal.
struct TokenSource {
    span: Span,
    tree: Option<TokenTree>,
}

/// Parses the tokens of a macro call. If the brackets are nested too deeply, the function reports only that error.
pub(crate) fn parse(stream: TokenStream, problems: &mut Problems) -> (Syntax, Sources) {
    let mut sources = Sources::default();
    let mut tokens = Vec::new();
    let sound = sources.read(stream, 0, &mut tokens, problems);
    let end = match tokens.last() {
        Some(last) => last.place,
        None => sources.place(Span::call_site(), None),
    };
    let syntax = if sound {
        parse_tokens(&tokens, end, problems)
    } else {
        parse_faulty(&tokens, end)
    };
    (syntax, sources)
}

impl Sources {
    /// Returns the span of a position. If the description is a string or a file, every position has the span of the
    /// macro call.
    pub(crate) fn span(&self, place: TokenPosition) -> Span {
        self.source(place)
            .map_or_else(Span::call_site, |source| source.span)
    }

    fn source(&self, place: TokenPosition) -> Option<&TokenSource> {
        self.list.get(place.token?)
    }

    /// Returns a word as an identifier. If the compiler has a token for the word, the function returns that token. The
    /// token may be `$crate`, which cannot be created from a text.
    pub(crate) fn ident(&self, name: &Name) -> Ident {
        self.word(&name.text, name.place)
    }

    fn word(&self, text: &str, place: TokenPosition) -> Ident {
        if let Some(TokenTree::Ident(ident)) = self.source(place).and_then(|one| one.tree.as_ref())
        {
            return ident.clone();
        }
        let span = self.span(place);
        let plain = text.strip_prefix("r#").unwrap_or(text);
        // `Ident::new` panics on letters that the compiler in use does not know.
        if !plain.is_ascii() {
            let mut ident = parsed(plain).unwrap_or_else(|| Ident::new("_", span));
            ident.set_span(span);
            return ident;
        }
        let is_raw = plain != text && !["_", "crate", "self", "Self", "super"].contains(&plain);
        if is_raw {
            Ident::new_raw(plain, span)
        } else {
            Ident::new(plain, span)
        }
    }

    /// Returns the errors in the order of the source.
    pub(crate) fn errors(&self, problems: Problems) -> Errors {
        let sorted = problems.into_sorted().into_iter();
        let mut list: Vec<(Span, String)> = sorted
            .map(|Problem { place, message }| (self.span(place), message))
            .collect();
        if list.is_empty() {
            list.push((Span::call_site(), "this is not a scene".to_owned()));
        }
        Errors { list }
    }

    /// Stores a token and returns its position.
    fn place(&mut self, span: Span, tree: Option<TokenTree>) -> TokenPosition {
        let start = span.start();
        self.list.push(TokenSource { span, tree });
        TokenPosition {
            line: start.line,
            column: start.column + 1,
            token: Some(self.list.len() - 1),
        }
    }

    /// Converts the compiler's tokens. If the brackets are nested too deeply, the function reports an error and returns
    /// false.
    fn read(
        &mut self,
        stream: TokenStream,
        depth: usize,
        out: &mut Vec<Token>,
        problems: &mut Problems,
    ) -> bool {
        let mut sound = true;
        for tree in stream {
            match tree {
                TokenTree::Ident(ident) => {
                    let kind = TokenKind::Word(ident.to_string());
                    let place = self.place(ident.span(), Some(ident.into()));
                    out.push(Token { kind, place });
                }
                TokenTree::Punct(punct) => out.push(Token {
                    kind: TokenKind::Punct(punct.as_char()),
                    place: self.place(punct.span(), None),
                }),
                TokenTree::Literal(literal) => self.read_literal(literal, out),
                TokenTree::Group(group) => sound &= self.read_group(&group, depth, out, problems),
            }
        }
        sound
    }

    fn read_literal(&mut self, literal: Literal, out: &mut Vec<Token>) {
        let text = literal.to_string();
        let place = self.place(literal.span(), Some(literal.into()));
        // Another macro may create a negative literal. Source text cannot contain one.
        let (sign, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest.to_owned()),
            None => (false, text),
        };
        if sign {
            out.push(Token {
                kind: TokenKind::Punct('-'),
                place,
            });
        }
        let is_number = text.starts_with(|first: char| first.is_ascii_digit());
        let kind = if is_number {
            TokenKind::Number(text)
        } else {
            TokenKind::Quoted {
                text,
                value: String::new(),
            }
        };
        out.push(Token { kind, place });
    }

    fn read_group(
        &mut self,
        group: &Group,
        depth: usize,
        out: &mut Vec<Token>,
        problems: &mut Problems,
    ) -> bool {
        let place = self.place(group.span_open(), None);
        if depth >= DEEPEST {
            problems.report(place, TOO_DEEP);
            return false;
        }
        let mut tokens = Vec::new();
        let sound = self.read(group.stream(), depth + 1, &mut tokens, problems);
        // A group of tokens from `macro_rules!` keeps its invisible brackets only around arithmetic, because only there
        // they change the result.
        let is_sum = || {
            tokens.iter().any(|token| {
                ['+', '-', '*', '/']
                    .iter()
                    .any(|&sign| token.is_punct(sign))
            })
        };
        let bracket = match group.delimiter() {
            proc_macro2::Delimiter::None if !is_sum() => {
                out.append(&mut tokens);
                return sound;
            }
            proc_macro2::Delimiter::None | proc_macro2::Delimiter::Parenthesis => {
                Delimiter::Parenthesis
            }
            proc_macro2::Delimiter::Bracket => Delimiter::Bracket,
            proc_macro2::Delimiter::Brace => Delimiter::Brace,
        };
        let close = self.place(group.span_close(), None);
        let kind = TokenKind::Group {
            bracket,
            tokens,
            close,
        };
        out.push(Token { kind, place });
        sound
    }

    /// Converts tokens back to tokens of the compiler, for attributes. Attributes contain no numbers.
    pub(crate) fn stream(&self, tokens: &[Token]) -> TokenStream {
        let trees = tokens.iter().filter_map(|token| {
            let mut tree = match &token.kind {
                TokenKind::Word(text) => self.word(text, token.place).into(),
                TokenKind::Punct(sign) => Punct::new(*sign, Spacing::Joint).into(),
                TokenKind::Quoted { value, .. } => self.literal(value, token.place).into(),
                TokenKind::Group {
                    bracket, tokens, ..
                } => Group::new(delimiter(*bracket), self.stream(tokens)).into(),
                TokenKind::Number(_) | TokenKind::Doc(_) | TokenKind::InnerDoc => return None,
            };
            TokenTree::set_span(&mut tree, self.span(token.place));
            Some(tree)
        });
        trees.collect()
    }

    fn literal(&self, value: &str, place: TokenPosition) -> Literal {
        match self.source(place).and_then(|one| one.tree.as_ref()) {
            Some(TokenTree::Literal(literal)) => literal.clone(),
            _ => Literal::string(value),
        }
    }
}

/// Returns a text as an identifier. Returns `None` if the compiler in use does not accept the text as an identifier.
fn parsed(text: &str) -> Option<Ident> {
    let mut tokens = text.parse::<TokenStream>().ok()?.into_iter();
    match (tokens.next()?, tokens.next()) {
        (TokenTree::Ident(ident), None) => Some(ident),
        _ => None,
    }
}

fn delimiter(bracket: Delimiter) -> proc_macro2::Delimiter {
    match bracket {
        Delimiter::Parenthesis => proc_macro2::Delimiter::Parenthesis,
        Delimiter::Bracket => proc_macro2::Delimiter::Bracket,
        Delimiter::Brace => proc_macro2::Delimiter::Brace,
    }
}
