//! The variables of an FMU. Its description and its Rust file are written from this list.

use crate::export::names::mass;
use crate::export::stepping::inputs;
use frictiongen::study::scene::Scene;
use frictiongen_codegen::standalone::StepperShape;

/// Time at which the importer may set a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variability {
    /// Before each step.
    Input,
    /// Before each step. The value seldom changes.
    Tunable,
    /// Before the first step.
    Initial,
}

/// A number that the importer may set.
#[derive(Clone, Debug)]
pub struct Settable {
    /// Name.
    pub name: String,
    /// Unit. It is empty for a ratio.
    pub unit: &'static str,
    /// Meaning.
    pub about: String,
    /// Time at which the importer may set the number.
    pub kind: Variability,
    /// Value if the importer does not set the number.
    pub start: f64,
    /// Smallest value.
    pub least: Option<f64>,
}

/// A number that the FMU computes.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: &'static str,
    /// Meaning.
    pub about: String,
    /// Expression in Rust.
    pub value: String,
}

/// All variables that are real numbers, in the order of their value references.
#[derive(Clone, Debug)]
pub struct Variables {
    /// Fields of the stepper's input in Rust, in the order of the first variables.
    pub fields: Vec<String>,
    /// Inputs, stiction, and initial displacements and velocities.
    pub settable: Vec<Settable>,
    /// Outputs.
    pub outputs: Vec<Output>,
}

impl Variables {
    /// Returns the variables of a scene.
    pub fn of(scene: &Scene) -> Self {
        let shape = StepperShape::of(scene);
        let fields = inputs(scene, &shape).into_iter();
        let (abouts, fields): (Vec<String>, Vec<String>) =
            fields.map(|(field, inner)| (field.about, inner)).unzip();
        let base = ["base.displacement", "base.velocity"].map(str::to_owned);
        let base = base.into_iter().filter(|_| shape.on_base);
        let forces = shape.forces.iter();
        let forces = forces.map(|index| format!("{}.force", mass(scene, *index)));
        let names = base.chain(forces).chain(["friction".to_owned()]);
        let input = |(name, about): (String, String)| {
            // The comment in C ends with the unit, for example `displacement of the base, m`.
            let unit = match name.as_str() {
                "base.displacement" => "m",
                "base.velocity" => "m/s",
                _ => "N",
            };
            let least = (name == "friction").then_some(0.0);
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
        settable.push(Settable {
            name: "stiction".to_owned(),
            unit: "",
            about: "mu, static over kinetic friction force".to_owned(),
            kind: Variability::Tunable,
            start: scene.stiction,
            least: Some(1.0),
        });
        settable.extend((0..scene.masses.len()).flat_map(|index| initial(mass(scene, index))));
        Self {
            fields,
            settable,
            outputs: outputs(scene),
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

fn outputs(scene: &Scene) -> Vec<Output> {
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
    all.extend(motion.map(|(what, unit)| {
        let about = format!("relative {what} of the contact");
        output("contact", (what, unit), about, format!("contact.{what}()"))
    }));
    all.push(output(
        "contact",
        ("force", "N"),
        "friction force, or the force that holds a stuck contact".to_owned(),
        "contact.force()".to_owned(),
    ));
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
