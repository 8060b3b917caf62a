//! The variables of an FMU. From this list, the command writes the description of the FMU and its Rust file.

use crate::export::names::mass;
use crate::export::stepping::{contact_method, input_expression, inputs};
use frictiongen::study::scene::Scene;
use frictiongen_codegen::standalone::StepperShape;

/// Time at which the importer of an FMU may set a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variability {
    /// The importer may set the variable before each step.
    Input,
    /// The importer may set the variable before each step, but the variable seldom changes.
    Tunable,
    /// The importer may set the variable before the first step.
    Initial,
}

/// A variable of an FMU that the importer may set.
#[derive(Clone, Debug)]
pub struct Settable {
    /// Name of the variable.
    pub name: String,
    /// Unit of the variable. It is empty for a ratio.
    pub unit: &'static str,
    /// Meaning of the variable, in words.
    pub about: String,
    /// Time at which the importer may set the variable.
    pub kind: Variability,
    /// Value of the variable if the importer does not set it.
    pub start: f64,
    /// Smallest permitted value of the variable, or `None` without a lower bound.
    pub least: Option<f64>,
}

/// A variable that the FMU computes.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name of the variable.
    pub name: String,
    /// Unit of the variable.
    pub unit: &'static str,
    /// Meaning of the variable, in words.
    pub about: String,
    /// Rust expression that computes the variable.
    pub value: String,
}

/// All real variables of an FMU, in the order of their value references.
#[derive(Clone, Debug)]
pub struct Variables {
    /// Number of inputs, which are the first variables.
    pub inputs: usize,
    /// Rust expression of the stepper's input from the array `values`.
    pub input: String,
    /// Contacts, each with its name in the FMU and the method of the stepper that returns it.
    pub contacts: Vec<[String; 2]>,
    /// Variables that the importer may set: inputs, stiction, and initial displacements and velocities.
    pub settable: Vec<Settable>,
    /// All variables that the FMU computes.
    pub outputs: Vec<Output>,
}

impl Variables {
    /// Returns the variables of a scene's FMU.
    pub fn of(scene: &Scene) -> Self {
        let shape = StepperShape::of(scene);
        let abouts = inputs(scene, &shape).into_iter();
        let abouts = abouts.map(|(field, _)| field.about);
        let contacts = shape.contacts.iter();
        let contacts: Vec<[String; 2]> = contacts
            .map(|name| {
                let method = contact_method(scene, name);
                [if scene.is_joined() { name } else { method }, method].map(str::to_owned)
            })
            .collect();
        // With one contact, its friction and its stiction need no name.
        let of_contacts = |what: &str| -> Vec<String> {
            match contacts.as_slice() {
                [_] => vec![what.to_owned()],
                contacts => contacts
                    .iter()
                    .map(|[name, _]| format!("{name}.{what}"))
                    .collect(),
            }
        };
        let base = ["base.displacement", "base.velocity"].map(str::to_owned);
        let base = base.into_iter().filter(|_| shape.on_base);
        let forces = shape.forces.iter();
        let forces = forces.map(|index| format!("{}.force", mass(scene, *index)));
        let names = base.chain(forces).chain(of_contacts("friction"));
        let input = |(name, about): (String, String)| {
            // The C comment of this field ends with the unit, for example `displacement of the base, m`.
            let unit = match name.as_str() {
                "base.displacement" => "m",
                "base.velocity" => "m/s",
                _ => "N",
            };
            let least = name.ends_with("friction").then_some(0.0);
            let about = about.split(',').next().unwrap_or_default().to_owned();
            Settable {
                name,
                unit,
                about,
                kind: Variability::Input,
                start: 0.0,
                least,
            }
        };
        let mut settable: Vec<Settable> = names.zip(abouts).map(input).collect();
        let count = settable.len();
        let stictions = of_contacts("stiction").into_iter();
        let laws = scene.named_contacts().into_iter();
        settable.extend(stictions.zip(laws).map(|(name, contact)| Settable {
            name,
            unit: "",
            about: "mu, static over kinetic friction force".to_owned(),
            kind: Variability::Tunable,
            start: contact.law.stiction,
            least: Some(1.0),
        }));
        settable.extend((0..scene.masses.len()).flat_map(|index| initial(mass(scene, index))));
        let input = input_expression(scene, &shape, &scene.name, |index, _| {
            format!("real(values[{index}])")
        });
        Self {
            inputs: count,
            input,
            settable,
            outputs: outputs(scene, &contacts),
            contacts,
        }
    }
}

fn initial(mass: &str) -> [Settable; 2] {
    [("displacement", "m"), ("velocity", "m/s")].map(|(what, unit)| Settable {
        name: format!("{mass}.initial_{what}"),
        unit,
        about: format!("{what} of mass {mass} at the start"),
        kind: Variability::Initial,
        start: 0.0,
        least: None,
    })
}

fn outputs(scene: &Scene, contacts: &[[String; 2]]) -> Vec<Output> {
    let output =
        |of: &str, (what, unit): (&str, &'static str), about: String, value: String| Output {
            name: format!("{of}.{what}"),
            unit,
            about,
            value,
        };
    let motion = [("displacement", "m"), ("velocity", "m/s")];
    let masses = (0..scene.masses.len()).map(|index| mass(scene, index));
    let mut all: Vec<Output> = masses
        .flat_map(|mass| {
            motion.map(|(what, unit)| {
                let about = format!("{what} of mass {mass}");
                output(
                    mass,
                    (what, unit),
                    about,
                    format!("stepper.{mass}().{what}()"),
                )
            })
        })
        .collect();
    for [name, method] in contacts {
        let of = match contacts {
            [_] => "the contact".to_owned(),
            _ => format!("contact {name}"),
        };
        all.extend(motion.map(|(what, unit)| {
            let about = format!("relative {what} of {of}");
            output(
                name,
                (what, unit),
                about,
                format!("stepper.{method}().{what}()"),
            )
        }));
        all.push(output(
            name,
            ("force", "N"),
            "friction force, or the force that holds a stuck contact".to_owned(),
            format!("stepper.{method}().force()"),
        ));
    }
    let work = [
        ("load", "work of the forces and of the base since the start"),
        ("friction", "energy dissipated by friction since the start"),
        ("damping", "energy dissipated by damping since the start"),
        (
            "stored",
            "increase of kinetic and elastic energy since the start",
        ),
    ];
    all.extend(work.map(|(what, about)| {
        output(
            "work",
            (what, "J"),
            about.to_owned(),
            format!("work.{what}"),
        )
    }));
    all
}
