//! Emits the stepper, which advances by a fixed step in physical time under any input.

use super::dynamics::{Constants, count};
use super::emission::{Emission, Part, rounded};
use super::names::{TypeNames, local};
use super::step_table::{self, Sizes};
use frictiongen_kernel::motion::LOST_MODES;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Cost, Input, MAX_EVENTS, MAX_PARTS, MAX_STRETCHES, StepScene, Units, series_terms,
};
use frictiongen_model::scene::Precision;
use frictiongen_model::stepping::Steps;
use frictiongen_model::transient::Transient;
use proc_macro2::{Ident, Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, constants: &Constants) -> Part {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        facade,
        names:
            TypeNames {
                name,
                stepper,
                input,
                ..
            },
        ..
    } = emission;
    let steps = Steps::of(scene, modal, std::iter::empty(), |value| value);
    let transient = Transient::<Dd>::of(scene, modal, |value| value);
    let exact = steps.scene(transient.dynamics());
    let sizes = Sizes {
        coefficients: steps.coefficients(),
        modes: transient.modes.len(),
        held: constants.driven - LOST_MODES,
        inputs: steps.inputs(),
    };
    let literals = sizes.literals();
    let masses = count(scene.masses.len());
    let number = |value: Dd| emission.literal(rounded(value, *precision));
    let step_scene = step_scene(emission, &steps, &number);
    let tables = scene
        .stepping
        .step
        .and_then(|step| step_table::emit(emission, &exact, step, &sizes));
    let mut cost = cost(&exact, scene.stepping.step);
    cost.extend(operations(
        &exact,
        scene.stepping.step,
        sizes.coefficients,
        *precision,
    ));
    let from_tables = tables.is_some().then(|| {
        code! {
            if dt == Self::STEP {
                return Ok(Self::STEP_TABLES);
            }
        }
    });
    let types = types(emission, &steps, &literals, &cost);
    let costs = format!(" [`{stepper}`] says what it costs.");
    let methods = methods(emission);
    let fields = force_fields(emission, &steps);
    let base = if steps.on_base {
        code!([input.displacement, input.velocity])
    } else {
        code!([0.0; 2])
    };
    let sample = code! {
        Sample { base: #base, forces: &[#(input.#fields),*], friction: input.friction }
    };
    let when = match steps.input {
        Input::Hold => " Takes a step under an input that is held over it.",
        Input::Linear => " Takes a step, in a straight line from the last input to this one.",
    };
    let loaded = steps.forces.iter().map(|mass| count(*mass));
    let on_base = steps.on_base;
    let associated = code! {
            #step_scene
            #tables

            #[inline]
            fn step_tables(dt: #scalar) -> Result<FixedTables<#scalar, #literals>, OutOfDomain> {
                #from_tables
                FixedTables::new(&Self::STEP_SCENE, dt)
            }

            /// The motion by steps of dt, in s, from rest under no load.
            ///
            /// # Errors
            /// `OutOfDomain` for a step that is not positive and finite, or too long.
            #[inline]
            pub fn stepper(dt: #scalar) -> Result<#stepper, OutOfDomain> {
                let tables = Self::step_tables(dt)?;
                Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None).map(From::from)
            }

            /// The same from a state: displacement and velocity of every mass.
            ///
            /// # Errors
            /// `OutOfDomain` also for a state that is not finite.
            #[inline]
            pub fn stepper_from(
                dt: #scalar,
                state: (&[#scalar; #masses], &[#scalar; #masses]),
            ) -> Result<#stepper, OutOfDomain> {
                let tables = Self::step_tables(dt)?;
                let state = Some((&state.0[..], &state.1[..]));
                Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), state).map(From::from)
            }
    };
    let items = code! {
        #facade::kernel::wraps!(#stepper, FixedStepper of #scalar, #literals);

        impl #stepper {
            /// Says what the input is before the first step; otherwise it is none.  The contact answers for it at once.
            ///
            /// # Errors
            /// `OutOfDomain` as of `advance`, and after the first step.
            pub fn begin(&mut self, input: #input) -> Result<(), OutOfDomain> {
                self.0.begin(#sample)
            }

            #[doc = #when]
            #[doc = #costs]
            ///
            /// # Errors
            /// `OutOfDomain` for what is NaN or infinite, for friction below zero, for numbers whose squares
            /// overflow, and before the work does: the stepper is then what it was.
            pub fn advance(&mut self, input: #input) -> Result<Stepped<#scalar>, OutOfDomain> {
                self.0.advance(#sample)
            }

            #methods
        }

        impl ::core::ops::DerefMut for #stepper {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.0
            }
        }

        #facade::emitted_stepper!(#name, #stepper, #scalar, #on_base, [#(#loaded),*]);
    };
    Part {
        types,
        associated,
        items,
    }
}

/// Returns documentation lines about the cost of a step.
fn cost(scene: &StepScene<'_, Dd>, step: Option<f64>) -> Vec<String> {
    let fastest = scene.fastest().to_f64();
    let shown = if (0.1..1e7).contains(&fastest) {
        format!("{fastest:.2}")
    } else {
        format!("{fastest:.3e}")
    };
    let mut parts = format!(" A step of dt, in s, has ⌈{shown}·dt⌉ parts, at most {MAX_PARTS}");
    if let Some(step) = step {
        parts += &format!(": `STEP` has {}", (fastest * step).ceil().max(1.0));
    }
    vec![
        parts + ".",
        " A part in which the contact certainly keeps sliding, or keeps sticking, is one product with tables.".to_owned(),
        format!(" Any other is followed from event to event, for at most {MAX_EVENTS} events and, where the friction law bends, {MAX_STRETCHES} stretches;"),
        " what is left of a part after that passes without creating energy, and `exceeded` tells.".to_owned(),
    ]
}

/// Returns documentation lines about the number of operations of a step.
fn operations(
    scene: &StepScene<'_, Dd>,
    step: Option<f64>,
    coefficients: usize,
    precision: Precision,
) -> Vec<String> {
    let angle = step.map_or(1.0, |step| scene.fastest().to_f64() * step);
    let parts = angle.ceil().clamp(1.0, f64::from(MAX_PARTS));
    let epsilon = match precision {
        Precision::F32 => f64::from(f32::EPSILON),
        Precision::F64 => f64::EPSILON,
    };
    let terms = series_terms(angle / parts, epsilon);
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 1 to MAX_PARTS"
    )]
    let cost = scene.cost(coefficients, parts as u32, terms);
    let of = if step.is_some() {
        "step of `STEP`"
    } else {
        "part"
    };
    let Cost {
        tables,
        one_event,
        most,
    } = cost;
    let (each, beside) = (Cost::INSTRUCTIONS, Cost::FIXED);
    let processor = match precision {
        Precision::F32 => format!(
            "  A Cortex-M4F takes up to {each} instructions for each, and {beside} for a part."
        ),
        // A Cortex-M4F has no registers for doubles, so no instruction count is given.
        Precision::F64 => String::new(),
    };
    vec![
        String::new(),
        format!(
            " A {of} has at most {tables} floating-point operations by the tables, about {one_event} with one event, never"
        ),
        format!(" more than {most}.{processor}"),
    ]
}

/// Emits the stepper's scene as constants.
fn step_scene(
    emission: &Emission<'_>,
    steps: &Steps<Dd>,
    number: &impl Fn(Dd) -> TokenStream,
) -> TokenStream {
    let scalar = &emission.scalar;
    let Units {
        stiffness,
        rate,
        support,
    } = steps.units;
    let (stiffness, rate, support) = (number(stiffness), number(rate), number(support));
    let on_base = steps.on_base;
    let forces = steps.forces.iter().map(|mass| count(*mass));
    let input = match steps.input {
        Input::Hold => code!(Hold),
        Input::Linear => code!(Linear),
    };
    let law = steps.law.iter().map(|[speed, level]| {
        let (speed, level) = (number(*speed), number(*level));
        code!([#speed, #level])
    });
    let step = emission.scene.stepping.step.map(|step| {
        let step = number(Dd::from(step));
        code! {
            /// The step of which the tables are constants, in s.
            pub const STEP: #scalar = #step;
        }
    });
    code! {
        #step

        /// What a stepper is told of the scene: `units`: k₁, √(k₁/m₁) in rad/s and the springs to the base over k₁;
        /// `forces`: the loaded masses; `law`: Stribeck's points, speed and kinetic friction over F.
        const STEP_SCENE: StepScene<'static, #scalar> = StepScene {
            dynamics: Self::DYNAMICS,
            units: Units { stiffness: #stiffness, rate: #rate, support: #support },
            on_base: #on_base,
            forces: &[#(#forces),*],
            input: Input::#input,
            law: &[#(#law),*],
        };
    }
}

/// Emits the types of the stepper and of its input.
fn types(
    emission: &Emission<'_>,
    steps: &Steps<Dd>,
    literals: &TokenStream,
    cost: &[String],
) -> TokenStream {
    let Emission {
        description,
        scene,
        scalar,
        facade,
        names:
            TypeNames {
                name,
                stepper,
                input,
                ..
            },
        ..
    } = emission;
    let visibility = &description.visibility;
    let about = format!(
        " The motion of [`{name}`] by steps of one length, under any input; `advance` takes a step."
    );
    let input_about = format!(" What acts on [`{name}`] at an instant, in the scene's units.");
    let scalar = code!(::core::primitive::#scalar);
    let base = steps.on_base.then(|| {
        code! {
            /// The base's displacement.
            pub displacement: #scalar,
            /// The base's velocity, in that unit a second.
            pub velocity: #scalar,
        }
    });
    let forces = force_fields(emission, steps);
    let forces = forces.iter().zip(&steps.forces).map(|(field, mass)| {
        let mass = scene.masses.get(*mass).map_or("", |mass| &mass.name);
        let about = format!(" The force on mass `{mass}`.");
        code! {
            #[doc = #about]
            pub #field: #scalar,
        }
    });
    let friction = if steps.law.is_empty() {
        " The kinetic friction force F, not negative; at rest the contact holds up to μF."
    } else {
        " The kinetic friction force F at vanishing speed, not negative; at rest the contact holds up to μF."
    };
    code! {
        #[doc = #about]
        ///
        #(#[doc = #cost])*
        #[allow(deprecated, non_camel_case_types)]
        #visibility struct #stepper(#facade::kernel::stepper::FixedStepper<#scalar, #literals>);

        #[doc = #input_about]
        #[allow(deprecated, non_camel_case_types, non_snake_case)]
        #[::core::prelude::v1::derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq,
            ::core::default::Default
        )]
        #visibility struct #input {
            #base
            #(#forces)*
            #[doc = #friction]
            pub friction: #scalar,
        }
    }
}

/// Returns the fields of the input for the loaded masses: `force` for the excited mass, otherwise
/// the name of the mass.
fn force_fields(emission: &Emission<'_>, steps: &Steps<Dd>) -> Vec<Ident> {
    let places = steps.forces.iter().enumerate();
    let names = places.filter_map(|(place, mass)| {
        if place == 0 && !steps.on_base {
            return Some(local("force"));
        }
        emission.description.mass_names.get(*mass).cloned()
    });
    names.collect()
}

/// Emits a method for each mass that returns its displacement and velocity.
fn methods(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let names = emission.description.mass_names.iter().enumerate();
    let methods = names.map(|(index, method)| {
        let about = format!(" Displacement and velocity of mass `{method}` now.");
        let index = Literal::usize_unsuffixed(index);
        code! {
            #[doc = #about]
            #[must_use]
            pub fn #method(&self) -> MassNow<#scalar> {
                self.mass(#index)
            }
        }
    });
    methods.collect()
}
