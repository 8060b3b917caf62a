//! The response while the contact is stuck.

use super::trace::Tracer;
use super::{Emission, Part, derives, local, rounded};
use crate::graph::Graph;
use proc_macro2::{Ident, Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>) -> Part {
    let Emission {
        description,
        name,
        at,
        stuck,
        scalar,
        facade,
        ..
    } = emission;
    let visibility = &description.visibility;
    let derives = derives();
    let about =
        format!(" The response of [`{name}`] at one frequency ratio while its contact is stuck.");
    let types = code! {
        #[doc = #about]
        #derives
        #[allow(non_camel_case_types)]
        #visibility struct #stuck {
            at: #at,
        }
    };
    let invisible = emission.list(
        emission
            .modal
            .unbounded(true)
            .into_iter()
            .map(|r| rounded(r, emission.precision)),
    );
    let methods = description
        .mass_names
        .iter()
        .enumerate()
        .map(|(mass, method)| of_mass(emission, mass, method));
    let asked = description
        .mass_names
        .iter()
        .enumerate()
        .map(|(index, method)| {
            let index = Literal::usize_unsuffixed(index);
            code!(#index => Some(stuck.#method()))
        });
    let items = code! {
        impl #at {
            /// The response while the contact is stuck, β ≥ β*_lim.
            ///
            /// # Errors
            /// `StuckResonance` on an undamped resonance of the chain with its contact stuck.
            pub fn stuck(&self) -> Result<#stuck, StuckResonance> {
                #name::CHAIN.stuck_admitted(self.r, &self.contact, &#invisible)?;
                Ok(#stuck { at: *self })
            }
        }

        impl #stuck {
            #(#methods)*
        }

        impl #facade::StuckAt for #at {
            fn stuck_mass(&self, index: ::core::primitive::usize) -> Result<Option<Complex<#scalar>>, StuckResonance> {
                let stuck = self.stuck()?;
                Ok(match index {
                    #(#asked,)*
                    _ => None,
                })
            }
        }
    };
    Part { types, items }
}

fn of_mass(emission: &Emission<'_>, mass: usize, method: &Ident) -> TokenStream {
    let Emission {
        scalar,
        name,
        at,
        reduced,
        ..
    } = emission;
    let about =
        format!(" x̄* = V_k − H_kV/H, the complex amplitude of mass `{method}` (6.11, 6.27, 6.33).");
    if let Some(held) = emission.modal.held(mass) {
        let held = emission.literal(held);
        return code! {
            #[doc = #about]
            ///
            /// The contact ties it to its support.
            #[inline]
            #[must_use]
            pub fn #method(&self) -> Complex<#scalar> {
                Complex { re: #held, im: 0.0 }
            }
        };
    }
    let shape_constant = emission.list(reduced.shapes.get(mass).cloned().unwrap_or_default());
    let absorbed = (!emission.damped() && emission.scene.has_absorber()).then(|| {
        code! {
            // Masses beyond the contact absorb: V and H have zeros in common.
            if let Some(force) = #name::CHAIN.absorbed_force(&contact, &#name::MODES, &modes) {
                let re = #name::CHAIN.stuck_under(
                    force, &SHAPE, &#name::MODES, &modes, &contact, inverse_r,
                );
                return Complex { re, im: 0.0 };
            }
        }
    });
    if emission.in_sums() {
        let modes = Literal::usize_unsuffixed(emission.modes());
        return code! {
            #[doc = #about]
            #[must_use]
            pub fn #method(&self) -> Complex<#scalar> {
                const SHAPE: [#scalar; #modes] = #shape_constant;
                let #at { inverse_r, contact, modes, .. } = self.at;
                #absorbed
                #name::CHAIN.stuck(&SHAPE, &#name::MODES, &modes, &contact, inverse_r)
            }
        };
    }
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let contact = tracer.contact("contact");
    let inverse_r = graph.input("inverse_r");
    let modes_at = tracer.modes_at();
    let components = tracer.reduced.shapes.get(mass).cloned().unwrap_or_default();
    let amplitude = tracer.reduced.chain.stuck(
        &components,
        &tracer.reduced.modes,
        &modes_at,
        &contact,
        inverse_r,
    );
    let outputs = [amplitude.re.operand(), amplitude.im.operand()];
    let (printed, count) = tracer.print(
        &outputs,
        emission.precision,
        &["inverse_r", "contact", "modes"],
    );
    let statements = printed.statements;
    let [re, im] = printed.outputs.as_slice() else {
        return TokenStream::new();
    };
    let names = (1..=emission.modes()).map(|mode| local(&format!("mode_{mode}")));
    let operations = format!(" Operations: {count}.");
    let guard = match absorbed {
        Some(absorbed) => {
            let modes = Literal::usize_unsuffixed(emission.modes());
            code! {
                const SHAPE: [#scalar; #modes] = #shape_constant;
                let #at { inverse_r, contact, modes, .. } = self.at;
                #absorbed
                let [#(#names),*] = modes;
            }
        }
        None => code!(let #at { inverse_r, contact, modes: [#(#names),*], .. } = self.at;),
    };
    code! {
        #[doc = #about]
        ///
        #[doc = #operations]
        #[must_use]
        #[allow(unused_variables)]
        pub fn #method(&self) -> Complex<#scalar> {
            #guard
            #statements
            Complex { re: #re, im: #im }
        }
    }
}
