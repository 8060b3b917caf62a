//! Exported functions of the stepper.

use super::face::{
    ExportedFunction, ExportedItems, ExportedStruct, FieldType, Opaque, Passed, StructField,
};
use super::names::{ascii, field, mass, mass_fields, of_masses};
use super::room;
use frictiongen::kernel::{joints, stepper};
use frictiongen::study::scene::{Precision, Scene};
use frictiongen_codegen::standalone::{StepperShape, StepperSizes};

const STATE: &str = "stepper";
const SAVED: &str = "stepper_saved";
const CHANGED: (&str, Passed) = ("stepper", Passed::Changed(STATE));
const READ: (&str, Passed) = ("stepper", Passed::Read(STATE));

/// Adds the functions of the stepper, and the structs of these functions. `name` is the Rust type of the scene.
pub fn add(face: &mut ExportedItems, scene: &Scene, name: &str) {
    let shape = StepperShape::of(scene);
    let [words, saved] = room::words(&shape.sizes, scene.precision);
    let scalar = match scene.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    face.opaque.push(Opaque {
        name: STATE,
        about: "A stepper: the motion in steps of one length dt. A static variable or any other memory of this type will do. An assignment copies a stepper.",
        contents: format!("super::{name}Stepper"),
        words,
    });
    face.opaque.push(Opaque {
        name: SAVED,
        about: "State of a stepper without its tables, for stepper_save and stepper_restore.",
        contents: shape.sizes.saved_type(scalar),
        words: saved,
    });
    records(face, scene, &shape);
    control(face, scene, &shape, name);
    read_outs(face, scene, &shape);
    storage(face, scene, &shape);
}

/// Returns the fields of the stepper's input in C, each with the corresponding field of the Rust type.
pub fn inputs(scene: &Scene, shape: &StepperShape) -> Vec<(StructField, String)> {
    let mut fields = Vec::new();
    let mut add = |name: String, inner: &str, about: String| {
        fields.push((
            StructField::new(name, FieldType::Real, about),
            inner.to_owned(),
        ));
    };
    if shape.on_base {
        add(
            "displacement".to_owned(),
            "displacement",
            "displacement of the base, m".to_owned(),
        );
        add(
            "velocity".to_owned(),
            "velocity",
            "velocity of the base, m/s".to_owned(),
        );
    }
    for (place, index) in shape.forces.iter().enumerate() {
        let about = format!("force on mass {}, N", mass(scene, *index));
        if place == 0 && !shape.on_base {
            add("force".to_owned(), "force", about);
        } else {
            add(field(scene, *index, "force"), mass(scene, *index), about);
        }
    }
    if let [_] = shape.contacts.as_slice() {
        let about = "kinetic friction force F, N, not negative".to_owned();
        add("friction".to_owned(), "friction", about);
        return fields;
    }
    for (index, contact) in shape.contacts.iter().enumerate() {
        let about = format!("kinetic friction force of contact {contact}, N, not negative");
        let name = format!("friction_{}", ascii(contact, index));
        add(name, contact, about);
    }
    fields
}

/// Returns the Rust expression of a stepper's input. `value` returns the expression of the field with a given index and
/// its name in C. `path` is the module of the scene's types, and `name` the type of the scene.
pub fn input_expression(
    scene: &Scene,
    shape: &StepperShape,
    name: &str,
    value: impl Fn(usize, &str) -> String,
) -> String {
    let fields = inputs(scene, shape);
    let fields = fields.iter().enumerate();
    let mut fields: Vec<String> = fields
        .map(|(index, (field, inner))| format!("{inner}: {}", value(index, &field.name)))
        .collect();
    if shape.contacts.len() > 1 {
        let frictions = fields.split_off(fields.len() - shape.contacts.len());
        fields.push(format!(
            "friction: super::{name}Friction {{ {} }}",
            frictions.join(", ")
        ));
    }
    format!("super::{name}Input {{ {} }}", fields.join(", "))
}

/// Returns the method of a stepper that returns the state of a contact.
pub fn contact_method<'s>(scene: &Scene, contact: &'s str) -> &'s str {
    if scene.is_joined() {
        contact
    } else {
        "contact"
    }
}

fn records(face: &mut ExportedItems, scene: &Scene, shape: &StepperShape) {
    let inputs = inputs(scene, shape).into_iter();
    face.records.push(ExportedStruct {
        name: "input",
        about: "Input at the end of a step (`input: linear`) or during the step (`input: hold`)."
            .to_owned(),
        fields: inputs.map(|(field, _)| field).collect(),
    });
    let sliding = || {
        StructField::new(
            "sliding",
            FieldType::Int,
            "0 while the contact sticks, otherwise the sign of its velocity",
        )
    };
    let of_step = [
        StructField::new(
            "events",
            FieldType::Count,
            "number of stops, break-aways and reversals",
        ),
        StructField::new(
            "exceeded",
            FieldType::Int,
            "1 if the step reached the bound on events",
        ),
    ];
    let of_contact = [
        StructField::new(
            "force",
            FieldType::Real,
            "force in the contact at the end of the step, N",
        ),
        sliding(),
    ];
    let is_single = shape.contacts.len() == 1;
    let of_contact = of_contact.into_iter().filter(|_| is_single);
    face.records.push(ExportedStruct {
        name: "stepped",
        about: "Result of a step.".to_owned(),
        fields: of_contact.chain(of_step).collect(),
    });
    face.records.push(ExportedStruct {
        name: "mass_now",
        about: "Motion of a mass at the end of the last step.".to_owned(),
        fields: vec![
            StructField::new("displacement", FieldType::Real, "m"),
            StructField::new("velocity", FieldType::Real, "m/s"),
        ],
    });
    face.records.push(ExportedStruct {
        name: "masses",
        about: "Motions of all masses.".to_owned(),
        fields: mass_fields(scene, "mass_now"),
    });
    face.records.push(ExportedStruct {
        name: "contact",
        about: "A contact at the end of the last step.".to_owned(),
        fields: vec![
            StructField::new("displacement", FieldType::Real, "relative displacement, m"),
            StructField::new("velocity", FieldType::Real, "relative velocity, m/s"),
            StructField::new(
                "force",
                FieldType::Real,
                "friction force, or the force that holds a stuck contact, N",
            ),
            sliding(),
        ],
    });
    if !is_single {
        let contacts = shape.contacts.iter().enumerate();
        let contacts = contacts.map(|(index, contact)| {
            StructField::new(
                format!("contact_{}", ascii(contact, index)),
                FieldType::Record("contact"),
                format!("contact {contact}"),
            )
        });
        face.records.push(ExportedStruct {
            name: "contacts",
            about: "All contacts at the end of the last step.".to_owned(),
            fields: contacts.collect(),
        });
    }
    face.records.push(ExportedStruct {
        name: "work",
        about: "Energy balance since the start, J.".to_owned(),
        fields: ["load", "friction", "damping", "stored"]
            .into_iter()
            .map(|name| {
                StructField::new(
                    name,
                    FieldType::Real,
                    match name {
                        "load" => "work of the forces and of the base",
                        "friction" => "dissipated by friction",
                        "damping" => "dissipated by damping",
                        _ => "increase of kinetic and elastic energy",
                    },
                )
            })
            .collect(),
    });
    let mut progress = vec![
        StructField::new("steps", FieldType::Long, "number of steps"),
        StructField::new(
            "exceeded",
            FieldType::Long,
            "number of steps that reached the bound on events",
        ),
        StructField::new("time", FieldType::Real, "time since the start, s"),
        StructField::new("dt", FieldType::Real, "length of a step, s"),
    ];
    if is_single {
        progress.push(StructField::new(
            "stiction",
            FieldType::Real,
            "mu, static over kinetic friction force",
        ));
    }
    face.records.push(ExportedStruct {
        name: "progress",
        about: "Steps and time since the start.".to_owned(),
        fields: progress,
    });
}

fn control(face: &mut ExportedItems, scene: &Scene, shape: &StepperShape, name: &str) {
    let dt = ("dt", Passed::Value(FieldType::Real));
    let fresh = ("stepper", Passed::Fresh(STATE));
    face.functions.push(ExportedFunction::new(
        "stepper_start",
        "Starts a stepper with the step dt, s, from rest without load.",
        vec![fresh.clone(), dt.clone()],
        "stepper.write(StepperMemory::new(Scene::stepper(dt).map_err(domain)?));\nOk(())"
            .to_owned(),
    ));
    let list = |of: &str| {
        let values = of_masses(scene, |field, _| format!("masses.{field}.{of}"));
        format!("[{}]", values.join(", "))
    };
    face.functions.push(ExportedFunction::new(
        "stepper_start_from",
        "Starts a stepper from the displacement and velocity of every mass.",
        vec![fresh, dt, ("masses", Passed::Input("masses"))],
        format!(
            "let displacements = {};\nlet velocities = {};\nlet state = (&displacements, &velocities);\nstepper.write(StepperMemory::new(Scene::stepper_from(dt, state).map_err(domain)?));\nOk(())",
            list("displacement"),
            list("velocity")
        ),
    ));
    let input = input_expression(scene, shape, name, |_, field| format!("input.{field}"));
    let input = format!("let input = {input};\n");
    face.functions.push(ExportedFunction::new(
        "stepper_begin",
        "Sets the input at the start of the first step.  Without this call that input is 0.",
        vec![CHANGED, ("input", Passed::Input("input"))],
        format!("{input}stepper.change()?.begin(input).map_err(domain)"),
    ));
    face.functions.push(ExportedFunction::new(
        "stepper_advance",
        "Takes a step.  After an error the stepper keeps its state.",
        vec![
            CHANGED,
            ("input", Passed::Input("input")),
            ("stepped", Passed::Output(FieldType::Record("stepped"))),
        ],
        advance(scene, shape, &input),
    ));
    let (contact, set) = match (shape.contacts.as_slice(), scene.is_joined()) {
        ([_], false) => (None, "set_stiction(mu)"),
        ([_], true) => (None, "set_stiction(0, mu)"),
        _ => (
            Some(("contact", Passed::Value(FieldType::Count))),
            "set_stiction(contact as usize, mu)",
        ),
    };
    let about = match contact {
        None => "Sets mu, the ratio of static to kinetic friction force, from the next step on.",
        Some(_) => {
            "Sets mu of a contact, the ratio of static to kinetic friction force, from the next step on.  Contacts are counted from 0."
        }
    };
    let parameters = [CHANGED].into_iter().chain(contact);
    face.functions.push(ExportedFunction::new(
        "stepper_set_stiction",
        about,
        parameters
            .chain([("mu", Passed::Value(FieldType::Real))])
            .collect(),
        format!("stepper.change()?.{set}.map_err(domain)"),
    ));
}

/// Returns the body of the function that takes a step.
fn advance(scene: &Scene, shape: &StepperShape, input: &str) -> String {
    let of_contact = match shape.contacts.as_slice() {
        [contact] if scene.is_joined() => format!(
            "let now = stepper.{contact}();\nlet (force, sliding) = (now.force(), sliding(now.contact()));\n"
        ),
        [_] => "let (force, sliding) = (found.force, sliding(found.contact));\n".to_owned(),
        _ => String::new(),
    };
    let written = if of_contact.is_empty() {
        ""
    } else {
        "    force,\n    sliding,\n"
    };
    format!(
        "{input}let stepper = stepper.change()?;\nlet found = stepper.advance(input).map_err(domain)?;\n{of_contact}stepped.write(Stepped {{\n{written}    events: found.events,\n    exceeded: i32::from(found.exceeded),\n}});\nOk(())"
    )
}

fn read_outs(face: &mut ExportedItems, scene: &Scene, shape: &StepperShape) {
    let masses = of_masses(scene, |field, name| {
        format!("{field}: mass_now(&found.{name}()), ")
    });
    let masses = masses.concat();
    let found = "let found = stepper.read()?;\n";
    let output = |name, record| (name, Passed::Output(FieldType::Record(record)));
    face.functions.push(ExportedFunction::new(
        "stepper_masses",
        "Returns the motions of all masses.",
        vec![READ, output("masses", "masses")],
        format!("{found}masses.write(Masses {{ {masses}}});\nOk(())"),
    ));
    let contact_of = |contact: &str| {
        format!(
            "{{\n    let now = found.{}();\n    Contact {{ displacement: now.displacement(), velocity: now.velocity(), force: now.force(), sliding: sliding(now.contact()) }}\n}}",
            contact_method(scene, contact)
        )
    };
    if let [contact] = shape.contacts.as_slice() {
        face.functions.push(ExportedFunction::new(
            "stepper_contact",
            "Returns motion, force and state of the contact.",
            vec![READ, output("contact", "contact")],
            format!("{found}contact.write({});\nOk(())", contact_of(contact)),
        ));
    } else {
        let contacts = shape.contacts.iter().enumerate();
        let contacts = contacts.map(|(index, contact)| {
            format!(
                "contact_{}: {},\n",
                ascii(contact, index),
                contact_of(contact)
            )
        });
        let contacts: String = contacts.collect();
        face.functions.push(ExportedFunction::new(
            "stepper_contacts",
            "Returns motion, force and state of all contacts.",
            vec![READ, output("contacts", "contacts")],
            format!("{found}contacts.write(Contacts {{\n{contacts}}});\nOk(())"),
        ));
    }
    face.functions.push(ExportedFunction::new(
        "stepper_work",
        "Returns the energy balance.",
        vec![READ, output("work", "work")],
        format!(
            "{found}let now = found.work();\nwork.write(Work {{ load: now.load, friction: now.friction, damping: now.damping, stored: now.stored }});\nOk(())"
        ),
    ));
    let stiction = match (shape.contacts.as_slice(), scene.is_joined()) {
        ([_], false) => "    stiction: found.stiction(),\n",
        ([_], true) => "    stiction: found.stiction(0).unwrap_or_default(),\n",
        _ => "",
    };
    face.functions.push(ExportedFunction::new(
        "stepper_progress",
        "Returns the numbers of steps, and the time.",
        vec![READ, output("progress", "progress")],
        format!(
            "{found}progress.write(Progress {{\n    steps: found.steps(),\n    exceeded: found.exceeded(),\n    time: found.time(),\n    dt: found.dt(),\n{stiction}}});\nOk(())"
        ),
    ));
}

fn storage(face: &mut ExportedItems, scene: &Scene, shape: &StepperShape) {
    let scalar = match scene.precision {
        Precision::F64 => 8,
        Precision::F32 => 4,
    };
    let length = match &shape.sizes {
        StepperSizes::Modes {
            modes,
            held,
            inputs,
            ..
        } => stepper::image_bytes(scalar, *modes, *held, *inputs),
        StepperSizes::Joints { .. } => {
            let (masses, loads) = (scene.masses.len(), shape.forces.len());
            joints::image_bytes(scalar, masses, shape.contacts.len(), loads)
        }
    };
    face.records.push(ExportedStruct {
        name: "stepper_image",
        about: "State of a stepper for a file or for flash memory.".to_owned(),
        fields: vec![StructField::new(
            "bytes",
            FieldType::Bytes(length),
            "version, hash of the scene, step, state and checksum",
        )],
    });
    face.functions.push(ExportedFunction::new(
        "stepper_image",
        "Writes the state as bytes, which a later run of the program reads.",
        vec![
            READ,
            ("image", Passed::Output(FieldType::Record("stepper_image"))),
        ],
        "let bytes = stepper.read()?.image();\nimage.write(StepperImage { bytes });\nOk(())"
            .to_owned(),
    ));
    face.functions.push(ExportedFunction::new(
        "stepper_start_from_image",
        "Starts a stepper with the step and the state of an image.  A changed bit gives a status.",
        vec![
            ("stepper", Passed::Fresh(STATE)),
            ("image", Passed::Input("stepper_image")),
        ],
        "let found = Scene::stepper_from_image(&image.bytes).map_err(domain)?;\nstepper.write(StepperMemory::new(found));\nOk(())"
            .to_owned(),
    ));
    face.functions.push(ExportedFunction::new(
        "stepper_save",
        "Saves the state of a stepper.",
        vec![READ, ("saved", Passed::Fresh(SAVED))],
        "saved.write(StepperSavedMemory::new(stepper.read()?.save()));\nOk(())".to_owned(),
    ));
    face.functions.push(ExportedFunction::new(
        "stepper_restore",
        "Restores a saved state, with which the stepper continues to the last bit.",
        vec![CHANGED, ("saved", Passed::Read(SAVED))],
        "let saved = saved.read()?;\nstepper.change()?.restore(saved).map_err(domain)".to_owned(),
    ));
}
