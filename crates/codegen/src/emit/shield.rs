//! Prevents the user's constants from changing emitted patterns.
//!
//! If the user's module has a constant `r`, a pattern `let r` refers to that constant. A function named `r`, in a
//! scope nearer to the pattern, hides the constant, and a pattern may bind a name that belongs to a function. The
//! library defines functions of this kind for the variables that most scenes have. This file emits them for all other
//! variables.

use frictiongen_kernel::emitted::locals::NAMES;
use frictiongen_model::validate::is_keyword;
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// Emits a function for each variable name in the emitted items for which the library defines none.
pub(super) fn emit(items: &TokenStream) -> TokenStream {
    let mut names = BTreeSet::new();
    collect(items.clone(), &mut names);
    let known: BTreeSet<&str> = NAMES.iter().copied().collect();
    let missing = names.iter().filter(|name| !known.contains(name.as_str()));
    missing
        .map(|name| {
            let name = Ident::new(name, Span::mixed_site());
            code! {
                /// Hides a constant of this name in the user's module.
                #[allow(dead_code)]
                fn #name() {}
            }
        })
        .collect()
}

/// Names of types that emitted code writes without a path. No pattern binds these names, so they need no hiding
/// function.
const TYPES: [&str; 4] = ["bool", "f32", "f64", "usize"];

/// Returns true if a name has a form like `mode_3_decay`. A name of this form needs no hiding function, because users
/// do not give it to a constant. Each mode has dozens of these names.
fn is_of_a_mode(text: &str) -> bool {
    let rest = text.strip_prefix("mode_").unwrap_or_default();
    let rest = rest.trim_start_matches(|letter: char| letter.is_ascii_digit());
    rest.starts_with('_')
}

/// Collects every word that a pattern may bind. A word that a pattern may bind begins with a small letter, is not in a
/// path, and is not the name of a function.
fn collect(tokens: TokenStream, names: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let sign = |index: Option<usize>, sign: char| matches!(index.and_then(|index| tokens.get(index)), Some(TokenTree::Punct(punct)) if punct.as_char() == sign);
    for (index, token) in tokens.iter().enumerate() {
        let before = index.checked_sub(1);
        match token {
            // Attributes and the arguments of macros bind nothing.
            TokenTree::Group(group)
                if !(sign(before, '!')
                    || group.delimiter() == Delimiter::Bracket && sign(before, '#')) =>
            {
                collect(group.stream(), names);
            }
            TokenTree::Ident(ident) => {
                let text = ident.to_string();
                let after = Some(index + 1);
                let in_path = sign(before, ':')
                    && sign(before.and_then(|at| at.checked_sub(1)), ':')
                    || sign(after, ':') && sign(Some(index + 2), ':');
                let called = matches!(tokens.get(index + 1), Some(TokenTree::Group(group))
                        if group.delimiter() == Delimiter::Parenthesis)
                    || sign(after, '!') && !sign(Some(index + 2), '=');
                let defined = matches!(before.and_then(|at| tokens.get(at)), Some(TokenTree::Ident(word))
                        if *word == "fn");
                let asked =
                    sign(before, '.') && !sign(before.and_then(|at| at.checked_sub(1)), '.');
                let lifetime = sign(before, '\'');
                if text.starts_with(|letter: char| letter.is_lowercase())
                    && !(in_path || called || defined || asked || lifetime)
                    && !is_keyword(&text)
                    && !TYPES.contains(&text.as_str())
                    && !is_of_a_mode(&text)
                {
                    names.insert(text);
                }
            }
            _ => {}
        }
    }
}
