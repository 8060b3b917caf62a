//! Converts the attributes, the visibility and the paths of a description to tokens.

use frictiongen_syntax::{Attribute, RustPath, Syntax, Visibility};
use proc_macro2::{Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::quote_spanned;

use crate::quoted;
use crate::tokens::Sources;

/// Attributes, visibility and name before the braces of a description, and the path of the facade crate.
pub(crate) struct Header {
    pub(crate) attributes: TokenStream,
    pub(crate) documentation: Vec<String>,
    pub(crate) visibility: TokenStream,
    pub(crate) facade: TokenStream,
}

impl Header {
    /// Converts the parsed header to tokens.
    pub(crate) fn of(syntax: &Syntax, sources: &Sources) -> Self {
        let (mut attributes, mut documentation) = (TokenStream::new(), Vec::new());
        for attribute in &syntax.attributes {
            match attribute {
                Attribute::Doc { text, place } => {
                    documentation.push(text.clone());
                    attributes.extend(doc(text, sources.span(*place)));
                }
                Attribute::Other { group, place } => {
                    let inside = sources.stream(core::slice::from_ref(group));
                    documentation.extend(documented(&inside));
                    attributes.extend([pound(sources.span(*place))]);
                    attributes.extend(inside);
                }
            }
        }
        Self {
            attributes,
            documentation,
            visibility: visibility(&syntax.visibility, sources),
            facade: syntax
                .facade()
                .map_or_else(default_facade, |facade| path(facade, sources)),
        }
    }
}

/// Converts `/// text` to `#[doc = "text"]`, as the compiler does.
fn doc(text: &str, span: Span) -> TokenStream {
    let mut text = Literal::string(text);
    text.set_span(span);
    quote_spanned!(span=> #[doc = #text])
}

/// Returns the text of an attribute `[doc = "text"]`.
fn documented(attribute: &TokenStream) -> Option<String> {
    let Some(TokenTree::Group(group)) = attribute.clone().into_iter().next() else {
        return None;
    };
    let mut inside = group.stream().into_iter();
    match (inside.next()?, inside.next()?, inside.next()?) {
        (TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Literal(text))
            if name == "doc" && inside.next().is_none() =>
        {
            quoted::value(&text)
        }
        _ => None,
    }
}

fn pound(span: Span) -> TokenTree {
    let mut pound = Punct::new('#', Spacing::Alone);
    pound.set_span(span);
    pound.into()
}

fn visibility(visibility: &Visibility, sources: &Sources) -> TokenStream {
    match visibility {
        Visibility::Inherited => TokenStream::new(),
        Visibility::Public(place) => quote_spanned!(sources.span(*place)=> pub),
        Visibility::Restricted {
            place,
            bracket,
            is_in,
            path: written,
        } => {
            let span = sources.span(*bracket);
            let mut inside = TokenStream::new();
            inside.extend(is_in.then(|| TokenTree::from(Ident::new("in", span))));
            inside.extend(path(written, sources));
            let mut group = Group::new(proc_macro2::Delimiter::Parenthesis, inside);
            group.set_span(span);
            quote_spanned!(sources.span(*place)=> pub #group)
        }
    }
}

fn path(written: &RustPath, sources: &Sources) -> TokenStream {
    let mut path = TokenStream::new();
    for (colons, name) in &written.segments {
        if let Some(place) = colons {
            path.extend(quote_spanned!(sources.span(*place)=> ::));
        }
        path.extend([TokenTree::from(sources.ident(name))]);
    }
    path
}

fn default_facade() -> TokenStream {
    quote_spanned!(Span::call_site()=> ::frictiongen)
}
