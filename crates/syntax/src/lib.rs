//! Reads scene descriptions: from text to tokens, from tokens to a syntax tree, and from the tree to a scene. `write`
//! writes a scene as a description.
//!
//! `parse` converts tokens to a syntax tree with positions. `lower` resolves the names in that tree and checks the
//! scene. A macro passes its own tokens to [`parse_tokens`].

mod diagnostics;
mod lower;
mod parse;
mod warnings;
mod write;

use frictiongen_model::scene::Scene;
use frictiongen_model::validate::MOST_MASSES;

pub use diagnostics::{Diagnostic, Diagnostics, Problem, Problems, Reported, TokenPosition};
pub use lower::{Located, Readable};
pub use parse::reader::Name;
pub use parse::syntax::{Attribute, Visibility};
pub use parse::syntax::{RustPath, Syntax};
pub use parse::token::{DEEPEST, Delimiter, TOO_DEEP, Token, TokenKind};
pub use parse::{parse_faulty, parse_tokens};
pub use warnings::{smooth_law, warnings};
pub use write::written;

/// Reads a scene of at most [`MOST_MASSES`] masses from a text.
///
/// ```
/// use frictiongen_syntax::{Diagnostics, read_scene};
///
/// fn main() -> Result<(), Diagnostics> {
///     let scene = read_scene("struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: block,
///     }")?;
///     assert_eq!(scene.masses.len(), 1);
///     Ok(())
/// }
/// ```
///
/// # Errors
/// Returns all errors of the text, with line and column.
pub fn read_scene(text: &str) -> Result<Scene, Diagnostics> {
    read(text, |_| {}).map(|(scene, ())| scene)
}

/// Reads a scene as [`read_scene`] does, from a text that may lack the field `excitation`. Returns false if the text
/// lacks the field. The excitation of the scene is then a force on a mass of its first contact.
///
/// # Errors
/// Returns all errors of the text, with line and column.
pub fn read_with_or_without_load(text: &str) -> Result<(Scene, bool), Diagnostics> {
    read(text, Syntax::fill_excitation)
}

fn read<T>(text: &str, change: impl Fn(&mut Syntax) -> T) -> Result<(Scene, T), Diagnostics> {
    let mut problems = Problems::default();
    let scene = parse_text(text, &mut problems).and_then(|mut syntax| {
        let changed = change(&mut syntax);
        Some((
            syntax.lower(MOST_MASSES, false, &mut problems)?.scene,
            changed,
        ))
    });
    match scene {
        Some(scene) if problems.is_empty() => Ok(scene),
        _ => Err(problems.into_diagnostics()),
    }
}

/// Parses a text into a syntax tree. If a bracket or a comment is not closed, reports only this error and returns
/// `None`.
pub fn parse_text(text: &str, problems: &mut Problems) -> Option<Syntax> {
    let (tokens, end) = parse::lex(text, problems).ok()?;
    Some(parse_tokens(&tokens, end, problems))
}
