//! Exported functions that compute the motion in time under a harmonic load, from event to event.

use super::face::{
    ExportedFunction, ExportedItems, ExportedStruct, FieldType, Opaque, Passed, StructField,
};
use super::names::{mass_fields, of_masses};
use super::room;
use frictiongen::study::scene::{FrictionLaw, Scene};
use frictiongen_codegen::standalone::{StepperShape, StepperSizes};

const STATE: &str = "simulation";
const CHANGED: (&str, Passed) = ("simulation", Passed::Changed(STATE));
const READ: (&str, Passed) = ("simulation", Passed::Read(STATE));

/// Adds the functions of the simulation, and the structs of these functions. `name` is the Rust type of the scene, and
/// `unit` the unit of displacements.
pub fn add(face: &mut ExportedItems, scene: &Scene, (name, unit): (&str, &str)) {
    let (parts, elastic) = match StepperShape::of(scene).sizes {
        StepperSizes::Modes {
            modes,
            held,
            elastic,
            ..
        } => (modes + held, elastic),
        StepperSizes::Joints { .. } => return,
    };
    let has_law = scene.friction != FrictionLaw::Coulomb;
    face.opaque.push(Opaque {
        name: STATE,
        about: "A motion in time under a harmonic load. A static variable or any other memory of this type will do. An assignment copies it.",
        contents: format!("super::{name}Simulation"),
        words: room::simulation_words(parts, (has_law, elastic), scene.precision),
    });
    records(face, scene, unit);
    starts(face, scene, has_law);
    face.functions.push(ExportedFunction::new(
        "simulation_advance",
        "Advances to the next event, or by at most reach in tau = omega t.  After an error the motion keeps its state.",
        vec![
            CHANGED,
            ("reach", Passed::Value(FieldType::Real)),
            ("segment", Passed::Output(FieldType::Record("segment"))),
        ],
        "use frictiongen::answer::Event;\nlet found = simulation.change()?.advance(reach).map_err(domain)?;\nlet event = match found.event {\n    None => 0,\n    Some(Event::Stop) => 1,\n    Some(Event::Slip) => 2,\n    Some(Event::Reversal) => 3,\n};\nsegment.write(Segment {\n    start: found.start,\n    length: found.length,\n    sliding: sliding(found.contact),\n    event,\n});\nOk(())",
    ));
    read_outs(face, scene);
}

fn records(face: &mut ExportedItems, scene: &Scene, unit: &str) {
    let sliding = |about: &str| StructField::new("sliding", FieldType::Int, about);
    face.records.push(ExportedStruct {
        name: "simulation_masses",
        about: format!("Motions of all masses at the present instant, over {unit}."),
        fields: mass_fields(scene, "instant"),
    });
    face.records.push(ExportedStruct {
        name: "segment",
        about: "A segment of the motion, in which the contact sticks or slides in one direction."
            .to_owned(),
        fields: vec![
            StructField::new(
                "start",
                FieldType::Real,
                "tau at the start within the excitation's cycle, from 0 to 2 pi",
            ),
            StructField::new("length", FieldType::Real, "length in tau"),
            sliding("0 if the contact sticks, otherwise the sign of its velocity"),
            StructField::new(
                "event",
                FieldType::Int,
                "event at the end: 0 none, 1 stop, 2 break-away, 3 reversal without a stop",
            ),
        ],
    });
    face.records.push(ExportedStruct {
        name: "simulation_contact",
        about: format!("The contact at the present instant. The displacement is over {unit}."),
        fields: vec![
            StructField::new("displacement", FieldType::Real, "relative displacement"),
            StructField::new(
                "velocity",
                FieldType::Real,
                "its derivative with respect to tau",
            ),
            StructField::new(
                "force",
                FieldType::Real,
                "force in the contact over the amplitude of the load",
            ),
            sliding("0 while the contact sticks, otherwise the sign of its velocity"),
        ],
    });
    face.records.push(ExportedStruct {
        name: "simulation_progress",
        about: "Time since the start, at a maximum of the excitation.".to_owned(),
        fields: vec![
            StructField::new(
                "cycles",
                FieldType::Long,
                "completed cycles of the excitation",
            ),
            StructField::new(
                "phase",
                FieldType::Real,
                "tau within the cycle, from 0 to 2 pi",
            ),
        ],
    });
}

/// Adds the functions that start a motion in time. If the friction depends on the speed, the functions need the
/// amplitude of the load.
fn starts(face: &mut ExportedItems, scene: &Scene, has_law: bool) {
    let (given, call) = if has_law {
        ("r, beta, amplitude", "simulation_under")
    } else {
        ("r, beta", "simulation")
    };
    let about = if has_law {
        " The amplitude is that of the force, N, or of the base, m."
    } else {
        ""
    };
    let value = |name| (name, Passed::Value(FieldType::Real));
    let mut parameters = vec![
        ("simulation", Passed::Fresh(STATE)),
        value("r"),
        value("beta"),
    ];
    if has_law {
        parameters.push(value("amplitude"));
    }
    face.functions.push(ExportedFunction::new(
        "simulation_start",
        format!("Starts the motion from rest, at a maximum of the excitation.{about}"),
        parameters.clone(),
        format!(
            "simulation.write(SimulationMemory::new(Scene::{call}({given}).map_err(domain)?));\nOk(())"
        ),
    ));
    let list = |of: &str| of_masses(scene, |field, _| format!("start.{field}.{of}")).join(", ");
    parameters.push(("start", Passed::Input("simulation_masses")));
    face.functions.push(ExportedFunction::new(
        "simulation_start_from",
        format!(
            "Starts the motion from a state of all masses, at a maximum of the excitation.{about}"
        ),
        parameters,
        format!(
            "let state = (&[{}], &[{}]);\nsimulation.write(SimulationMemory::new(Scene::{call}_from({given}, state).map_err(domain)?));\nOk(())",
            list("displacement"),
            list("velocity")
        ),
    ));
}

fn read_outs(face: &mut ExportedItems, scene: &Scene) {
    let masses = of_masses(scene, |field, name| {
        format!("{field}: moment!(found.{name}()), ")
    });
    let masses = masses.concat();
    let found = "let found = simulation.read()?;\n";
    let output = |name, record| (name, Passed::Output(FieldType::Record(record)));
    face.functions.push(ExportedFunction::new(
        "simulation_masses",
        "Returns the motions of all masses.",
        vec![READ, output("masses", "simulation_masses")],
        format!(
            "macro_rules! moment {{\n    ($of:expr) => {{{{ let of = $of; Instant {{ displacement: of.displacement(), velocity: of.velocity() }} }}}};\n}}\n{found}masses.write(SimulationMasses {{ {masses}}});\nOk(())"
        ),
    ));
    face.functions.push(ExportedFunction::new(
        "simulation_contact",
        "Returns motion, force and state of the contact.",
        vec![READ, output("contact", "simulation_contact")],
        format!(
            "{found}let (displacement, velocity) = found.relative();\ncontact.write(SimulationContact {{\n    displacement,\n    velocity,\n    force: found.friction(),\n    sliding: sliding(found.contact()),\n}});\nOk(())"
        ),
    ));
    face.functions.push(ExportedFunction::new(
        "simulation_progress",
        "Returns the time since the start.",
        vec![READ, output("progress", "simulation_progress")],
        format!(
            "{found}progress.write(SimulationProgress {{ cycles: found.cycles(), phase: found.phase() }});\nOk(())"
        ),
    ));
}
