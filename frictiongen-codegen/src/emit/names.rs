//! Defines the names in emitted code.

use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

/// Names that emitted code imports from the kernel. If a type of the scene has such a name, the emitted block refers to
/// the scene's types by aliases.
pub(super) const IMPORTED: [&str; 91] = [
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

/// Returns the names of the emitted types.
pub(super) fn names(scene: &Ident) -> [Ident; 8] {
    [
        scene.clone(),
        suffixed(scene, "At"),
        suffixed(scene, "Motion"),
        suffixed(scene, "Stuck"),
        suffixed(scene, "Simulation"),
        suffixed(scene, "Orbit"),
        suffixed(scene, "Stepper"),
        suffixed(scene, "Input"),
    ]
}

fn suffixed(name: &Ident, suffix: &str) -> Ident {
    let mut ident = format_ident!("{}{}", name, suffix);
    ident.set_span(name.span());
    ident
}

/// Returns a local name that the user's code cannot capture.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// Emits `field: value`, or `field` alone where the value has the same name.
pub(super) fn field(name: &str, value: &TokenStream) -> TokenStream {
    let ident = local(name);
    if value.to_string() == name {
        code!(#value)
    } else {
        code!(#ident: #value)
    }
}
