//! Methods that the scene does not provide: they cannot be called, and say what to add to `provide`.

use super::{Emission, Wanted};
use proc_macro2::{Ident, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> TokenStream {
    let Emission {
        name,
        at,
        motion,
        scalar,
        facade,
        ..
    } = emission;
    let missing = code!(#facade::kernel::missing);
    let mut of_at = TokenStream::new();
    if wanted.motion.is_none() {
        of_at.extend(asked(&code!(motion), &code!(#missing::AddMotionToProvide)));
    }
    if !wanted.orbit {
        let short = code!(#missing::AddOrbitToProvide);
        of_at.extend(asked(&code!(orbit), &short));
        of_at.extend(code! {
            #[doc(hidden)]
            pub fn orbit_from<T: #short, U>(&self, _: T, _: U) -> T::Answer {
                T::answer()
            }
        });
    }
    if !wanted.stuck {
        of_at.extend(unasked(&code!(stuck), &code!(#missing::AddStuckToProvide)));
    }
    let mut items = TokenStream::new();
    if !of_at.is_empty() {
        items.extend(code!(impl #at { #of_at }));
    }
    if !wanted.simulation {
        let short = code!(#missing::AddSimulationToProvide);
        items.extend(code! {
            impl #name {
                #[doc(hidden)]
                pub fn simulation<'a>(_: #scalar, _: #scalar) -> <&'a Self as #short>::Answer
                where
                    &'a Self: #short,
                {
                    <&'a Self as #short>::answer()
                }
                #[doc(hidden)]
                pub fn simulation_from<'a, T>(
                    _: #scalar,
                    _: #scalar,
                    _: T,
                ) -> <&'a Self as #short>::Answer
                where
                    &'a Self: #short,
                {
                    <&'a Self as #short>::answer()
                }
            }
        });
    }
    if let Some(masses) = &wanted.motion {
        let names = emission.description.mass_names.iter();
        let left_out = |name: &&Ident| masses.iter().all(|(_, mass)| mass != name);
        let methods: TokenStream = names
            .filter(left_out)
            .map(|name| unasked(&code!(#name), &code!(#missing::AddMassToMotion)))
            .collect();
        if !methods.is_empty() {
            items.extend(code!(impl #motion { #methods }));
        }
    }
    items
}

/// A method of a number: the compiler tells what is missing when it sees the number.
fn asked(method: &TokenStream, short: &TokenStream) -> TokenStream {
    code! {
        #[doc(hidden)]
        pub fn #method<T: #short>(&self, _: T) -> T::Answer {
            T::answer()
        }
    }
}

/// A method of nothing: the name of the trait is what the compiler tells.
fn unasked(method: &TokenStream, short: &TokenStream) -> TokenStream {
    code! {
        #[doc(hidden)]
        pub fn #method<'a>(&'a self) -> <&'a Self as #short>::Answer
        where
            &'a Self: #short,
        {
            <&'a Self as #short>::answer()
        }
    }
}
