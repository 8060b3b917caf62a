//! The exact motion in time.

use super::dynamics::{Constants, count};
use super::{Emission, Part, not_copied};
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
    let derives = not_copied();
    let parts = count(constants.parts);
    let masses = count(scene.masses.len());
    let about = format!(
        " The exact motion of [`{name}`] in time, from event to event; `next` gives its segments."
    );
    let kernel = code!(#facade::kernel::simulation);
    let run = code! {
        #kernel::Simulation<
            'static,
            ::core::primitive::#scalar,
            [#kernel::Part<::core::primitive::#scalar>; #parts],
        >
    };
    let types = code! {
        #[doc = #about]
        #derives
        #[allow(non_camel_case_types)]
        #visibility struct #simulation {
            run: #run,
        }
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
                    self.run.mass(#index)
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
                let run = Simulation::new(Self::DYNAMICS, r, beta, None, [Part::empty(); #parts])?;
                Ok(#simulation { run })
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
                let run = Simulation::new(
                    Self::DYNAMICS,
                    r,
                    beta,
                    Some((state.0, state.1)),
                    [Part::empty(); #parts],
                )?;
                Ok(#simulation { run })
            }
        }

        impl #simulation {
            #methods
        }

        impl #facade::Simulates for #name {
            type Run<'a> = #simulation;

            fn simulation(&self, r: #scalar, beta: #scalar) -> Result<#simulation, OutOfDomain> {
                Self::simulation(r, beta)
            }
        }

        impl ::core::ops::Deref for #simulation {
            type Target = Simulation<'static, #scalar, [Part<#scalar>; #parts]>;

            fn deref(&self) -> &Self::Target {
                &self.run
            }
        }

        impl ::core::ops::DerefMut for #simulation {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.run
            }
        }

        impl<'a> IntoIterator for &'a mut #simulation {
            type Item = Segment<#scalar>;
            type IntoIter = &'a mut Simulation<'static, #scalar, [Part<#scalar>; #parts]>;

            fn into_iter(self) -> Self::IntoIter {
                &mut self.run
            }
        }
    };
    Part { types, items }
}
