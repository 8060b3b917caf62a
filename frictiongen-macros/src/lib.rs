//! The `friction_system!` macro, documented in `frictiongen`.

use proc_macro::TokenStream;

/// Turns the description of a scene into its solver.
///
/// The macro accepts `friction_system! { struct Name { … } }`. It also accepts `friction_system!("name.friction")`, the
/// path of a file with the text `struct Name { … }`, relative to the folder of Cargo.toml. See the documentation of
/// `frictiongen`.
#[proc_macro]
pub fn friction_system(input: TokenStream) -> TokenStream {
    frictiongen_codegen::expand(input.into()).into()
}
