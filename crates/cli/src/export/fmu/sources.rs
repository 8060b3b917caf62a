//! Writes the source files of an FMU's crate.

use super::variables::{Variability, Variables};
use frictiongen::study::scene::{Excitation, Precision, Scene, StepInput};

/// Source files that are the same for every scene.
pub const FIXED: [(&str, &str); 6] = [
    ("src/fmi3.rs", include_str!("../../../fmu/fmi3.rs")),
    ("src/inputs.rs", include_str!("../../../fmu/inputs.rs")),
    ("src/instance.rs", include_str!("../../../fmu/instance.rs")),
    ("src/missing.rs", include_str!("../../../fmu/missing.rs")),
    ("src/saved.rs", include_str!("../../../fmu/saved.rs")),
    ("src/steps.rs", include_str!("../../../fmu/steps.rs")),
];

/// Returns the text of `src/lib.rs` of an FMU's crate.
pub fn library(head: &str, prefix: &str) -> String {
    format!(
        "{head}//\n// `scene.rs` has the variables of the scene.  The other modules are the same for every scene.\n\
         #![deny(unsafe_code)]\n#![allow(missing_docs, dead_code, non_snake_case, clippy::all)]\n\n\
         frictiongen::friction_system!(\"{prefix}.friction\");\n\n\
         #[allow(unsafe_code)]\nmod fmi3;\nmod inputs;\nmod instance;\n#[allow(unsafe_code)]\nmod missing;\nmod saved;\nmod scene;\nmod steps;\n"
    )
}

/// Returns the text of `src/scene.rs` of an FMU's crate. `name` is the scene's type in Rust.
pub fn scene(scene: &Scene, variables: &Variables, (name, token): (&str, &str)) -> String {
    let scalar = match scene.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let inputs = variables.inputs;
    let contacts = variables.contacts.len();
    let settable = variables.settable.iter().map(|of| {
        let kind = match of.kind {
            Variability::Input => "Input",
            Variability::Tunable => "Tunable",
            Variability::Initial => "Initial",
        };
        let least = of
            .least
            .map_or("f64::NEG_INFINITY".to_owned(), |least| format!("{least:?}"));
        format!(
            "    Variable {{ name: {:?}, unit: {:?}, kind: Kind::{kind}, start: {:?}, least: {least} }},\n",
            of.name, of.unit, of.start
        )
    });
    let methods = variables.contacts.iter().map(|[_, method]| method);
    let directions =
        methods.map(|method| format!("        direction(stepper.{method}().contact()),\n"));
    // The stepper of one contact without dashpots holds the friction force during a step.
    let linear = if scene.is_joined() {
        inputs
    } else {
        inputs - 1
    };
    let names = variables
        .outputs
        .iter()
        .map(|of| format!("    {:?},\n", of.name));
    let values = variables
        .outputs
        .iter()
        .map(|of| format!("        f64::from({}),\n", of.value));
    let set_stiction = if scene.is_joined() {
        "stepper.set_stiction(contact, real(mu))"
    } else {
        "let _ = contact;\n    stepper.set_stiction(real(mu))"
    };
    format!(
        "//! The variables of the scene.\n\n\
         use super::{{{name} as Scene, {name}Input as Input}};\nuse frictiongen::OutOfDomain;\n\
         use frictiongen::answer::Contact;\n\n\
         pub(crate) type Stepper = super::{name}Stepper;\n\n\
         /// The token of modelDescription.xml.\npub const TOKEN: &str = {token:?};\n\
         pub const HASH: u64 = Scene::SCENE_HASH;\n/// Length of a step, s.\npub const DT: f64 = Scene::STEP as f64;\n\
         /// True if the inputs act during a step, false if they act at its end.\npub const HOLD: bool = {hold};\n\
         /// True if the first two inputs are displacement and velocity of the base.\npub const ON_BASE: bool = {on_base};\n\
         pub const MASSES: usize = {masses};\npub const CONTACTS: usize = {contacts};\npub const INPUTS: usize = {inputs};\n\
         /// Number of inputs that change linearly between two samples.\npub const LINEAR: usize = {linear};\n\
         /// Place of the first stiction among the variables.\npub const STICTION: usize = INPUTS;\n\
         pub const SETTABLE: usize = INPUTS + CONTACTS + 2 * MASSES;\n\n\
         #[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum Kind {{\n    Input,\n    Tunable,\n    Initial,\n}}\n\n\
         pub struct Variable {{\n    pub name: &'static str,\n    pub unit: &'static str,\n    pub kind: Kind,\n    \
         pub start: f64,\n    pub least: f64,\n}}\n\n\
         pub const VARIABLES: [Variable; SETTABLE] = [\n{settable}];\n\n\
         pub const OUTPUTS: [&str; {outputs}] = [\n{names}];\n\n\
         /// Returns a number in the scene's scalar.\npub fn real(value: f64) -> {scalar} {{\n    value as {scalar}\n}}\n\n\
         pub(crate) fn input(values: &[f64; INPUTS]) -> Input {{\n    {input}\n}}\n\n\
         pub(crate) fn start(displacements: [f64; MASSES], velocities: [f64; MASSES]) -> Result<Stepper, OutOfDomain> {{\n    \
         let (displacements, velocities) = (displacements.map(real), velocities.map(real));\n    \
         Scene::stepper_from(Scene::STEP, (&displacements, &velocities))\n}}\n\n\
         pub(crate) fn restored(image: &[u8; Stepper::IMAGE]) -> Result<Stepper, OutOfDomain> {{\n    \
         Scene::stepper_from_image(image)\n}}\n\n\
         pub(crate) fn outputs(stepper: &Stepper) -> [f64; OUTPUTS.len()] {{\n    \
         let work = stepper.work();\n    [\n{values}    ]\n}}\n\n\
         /// Returns 0 for each contact that sticks, and otherwise the sign of its velocity.\n\
         pub(crate) fn directions(stepper: &Stepper) -> [i32; CONTACTS] {{\n    [\n{directions}    ]\n}}\n\n\
         fn direction(contact: Contact) -> i32 {{\n    match contact {{\n        \
         Contact::Stuck => 0,\n        Contact::Forward => 1,\n        Contact::Backward => -1,\n    }}\n}}\n\n\
         pub(crate) fn set_stiction(stepper: &mut Stepper, contact: usize, mu: f64) -> Result<(), OutOfDomain> {{\n    \
         {set_stiction}\n}}\n",
        input = variables.input,
        directions = directions.collect::<String>(),
        hold = scene.stepping.input == StepInput::Hold,
        on_base = scene.excitation == Excitation::Base,
        masses = scene.masses.len(),
        outputs = variables.outputs.len(),
        settable = settable.collect::<String>(),
        names = names.collect::<String>(),
        values = values.collect::<String>(),
    )
}
