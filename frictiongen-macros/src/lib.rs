//! The `friction_system!` macro; its documentation is that of `frictiongen`.

use frictiongen_codegen::{Limits, emit, parse_tokens};
use proc_macro::TokenStream;

/// Turns the description of a scene into its solver.  See the documentation of `frictiongen`.
#[proc_macro]
pub fn friction_system(input: TokenStream) -> TokenStream {
    match parse_tokens(input.into(), &Limits::MACRO) {
        Ok(description) => emit(&description).into(),
        Err(failure) => failure.errors.to_compile_error().into(),
    }
}
