//! The exact motion in time.

use super::dynamics::{Constants, count};
use super::{Emission, Part};
use proc_macro2::TokenStream;

pub(super) fn emit(emission: &Emission<'_>, constants: &Constants) -> Part {
    let Emission {
        description,
        scene,
        name,
        simulation,
        scalar,
        facade,
        ..
    } = emission;
    let visibility = &description.visibility;
    let parts = count(constants.parts);
    let masses = count(scene.masses.len());
    let about = format!(
        " The exact motion of [`{name}`] in time, from event to event; `next` gives its segments."
    );
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types)]
            #visibility struct #simulation(
                #facade::kernel::simulation::FixedSimulation<::core::primitive::#scalar, #parts>
            );
    };
    let methods = description
        .mass_names
        .iter()
        .enumerate()
        .map(|(index, method)| {
            let about = format!(" Displacement and velocity of mass `{method}` now.");
            let index = count(index);
            code! {
                #[doc = #about]
                #[must_use]
                pub fn #method(&self) -> Moment<#scalar> {
                    self.mass(#index)
                }
            }
        });
    let methods: TokenStream = methods.collect();
    let items = code! {
        impl #name {
            /// The exact motion in time from rest, the excitation at its maximum.
            ///
            /// # Errors
            /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
            pub fn simulation(r: #scalar, beta: #scalar) -> Result<#simulation, OutOfDomain> {
                let parts = [Part::empty(); #parts];
                Simulation::new(Self::DYNAMICS, r, beta, None, parts).map(From::from)
            }

            /// The same from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass.
            ///
            /// # Errors
            /// `OutOfDomain` also for a state that is not finite.
            pub fn simulation_from(
                r: #scalar,
                beta: #scalar,
                state: (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> Result<#simulation, OutOfDomain> {
                let parts = [Part::empty(); #parts];
                let start = Some((&state.0[..], &state.1[..]));
                Simulation::new(Self::DYNAMICS, r, beta, start, parts).map(From::from)
            }
        }

        #facade::kernel::wraps!(#simulation, FixedSimulation of #scalar, #parts);

        impl #simulation {
            #methods
        }

        impl #facade::Simulates for #name {
            type Run<'a> = #simulation;

            fn simulation(&self, r: #scalar, beta: #scalar) -> Result<#simulation, OutOfDomain> {
                Self::simulation(r, beta)
            }
        }

        impl ::core::ops::DerefMut for #simulation {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.0
            }
        }

        impl<'a> IntoIterator for &'a mut #simulation {
            type Item = Segment<#scalar>;
            type IntoIter = &'a mut FixedSimulation<#scalar, #parts>;

            fn into_iter(self) -> Self::IntoIter {
                &mut self.0
            }
        }
    };
    Part { types, items }
}
