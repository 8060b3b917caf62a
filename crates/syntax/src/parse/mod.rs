//! Parses a description into a syntax tree with positions. The parser does not resolve names.
//!
//! After each error the parser continues, so that it reports every error. Within a list it continues with the next
//! entry, outside a list with the next field.

mod chain;
mod declared;
mod fields;
mod forms;
pub(crate) mod header;
mod joints;
mod lex;
pub(crate) mod number;
pub(crate) mod reader;
mod stepping;
mod stops;
pub(crate) mod suggest;
pub(crate) mod syntax;
pub(crate) mod token;

pub(crate) use self::lex::lex;
pub(crate) use self::number::Number;
use self::reader::TokenReader;
pub(crate) use self::reader::{List, Name};
use self::syntax::{Fields, Syntax};
use self::token::{Delimiter, Token};
use crate::diagnostics::{Problems, TokenPosition};

/// Parses the tokens of a description. Errors at the end of the tokens have the position `end`.
pub fn parse_tokens(tokens: &[Token], end: TokenPosition, problems: &mut Problems) -> Syntax {
    let mut reader = TokenReader::new(tokens, end);
    let mut reader = call(&mut reader, problems).unwrap_or(reader);
    let reader = &mut reader;
    let attributes = header::attributes(reader, problems);
    let visibility = header::visibility(reader, problems);
    let place = reader.place();
    let mut syntax = Syntax {
        attributes,
        visibility,
        name: None,
        place,
        has_body: false,
        fields: Fields::default(),
    };
    let Some(name) = header::name(reader, problems) else {
        return syntax;
    };
    if let Some(name) = &name {
        syntax.place = name.place;
    }
    syntax.name = name;
    if fields::begins(reader) {
        syntax.fields = fields::fields(reader, problems);
        syntax.has_body = true;
    } else if let Some(mut body) = body(reader, problems) {
        syntax.fields = fields::fields(&mut body, problems);
        syntax.has_body = true;
        if !reader.is_empty() {
            let message = format!(
                "{} follows the scene, but a description has only one scene; give each scene its own file or macro call",
                reader.found()
            );
            problems.report(reader.place(), message);
        }
    }
    syntax
}

/// Parses only the names in a description. The caller has already reported an error that makes all further errors
/// meaningless, so the function reports none. The result counts as a description without fields.
#[must_use]
pub fn parse_faulty(tokens: &[Token], end: TokenPosition) -> Syntax {
    let mut syntax = parse_tokens(tokens, end, &mut Problems::default());
    syntax.has_body = false;
    syntax
}

/// Returns the tokens within the brackets of a macro call, if the text is a macro call around a description.
fn call<'t>(reader: &mut TokenReader<'t>, problems: &mut Problems) -> Option<TokenReader<'t>> {
    const NAME: &str = "friction_system";
    let mut ahead = *reader;
    let place = ahead.place();
    while ahead.is_punct(0, ':') || (ahead.is_word(0) && ahead.is_punct(1, ':')) {
        ahead.next();
    }
    if ahead.take_word()?.text != NAME || !ahead.take_punct('!') {
        return None;
    }
    let inside = [Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket]
        .into_iter()
        .find_map(|bracket| ahead.take_group(bracket))?;
    problems.report(
        place,
        format!("a description is only the text inside `{NAME}! {{ … }}`; delete the macro call around it"),
    );
    Some(inside.reader)
}

/// Returns the tokens between the braces of a description, which are its fields.
fn body<'t>(reader: &mut TokenReader<'t>, problems: &mut Problems) -> Option<TokenReader<'t>> {
    let place = reader.place();
    if let Some(inside) = reader.take_group(Delimiter::Brace) {
        return Some(inside.reader);
    }
    let message = if reader.is_punct(0, '<') {
        "a scene has no type parameters; delete them".to_owned()
    } else {
        format!(
            "the fields of a scene must be in braces, but here is {}; write `{{ … }}` after the name",
            reader.found()
        )
    };
    problems.report(place, message);
    while !reader.is_empty() {
        if let Some(inside) = reader.take_group(Delimiter::Brace) {
            return Some(inside.reader);
        }
        reader.next();
    }
    None
}
