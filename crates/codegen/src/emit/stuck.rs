//! Emits the code that computes the response while the contact is stuck.

use super::arm::{self, Arm};
use super::emission::{Emission, EmittedCode};
use super::mode::operations_about;
use super::names::TypeNames;
use super::trace::Tracer;
use crate::graph::Expr;
use crate::graph::alternatives::{self, Alternative};
use frictiongen_model::scene::Excitation;
use proc_macro2::{Literal, TokenStream};

/// Emits the type of the stuck response, with a method for each mass.
pub(super) fn emit(emission: &Emission<'_>) -> EmittedCode {
    let Emission {
        description,
        scalar,
        facade,
        names: TypeNames { name, stuck, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let about =
        format!(" Response of [`{name}`] at one frequency ratio while its contact is stuck.");
    let tabled = emission.is_tabled();
    let inner = if tabled {
        code!(table::Sticking)
    } else {
        code!(response::Stuck)
    };
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
        #visibility struct #stuck(#facade::kernel::#inner<#name>);
    };
    let unit = match emission.scene.excitation {
        Excitation::Base => "Y",
        Excitation::Force(_) => "P/k₁",
    };
    let tied = match emission.reduced.chain.on_moving_base {
        None => " It is 0, because the contact holds the mass to a support at rest.",
        Some(_) => " It is 1, because the contact holds the mass to the base.",
    };
    let elastic = emission.is_elastic();
    let h = if elastic { "(H + ρ)" } else { "H" };
    let methods = description.mass_names.iter().enumerate();
    let methods = methods.map(|(mass, method)| {
        let about = format!(
            " x̄* = V_k − H_kV/{h}, the complex amplitude of mass `{method}` over {unit} (6.11, 6.27, 6.33)."
        );
        let why = (!elastic && emission.reduced.rubbing == Some(mass)).then(|| {
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
    let in_lines = (!emission.in_sums() && !elastic).then(|| in_lines(emission));
    let of_kernel = in_lines.is_none().then(|| {
        code! {
            /// The responses are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of
            /// operations for each mode, without a search.
        }
    });
    // The kernel's `Stuck` computes the responses for which the scene has no table.
    let (exact, wraps) = if tabled {
        let wraps = code! {
            /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the response has all methods of the wrapped type.
            #facade::kernel::wraps!(#stuck, Sticking of tabled #name, Copy);
        };
        (code!(Stuck<Self>), wraps)
    } else {
        let wraps = code! {
            /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the response has all methods of the wrapped type.
            #facade::kernel::wraps!(#stuck, Stuck of #name, Copy);
        };
        (code!(#stuck), wraps)
    };
    let contact = emission.contact_method(&code!(contact_force), &code!(Complex<#scalar>));
    let items = code! {
        #of_kernel
        impl ProvidesStuck for #name {
            type Stuck = #exact;

            #in_lines
        }

        #wraps

        impl #stuck {
            #(#methods)*

            #contact
        }
    };
    EmittedCode {
        types,
        items,
        ..EmittedCode::default()
    }
}

/// Emits straight-line code for the stuck response of a scene with few modes, as a method of the kernel's
/// `ProvidesStuck`.
fn in_lines(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let graph = emission.graph(emission.modes());
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
    let operations = operations_about(&alternatives::most_operations(&graph, &amplitudes));
    let (common, amplitudes) = alternatives::print(&amplitudes, emission.precision, &taken);
    let arms = masses.into_iter().zip(&amplitudes);
    let arms = arms.filter_map(|(masses, printed)| {
        let [re, im] = printed.outputs.as_slice() else {
            return None;
        };
        let value = code!(Complex { re: #re, im: #im });
        let statements = &printed.statements;
        let shape = emission.shape(&code!(#statements #value));
        Some(Arm {
            masses,
            statements: code!(#shape #statements),
            value,
        })
    });
    let arms: Vec<Arm> = arms.collect();
    let (statements, amplitude) = arm::chosen(&arms, emission.scene.masses.len());
    let body = code!(#common #statements Some(#amplitude));
    let inputs = emission.inputs(&body);
    let where_asked = emission
        .is_tabled()
        .then(|| code!(#[doc = " The kernel calls it where no table answers."]));
    code! {
        /// x̄* = (V_kH − H_kV)/H, the complex amplitude of mass k (6.11, 6.27, 6.33).
        #where_asked
        ///
        #[doc = #operations]
        #[inline]
        fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<#scalar>> {
            #inputs
            #body
        }
    }
}

fn of_mass(tracer: &Tracer<'_>, mass: usize) -> Alternative {
    let amplitude = tracer.reduced.chain.stuck_loaded(
        &tracer.shape(mass),
        tracer.loaded(),
        &tracer.modes_at(),
        &tracer.contact("contact"),
        tracer.graph.input("inverse_r"),
    );
    let outputs = [amplitude.re, amplitude.im].map(Expr::operand);
    Alternative::of(tracer.graph, outputs.to_vec())
}
