//! Parses the text before the braces: doc comments, visibility, `struct` and the name.

use frictiongen_model::validate::is_keyword;
use proc_macro2::Delimiter;
use syn::parse::Parser;

use super::fields;
use super::reader::{Name, Reader};
use super::token::{Kind, Token, to_stream};
use crate::diagnostics::{Place, Problems};

const FORM: &str =
    "write `struct Name { masses: { … }, springs: { … }, contact: …, excitation: … }`";

/// Attributes allowed before a scene: documentation, lint levels and deprecation. Any other
/// attribute would act on only one of the items that the scene becomes.
const ATTRIBUTES: [&str; 7] = [
    "doc",
    "allow",
    "expect",
    "warn",
    "deny",
    "forbid",
    "deprecated",
];

/// Parses doc comments and attributes.
pub(crate) fn attributes(reader: &mut Reader<'_>, problems: &mut Problems) -> Vec<syn::Attribute> {
    let mut attributes = Vec::new();
    loop {
        let place = reader.place();
        match reader.peek(0).map(|token| &token.kind) {
            Some(Kind::Doc(text)) => {
                reader.next();
                attributes.push(doc(text, place));
            }
            Some(Kind::InnerDoc) => {
                reader.next();
                problems.report(
                    place,
                    "an inner doc comment or attribute has no meaning here; write `///` or `#[…]` before `struct`",
                );
            }
            Some(Kind::Punct('#')) => {
                reader.next();
                attribute(reader, place, problems, &mut attributes);
            }
            _ => return attributes,
        }
    }
}

/// Turns `/// text` into `#[doc = "text"]`, as the compiler does.
fn doc(text: &str, place: Place) -> syn::Attribute {
    let span = place.span();
    syn::Attribute {
        pound_token: syn::Token![#](span),
        style: syn::AttrStyle::Outer,
        bracket_token: syn::token::Bracket(span),
        meta: syn::Meta::NameValue(syn::MetaNameValue {
            path: syn::Path::from(syn::Ident::new("doc", span)),
            eq_token: syn::Token![=](span),
            value: syn::Expr::Lit(syn::ExprLit {
                attrs: Vec::new(),
                lit: syn::Lit::Str(syn::LitStr::new(text, span)),
            }),
        }),
    }
}

/// Parses an attribute after its `#`.
fn attribute(
    reader: &mut Reader<'_>,
    place: Place,
    problems: &mut Problems,
    attributes: &mut Vec<syn::Attribute>,
) {
    if reader.take_punct('!') {
        reader.take_group(Delimiter::Bracket);
        problems.report(
            place,
            "an inner doc comment or attribute has no meaning here; write `///` or `#[…]` before `struct`",
        );
        return;
    }
    let token = reader.peek(0);
    let Some(inside) = reader.take_group(Delimiter::Bracket) else {
        problems.report(
            place,
            "`#` means nothing here; a comment begins with `//`, a line of documentation with `///`",
        );
        return;
    };
    let name = match inside.reader.peek(0) {
        Some(Token {
            kind: Kind::Word { text, .. },
            ..
        }) => text.as_str(),
        _ => "",
    };
    if !ATTRIBUTES.contains(&name) {
        problems.report(
            place,
            "only doc comments, lint levels and `deprecated` are allowed before a scene; put this attribute on a module around it",
        );
        return;
    }
    let span = place.span();
    let stream = to_stream(token.map(core::slice::from_ref).unwrap_or_default());
    let stream = core::iter::once(proc_macro2::TokenTree::from({
        let mut pound = proc_macro2::Punct::new('#', proc_macro2::Spacing::Alone);
        pound.set_span(span);
        pound
    }))
    .chain(stream)
    .collect();
    match syn::Attribute::parse_outer.parse2(stream) {
        Ok(mut parsed) => attributes.append(&mut parsed),
        Err(error) => {
            problems.report(place, format!("this attribute cannot be read: {error}"));
        }
    }
}

/// Returns whether Rust accepts the path in a visibility without `in`.
fn is_short(path: &syn::Path) -> bool {
    ["crate", "self", "super"]
        .iter()
        .any(|word| path.is_ident(word))
}

/// Parses `pub`, `pub(crate)`, `pub(in path)` or nothing.
pub(crate) fn visibility(reader: &mut Reader<'_>, problems: &mut Problems) -> syn::Visibility {
    let place = reader.place();
    if !is_word(reader, 0, "pub") {
        return syn::Visibility::Inherited;
    }
    reader.next();
    let pub_token = syn::Token![pub](place.span());
    let Some(mut inside) = reader.take_group(Delimiter::Parenthesis) else {
        return syn::Visibility::Public(pub_token);
    };
    let in_token = is_word(&inside.reader, 0, "in").then(|| {
        inside.reader.next();
        syn::Token![in](inside.place.span())
    });
    match fields::path(&mut inside.reader) {
        Some(path) if inside.reader.is_empty() && (in_token.is_some() || is_short(&path)) => {
            syn::Visibility::Restricted(syn::VisRestricted {
                pub_token,
                paren_token: syn::token::Paren(inside.place.span()),
                in_token,
                path: Box::new(path),
            })
        }
        _ => {
            problems.report(
                inside.place,
                "a visibility is `pub`, `pub(crate)`, `pub(super)` or `pub(in path)`; write one of these",
            );
            syn::Visibility::Public(pub_token)
        }
    }
}

/// Parses `struct Name`. Returns `None` if the following text cannot be a scene.
pub(crate) fn name(reader: &mut Reader<'_>, problems: &mut Problems) -> Option<Option<Name>> {
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
        // `enum Name {` and `Name {` resemble a scene enough for the parser to continue.
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

fn is_word(reader: &Reader<'_>, ahead: usize, word: &str) -> bool {
    matches!(reader.peek(ahead), Some(Token { kind: Kind::Word { text, .. }, .. }) if text == word)
}
