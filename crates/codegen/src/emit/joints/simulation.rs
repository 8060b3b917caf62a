//! Emits the simulation of a scene with several contacts.

use super::{JointsEmission, wrapper};
use crate::Description;
use crate::emit::names::TypeNames;
use frictiongen_model::scene::Scene;
use proc_macro2::{Literal, TokenStream};
use quote::format_ident;

/// Emits the simulation: its type, and its items.
pub(super) fn emit(emission: &JointsEmission<'_>) -> (TokenStream, TokenStream) {
    let TypeNames {
        name, simulation, ..
    } = &emission.names;
    let scene = &emission.description.scene;
    let about = format!(
        " Exact motion of [`{name}`] in time under a harmonic load, from event to event.  Displacements are over P/k₁ (over Y for base motion), velocities are dx̄/dτ, and forces are over P (over k₁Y)."
    );
    let types = wrapper(emission, simulation, "Simulation", &about);
    let masses = Literal::usize_unsuffixed(scene.masses.len());
    let methods = methods(emission);
    let starts = starts(emission, &masses);
    let items = code! {
        impl #name {
            #starts
        }

        #methods
    };
    (types, items)
}

/// Returns the call that starts the simulation of a scene, for the documentation of the scene's type.
pub(super) fn start(scene: &Scene) -> &'static str {
    if !scene.has_length() {
        "simulation(r, beta)"
    } else {
        "simulation_under(r, beta, amplitude)"
    }
}

/// Documentation of the emitted constructor of a simulation, for a scene without lengths and speeds.
const ABOUT: [&str; 5] = [
    " Starts the exact motion in time from rest, at a maximum of the excitation.  β is the common friction: the",
    " friction of each contact is its share of it.",
    "",
    " # Errors",
    " `OutOfDomain` unless r is positive and finite, and β finite and not negative.",
];

/// Documentation of the emitted constructor of a simulation, for a scene with lengths or speeds.
const ABOUT_UNDER: [&str; 6] = [
    " Starts the exact motion in time from rest, at a maximum of the excitation.  `amplitude` is that of the load, in",
    " the units of the scene.  β is the common friction at vanishing speed: the friction of each contact is its share of",
    " it.",
    "",
    " # Errors",
    " `OutOfDomain` unless r and the amplitude are positive and finite, and β finite and not negative.",
];

/// Emits the constructors of the simulation. If the scene has lengths or speeds, the constructors also take the amplitude
/// of the load.
fn starts(emission: &JointsEmission<'_>, masses: &Literal) -> TokenStream {
    let JointsEmission {
        description: Description { facade, scene, .. },
        scalar,
        engine,
        names: TypeNames { simulation, .. },
        ..
    } = emission;
    let is_constant = !scene.has_length();
    let (about, suffix, new) = if is_constant {
        (&ABOUT[..], "", "new")
    } else {
        (&ABOUT_UNDER[..], "_under", "under")
    };
    let amplitude = (!is_constant).then(|| code!(amplitude: #scalar,));
    let ratios = if is_constant {
        code!((r, beta))
    } else {
        code!((r, beta, amplitude))
    };
    let start = format_ident!("simulation{suffix}");
    let start_from = format_ident!("simulation{suffix}_from");
    let new = format_ident!("{new}");
    code! {
        #(#[doc = #about])*
        pub fn #start(
            r: #scalar,
            beta: #scalar,
            #amplitude
        ) -> ::core::result::Result<#simulation, #facade::OutOfDomain> {
            #engine::Simulation::#new(
                Self::CHAIN,
                Self::REFERENCE,
                #ratios,
                ::core::option::Option::None,
            )
            .map(#simulation)
        }

        /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        pub fn #start_from(
            r: #scalar,
            beta: #scalar,
            #amplitude
            state: (&[#scalar; #masses], &[#scalar; #masses]),
        ) -> ::core::result::Result<#simulation, #facade::OutOfDomain> {
            #engine::Simulation::#new(
                Self::CHAIN,
                Self::REFERENCE,
                #ratios,
                ::core::option::Option::Some((&state.0[..], &state.1[..])),
            )
            .map(#simulation)
        }
    }
}

/// Emits the methods of the simulation.
fn methods(emission: &JointsEmission<'_>) -> TokenStream {
    let JointsEmission {
        description,
        scalar,
        engine,
        size,
        ..
    } = emission;
    let simulation = &emission.names.simulation;
    let facade = &description.facade;
    let methods = emission.methods("now");
    code! {
        impl #simulation {
            /// Advances by `reach` in the phase τ, and returns the number of events on the way.
            ///
            /// # Errors
            /// `OutOfDomain` for a reach that is negative or not finite, and if the motion exceeds a bound.
            pub fn advance(
                &mut self,
                reach: #scalar,
            ) -> ::core::result::Result<::core::primitive::u32, #facade::OutOfDomain> {
                self.0.advance(reach)
            }

            #methods
        }

        impl ::core::ops::Deref for #simulation {
            type Target = #engine::Simulation<#scalar, #size>;

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }
    }
}
