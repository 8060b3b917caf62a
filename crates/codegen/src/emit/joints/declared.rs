//! Emits the stepper for the step that the description declares. The tables of this stepper are constants.

use super::{JointsEmission, stepper, wrapper_of};
use crate::graph::literal::literal;
use frictiongen_kernel::Float;
use frictiongen_kernel::joints::{Pace, fill};
use frictiongen_model::joined::unloaded;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Excitation, Precision};
use proc_macro2::{Literal, TokenStream};

/// Pace of a stepper and its tables, in double precision.
struct Declared {
    pace: Pace<f64>,
    stretch: f64,
    tables: Vec<f64>,
}

/// Emits the stepper of the declared step: its type, and its items. Returns `None` for a scene without a declared step,
/// and for one whose stepper has no tables.
pub(super) fn emit(
    emission: &JointsEmission<'_>,
    modal: &Modal,
) -> Option<(TokenStream, TokenStream)> {
    let JointsEmission {
        description,
        scalar,
        size,
        engine,
        ..
    } = emission;
    let facade = &description.facade;
    let scene = &description.scene;
    let (name, declared) = (&emission.names.name, &emission.names.declared);
    let Declared {
        pace,
        stretch,
        tables,
    } = match scene.precision {
        Precision::F64 => of_step::<f64>(emission, modal)?,
        Precision::F32 => of_step::<f32>(emission, modal)?,
    };
    let chain = emission.chain_fields(modal, |_| 0.0, stretch);
    let number = |value: f64| literal(value, scene.precision);
    let tables = tables.iter().map(|entry| number(*entry));
    let (entries, zero) = (emission.entries(), number(0.0));
    let (dt, part) = (number(pace.dt), number(pace.part));
    let parts = Literal::u32_unsuffixed(pace.parts);
    let input = match pace.input {
        frictiongen_kernel::stepper::Input::Hold => code!(Hold),
        frictiongen_kernel::stepper::Input::Linear => code!(Linear),
    };
    let on_base = pace.on_base;
    let target = emission.stepper_type(&code!(&'static [#scalar; #entries]));
    let about = format!(
        " Stepper of the declared step `STEP`.  It borrows its tables, which stay constants of the program, and has the methods of [`{}`].",
        emission.names.stepper
    );
    let types = wrapper_of(emission, declared, &target, &about);
    let calls = stepper::calls(emission, declared, &target);
    let items = code! {
        impl #name {
            /// The chain at rest, without loads and friction.
            const STEP_CHAIN: #engine::Model<#scalar, #size> = #chain;
            /// The declared step and its division into parts.
            const STEP_PACE: #engine::Pace<#scalar> = #engine::Pace {
                dt: #dt,
                parts: #parts,
                part: #part,
                input: #facade::kernel::stepper::Input::#input,
                on_base: #on_base,
            };
            /// Tables of a part, for each set of contacts that stick.
            const STEP_TABLES: [#scalar; #entries] = [#(#tables),*];

            /// Creates a stepper with the declared step `STEP`, for a chain at rest without load.  It computes and copies no
            /// tables, and can be the value of a `static`.
            #[inline]
            #[must_use]
            #[allow(dead_code, clippy::init_numbered_fields, reason = "a program may use only the other stepper; for a scene in a function the type is an alias, which has no constructor function")]
            pub const fn declared_stepper() -> #declared {
                #declared {
                    0: #engine::Stepper::declared(
                        Self::STEP_CHAIN,
                        Self::STEP_PACE,
                        &Self::STEP_TABLES,
                        #zero,
                    ),
                }
            }
        }

        #calls
    };
    Some((types, items))
}

/// Computes the tables of the declared step. The scalar `S` of the scene determines the number of sub-intervals, and the
/// tables are computed in double precision.
fn of_step<S: Float>(emission: &JointsEmission<'_>, modal: &Modal) -> Option<Declared>
where
    f64: From<S>,
{
    let scene = &emission.description.scene;
    let step = S::constant(scene.stepping.step?);
    let layout = emission.steps?;
    let loaded: Vec<usize> = emission.loads.iter().map(|(mass, _)| *mass).collect();
    let stretch = unloaded::<S>(scene, modal, &loaded).stretch;
    let on_base = scene.excitation == Excitation::Base;
    let pace = Pace::new((step, stretch), scene.stepping.input.into(), on_base).ok()?;
    let part = f64::from(pace.part);
    let mut tables = vec![0.0; layout.entries()];
    let chain = unloaded::<f64>(scene, modal, &loaded);
    fill(&chain, part, &layout, &mut tables);
    Some(Declared {
        pace: Pace {
            dt: f64::from(pace.dt),
            parts: pace.parts,
            part,
            input: pace.input,
            on_base,
        },
        stretch: f64::from(stretch),
        tables,
    })
}
