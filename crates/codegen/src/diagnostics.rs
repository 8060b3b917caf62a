//! Errors of a macro call, and the fields that the macro can read in spite of the errors.

use core::fmt;

use frictiongen_model::scene::Precision;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote_spanned;

/// Errors of a macro call whose tokens are not a valid scene.
#[derive(Debug)]
pub struct MacroErrors {
    /// All errors, each on the token that caused it.
    pub errors: Errors,
    /// The fields of the description that could be read in spite of the errors.
    pub partial: Partial,
}

/// Errors in the order of the source, each with its position and its message.
#[derive(Debug)]
pub struct Errors {
    /// The errors. The list is never empty.
    pub list: Vec<(Span, String)>,
}

impl Errors {
    /// Emits a `compile_error!` for each error.
    #[must_use]
    pub fn to_compile_error(&self) -> TokenStream {
        let each = self.list.iter();
        each.map(|(span, message)| compile_error(*span, message))
            .collect()
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let messages = self.list.iter().map(|(_, message)| message.as_str());
        f.write_str(&messages.collect::<Vec<_>>().join("\n"))
    }
}

/// Emits a compiler error at a position in the source.
pub(crate) fn compile_error(span: Span, message: &str) -> TokenStream {
    let mut message = Literal::string(message);
    message.set_span(span);
    quote_spanned!(span=> ::core::compile_error! { #message })
}

/// The readable fields of a faulty description. They are enough for a macro to emit a type with the expected methods,
/// so that calls to those methods do not add errors.
pub struct Partial {
    /// The attributes before the struct.
    pub attributes: TokenStream,
    /// The lines of the doc comments before the struct.
    pub documentation: Vec<String>,
    /// The visibility of the described struct, such as `pub`.
    pub visibility: TokenStream,
    /// The name of the struct; `None` if it is not usable.
    pub name: Option<Ident>,
    /// The path under which the user's crate imports the facade crate `frictiongen`.
    pub facade: TokenStream,
    /// The masses whose names are valid method names.
    pub mass_names: Vec<Ident>,
    /// The scalar type of the scene.
    pub precision: Precision,
    /// True if the excitation is a motion of the base.
    pub on_base: bool,
    /// The masses that the stepper may load, as indices into `mass_names`.
    pub forces: Vec<usize>,
    /// True if the description declares the step of a stepper.
    pub has_step: bool,
}

impl fmt::Debug for Partial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Partial")
            .field("name", &self.name)
            .field("mass_names", &self.mass_names)
            .field("precision", &self.precision)
            .finish_non_exhaustive()
    }
}
