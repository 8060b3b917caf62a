//! Errors of a macro call, and the fields that it can use in spite of them.

use core::fmt;

use frictiongen_model::scene::Precision;
use proc_macro2::Ident;

/// Errors of a macro call whose tokens are not a valid scene.
#[derive(Debug)]
pub struct Failure {
    /// All errors, each on the token that caused it.
    pub errors: syn::Error,
    /// The fields of the description that could be read in spite of the errors.
    pub partial: Partial,
}

/// The fields of a faulty description that could be read. They are enough for a macro to emit a
/// type with the expected methods, so that calls to those methods do not add errors.
pub struct Partial {
    /// The attributes before the struct.
    pub attributes: Vec<syn::Attribute>,
    /// The visibility of the struct.
    pub visibility: syn::Visibility,
    /// The name of the struct; `None` if it is not usable.
    pub name: Option<Ident>,
    /// The path under which the user's crate imports the facade crate `frictiongen`.
    pub facade: syn::Path,
    /// The masses whose names are valid method names.
    pub mass_names: Vec<Ident>,
    /// The scalar type of the scene.
    pub precision: Precision,
    /// True if the base is excited.
    pub on_base: bool,
    /// The masses that the stepper may load, as indices into `mass_names`.
    pub forces: Vec<usize>,
    /// True if the description declares a step.
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
