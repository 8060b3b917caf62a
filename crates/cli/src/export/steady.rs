//! Exported functions that take a frequency ratio. They return limits, regimes, continuous motions, stuck responses and
//! steady states.

use super::face::{
    ExportedFunction, ExportedItems, ExportedStruct, FieldType, Passed, StructField,
};
use super::names::{field, mass, mass_field, mass_fields, of_masses};
use frictiongen::study::scene::{Excitation, Provide, Scene};

const R: (&str, Passed) = ("r", Passed::Value(FieldType::Real));
const BETA: (&str, Passed) = ("beta", Passed::Value(FieldType::Real));

/// Adds the functions of the items of `provide` that depend on the frequency ratio.
pub fn add(face: &mut ExportedItems, scene: &Scene) {
    if scene.needs_frequency() {
        face.records.push(ExportedStruct {
            name: "oscillation",
            about: format!("A steady motion, over {}.", unit(scene)),
            fields: vec![
                StructField::new(
                    "amplitude",
                    FieldType::Real,
                    "exact maximum of the displacement",
                ),
                StructField::new(
                    "phase",
                    FieldType::Real,
                    "lag of the maximum behind the excitation's, rad",
                ),
            ],
        });
        face.records.push(ExportedStruct {
            name: "complex",
            about: format!(
                "A complex amplitude X over {}: x = Re(X e^(i omega t)).",
                unit(scene)
            ),
            fields: vec![
                StructField::new("re", FieldType::Real, "real component"),
                StructField::new("im", FieldType::Real, "imaginary component"),
            ],
        });
    }
    if scene.needs_frequency() || scene.provides(&Provide::Simulation) {
        face.records.push(ExportedStruct {
            name: "instant",
            about: format!(
                "Displacement and velocity at an instant, over {}.",
                unit(scene)
            ),
            fields: vec![
                StructField::new("displacement", FieldType::Real, "displacement"),
                StructField::new(
                    "velocity",
                    FieldType::Real,
                    "derivative with respect to tau = omega t",
                ),
            ],
        });
    }
    if scene.provides(&Provide::Limits) {
        limits(face);
    }
    let motion = scene.provide.iter().find_map(|item| match item {
        Provide::Motion(masses) => Some(masses.clone()),
        _ => None,
    });
    if let Some(masses) = motion {
        let masses = masses.unwrap_or_else(|| (0..scene.masses.len()).collect());
        let motion = Motions {
            name: "motion",
            prepare: "let motion = Scene::at(r).map_err(domain)?.motion(beta).map_err(not_continuous)?;",
            about: "The motion in which the contact slides all the time",
            masses,
        };
        motion.add(face, scene);
    }
    if scene.provides(&Provide::Stuck) {
        stuck(face, scene);
    }
    if scene.provides(&Provide::Orbit) {
        super::orbit::add(face, scene, unit(scene));
        let motion = Motions {
            name: "orbit",
            prepare: "let motion = Scene::at(r).map_err(domain)?.orbit(beta).map_err(no_orbit)?;",
            about: "The steady state that motion from rest reaches, in any regime",
            masses: (0..scene.masses.len()).collect(),
        };
        motion.add(face, scene);
    }
    if scene.provides(&Provide::SelfCheck) {
        face.functions.push(ExportedFunction {
            name: "self_check",
            about: "Compares all constants with their checksums, and answers with known answers."
                .to_owned(),
            parameters: Vec::new(),
            body: "Scene::self_check().map_err(|_| SELF_CHECK)".to_owned(),
        });
    }
}

/// Returns the unit of displacements in the exported interface.
pub fn unit(scene: &Scene) -> &'static str {
    match scene.excitation {
        Excitation::Base => "the amplitude Y of the base",
        Excitation::Force(_) => "P/k1",
    }
}

fn limits(face: &mut ExportedItems) {
    face.records.push(ExportedStruct {
        name: "limits",
        about: "Both limits of the friction ratio beta.".to_owned(),
        fields: vec![
            StructField::new(
                "continuous",
                FieldType::Real,
                "beta_lim: below it a motion slides all the time",
            ),
            StructField::new(
                "sliding",
                FieldType::Real,
                "beta*_lim: from it on a stuck state exists",
            ),
        ],
    });
    let at = "let at = Scene::at(r).map_err(domain)?;\n";
    let question = |name, about: &str, kind, parameters: &[(&'static str, Passed)], rest: &str| {
        let mut parameters = parameters.to_vec();
        parameters.push((name, Passed::Output(kind)));
        ExportedFunction {
            name,
            about: about.to_owned(),
            parameters,
            body: format!("{at}{rest}"),
        }
    };
    face.functions.push(question(
        "limits",
        "Returns both limits at the frequency ratio r = omega sqrt(m1/k1).",
        FieldType::Record("limits"),
        &[R],
        "let found = at.limits();\nlimits.write(Limits { continuous: found.continuous, sliding: found.sliding });\nOk(())",
    ));
    face.functions.push(question(
        "regime",
        "Returns the regime at r and at the friction ratio beta: 0 continuous, 1 stick-slip, 2 stuck, 3 bistable.",
        FieldType::Int,
        &[R, BETA],
        "let number = match at.regime(beta).map_err(domain)? {\n    Regime::Continuous => 0,\n    Regime::StickSlip => 1,\n    Regime::Stuck => 2,\n    Regime::Bistable => 3,\n    _ => return Err(OTHER),\n};\nregime.write(number);\nOk(())",
    ));
    face.functions.push(question(
        "margin",
        "Returns beta over the smaller limit, minus 1. Below 0 the contact slides all the time.",
        FieldType::Real,
        &[R, BETA],
        "margin.write(at.margin(beta).map_err(domain)?);\nOk(())",
    ));
}

/// Motions of the contact and of masses. The exported interface returns these motions as fields of one struct.
struct Motions {
    name: &'static str,
    prepare: &'static str,
    about: &'static str,
    masses: Vec<usize>,
}

impl Motions {
    /// Returns the fields of a struct: one for the contact, and one for each mass whose motion the scene provides.
    fn fields(&self, scene: &Scene, record: &'static str) -> Vec<StructField> {
        let contact = StructField::new(
            "contact",
            FieldType::Record(record),
            "relative motion in the contact",
        );
        let masses = self.masses.iter();
        let masses = masses.map(|index| mass_field(scene, *index, record));
        std::iter::once(contact).chain(masses).collect()
    }

    /// Returns the Rust code for the fields of the struct. The code applies the macro `function` to the motion of the
    /// contact and of each mass.
    fn written(&self, scene: &Scene, function: &str) -> String {
        let contact = format!("contact: {function}!(motion.contact()), ");
        let masses = self.masses.iter().map(|index| {
            let (name, method) = (field(scene, *index, "mass"), mass(scene, *index));
            format!("{name}: {function}!(motion.{method}()), ")
        });
        std::iter::once(contact).chain(masses).collect()
    }

    fn add(&self, face: &mut ExportedItems, scene: &Scene) {
        let questions = [
            (
                "",
                "oscillation",
                "oscillation",
                "amplitudes and phases",
                None,
            ),
            (
                "_harmonic",
                "complex",
                "harmonic",
                "harmonics of order n, with t from a maximum of the excitation",
                Some(("n", Passed::Value(FieldType::Count))),
            ),
            (
                "_at",
                "instant",
                "instant",
                "displacements and velocities at tau after a maximum of the contact's motion",
                Some(("tau", Passed::Value(FieldType::Real))),
            ),
        ];
        for (ending, record, function, what, more) in questions {
            let whole: &'static str = match (self.name, ending) {
                ("motion", "") => "motion",
                ("motion", "_harmonic") => "motion_harmonic",
                ("motion", _) => "motion_at",
                (_, "") => "orbit_motion",
                (_, "_harmonic") => "orbit_harmonic",
                _ => "orbit_at",
            };
            face.records.push(ExportedStruct {
                name: whole,
                about: format!("{}: {what}.", self.about),
                fields: self.fields(scene, record),
            });
            let written = self.written(scene, function);
            let mut parameters = vec![R, BETA];
            parameters.extend(more);
            parameters.push(("result", Passed::Output(FieldType::Record(whole))));
            let given = match ending {
                "_harmonic" => {
                    "macro_rules! harmonic {\n    ($of:expr) => { complex($of.harmonic(n)) };\n}\n"
                }
                "_at" => {
                    "macro_rules! instant {\n    ($of:expr) => { Instant { displacement: $of.displacement(tau), velocity: $of.velocity(tau) } };\n}\n"
                }
                _ if self.name == "motion" => {
                    "macro_rules! oscillation {\n    ($of:expr) => {{ let largest = $of.largest(); Oscillation { amplitude: largest.amplitude, phase: largest.phase } }};\n}\n"
                }
                _ => {
                    "macro_rules! oscillation {\n    ($of:expr) => {{ let (amplitude, phase) = ($of.amplitude(), $of.phase()); Oscillation { amplitude, phase } }};\n}\n"
                }
            };
            face.functions.push(ExportedFunction {
                name: whole,
                about: format!("Returns {what}. {}.", self.about),
                parameters,
                body: format!(
                    "{given}{}\nresult.write({} {{ {written}}});\nOk(())",
                    self.prepare,
                    super::face::type_name(whole)
                ),
            });
        }
    }
}

fn stuck(face: &mut ExportedItems, scene: &Scene) {
    face.records.push(ExportedStruct {
        name: "stuck",
        about: "Complex amplitudes while the contact is stuck.".to_owned(),
        fields: mass_fields(scene, "complex"),
    });
    let written = of_masses(scene, |field, name| {
        format!("{field}: complex(found.{name}()), ")
    });
    let written = written.concat();
    face.functions.push(ExportedFunction {
        name: "stuck",
        about: "Returns the response while the contact is stuck.".to_owned(),
        parameters: vec![R, ("stuck", Passed::Output(FieldType::Record("stuck")))],
        body: format!(
            "let found = Scene::at(r).map_err(domain)?.stuck().map_err(|_| STUCK_RESONANCE)?;\nstuck.write(Stuck {{ {written}}});\nOk(())"
        ),
    });
}
