//! The steady state in any regime.

use super::dynamics::{Constants, count};
use super::{Emission, Part, not_copied};
use frictiongen_kernel::orbit::numbers;
use proc_macro2::TokenStream;

pub(super) fn emit(emission: &Emission<'_>, constants: &Constants) -> Part {
    let Emission {
        description,
        scene,
        modal,
        reduced,
        name,
        at,
        orbit,
        scalar,
        facade,
        ..
    } = emission;
    let visibility = &description.visibility;
    let derives = not_copied();
    let driven = constants.driven;
    let parts = count(constants.parts);
    let masses = count(scene.masses.len());
    let room = count(numbers(scene.masses.len(), driven));
    let multipliers = count(2 * driven);
    let about = format!(
        " The steady state of [`{name}`] at one frequency and one friction ratio, in any regime."
    );
    let kernel = code!(#facade::kernel);
    let number = code!(::core::primitive::#scalar);
    let types = code! {
        #[doc = #about]
        #derives
        #[allow(non_camel_case_types)]
        #visibility struct #orbit {
            orbit: #kernel::orbit::Orbit<
                'static,
                #number,
                [#kernel::simulation::Part<#number>; #parts],
                [#number; #room],
                [#facade::Complex<#number>; #multipliers],
            >,
        }
    };
    let stored = code! {
        #scalar, [Part<#scalar>; #parts], [#scalar; #room], [Complex<#scalar>; #multipliers]
    };
    let methods = description
        .mass_names
        .iter()
        .enumerate()
        .map(|(mass, method)| {
            let about = format!(" The motion of mass `{method}`.");
            // On a support at rest its motion is the contact's.
            let rubs = reduced.chain.on_moving_base.is_none() && modal.contact == (mass, None);
            let index = count(mass);
            let motion = if rubs {
                code!(self.orbit.contact())
            } else {
                code!(self.orbit.mass(#index))
            };
            code! {
                #[doc = #about]
                #[must_use]
                pub fn #method(&self) -> OrbitMotion<'_, 'static, #stored> {
                    #motion
                }
            }
        });
    let methods: TokenStream = methods.collect();
    let asked = description.mass_names.iter().enumerate();
    let asked: TokenStream = asked
        .map(|(mass, method)| {
            let index = count(mass);
            code!(#facade::Of::Mass(#index) => Some(question(&self.#method())),)
        })
        .collect();
    let items = code! {
        impl #at {
            /// The steady state at β = F/P that is reached from rest, in any regime.
            ///
            /// # Errors
            /// `NoOrbit` says why there is none.
            pub fn orbit(&self, beta: #scalar) -> Result<#orbit, NoOrbit> {
                self.settled(beta, None, false)
            }

            /// The steady state as `orbit` gives it.  Where the motion from rest does not settle, its last 64 cycles
            /// stand in its place: `is_settled()` is false, and an amplitude is the largest of those cycles.
            ///
            /// # Errors
            /// `NoOrbit` if the motion is unbounded, if following it takes too many steps, or if β is negative or not finite.
            pub fn orbit_or_last_cycles(&self, beta: #scalar) -> Result<#orbit, NoOrbit> {
                self.settled(beta, None, true)
            }

            /// The steady state that is reached from another state at a maximum of the excitation: x̄ and dx̄/dτ
            /// of every mass.
            ///
            /// # Errors
            /// `NoOrbit`, also for a state that is not finite.
            pub fn orbit_from(
                &self,
                beta: #scalar,
                state: (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> Result<#orbit, NoOrbit> {
                self.settled(beta, Some((state.0, state.1)), false)
            }

            fn settled(
                &self,
                beta: #scalar,
                state: Option<(&[#scalar], &[#scalar])>,
                last: ::core::primitive::bool,
            ) -> Result<#orbit, NoOrbit> {
                let orbit = Orbit::new(
                    #name::DYNAMICS,
                    self.r,
                    beta,
                    self.sliding_limit(),
                    state,
                    last,
                    [Part::empty(); #parts],
                    [0.0; #room],
                    [Complex { re: 0.0, im: 0.0 }; #multipliers],
                )?;
                Ok(#orbit { orbit })
            }
        }

        impl #orbit {
            #methods
        }

        impl #facade::OrbitAt for #at {
            type Orbit<'o> = #orbit;

            fn orbit(&self, beta: #scalar) -> Result<#orbit, NoOrbit> {
                Self::orbit(self, beta)
            }
            fn orbit_or_last_cycles(&self, beta: #scalar) -> Result<#orbit, NoOrbit> {
                Self::orbit_or_last_cycles(self, beta)
            }
        }

        impl #facade::SteadyState for #orbit {
            type Scalar = #scalar;

            fn period(&self) -> ::core::primitive::u32 {
                self.orbit.period()
            }
            fn is_settled(&self) -> ::core::primitive::bool {
                self.orbit.is_settled()
            }
            fn stops(&self) -> ::core::primitive::usize {
                self.orbit.stops()
            }
            fn reversals(&self) -> ::core::primitive::usize {
                self.orbit.reversals()
            }
            fn stuck_fraction(&self) -> #scalar {
                self.orbit.stuck_fraction()
            }
            fn is_symmetric(&self) -> ::core::primitive::bool {
                self.orbit.is_symmetric()
            }
            fn is_stable(&self) -> ::core::primitive::bool {
                self.orbit.is_stable()
            }
            fn is_marginal(&self) -> ::core::primitive::bool {
                self.orbit.is_marginal()
            }
            fn multipliers(&self) -> &[Complex<#scalar>] {
                self.orbit.multipliers()
            }
            fn ask<T>(
                &self,
                of: #facade::Of,
                question: impl ::core::ops::FnOnce(&dyn #facade::Periodic<Scalar = #scalar>) -> T,
            ) -> Option<T> {
                match of {
                    #facade::Of::Contact => Some(question(&self.orbit.contact())),
                    #asked
                    _ => None,
                }
            }
        }

        impl ::core::ops::Deref for #orbit {
            type Target = Orbit<'static, #stored>;

            fn deref(&self) -> &Self::Target {
                &self.orbit
            }
        }
    };
    Part { types, items }
}
