//! Emits the stepper for the step that the description declares. The tables of this stepper are constants.

use super::emission::Emission;
use super::names::TypeNames;
use proc_macro2::TokenStream;

/// Emits the type of the stepper for the declared step.
pub(super) fn types(emission: &Emission<'_>, literals: &TokenStream) -> TokenStream {
    let Emission {
        description,
        scalar,
        facade,
        names: TypeNames {
            stepper, declared, ..
        },
        ..
    } = emission;
    let (visibility, law) = (&description.visibility, emission.law_in_types());
    let about = format!(
        " Stepper of the declared step `STEP`.  It borrows its tables, which stay constants of the program, and has the methods and the costs of [`{stepper}`]."
    );
    let scalar = code!(::core::primitive::#scalar);
    code! {
        #[doc = #about]
        #[allow(dead_code, deprecated, non_camel_case_types, reason = "a program may use only the other stepper, and names and attributes are those of the description")]
        #visibility struct #declared(#facade::kernel::stepper::DeclaredStepper<#scalar, #literals #law>);
    }
}

/// Emits the function that creates the stepper for the declared step.
pub(super) fn associated(emission: &Emission<'_>) -> TokenStream {
    let declared = &emission.names.declared;
    code! {
        /// Creates a stepper with the declared step `STEP`, for a chain at rest without load.  It computes and copies no
        /// tables, and can be the value of a `static`.  The pair of numbers is the friction force at the start, and μ.
        #[inline]
        #[must_use]
        #[allow(dead_code, clippy::init_numbered_fields, reason = "a program may use only the other stepper; for a scene in a function the type is an alias, which has no constructor function")]
        pub const fn declared_stepper() -> #declared {
            #declared {
                0: DeclaredStepper::declared(
                    Self::STEP_SCENE,
                    &Self::STEP_TABLES,
                    (0.0, Self::CHAIN.stiction),
                ),
            }
        }
    }
}
