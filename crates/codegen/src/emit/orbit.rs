//! Emits the type of the steady state in any regime, with the code that computes it.

use super::dynamics::{DynamicsConstants, count};
use super::emission::{Emission, EmittedCode};
use super::names::TypeNames;
use super::table::counted;
use frictiongen_kernel::orbit::{MAX_STEPS, numbers_of};

pub(super) fn emit(emission: &Emission<'_>, constants: &DynamicsConstants) -> EmittedCode {
    let Emission {
        description,
        scene,
        scalar,
        facade,
        names: TypeNames { name, orbit, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let parts = count(constants.parts);
    let modes = counted(constants.parts, "mode");
    let masses = count(scene.masses.len());
    let room = count(numbers_of(scene.masses.len(), constants.state));
    let multipliers = count(constants.state);
    let about = format!(
        " Steady state of [`{name}`] at one frequency and one friction ratio, in any regime."
    );
    let sizes_about = format!(
        " Room for {parts} modes of the chain and of the stuck chain, for {room} numbers (states at the starts of segments, Jacobian matrices) and for {multipliers} Floquet multipliers."
    );
    let work_about = format!(
        " Worst case: {MAX_STEPS} steps of all searches for events together, each a sum over at most {modes}, those of the chain and of the stuck chain, and Newton's method on {multipliers} unknowns."
    );
    let sizes = code!(#parts, #room, #multipliers);
    let (law, law_in_types, law_word) =
        (emission.law(), emission.law_in_types(), emission.law_word());
    let types = code! {
        #[doc = #about]
        ///
        #[doc = #sizes_about]
        ///
        #[doc = #work_about]
        #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
        #visibility struct #orbit(
            #facade::kernel::orbit::FixedOrbit<::core::primitive::#scalar, #sizes #law_in_types>
        );
    };
    let methods = description.mass_names.iter().enumerate();
    let methods = methods.map(|(mass, method)| {
        let about = format!(" Motion of mass `{method}`.");
        let index = count(mass);
        code! {
            #[doc = #about]
            #[must_use]
            pub fn #method(&self) -> FixedOrbitMotion<'_, #scalar, #sizes #law> {
                self.mass(#index)
            }
        }
    });
    let contact = emission.contact_method(
        &code!(contact),
        &code!(FixedOrbitMotion<'_, #scalar, #sizes #law>),
    );
    let items = code! {
        impl ProvidesOrbit for #name {
            type Orbit = #orbit;
            type State = [#scalar; #masses];

            /// Returns the steady state that the motion from `start` reaches.  If the motion does not settle and `last` is true, it
            /// returns its last 64 cycles.  Otherwise the error [`NoOrbit`] gives the reason.
            #[inline]
            fn settled(
                at: &At<Self>,
                beta: #scalar,
                start: Start<'_, #scalar>,
                last: bool,
            ) -> Result<#orbit, NoOrbit> {
                Orbit::new(
                    Self::DYNAMICS,
                    at.frequency_ratio(),
                    beta,
                    at.sliding_limit(),
                    start,
                    last,
                    [Part::empty(); #parts],
                    [0.0; #room],
                    [Complex { re: 0.0, im: 0.0 }; #multipliers],
                )
                .map(From::from)
            }
        }

        /// `Clone`, `Debug`, `From` and `Deref`: the steady state has all methods of the wrapped type.
        #facade::kernel::wraps!(#orbit, FixedOrbit of #law_word #scalar, #sizes);

        impl #orbit {
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
