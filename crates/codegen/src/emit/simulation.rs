//! Emits the type that simulates the exact motion in time, with its constructors.

use super::dynamics::{DynamicsConstants, count};
use super::emission::{Checked, Emission, EmittedCode, rounded};
use super::names::TypeNames;
use super::table::counted;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::simulation::{MAX_STEPS, MAX_STRETCHES};
use frictiongen_model::scene::FrictionLaw;
use frictiongen_model::stepping::StepperSettings;
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, constants: &DynamicsConstants) -> EmittedCode {
    let Emission {
        description,
        scene,
        scalar,
        facade,
        names: TypeNames {
            name, simulation, ..
        },
        ..
    } = emission;
    let visibility = &description.visibility;
    let parts = count(constants.parts);
    let modes = counted(constants.parts, "mode");
    let constant = scene.friction == FrictionLaw::Coulomb;
    let (law, law_in_types, law_word) =
        (emission.law(), emission.law_in_types(), emission.law_word());
    let target = if constant {
        code!(FixedSimulation)
    } else {
        code!(FixedLinesSimulation)
    };
    let about = format!(
        " Exact motion of [`{name}`] in time, from event to event.  `next` returns its segments and never ends."
    );
    let work_about = if constant {
        format!(
            " Worst case of `next`: {MAX_STEPS} steps of the search for the end of a segment, each a sum over at most {modes}, those of the chain and of the stuck chain; of `advance` two segments."
        )
    } else {
        format!(
            " Worst case of `advance`: {MAX_STRETCHES} stretches of at most 128 steps, or of {MAX_STEPS} where the kinetic friction is constant; a step is a sum over at most {modes}, those of the chain and of the stuck chain."
        )
    };
    let types = code! {
        #[doc = #about]
        ///
        #[doc = #work_about]
        #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
            #visibility struct #simulation(
                #facade::kernel::simulation::#target<::core::primitive::#scalar, #parts #law_in_types>
            );
    };
    let methods = description
        .mass_names
        .iter()
        .enumerate()
        .map(|(index, method)| {
            let about =
                format!(" Displacement and velocity of mass `{method}` at the present instant.");
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
    let contact = emission.contact_method(
        &code!(contact),
        &code!(#facade::kernel::simulation::Contact),
    );
    let ([starts, trait_of], constants) = if constant {
        (starts(emission, &parts), Vec::new())
    } else {
        starts_under(emission, &parts)
    };
    let items = code! {
        /// `Clone`, `Debug`, `From` and `Deref`: the simulation has all methods of the wrapped type.
        #facade::kernel::wraps!(#simulation, #target of #law_word #scalar, #parts);

        impl #simulation {
            #methods

            #contact
        }

        #trait_of

        impl ::core::ops::DerefMut for #simulation {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.0
            }
        }

        impl<'a> IntoIterator for &'a mut #simulation {
            type Item = Segment<#scalar>;
            type IntoIter = &'a mut #target<#scalar, #parts #law>;

            fn into_iter(self) -> Self::IntoIter {
                &mut self.0
            }
        }
    };
    EmittedCode {
        types,
        associated: starts,
        items,
        constants,
        ..EmittedCode::default()
    }
}

/// Emits the constructors of a simulation with constant kinetic friction.
fn starts(emission: &Emission<'_>, parts: &Literal) -> [TokenStream; 2] {
    let Emission {
        scalar,
        facade,
        names: TypeNames {
            name, simulation, ..
        },
        ..
    } = emission;
    let masses = count(emission.scene.masses.len());
    let starts = code! {
            /// Starts the exact motion in time from rest, at a maximum of the excitation.
            ///
            /// # Errors
            /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
            pub fn simulation(r: #scalar, beta: #scalar) -> Result<#simulation, OutOfDomain> {
                let parts = [Part::empty(); #parts];
                Simulation::new(Self::DYNAMICS, r, beta, None, parts).map(From::from)
            }

            /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass, in the order of the description.
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
    };
    let trait_of = code! {
        impl #facade::Simulates for #name {
            type Run<'a> = #simulation;

            fn simulation(&self, r: #scalar, beta: #scalar) -> Result<#simulation, OutOfDomain> {
                Self::simulation(r, beta)
            }
        }
    };
    [starts, trait_of]
}

/// Emits the constructors of a simulation whose kinetic friction depends on the speed.
fn starts_under(emission: &Emission<'_>, parts: &Literal) -> ([TokenStream; 2], Vec<Checked>) {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        facade,
        names: TypeNames {
            name, simulation, ..
        },
        ..
    } = emission;
    let masses = count(scene.masses.len());
    let steps = StepperSettings::<f64>::of(scene, modal, std::iter::empty(), |value: Dd| {
        rounded(value, *precision)
    });
    let law = steps.law.iter().map(|point| emission.list(*point));
    let speed = emission.literal(steps.speed);
    let constants = vec![
        Checked::new("LAW", code!(&Self::LAW), &steps.law.as_slice()),
        Checked::new("SPEED", code!(&Self::SPEED), &steps.speed),
    ];
    let starts = code! {
            /// Points of the friction law: speed, and kinetic friction over F.
            const LAW: &'static [[#scalar; 2]] = &[#(#law),*];

            /// Relative velocity at dz̄/dτ = 1, for r = 1 and a load of amplitude 1.
            const SPEED: #scalar = #speed;

            /// Starts the exact motion in time from rest, at a maximum of the excitation.  `amplitude` is that of the load, in
            /// the units of the scene; β is the kinetic friction at vanishing speed.
            ///
            /// # Errors
            /// `OutOfDomain` unless r and the amplitude are positive and finite, and β finite and not negative; and for a
            /// friction law that is too steep under this load.
            pub fn simulation_under(
                r: #scalar,
                beta: #scalar,
                amplitude: #scalar,
            ) -> Result<#simulation, OutOfDomain> {
                Self::started(r, beta, amplitude, None)
            }

            /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass, in the order of the description.
            ///
            /// # Errors
            /// `OutOfDomain` also for a state that is not finite.
            pub fn simulation_under_from(
                r: #scalar,
                beta: #scalar,
                amplitude: #scalar,
                state: (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> Result<#simulation, OutOfDomain> {
                Self::started(r, beta, amplitude, Some((&state.0[..], &state.1[..])))
            }

            fn started(
                r: #scalar,
                beta: #scalar,
                amplitude: #scalar,
                state: Option<(&[#scalar], &[#scalar])>,
            ) -> Result<#simulation, OutOfDomain> {
                let lines = Lines::under(Self::LAW, r, amplitude, Self::SPEED);
                let parts = [Part::empty(); #parts];
                Simulation::along(Self::DYNAMICS, r, beta, lines, state, parts).map(From::from)
            }
    };
    let trait_of = code! {
        impl #facade::SimulatesUnder for #name {
            type Scalar = #scalar;
            type Run<'a> = #simulation;

            fn simulation_under(
                &self,
                r: #scalar,
                beta: #scalar,
                amplitude: #scalar,
            ) -> Result<#simulation, OutOfDomain> {
                Self::simulation_under(r, beta, amplitude)
            }
        }
    };
    ([starts, trait_of], constants)
}
