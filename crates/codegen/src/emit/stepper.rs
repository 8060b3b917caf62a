//! Emits the stepper, which advances in steps of fixed physical time under any input.

use super::about::{NumberField, numbers_struct};
use super::declared;
use super::dynamics::{DynamicsConstants, count};
use super::emission::{Checked, Emission, EmittedCode, rounded};
use super::fields::fields;
use super::names::{TypeNames, local};
use super::step_cost;
use super::step_table::{self, Sizes};
use super::units;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{Input, Units};
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;
use proc_macro2::{Ident, Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, constants: &DynamicsConstants) -> EmittedCode {
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
                declared,
                ..
            },
        ..
    } = emission;
    let steps = StepperSettings::of(scene, modal, std::iter::empty(), |value| value);
    let transient = Transient::<Dd>::of(scene, modal, |value| value);
    let exact = steps.scene(transient.contact_dynamics());
    let sizes = Sizes {
        coefficients: steps.coefficients(),
        modes: transient.modes.len(),
        held: constants.held,
        inputs: steps.inputs(),
    };
    let literals = sizes.literals();
    let law_word = emission.law_word();
    let masses = count(scene.masses.len());
    let (step_scene, mut constants) = step_scene(emission);
    let tables = scene
        .stepping
        .step
        .and_then(|step| step_table::emit(emission, &exact, step, &sizes));
    let tables = tables.map(|(tables, sum)| {
        constants.push(Checked::of_sum(
            "STEP_TABLES",
            code!(&Self::STEP_TABLES),
            sum,
        ));
        tables
    });
    let mut cost = step_cost::parts(&exact, scene.stepping.step);
    cost.extend(step_cost::operations(
        &exact,
        scene.stepping.step,
        sizes.coefficients,
        *precision,
    ));
    let from_tables = tables.is_some().then(|| {
        code! {
            if dt.to_bits() == Self::STEP.to_bits() {
                return Ok(Self::STEP_TABLES);
            }
        }
    });
    let fields = force_fields(emission, &steps);
    let base = if steps.on_base {
        code!([input.displacement, input.velocity])
    } else {
        code!([0.0; 2])
    };
    let sample = code! {
        Sample { base: #base, forces: &[#(input.#fields),*], friction: input.friction }
    };
    let [constant, linear] = if steps.forces.is_empty() {
        ["Friction is constant", "Friction changes linearly"]
    } else {
        [
            "Forces and friction are constant",
            "Forces and friction change linearly",
        ]
    };
    let when = match (steps.input, steps.on_base) {
        (Input::Hold, false) => " Takes a step, over which the input is constant.".to_owned(),
        (Input::Hold, true) => format!(
            " Takes a step.  {constant} over it.  The base jumps to the displacement of the input and then moves with its velocity."
        ),
        (Input::Linear, false) => {
            " Takes a step, over which the input changes linearly from the last input to this one."
                .to_owned()
        }
        (Input::Linear, true) => format!(
            " Takes a step.  {linear} over it.  The base follows the cubic through the displacements and velocities of the last input and of this one."
        ),
    };
    let loaded = steps.forces.iter().map(|mass| count(*mass));
    let on_base = steps.on_base;
    let about_tables = if from_tables.is_some() {
        " Returns the tables for the step dt, s.  If dt is the declared step `STEP`, the tables are constants."
    } else {
        " Computes the tables for the step dt, s."
    };
    let associated = code! {
            #step_scene

            #[doc = #about_tables]
            #[inline]
            fn step_tables(dt: #scalar) -> Result<FixedTables<#scalar, #literals>, OutOfDomain> {
                #from_tables
                FixedTables::new(&Self::STEP_SCENE, dt)
            }

            /// Creates a stepper with the step dt, s, for a chain at rest without load.
            ///
            /// # Errors
            /// `OutOfDomain` for a step that is not positive and finite, or too long.
            #[inline]
            pub fn stepper(dt: #scalar) -> Result<#stepper, OutOfDomain> {
                let tables = Self::step_tables(dt)?;
                Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None).map(From::from)
            }

            /// Creates a stepper that starts from a state: absolute displacements and velocities of all masses, in the order of the
            /// description.  The unit of time is the second.
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
    let calls_of = |stepper: &Ident| calls(emission, stepper, &sample, &when);
    let of_stepper = calls_of(stepper);
    let mut items = code! {
        /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
        #facade::kernel::wraps!(#stepper, FixedStepper of #law_word #scalar, #literals);

        #of_stepper

        /// The traits `Steps` and `Stepping`, and the functions `image` and `stepper_from_image`, which write and read the state
        /// as bytes.  `true` stands for a moving base.  The list contains the indices of the loaded masses.
        #facade::emitted_stepper!(#name, #stepper, #scalar, #on_base, [#(#loaded),*]);
    };
    cost.push(format!(" {}", sizes.about()));
    let mut types = types(emission, &steps, &literals, &cost);
    let mut associated = associated;
    if tables.is_some() {
        let of_declared = calls_of(declared);
        let loaded = steps.forces.iter().map(|mass| count(*mass));
        types.extend(declared::types(emission, &literals));
        associated.extend(declared::associated(emission));
        items.extend(code! {
            /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
            #facade::kernel::wraps!(#declared, DeclaredStepper of #law_word #scalar, #literals);

            #of_declared

            /// The trait `Stepping` and the function `image`.  Base and loaded masses are written as above.
            #facade::emitted_stepper!(declared #declared, #scalar, #on_base, [#(#loaded),*]);
        });
    }
    EmittedCode {
        types,
        associated,
        items,
        tables: tables.unwrap_or_default(),
        constants,
    }
}

/// Emits the functions of a stepper type that take an input, and a method for each mass.
fn calls(
    emission: &Emission<'_>,
    stepper: &Ident,
    sample: &TokenStream,
    when: &str,
) -> TokenStream {
    let Emission { scalar, names, .. } = emission;
    let input = &names.input;
    let costs = format!(
        " Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`{}`] gives the number of operations.",
        names.stepper
    );
    let methods = methods(emission);
    code! {
        impl #stepper {
            /// Sets the input at the start of the first step.  Without this call the input there is 0.
            ///
            /// # Errors
            /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
            pub fn begin(&mut self, input: #input) -> Result<(), OutOfDomain> {
                self.0.begin(#sample)
            }

            #[doc = #when]
            #[doc = #costs]
            ///
            /// # Errors
            /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
            /// that `work()` returns would overflow.  The stepper then keeps its state.
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
    }
}

/// Emits, as constants, the numbers of the scene that the stepper needs.
fn step_scene(emission: &Emission<'_>) -> (TokenStream, Vec<Checked>) {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        ..
    } = emission;
    let round = |value: Dd| rounded(value, *precision);
    let steps = StepperSettings::<f64>::of(scene, modal, std::iter::empty(), round);
    let transient = Transient::<f64>::of(scene, modal, round);
    let mut constants = vec![Checked::new(
        "STEP_SCENE",
        code!(&Self::STEP_SCENE),
        &steps.scene(transient.dynamics()),
    )];
    let Units { rate, support, .. } = steps.units;
    let rate = units::reference_by_name(emission, rate);
    let support = emission.literal(support);
    let on_base = steps.on_base;
    let forces = steps.forces.iter().map(|mass| count(*mass));
    let input = match steps.input {
        Input::Hold => code!(Hold),
        Input::Linear => code!(Linear),
    };
    let law = steps.law.iter().map(|point| emission.list(*point));
    let step = scene.stepping.step.map(|step| {
        let step = round(Dd::from(step));
        constants.push(Checked::new("STEP", code!(&Self::STEP), &step));
        let step = emission.literal(step);
        code! {
            /// Step, s, for which the tables are constants.
            pub const STEP: #scalar = #step;
        }
    });
    let units = fields(
        true,
        &[
            ("stiffness", code!(Self::K1), "k₁"),
            ("rate", rate, "√(k₁/m₁), rad/s"),
            (
                "support",
                support,
                "sum of the springs to the base, over k₁",
            ),
        ],
    );
    let numbers = fields(
        true,
        &[
            (
                "dynamics",
                code!(Self::DYNAMICS),
                "modes of the chain, and of the chain with its contact stuck",
            ),
            (
                "units",
                code!(Units { #units }),
                "factors to the units of the scene",
            ),
            ("on_base", code!(#on_base), "true if the base moves"),
            (
                "forces",
                code!(&[#(#forces),*]),
                "indices of the loaded masses",
            ),
            (
                "input",
                code!(Input::#input),
                "course of the inputs during a step: constant with `Hold`; with `Linear` forces are linear, and a base follows a cubic",
            ),
            (
                "law",
                code!(&[#(#law),*]),
                "points of a friction law over the speed: speed, kinetic friction over F; without points the kinetic friction is F",
            ),
        ],
    );
    let law = emission.law();
    let associated = code! {
        #step

        /// Constants of the stepper.
        const STEP_SCENE: StepScene<'static, #scalar #law> = StepScene { #numbers };
    };
    (associated, constants)
}

/// Emits the types of the stepper and of its input.
fn types(
    emission: &Emission<'_>,
    steps: &StepperSettings<Dd>,
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
        " Stepper: motion of [`{name}`] in time, by steps of one length, under any input.  `advance` takes a step."
    );
    let input_about = format!(
        " Loads on [`{name}`] at an instant, in the units of the scene: the input of a step."
    );
    let scalar = code!(::core::primitive::#scalar);
    let mut fields = Vec::new();
    if steps.on_base {
        fields.extend([
            NumberField::new(
                " Absolute displacement of the base.",
                &local("displacement"),
                &scalar,
            ),
            NumberField::new(
                " Absolute velocity of the base, in the unit of displacement per second.",
                &local("velocity"),
                &scalar,
            ),
        ]);
    }
    let forces = force_fields(emission, steps);
    fields.extend(forces.iter().zip(&steps.forces).map(|(field, mass)| {
        let mass = scene.masses.get(*mass).map_or("", |mass| &mass.name);
        NumberField::new(format!(" Force on mass `{mass}`."), field, &scalar)
    }));
    let law_in_types = emission.law_in_types();
    let friction = if steps.law.is_empty() {
        " Kinetic friction force F, not negative.  A stuck contact holds up to μF."
    } else {
        " Kinetic friction force F at vanishing speed, not negative.  A stuck contact holds up to μF."
    };
    fields.push(NumberField::new(friction, &local("friction"), &scalar));
    let input = numbers_struct(description, input, &input_about, &fields);
    code! {
        #[doc = #about]
        ///
        #(#[doc = #cost])*
        #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
        #visibility struct #stepper(#facade::kernel::stepper::FixedStepper<#scalar, #literals #law_in_types>);

        #input
    }
}

/// Returns the names of the input's fields for the loaded masses. The field of the excited mass is `force`. The field
/// of any other mass has the name of the mass.
fn force_fields(emission: &Emission<'_>, steps: &StepperSettings<Dd>) -> Vec<Ident> {
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
        let about = format!(" Absolute displacement and velocity of mass `{method}` now.");
        let index = Literal::usize_unsuffixed(index);
        code! {
            #[doc = #about]
            #[must_use]
            pub fn #method(&self) -> MassNow<#scalar> {
                self.mass(#index)
            }
        }
    });
    let facade = &emission.facade;
    let contact = emission.contact_method(
        &code!(contact),
        &code!(#facade::kernel::stepper::ContactNow<#scalar>),
    );
    methods.chain(contact).collect()
}
