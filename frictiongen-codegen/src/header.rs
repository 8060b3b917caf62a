//! Turns the attributes, the visibility and the paths of a description into types of `syn`.

use frictiongen_syntax::{Attribute, Problems, RustPath, Syntax, Visibility};
use proc_macro2::{Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::Parser;

use crate::tokens::Sources;

/// The text before the braces, and the path of the facade crate.
pub(crate) struct Header {
    pub(crate) attributes: Vec<syn::Attribute>,
    pub(crate) visibility: syn::Visibility,
    pub(crate) facade: syn::Path,
}

impl Header {
    /// Converts the header, and reports every attribute that `syn` cannot read.
    pub(crate) fn of(syntax: &Syntax, sources: &Sources, problems: &mut Problems) -> Self {
        let mut attributes = Vec::new();
        for attribute in &syntax.attributes {
            match attribute {
                Attribute::Doc { text, place } => attributes.push(doc(text, sources.span(*place))),
                Attribute::Other { group, place } => {
                    let inside = sources.stream(core::slice::from_ref(group));
                    match attribute_of(inside, sources.span(*place)) {
                        Ok(mut parsed) => attributes.append(&mut parsed),
                        Err(error) => {
                            let message = format!("this attribute cannot be read: {error}");
                            problems.report(*place, message);
                        }
                    }
                }
            }
        }
        Self {
            attributes,
            visibility: visibility(&syntax.visibility, sources),
            facade: syntax
                .facade()
                .map_or_else(default_facade, |facade| path(facade, sources)),
        }
    }
}

/// Turns `/// text` into `#[doc = "text"]`, as the compiler does.
fn doc(text: &str, span: Span) -> syn::Attribute {
    syn::Attribute {
        pound_token: syn::Token![#](span),
        style: syn::AttrStyle::Outer,
        bracket_token: syn::token::Bracket(span),
        meta: syn::Meta::NameValue(syn::MetaNameValue {
            path: syn::Path::from(Ident::new("doc", span)),
            eq_token: syn::Token![=](span),
            value: syn::Expr::Lit(syn::ExprLit {
                attrs: Vec::new(),
                lit: syn::Lit::Str(syn::LitStr::new(text, span)),
            }),
        }),
    }
}

/// Parses an attribute from the tokens after its `#`.
fn attribute_of(inside: TokenStream, span: Span) -> syn::Result<Vec<syn::Attribute>> {
    let mut pound = Punct::new('#', Spacing::Alone);
    pound.set_span(span);
    let stream = core::iter::once(TokenTree::from(pound))
        .chain(inside)
        .collect();
    syn::Attribute::parse_outer.parse2(stream)
}

fn visibility(visibility: &Visibility, sources: &Sources) -> syn::Visibility {
    match visibility {
        Visibility::Inherited => syn::Visibility::Inherited,
        Visibility::Public(place) => {
            syn::Visibility::Public(syn::Token![pub](sources.span(*place)))
        }
        Visibility::Restricted {
            place,
            bracket,
            is_in,
            path: written,
        } => {
            let bracket = sources.span(*bracket);
            syn::Visibility::Restricted(syn::VisRestricted {
                pub_token: syn::Token![pub](sources.span(*place)),
                paren_token: syn::token::Paren(bracket),
                in_token: is_in.then(|| syn::Token![in](bracket)),
                path: Box::new(path(written, sources)),
            })
        }
    }
}

fn path(written: &RustPath, sources: &Sources) -> syn::Path {
    let mut path = syn::Path {
        leading_colon: None,
        segments: syn::punctuated::Punctuated::new(),
    };
    for (colons, name) in &written.segments {
        let colons = colons.map(|place| {
            let span = sources.span(place);
            syn::Token![::]([span, span])
        });
        match colons {
            Some(sign) if path.segments.is_empty() => path.leading_colon = Some(sign),
            Some(sign) => path.segments.push_punct(sign),
            None => {}
        }
        let segment = syn::PathSegment::from(sources.ident(name));
        path.segments.push_value(segment);
    }
    path
}

fn default_facade() -> syn::Path {
    let span = Span::call_site();
    let mut segments = syn::punctuated::Punctuated::new();
    segments.push_value(syn::PathSegment::from(Ident::new("frictiongen", span)));
    syn::Path {
        leading_colon: Some(syn::Token![::]([span, span])),
        segments,
    }
}
