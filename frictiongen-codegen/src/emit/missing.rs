//! Methods that the scene does not provide: they cannot be called, and say what to add to `provide`.

use super::{Emission, Wanted};
use proc_macro2::{Ident, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> TokenStream {
    let Emission {
        name,
        at,
        motion,
        facade,
        ..
    } = emission;
    let mut items = TokenStream::new();
    let of_at = [
        (wanted.motion.is_some(), code!(motion)),
        (wanted.stuck, code!(stuck)),
        (wanted.orbit, code!(orbit)),
    ];
    let of_at = of_at.into_iter().filter(|(provided, _)| !provided);
    let of_at: Vec<TokenStream> = of_at.map(|(_, method)| method).collect();
    if !of_at.is_empty() && emission.scene.needs_frequency() {
        items.extend(code!(#facade::kernel::not_provided!(#at: #(#of_at),*);));
    }
    if !emission.scene.needs_frequency() {
        items.extend(code!(#facade::kernel::not_provided!(#name: limits);));
    }
    if !wanted.stepper {
        items.extend(code!(#facade::kernel::not_provided!(#name: stepper);));
    }
    if !wanted.simulation {
        items.extend(code!(#facade::kernel::not_provided!(#name: simulation);));
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
            items.extend(code!(#facade::kernel::left_out!(#motion: #(#names),*);));
        }
    }
    items
}
