//! The variables of an FMU. From this list, the command writes the description of the FMU and its Rust file.

use crate::export::names::mass;
use crate::export::stepping::inputs;
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
    /// Fields of the stepper's input in Rust. They correspond to the first variables, in the same order.
    pub fields: Vec<String>,
    /// Variables that the importer may set: inputs, stiction, and initial displacements and velocities.
    pub settable: Vec<Settable>,
    /// All variables that the FMU computes.
    pub outputs: Vec<Output>,
}

impl Variables {
    /// Returns the variables of a scene's FMU.
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
            // The C comment of this field ends with the unit, for example `displacement of the base, m`.
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
