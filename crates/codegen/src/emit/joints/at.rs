//! Emits a scene with several contacts at one frequency: the state in which no contact slides, and the steady states.

use super::{JointsEmission, wrapper};
use crate::emit::names::TypeNames;
use frictiongen_model::scene::Provide;
use proc_macro2::{Ident, Literal, TokenStream};

/// Emits the type of the scene at one frequency. Returns the definitions of the types, and the items that implement
/// them.
pub(super) fn emit(emission: &JointsEmission<'_>) -> (TokenStream, TokenStream) {
    let JointsEmission {
        description,
        scalar,
        engine,
        ..
    } = emission;
    let TypeNames { name, at, .. } = &emission.names;
    let facade = &description.facade;
    let about = format!(" [`{name}`] at one frequency.");
    let mut types = wrapper(emission, at, "At", &about);
    let contacts = emission.contacts.iter().map(|contact| &contact.name);
    let deref = deref(emission, at, &code!(At));
    let mut items = code! {
        impl #name {
            /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁).
            ///
            /// # Errors
            /// `OutOfDomain` unless r is positive and finite.
            pub fn at(r: #scalar) -> ::core::result::Result<#at, #facade::OutOfDomain> {
                #engine::At::new(Self::CHAIN, Self::REFERENCE, r, &[#(#contacts),*]).map(#at)
            }
        }

        #deref
    };
    for (what, part) in [
        (Provide::Stuck, stuck(emission)),
        (Provide::Orbit, orbit(emission)),
    ] {
        if emission.provides(&what) {
            types.extend(part.0);
            items.extend(part.1);
        }
    }
    (types, items)
}

/// Emits `Deref`, which gives access to the methods of the kernel's type that the emitted type wraps.
fn deref(emission: &JointsEmission<'_>, own: &Ident, target: &TokenStream) -> TokenStream {
    let JointsEmission {
        scalar,
        size,
        engine,
        ..
    } = emission;
    code! {
        impl ::core::ops::Deref for #own {
            type Target = #engine::#target<#scalar, #size>;

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }
    }
}

/// Emits the type of the state in which no contact slides, and the method that returns it.
fn stuck(emission: &JointsEmission<'_>) -> (TokenStream, TokenStream) {
    let JointsEmission {
        description,
        scalar,
        ..
    } = emission;
    let TypeNames {
        name, at, stuck, ..
    } = &emission.names;
    let facade = &description.facade;
    let about = format!(
        " State of [`{name}`] in which no contact slides, in closed form.  Displacements are over P/k₁ (over Y for base motion), and forces are over P (over k₁Y)."
    );
    let types = wrapper(emission, stuck, "StuckState", &about);
    let methods = emission.named(
        [
            "Complex amplitude X of mass `{}`.  Its motion is x̄ = Re X exp(iτ).",
            "Amplitude of the force of contact `{}`.",
        ],
        [&code!(#facade::Complex<#scalar>), scalar],
    );
    let deref = deref(emission, stuck, &code!(StuckState));
    let items = code! {
        impl #at {
            /// Returns the state in which no contact slides, the common friction from which it exists (`limit`), and
            /// the contact that slides first below it (`first`).  No earlier motion has left a force in a contact.
            ///
            /// # Errors
            /// `StuckResonance` on an undamped resonance of the chain with its contacts stuck.
            pub fn stuck(&self) -> ::core::result::Result<#stuck, #facade::StuckResonance> {
                self.0.stuck().map(#stuck)
            }
        }

        impl #stuck {
            #methods
        }

        #deref
    };
    (types, items)
}

/// Emits the type of a steady state, and the methods that return it.
fn orbit(emission: &JointsEmission<'_>) -> (TokenStream, TokenStream) {
    let JointsEmission {
        description,
        scalar,
        size,
        engine,
        ..
    } = emission;
    let TypeNames {
        name, at, orbit, ..
    } = &emission.names;
    let facade = &description.facade;
    let about = format!(
        " Steady state of [`{name}`].  Displacements are over P/k₁ (over Y for base motion), forces are over P (over k₁Y), and energies are over P²/k₁ (over k₁Y²)."
    );
    let types = wrapper(emission, orbit, "Orbit", &about);
    let methods = emission.named(
        [
            "Motion of mass `{}` over the period.",
            "Motion of contact `{}` over the period.",
        ],
        [
            &code!(#engine::MassOrbit<'_, #scalar, #size>),
            &code!(#engine::ContactOrbit<'_, #scalar, #size>),
        ],
    );
    let masses = Literal::usize_unsuffixed(description.scene.masses.len());
    let deref = deref(emission, orbit, &code!(Orbit));
    let items = code! {
        impl #at {
            /// Returns the steady state that the motion from rest reaches.  β is the common friction: the friction of
            /// each contact is its share of it.
            ///
            /// # Errors
            /// `NoOrbit::OutOfDomain` for a β that is negative or not finite, and if the motion exceeds a bound.
            /// `NoOrbit::Unsettled` if the motion does not settle on a period of at most 64 cycles.
            pub fn orbit(
                &self,
                beta: #scalar,
            ) -> ::core::result::Result<#orbit, #facade::NoOrbit> {
                self.0.orbit(beta, ::core::option::Option::None).map(#orbit)
            }

            /// Returns the steady state that the motion from a state reaches.  The state is x̄ and dx̄/dτ of every mass
            /// at a maximum of the excitation.
            ///
            /// # Errors
            /// Those of `orbit`, also for a state that is not finite.
            pub fn orbit_from(
                &self,
                beta: #scalar,
                state: (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> ::core::result::Result<#orbit, #facade::NoOrbit> {
                let state = (&state.0[..], &state.1[..]);
                self.0.orbit(beta, ::core::option::Option::Some(state)).map(#orbit)
            }
        }

        impl #orbit {
            #methods
        }

        #deref
    };
    (types, items)
}
