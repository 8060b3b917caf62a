//! Emits the stepper of a scene with several contacts.

use super::{JointsEmission, declared, wrapper_of};
use crate::emit::about::{NumberField, numbers_struct};
use crate::emit::names::{TypeNames, local};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Excitation, StepInput};
use proc_macro2::{Ident, Literal, TokenStream};

/// Emits the types of the stepper and of its input.
fn types(emission: &JointsEmission<'_>, target: &TokenStream) -> TokenStream {
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
        " Stepper: motion of [`{name}`] in time, by steps of one length, under any input.  `advance` takes a step."
    );
    let mut types = wrapper_of(emission, stepper, target, &about);
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
    let about_inputs = format!(
        " Loads on [`{name}`] and friction forces, in the units of the scene: the input of a step."
    );
    if let [_] = emission.contact_names.as_slice() {
        let about = format!(" Kinetic friction force {of_force}, not negative.");
        fields.push(NumberField::new(about, &local("friction"), scalar));
        types.extend(numbers_struct(description, input, &about_inputs, &fields));
        return types;
    }
    let about = format!(" Kinetic friction force of each contact {of_force}.");
    fields.push(NumberField::new(about, &local("friction"), friction));
    types.extend(numbers_struct(description, input, &about_inputs, &fields));
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
pub(super) fn emit(emission: &JointsEmission<'_>, modal: &Modal) -> (TokenStream, TokenStream) {
    let JointsEmission {
        description,
        scalar,
        engine,
        ..
    } = emission;
    let TypeNames { name, stepper, .. } = &emission.names;
    let facade = &description.facade;
    let scene = &description.scene;
    let input = match scene.stepping.input {
        StepInput::Linear => code!(Linear),
        StepInput::Hold => code!(Hold),
    };
    let on_base = scene.excitation == Excitation::Base;
    let pace = code!((dt, #facade::kernel::stepper::Input::#input, #on_base));
    let [masses, contacts] =
        [scene.masses.len(), emission.contact_count()].map(Literal::usize_unsuffixed);
    let (zero, entries) = (emission.number(0.0), emission.entries());
    let step = scene.stepping.step.map(|step| {
        let step = emission.number(step);
        code! {
            /// Step of the description, s.
            pub const STEP: #scalar = #step;
        }
    });
    let declared = declared::emit(emission, modal);
    let known = declared.as_ref().map(|_| {
        code! {
            if dt.to_bits() == Self::STEP.to_bits() {
                let known = #engine::Stepper::known(
                    Self::STEP_CHAIN,
                    Self::STEP_PACE,
                    Self::STEP_TABLES,
                    (x, v),
                );
                return known.map(#stepper);
            }
        }
    });
    let target = emission.stepper_type(&code!([#scalar; #entries]));
    let calls = calls(emission, stepper, &target);
    let mut items = code! {
        impl #name {
            #step

            /// Creates a stepper with the step dt, s, for a chain at rest without load.  Every friction force is 0.
            ///
            /// # Errors
            /// `OutOfDomain` for a step that is not positive and finite, or too long.
            pub fn stepper(dt: #scalar) -> ::core::result::Result<#stepper, #facade::OutOfDomain> {
                Self::stepper_from(dt, (&[#zero; #masses], &[#zero; #masses]))
            }

            /// Creates a stepper that starts from a state: displacements and velocities of all masses, in the order of the
            /// description.
            ///
            /// # Errors
            /// `OutOfDomain` also for a state that is not finite.
            pub fn stepper_from(
                dt: #scalar,
                (x, v): (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> ::core::result::Result<#stepper, #facade::OutOfDomain> {
                #known
                let started = #engine::Stepper::from_state(
                    Self::CHAIN,
                    #pace,
                    [#zero; #entries],
                    (x, v),
                );
                started.map(#stepper)
            }

            /// Creates a stepper from the bytes of an image.  The stepper has the step and the state of the stepper that wrote the
            /// image.
            ///
            /// # Errors
            /// `OutOfDomain` for an image of another scene or version, and for an image of which a bit has changed.
            pub fn stepper_from_image(
                bytes: &[::core::primitive::u8],
            ) -> ::core::result::Result<#stepper, #facade::OutOfDomain> {
                let mut stepper = Self::stepper(#engine::image_step(bytes, #contacts)?)?;
                stepper.0.restore_image(bytes)?;
                ::core::result::Result::Ok(stepper)
            }
        }

        #calls
    };
    let mut types = types(emission, &target);
    if let Some((own, more)) = declared {
        types.extend(own);
        items.extend(more);
    }
    (types, items)
}

/// Emits the functions of a stepper type that take an input, and a method for each mass and each contact. `target` is
/// the type that the stepper wraps.
pub(super) fn calls(
    emission: &JointsEmission<'_>,
    stepper: &Ident,
    target: &TokenStream,
) -> TokenStream {
    let JointsEmission {
        description,
        engine,
        scalar,
        ..
    } = emission;
    let facade = &description.facade;
    let masses = description.scene.masses.len();
    let loads = emission.loads.len() + description.scene.joints.constant.len();
    let lengths = [masses, emission.contact_count(), loads];
    let lengths = lengths.map(Literal::usize_unsuffixed);
    let input = &emission.names.input;
    let loads = emission.loads.iter().map(|(_, field)| field);
    let base = if description.scene.excitation == Excitation::Base {
        code!([input.displacement, input.velocity])
    } else {
        let zero = emission.number(0.0);
        code!([#zero; 2])
    };
    let frictions = match emission.contact_names.as_slice() {
        [_] => code!(input.friction),
        contacts => code!(#(input.friction.#contacts),*),
    };
    let sample = code! {
        #engine::Sample { base: #base, forces: &[#(input.#loads),*], frictions: &[#frictions] }
    };
    let methods = emission.methods("at the end of the last step");
    let result = |of: TokenStream| code!(::core::result::Result<#of, #facade::OutOfDomain>);
    let (begun, stepped) = (result(code!(())), result(code!(#engine::Stepped)));
    code! {
        impl #stepper {
            /// Sets the input at the start of the first step.  Without this call the input there is 0.
            ///
            /// # Errors
            /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
            pub fn begin(&mut self, input: #input) -> #begun {
                self.0.begin(#sample)
            }

            /// Takes a step.  Returns the number of its events.
            ///
            /// # Errors
            /// `OutOfDomain` for a force or a base motion that is not finite, for a friction force that is negative or not finite, and if
            /// the motion exceeds the range of numbers.  The stepper then keeps its state.
            pub fn advance(&mut self, input: #input) -> #stepped {
                self.0.advance(#sample)
            }

            /// Length of an image of the stepper's state, in bytes.
            pub const IMAGE: ::core::primitive::usize = #engine::image_bytes(
                ::core::mem::size_of::<#scalar>(),
                #(#lengths),*
            );

            /// Returns the state as bytes, for a file or for flash memory.  `stepper_from_image` continues from these bytes.  The
            /// bytes contain a hash of the scene and of the step, a version and a checksum.
            #[must_use]
            pub fn image(&self) -> [::core::primitive::u8; Self::IMAGE] {
                let mut bytes = [0; Self::IMAGE];
                self.0.write_image(&mut bytes);
                bytes
            }

            #methods
        }

        impl ::core::ops::Deref for #stepper {
            type Target = #target;

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }

        impl ::core::ops::DerefMut for #stepper {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.0
            }
        }
    }
}
