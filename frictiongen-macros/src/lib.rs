//! The `friction_system!` macro; its documentation is that of `frictiongen`.

use proc_macro::TokenStream;

/// Turns the description of a scene into its solver: `friction_system! { struct Name { … } }`, or
/// `friction_system!("name.friction")` with the path of a file that holds one, from the folder of
/// Cargo.toml.  See the documentation of `frictiongen`.
#[proc_macro]
pub fn friction_system(input: TokenStream) -> TokenStream {
    frictiongen_codegen::expand(input.into()).into()
}
