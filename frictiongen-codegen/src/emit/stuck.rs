//! The response while the contact is stuck.

use super::motion::mode_names;
use super::trace::Tracer;
use super::{Emission, Part};
use crate::graph::Graph;
use frictiongen_model::scene::Excitation;
use proc_macro2::{Literal, TokenStream};

/// The type of the response, with a method for each mass.
pub(super) fn emit(emission: &Emission<'_>) -> Part {
    let Emission {
        description,
        name,
        stuck,
        scalar,
        facade,
        ..
    } = emission;
    let visibility = &description.visibility;
    let about =
        format!(" The response of [`{name}`] at one frequency ratio while its contact is stuck.");
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types)]
        #visibility struct #stuck(#facade::kernel::response::Stuck<#name>);
    };
    let unit = match emission.scene.excitation {
        Excitation::Base => "Y",
        Excitation::Force(_) => "P/k₁",
    };
    let tied = match emission.reduced.chain.on_moving_base {
        None => " It is 0: the contact holds the mass to a support at rest.",
        Some(_) => " It is that of the base, to which the contact holds the mass.",
    };
    let methods = description.mass_names.iter().enumerate();
    let methods = methods.map(|(mass, method)| {
        let about = format!(
            " x̄* = V_k − H_kV/H, the complex amplitude of mass `{method}` over {unit} (6.11, 6.27, 6.33)."
        );
        let why = (emission.reduced.rubbing == Some(mass)).then(|| {
            code! {
                ///
                #[doc = #tied]
            }
        });
        let mass = Literal::usize_unsuffixed(mass);
        code! {
            #[doc = #about]
            #why
            #[must_use]
            pub fn #method(&self) -> Complex<#scalar> {
                self.mass(#mass)
            }
        }
    });
    let in_lines = (!emission.in_sums()).then(|| in_lines(emission));
    let items = code! {
        impl ProvidesStuck for #name {
            type Stuck = #stuck;

            #in_lines
        }

        #facade::kernel::wraps!(#stuck, Stuck of #name, Copy);

        impl #stuck {
            #(#methods)*
        }
    };
    Part { types, items }
}

/// The response of a scene of few modes in straight lines, as a method of the kernel's `ProvidesStuck`.
fn in_lines(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let modes = mode_names(emission);
    let masses = 0..emission.scene.masses.len();
    let masses = masses
        .filter(|mass| emission.reduced.rubbing != Some(*mass))
        .map(|mass| of_mass(emission, mass));
    let masses: Vec<TokenStream> = masses.collect();
    if masses.is_empty() {
        return TokenStream::new();
    }
    code! {
        /// x̄* = (V_kH − H_kV)/H: `numerator` has each mode's products with the others, as those with itself would cancel.
        #[allow(unused_variables)]
        #[inline]
        fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<#scalar>> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [#(#modes),*] = at.modes();
            Some(match mass {
                #(#masses)*
                _ => return None,
            })
        }
    }
}

fn of_mass(emission: &Emission<'_>, mass: usize) -> TokenStream {
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let amplitude = tracer.reduced.chain.stuck(
        tracer.reduced.shape(mass),
        &tracer.reduced.modes,
        &tracer.modes_at(),
        &tracer.contact("contact"),
        graph.input("inverse_r"),
    );
    let outputs = [amplitude.re.operand(), amplitude.im.operand()];
    let taken = ["at", "inverse_r", "contact", "modes"];
    let (printed, _) = tracer.print(&outputs, emission.precision, &taken);
    let statements = printed.statements;
    let [re, im] = printed.outputs.as_slice() else {
        return TokenStream::new();
    };
    let mass = Literal::usize_unsuffixed(mass);
    code! {
        #mass => {
            #statements
            Complex { re: #re, im: #im }
        }
    }
}
