//! Extracts the text of a description for the documentation of the emitted type.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Returns a text without byte order mark and without the doc comments before the struct. The emitted type already has
/// these doc comments.
pub(super) fn of_text(text: &str) -> String {
    let text = text.trim_start_matches('\u{feff}');
    let mut before = true;
    let lines = text.lines().filter(|line| {
        let line = line.trim_start();
        let is_doc = before && line.starts_with("///") && !line.starts_with("////");
        before &= line.starts_with("//") || line.starts_with('#') || line.is_empty();
        !is_doc
    });
    let lines: Vec<&str> = lines.collect();
    lines.join("\n").trim().to_owned()
}

/// Returns the text of a macro's tokens without attributes. The text has the comments and the layout of the source,
/// unless another macro produced the tokens.
pub(super) fn of_tokens(tokens: &TokenStream) -> String {
    let mut trees: Vec<TokenTree> = tokens.clone().into_iter().collect();
    while let [TokenTree::Punct(sign), TokenTree::Group(group), ..] = trees.as_slice()
        && sign.as_char() == '#'
        && group.delimiter() == Delimiter::Bracket
    {
        trees.drain(..2);
    }
    let Some(TokenTree::Group(body)) = trees.pop() else {
        return tokens.to_string();
    };
    let head: TokenStream = trees.into_iter().collect();
    let body = source(&body).unwrap_or_else(|| body.to_string());
    format!("{head} {body}")
}

/// Returns the source text of a group. Returns `None` if the source text does not consist of the group's own tokens.
/// For tokens from another macro, the source text contains the parameters of that macro.
fn source(group: &Group) -> Option<String> {
    let text = group.span().source_text()?;
    let read: TokenStream = text.parse().ok()?;
    let own = TokenStream::from(TokenTree::from(group.clone()));
    is_same(own, read).then(|| outdented(&text))
}

fn is_same(one: TokenStream, other: TokenStream) -> bool {
    let (mut one, mut other) = (one.into_iter(), other.into_iter());
    loop {
        match (one.next(), other.next()) {
            (None, None) => return true,
            (Some(TokenTree::Group(one)), Some(TokenTree::Group(other))) => {
                if one.delimiter() != other.delimiter() || !is_same(one.stream(), other.stream()) {
                    return false;
                }
            }
            (Some(one), Some(other)) if one.to_string() == other.to_string() => {}
            _ => return false,
        }
    }
}

/// Removes the indentation that all lines after the first have in common.
fn outdented(text: &str) -> String {
    let indentation = |line: &str| line.len() - line.trim_start().len();
    let lines = text.lines().skip(1).filter(|line| !line.trim().is_empty());
    let common = lines.map(indentation).min().unwrap_or(0);
    let lines = text.lines().enumerate().map(|(number, line)| {
        let cut = if number == 0 { 0 } else { common };
        line.get(cut..).unwrap_or_default().trim_end()
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests;
