//! Emits placeholder methods for everything that the scene does not provide. A call does not compile, and the compiler
//! message says what to add to `provide`.

use super::emission::{Emission, EmittedCode, Wanted};
use super::names::TypeNames;
use proc_macro2::{Ident, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> EmittedCode {
    let Emission {
        facade,
        names: TypeNames {
            name, at, motion, ..
        },
        ..
    } = emission;
    let needs_frequency = emission.scene.needs_frequency();
    let of_at = [
        (wanted.motion.is_some(), code!(motion)),
        (wanted.stuck, code!(stuck)),
        (wanted.orbit, code!(orbit)),
    ];
    let of_scene = [
        (needs_frequency, code!(limits)),
        (wanted.simulation, code!(simulation)),
        (wanted.stepper, code!(stepper)),
        (wanted.self_check, code!(self_check)),
    ];
    let not_provided = |type_of: &Ident, methods: &[(bool, TokenStream)]| {
        let missing = methods.iter().filter(|(provided, _)| !provided);
        let missing: Vec<&TokenStream> = missing.map(|(_, method)| method).collect();
        (!missing.is_empty()).then(|| code!(#type_of: #(#missing),*))
    };
    let of_at = needs_frequency.then(|| not_provided(at, &of_at)).flatten();
    let missing: Vec<TokenStream> = of_at
        .into_iter()
        .chain(not_provided(name, &of_scene))
        .collect();
    let mut items = TokenStream::new();
    if !missing.is_empty() {
        items.extend(code! {
            /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
            #facade::kernel::not_provided!(#(#missing);*);
        });
    }
    if let Some(masses) = &wanted.motion {
        let left_out = |name: &&Ident| masses.iter().all(|(_, mass)| mass != name);
        let names: Vec<&Ident> = emission
            .description
            .mass_names
            .iter()
            .filter(left_out)
            .collect();
        if !names.is_empty() {
            items.extend(code! {
                /// Placeholders for masses whose motion `provide` does not list: the compiler refuses a call.
                #facade::kernel::left_out!(#motion: #(#names),*);
            });
        }
    }
    EmittedCode {
        items,
        ..EmittedCode::default()
    }
}
