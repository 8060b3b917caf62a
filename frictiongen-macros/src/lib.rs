//! The `friction_system!` macro, documented in `frictiongen`.

use proc_macro::TokenStream;

/// Turns the description of a scene into a solver for this scene.
///
/// The macro accepts `friction_system! { struct Name { … } }`. It also accepts `friction_system!("name.friction")`.
/// The path in quotes is relative to the folder of Cargo.toml, and the file contains the text `struct Name { … }`.
/// The documentation of the crate `frictiongen` lists the fields of a description and the emitted items.
#[proc_macro]
pub fn friction_system(input: TokenStream) -> TokenStream {
    frictiongen_codegen::expand(input.into()).into()
}
