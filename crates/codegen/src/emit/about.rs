//! Emits the scene's type with its documentation: its origin, its description and its methods.

use super::emission::Emission;
use super::fingerprint::fingerprint;
use super::names::TypeNames;
use crate::Description;
use crate::comment::rust_text;
use frictiongen_model::scene::{Beyond, Excitation, FrictionLaw, Node, Scene};
use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

/// From this number of masses on, the emitted documentation does not list the methods of single masses by name.
const MANY_MASSES: usize = 9;

/// Emits the type of the scene, with its documentation.
pub(super) fn scene_type(emission: &Emission<'_>) -> TokenStream {
    scene_struct(emission.description, lines(emission))
}

/// Emits the scene's type: a structure without fields, with the lines of its documentation.
pub(super) fn scene_struct(description: &Description, lines: Vec<String>) -> TokenStream {
    let lines = lines
        .into_iter()
        .map(|line| format!(" {line}").trim_end().to_owned());
    let (attributes, visibility) = (&description.attributes, &description.visibility);
    let name = &description.name;
    // An empty doc line separates the header from the scene's own documentation.
    let documented = !description.documentation.is_empty();
    let blank = documented.then(|| code!(#[doc = ""]));
    code! {
        #attributes
        #blank
        #(#[doc = #lines])*
        #[::core::prelude::v1::derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::Eq,
            ::core::cmp::PartialEq,
            ::core::default::Default,
            ::core::hash::Hash
        )]
        #visibility struct #name;
    }
}

/// A field of an emitted structure: its documentation, its name and its type.
pub(super) struct NumberField {
    about: String,
    name: Ident,
    of: TokenStream,
}

impl NumberField {
    pub(super) fn new(about: impl Into<String>, name: &Ident, of: &impl ToTokens) -> Self {
        Self {
            about: about.into(),
            name: name.clone(),
            of: of.to_token_stream(),
        }
    }
}

/// Emits a structure whose fields are numbers, for the input of a stepper.
pub(super) fn numbers_struct(
    description: &Description,
    name: &Ident,
    about: &str,
    fields: &[NumberField],
) -> TokenStream {
    let (visibility, facade) = (&description.visibility, &description.facade);
    let names: Vec<_> = fields.iter().map(|field| &field.name).collect();
    let fields = fields.iter().map(|NumberField { about, name, of }| {
        code! {
            #[doc = #about]
            pub #name: #of,
        }
    });
    code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types, non_snake_case, reason = "names and attributes are those of the description")]
        #[::core::prelude::v1::derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq,
            ::core::default::Default
        )]
        #visibility struct #name { #(#fields)* }

        /// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
        #facade::kernel::written!(#name, #(#names),*);
    }
}

/// Returns the first lines of the documentation of the scene's type: the origin of the code, and the description.
pub(super) fn origin(description: &Description) -> Vec<String> {
    let mut lines = vec![
        format!(
            "Emitted by `friction_system!` of frictiongen {} from scene {:016x}.  Change the description, not this code.",
            env!("CARGO_PKG_VERSION"),
            fingerprint(&description.scene)
        ),
        String::new(),
    ];
    let written = &description.written;
    if !written.is_empty() {
        let fence = fence(written);
        lines.extend([
            "# Description".to_owned(),
            String::new(),
            format!("{fence}text"),
        ]);
        lines.extend(written.lines().map(rust_text));
        lines.extend([fence, String::new()]);
    }
    if let Some(acts_on) = description.scene.damping_acts_on() {
        lines.extend([format!("The {acts_on}."), String::new()]);
    }
    if description.scene.joints.is_empty() {
        lines.extend([motion_in_contact(&description.scene), String::new()]);
    }
    lines.extend(["# What it offers".to_owned(), String::new()]);
    lines
}

/// Returns the sentence that defines the motion in the contact of a scene with one contact. This motion is the
/// displacement of one mass, or a difference of two displacements.
pub(crate) fn motion_in_contact(scene: &Scene) -> String {
    let name = |mass: usize| scene.node_name(Node::Mass(mass));
    let (one, other) = match (scene.contact.from, scene.contact.to) {
        (Node::Mass(a), Node::Mass(b)) => (name(a.max(b)), Some(name(a.min(b)))),
        (Node::Mass(mass), support) | (support, Node::Mass(mass)) => {
            let moves = support == Node::Base && scene.excitation == Excitation::Base;
            (name(mass), moves.then_some("base"))
        }
        _ => return String::new(),
    };
    let minus = other.map_or_else(String::new, |other| format!(" minus that of `{other}`"));
    format!("The motion in the contact is the displacement of `{one}`{minus}.")
}

/// Returns all lines of the documentation of the scene's type: origin, description, methods and constants.
fn lines(emission: &Emission<'_>) -> Vec<String> {
    let mut lines = origin(emission.description);
    lines.extend(offers(emission).into_iter().map(|item| format!("* {item}")));
    lines.push(String::new());
    // A scene with a stepper alone has no formula of the thesis.
    let non_dimensional = emission.scene.needs_frequency() || emission.wanted().simulation;
    if non_dimensional {
        lines.extend([units(emission), String::new()]);
    }
    let thesis = if emission.scene.needs_frequency() {
        "Numbers in brackets are equations of L. Marino, *Dynamic analysis of mechanical systems with Coulomb friction*, Oxford 2021.  "
    } else {
        ""
    };
    lines.push(format!(
        "{thesis}Counts of operations do not include operations whose operands are all constants, because the compiler computes them.  An expression that stands several times counts once, and an `if` as a comparison and a choice."
    ));
    lines
}

/// Returns a line about the units of the results at one frequency ratio, of the simulation and of the stepper.
fn units(emission: &Emission<'_>) -> String {
    let wanted = emission.wanted();
    let answers = match (emission.scene.needs_frequency(), wanted.simulation) {
        (true, true) => "Answers of `at(r)` and of the simulation are",
        (true, false) => "Answers of `at(r)` are",
        (false, _) => "Answers of the simulation are",
    };
    let over = match emission.scene.excitation {
        Excitation::Base => {
            "displacements are over Y, the amplitude of the base motion, and forces over k₁Y"
        }
        Excitation::Force(_) => {
            "displacements are over P/k₁, with P the amplitude of the force, and forces over P"
        }
    };
    let mut line = format!("{answers} non-dimensional: {over}.  The time is τ = ωt.");
    if wanted.motion.is_some() {
        line += "  A phase is the lag of a maximum behind that of the load, in rad.  In `motion(beta)` τ is 0 at a maximum of the motion in the contact, and elsewhere at a maximum of the load.";
    }
    if wanted.stepper {
        line += "  The stepper uses the units of the scene, and seconds.";
    }
    line
}

/// Returns a fence of backticks that is longer than every run of backticks in a text.
fn fence(text: &str) -> String {
    let runs = text.split(|letter| letter != '`').map(str::len);
    "`".repeat(runs.max().unwrap_or(0).max(2) + 1)
}

/// Lists the methods and constants of the scene, for the documentation of its type.
fn offers(emission: &Emission<'_>) -> Vec<String> {
    let TypeNames {
        at,
        motion,
        stuck,
        simulation,
        orbit,
        stepper,
        declared,
        input,
        ..
    } = &emission.names;
    let (scene, wanted) = (emission.scene, emission.wanted());
    let every: Vec<usize> = (0..scene.masses.len()).collect();
    let mut items = vec![
        "`K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain".to_owned(),
        "`frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units".to_owned(),
    ];
    if scene.needs_frequency() {
        let refused = if emission.is_tabled() && scene.declared.beyond == Beyond::Error {
            "outside the declared range of r"
        } else {
            "if r is negative or not a number"
        };
        items.push(format!(
            "`at(r)` returns [`{at}`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error {refused}"
        ));
        items.push(
            "`limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length"
                .to_owned(),
        );
    }
    if let Some(masses) = &wanted.motion {
        let masses: Vec<usize> = masses.iter().map(|(mass, _)| *mass).collect();
        let methods = methods(emission, &masses, &["contact()"]);
        items.push(format!(
            "`at(r)?.motion(beta)` returns [`{motion}`], the continuous motion, with {methods}"
        ));
    }
    if wanted.stuck {
        let methods = methods(emission, &every, &["contact_force()"]);
        items.push(format!(
            "`at(r)?.stuck()` returns [`{stuck}`], the response while the contact is stuck, with {methods}"
        ));
    }
    if wanted.orbit {
        let methods = methods(emission, &every, &["contact()"]);
        items.push(format!(
            "`at(r)?.orbit(beta)` returns [`{orbit}`], the steady state in any regime, with {methods}"
        ));
    }
    if wanted.simulation {
        let methods = methods(emission, &every, &["next()"]);
        let start = if scene.friction == FrictionLaw::Coulomb {
            "simulation(r, beta)` and `simulation_from(r, beta, state)"
        } else {
            "simulation_under(r, beta, amplitude)` and `simulation_under_from(r, beta, amplitude, state)"
        };
        items.push(format!(
            "`{start}` return [`{simulation}`], the motion in time from event to event, with {methods}"
        ));
    }
    if wanted.stepper {
        let methods = methods(
            emission,
            &every,
            &["begin(input)", "advance(input)", "image()", "contact()"],
        );
        items.push(format!(
            "`stepper(dt)`, `stepper_from(dt, state)` and `stepper_from_image(image)` return [`{stepper}`], the motion by steps under any [`{input}`], with {methods}"
        ));
        if scene.stepping.step.is_some() {
            items.push(format!(
                "`declared_stepper()` returns [`{declared}`], which borrows the tables of the declared step `STEP`, s"
            ));
        }
    }
    if wanted.self_check {
        items.push("`self_check()` compares constants and answers with known ones".to_owned());
    }
    items
}

/// Returns a list of methods as text: the methods in `first`, then the methods that have the name of the contact or
/// of masses.
fn methods(emission: &Emission<'_>, masses: &[usize], first: &[&str]) -> String {
    let mut methods: Vec<String> = first.iter().map(|method| format!("`{method}`")).collect();
    let contact = emission.contact_name().into_iter();
    methods.extend(contact.map(|name| format!("`{name}()`")));
    if masses.len() < MANY_MASSES {
        let names = &emission.description.mass_names;
        let names = masses.iter().filter_map(|mass| names.get(*mass));
        methods.extend(names.map(|name| format!("`{name}()`")));
    } else {
        methods.push(format!("one method for each of {} masses", masses.len()));
    }
    match methods.pop() {
        Some(last) if !methods.is_empty() => format!("{} and {last}", methods.join(", ")),
        last => last.unwrap_or_default(),
    }
}
