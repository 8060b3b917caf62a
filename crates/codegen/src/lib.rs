//! Emits specialised Rust solvers for scene descriptions.
//!
//! `tokens` passes a macro's tokens to the parser of `frictiongen-syntax`. `lower` converts the parsed description to a
//! scene with its tables. `graph` records the closed forms as code, and `emit` writes the items of a solver. With the
//! feature `pretty`, `standalone` writes files in C and Rust that need no other crate.

/// Emits code as `quote!` does, but with another name resolution. Names in the user's code and local names in the
/// emitted code cannot refer to each other.
macro_rules! code {
    ($($tokens:tt)*) => {
        ::quote::quote_spanned!(::proc_macro2::Span::mixed_site()=> $($tokens)*)
    };
}

mod comment;
mod diagnostics;
mod emit;
mod expand;
pub mod graph;
mod header;
pub mod known;
mod lower;
mod quoted;
#[cfg(feature = "pretty")]
pub mod standalone;
mod tokens;
mod units;

pub use diagnostics::{Errors, MacroErrors, Partial};
#[cfg(feature = "pretty")]
pub use emit::{StepFacts, step_facts};
pub use emit::{emit, traces};
pub use expand::expand;
pub use frictiongen_syntax::{Diagnostic, Diagnostics, smooth_law, warnings};
pub use lower::{Description, ProofAt, SceneTables, SizeLimits, parse_text, parse_tokens};

#[cfg(feature = "pretty")]
/// Returns the emitted code of a description as formatted source text.
///
/// # Errors
/// Returns a message if the emitted tokens are not valid Rust, which would be a defect of this crate.
pub fn pretty(description: &Description) -> Result<String, String> {
    formatted(emit(description))
}

#[cfg(feature = "pretty")]
/// Formats emitted tokens as source text.
///
/// # Errors
/// Returns a message if the tokens are not valid Rust.
pub fn formatted(tokens: proc_macro2::TokenStream) -> Result<String, String> {
    let file: syn::File = syn::parse2(tokens).map_err(|error| error.to_string())?;
    Ok(prettyplease::unparse(&file))
}
