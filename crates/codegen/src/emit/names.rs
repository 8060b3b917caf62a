//! Names in emitted code.

use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

/// Names that emitted code imports from the kernel. If a type of the scene has one of these names, the emitted code
/// refers to the scene's types by aliases.
const IMPORTED: [&str; 97] = [
    "check",
    "locals",
    "missing",
    "written",
    "Complex",
    "Scalar",
    "Chain",
    "ContactAt",
    "ModeAt",
    "Limits",
    "Damped",
    "Decay",
    "Undamped",
    "NoOrbit",
    "OutOfDomain",
    "Kind",
    "Mode",
    "ModeResponse",
    "Fundamental",
    "Friction",
    "ModalCoefficients",
    "FixedOrbit",
    "FixedOrbitMotion",
    "Orbit",
    "ProvidesOrbit",
    "Start",
    "At",
    "Continuous",
    "Ends",
    "MotionOf",
    "Numbers",
    "ProvidesMotion",
    "ProvidesStuck",
    "Scene",
    "Stuck",
    "Dynamics",
    "ElasticChain",
    "FixedLinesSimulation",
    "FixedSimulation",
    "HeldMode",
    "Lines",
    "Moment",
    "Part",
    "Segment",
    "Simulation",
    "mass_wave",
    "motion_wave",
    "Motion",
    "Wave",
    "Channel",
    "DeclaredStepper",
    "FixedStepper",
    "FixedStore",
    "FixedTables",
    "HeldLoad",
    "HeldRow",
    "HeldStep",
    "Input",
    "MassNow",
    "ModeStep",
    "Pace",
    "Row",
    "Sample",
    "StepScene",
    "Stepped",
    "Stepper",
    "Units",
    "Compiled",
    "ContactTable",
    "Domain",
    "Factor",
    "Moving",
    "Piece",
    "Quotient",
    "SteadyContact",
    "Table",
    "Tabled",
    "TabledMotion",
    "transposed",
    "From",
    "IntoIterator",
    "Iterator",
    "Option",
    "None",
    "Some",
    "bool",
    "f32",
    "f64",
    "usize",
    "Result",
    "Err",
    "Ok",
    "HeldResponse",
    "Root",
    "Sticking",
    "TabledStuck",
    "Transfer",
];

/// Names of the types that are emitted for a scene.
pub(super) struct TypeNames {
    pub name: Ident,
    pub at: Ident,
    pub motion: Ident,
    pub stuck: Ident,
    pub simulation: Ident,
    pub orbit: Ident,
    pub stepper: Ident,
    pub declared: Ident,
    pub input: Ident,
}

impl TypeNames {
    /// Returns the names of the types for a scene with the name `scene`.
    pub fn of(scene: &Ident) -> Self {
        let suffixed = |suffix| suffixed(scene, suffix);
        Self {
            name: scene.clone(),
            at: suffixed("At"),
            motion: suffixed("Motion"),
            stuck: suffixed("Stuck"),
            simulation: suffixed("Simulation"),
            orbit: suffixed("Orbit"),
            stepper: suffixed("Stepper"),
            declared: suffixed("DeclaredStepper"),
            input: suffixed("Input"),
        }
    }

    /// Returns true if one of the type names is also a name that emitted code imports.
    pub fn clash(&self) -> bool {
        let Self {
            name,
            at,
            motion,
            stuck,
            simulation,
            orbit,
            stepper,
            declared,
            input,
        } = self;
        [
            name, at, motion, stuck, simulation, orbit, stepper, declared, input,
        ]
        .into_iter()
        .any(|name| IMPORTED.iter().any(|imported| name == imported))
    }
}

fn suffixed(name: &Ident, suffix: &str) -> Ident {
    let mut ident = format_ident!("{}{}", name, suffix);
    ident.set_span(name.span());
    ident
}

/// Returns the name of a local variable. The name cannot refer to an item of the user.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// Emits `field: value`, or only `field` if the value has the same name.
pub(super) fn field(name: &str, value: &TokenStream) -> TokenStream {
    let ident = local(name);
    if value.to_string() == name {
        code!(#value)
    } else {
        code!(#ident: #value)
    }
}
