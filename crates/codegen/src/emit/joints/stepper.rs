//! Emits the stepper of a scene with several contacts.

use super::{JointsEmission, wrapper};
use crate::emit::about::{NumberField, numbers_struct};
use crate::emit::names::{TypeNames, local};
use frictiongen_kernel::joints::MAX_STEP_EVENTS;
use frictiongen_model::scene::{Excitation, StepInput};
use proc_macro2::TokenStream;

/// Emits the types of the stepper and of its input.
fn types(emission: &JointsEmission<'_>) -> TokenStream {
    let JointsEmission {
        description,
        friction,
        scalar,
        ..
    } = emission;
    let TypeNames {
        name,
        stepper,
        input,
        ..
    } = &emission.names;
    let scene = &description.scene;
    let about = format!(
        " Stepper: motion of [`{name}`] in time, by steps of one length, under any input.  `advance` takes a step, with at most {} events.",
        MAX_STEP_EVENTS
    );
    let mut types = wrapper(emission, stepper, "Stepper", &about);
    let (of_base, of_force) = match scene.stepping.input {
        StepInput::Linear => ("at the end of the step", "at the end of the step"),
        StepInput::Hold => ("at the start of the step", "during the step"),
    };
    let mut fields = Vec::new();
    if scene.excitation == Excitation::Base {
        let (displacement, velocity) = (local("displacement"), local("velocity"));
        let about = format!(" Displacement of the base {of_base}.");
        fields.push(NumberField::new(about, &displacement, scalar));
        let about =
            format!(" Velocity of the base {of_base}, in the unit of displacement per second.");
        fields.push(NumberField::new(about, &velocity, scalar));
    }
    fields.extend(emission.loads.iter().map(|(mass, field)| {
        let mass = scene.masses.get(*mass).map_or("", |mass| &mass.name);
        let about = format!(" Force on mass `{mass}` {of_force}.");
        NumberField::new(about, field, scalar)
    }));
    let about = " Kinetic friction force of each contact during the step.";
    fields.push(NumberField::new(about, &local("friction"), friction));
    let about = format!(
        " Loads on [`{name}`] and friction forces, in the units of the scene: the input of a step."
    );
    types.extend(numbers_struct(description, input, &about, &fields));
    let contacts = emission.contact_names.iter().map(|contact| {
        let about = format!(
            " Kinetic friction force of contact `{contact}`, not negative.  A contact with 0 has no effect."
        );
        NumberField::new(about, contact, scalar)
    });
    let about = format!(" Friction forces of [`{name}`], by contact.");
    let fields: Vec<_> = contacts.collect();
    types.extend(numbers_struct(description, friction, &about, &fields));
    types
}

/// Emits the stepper: its types, and its items.
pub(super) fn emit(emission: &JointsEmission<'_>) -> (TokenStream, TokenStream) {
    let JointsEmission {
        description,
        scalar,
        size,
        engine,
        ..
    } = emission;
    let TypeNames {
        name,
        stepper,
        input,
        ..
    } = &emission.names;
    let facade = &description.facade;
    let scene = &description.scene;
    let holds = scene.stepping.input == StepInput::Hold;
    let step = scene.stepping.step.map(|step| {
        let step = emission.number(step);
        code! {
            /// Step of the description, s.
            pub const STEP: #scalar = #step;
        }
    });
    let loads = emission.loads.iter().map(|(_, field)| field);
    let base = if scene.excitation == Excitation::Base {
        code!([input.displacement, input.velocity])
    } else {
        let zero = emission.number(0.0);
        code!([#zero; 2])
    };
    let contacts = &emission.contact_names;
    let methods = emission.methods("at the end of the last step");
    let items = code! {
        impl #name {
            #step

            /// Creates a stepper with the step dt, s, for a chain at rest.  Every friction force is 0 before the first step.
            ///
            /// # Errors
            /// `OutOfDomain` for a step that is not positive and finite, or too long.
            pub fn stepper(dt: #scalar) -> ::core::result::Result<#stepper, #facade::OutOfDomain> {
                #engine::Stepper::new(Self::CHAIN, dt, #holds).map(#stepper)
            }
        }

        impl #stepper {
            /// Takes a step, and returns the number of its events.
            ///
            /// # Errors
            /// `OutOfDomain` for a force or a base motion that is not finite, for a friction force that is negative or not finite, and if
            /// the motion exceeds a bound.  The stepper then keeps its state.
            pub fn advance(
                &mut self,
                input: #input,
            ) -> ::core::result::Result<::core::primitive::u32, #facade::OutOfDomain> {
                self.0.advance(#base, &[#(input.#loads),*], &[#(input.friction.#contacts),*])
            }

            #methods
        }

        impl ::core::ops::Deref for #stepper {
            type Target = #engine::Stepper<#scalar, #size>;

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }
    };
    (types(emission), items)
}
