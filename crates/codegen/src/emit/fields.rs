//! Emits the fields of a structure. Each field may have an explanation above it.

use super::names::local;
use proc_macro2::TokenStream;

/// A field: its name, its value and its explanation.
pub(super) type EmittedField<'a> = (&'a str, TokenStream, &'a str);

/// Emits `name: value, …`, with the explanations if `explained` is true. In a list of structures, only the first
/// structure has the explanations.
pub(super) fn fields(explained: bool, fields: &[EmittedField<'_>]) -> TokenStream {
    let fields = fields.iter().map(|(name, value, about)| {
        let name = local(name);
        if explained {
            let about = format!(" {about}");
            code!(#[doc = #about] #name: #value,)
        } else {
            code!(#name: #value,)
        }
    });
    fields.collect()
}
