//! Emits the response while the contact is stuck.

use super::arm::{self, Arm};
use super::emission::{Emission, Part};
use super::names::TypeNames;
use super::trace::Tracer;
use crate::graph::alternatives::{self, Alternative};
use crate::graph::{Expr, Graph};
use frictiongen_model::scene::Excitation;
use proc_macro2::{Literal, TokenStream};

/// Emits the type of the stuck response, with a method for each mass.
pub(super) fn emit(emission: &Emission<'_>) -> Part {
    let Emission {
        description,
        scalar,
        facade,
        names: TypeNames { name, stuck, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let about =
        format!(" The response of [`{name}`] at one frequency ratio while its contact is stuck.");
    let tabled = emission.is_tabled();
    let inner = if tabled {
        code!(table::Sticking)
    } else {
        code!(response::Stuck)
    };
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types)]
        #visibility struct #stuck(#facade::kernel::#inner<#name>);
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
    // The kernel's `Stuck` computes the responses for which the scene has no table.
    let (exact, wraps) = if tabled {
        let wraps = code!(#facade::kernel::wraps!(#stuck, Sticking of tabled #name, Copy););
        (code!(Stuck<Self>), wraps)
    } else {
        let wraps = code!(#facade::kernel::wraps!(#stuck, Stuck of #name, Copy););
        (code!(#stuck), wraps)
    };
    let items = code! {
        impl ProvidesStuck for #name {
            type Stuck = #exact;

            #in_lines
        }

        #wraps

        impl #stuck {
            #(#methods)*
        }
    };
    Part {
        types,
        associated: TokenStream::new(),
        items,
    }
}

/// Emits the stuck response of a scene with few modes in straight lines, as a method of the kernel's `ProvidesStuck`.
fn in_lines(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let modes = emission.mode_names();
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let masses = 0..emission.scene.masses.len();
    let masses = masses.filter(|mass| emission.reduced.rubbing != Some(*mass));
    let masses: Vec<usize> = masses.collect();
    if masses.is_empty() {
        return TokenStream::new();
    }
    let amplitudes = masses
        .into_iter()
        .map(|mass| (mass, of_mass(&tracer, mass)));
    let (masses, amplitudes) = alternatives::grouped(amplitudes);
    let taken = ["at", "inverse_r", "contact", "modes"];
    let (common, amplitudes) = alternatives::print(&amplitudes, emission.precision, &taken);
    let arms = masses.into_iter().zip(&amplitudes);
    let arms = arms.filter_map(|(masses, printed)| {
        let [re, im] = printed.outputs.as_slice() else {
            return None;
        };
        Some(Arm {
            masses,
            statements: printed.statements.clone(),
            value: code!(Complex { re: #re, im: #im }),
        })
    });
    let arms: Vec<Arm> = arms.collect();
    let (statements, amplitude) = arm::chosen(&arms);
    let constants = tracer.names_constants().then(|| emission.constants());
    code! {
        /// x̄* = (V_kH − H_kV)/H: `numerator` has each mode's products with the others, as those with itself would cancel.
        /// `driven` is a mode's part of V_k, `held_back` of −H_k; `v_term` and `h_term` of V and H; `inverse` is 1/H, `unscale` 1/(r²E).
        #[allow(unused_variables)]
        #[inline]
        fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<#scalar>> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            #constants
            let [#(#modes),*] = at.modes();
            #common
            #statements
            Some(#amplitude)
        }
    }
}

fn of_mass(tracer: &Tracer<'_>, mass: usize) -> Alternative {
    let amplitude = tracer.reduced.chain.stuck_loaded(
        tracer.reduced.shape(mass),
        tracer.loaded(),
        &tracer.modes_at(),
        &tracer.contact("contact"),
        tracer.graph.input("inverse_r"),
    );
    let outputs = [amplitude.re, amplitude.im].map(Expr::operand);
    Alternative::of(tracer.graph, outputs.to_vec())
}
