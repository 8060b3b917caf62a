//! Compares the parameters of two scene descriptions, field by field.

use frictiongen::study::scene::{
    Accuracy, Beyond, CONTACT, Damping, DampingFrom, Excitation, FrictionLaw, Impact, Precision,
    Provide, Scene, Side, StepInput,
};

/// A field of a scene description as text, and as a number if the text is a number.
#[derive(Clone, Debug, PartialEq)]
pub struct DescriptionField {
    /// Name of the field, with the name of its mass or spring.
    pub name: String,
    /// Value of the field, in the notation of a scene description.
    pub text: String,
    /// Value of the field as a number, or `None` if it is not a number.
    pub number: Option<f64>,
}

/// A field with different values in two scene descriptions. The value is `None` if a description does not contain the
/// field.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldChange {
    /// Name of the field that differs.
    pub name: String,
    /// Value of the field in the old scene description.
    pub old: Option<DescriptionField>,
    /// Value of the field in the new scene description.
    pub new: Option<DescriptionField>,
}

impl FieldChange {
    /// Returns the change of the number, divided by the old number. Returns `None` unless both values are numbers.
    pub fn relative(&self) -> Option<f64> {
        let (old, new) = (self.old.as_ref()?.number?, self.new.as_ref()?.number?);
        (old != 0.0).then(|| (new - old) / old)
    }

    /// Returns true if the field describes the physics of the scene, so that a motion may depend on it.
    pub fn is_physical(&self) -> bool {
        let name = self.name.as_str();
        !NOT_PHYSICAL.contains(&name) && !name.starts_with("name of mass")
    }
}

/// Fields on which no motion of the scene depends: names, and settings of the emitted code.
const NOT_PHYSICAL: [&str; 14] = [
    "name",
    "first mass (m1)",
    "first spring (k1)",
    "provide",
    "scalar",
    "accuracy",
    "budget",
    "range of r",
    "range of beta",
    "side",
    "beyond",
    "step",
    "input",
    "force",
];

/// Returns the old scene with new names for some masses, and a change for each new name. A mass gets a new name under
/// two conditions: both scenes have the same number of masses, and each of the two names occurs in only one scene.
pub fn renamed(old: &Scene, new: &Scene) -> (Scene, Vec<FieldChange>) {
    let (mut scene, mut changes) = (old.clone(), Vec::new());
    if old.masses.len() != new.masses.len() {
        return (scene, changes);
    }
    let has = |scene: &Scene, name: &str| scene.masses.iter().any(|mass| mass.name == name);
    let masses = scene.masses.iter_mut().zip(&new.masses);
    for (number, (mass, other)) in (1..).zip(masses) {
        if !has(new, &mass.name) && !has(old, &other.name) {
            let name = format!("name of mass {number}");
            changes.push(FieldChange {
                old: Some(word(&name, mass.name.clone())),
                new: Some(word(&name, other.name.clone())),
                name,
            });
            mass.name.clone_from(&other.name);
        }
    }
    (scene, changes)
}

/// Returns the fields whose values differ, in the order of the old scene description.
pub fn changes(old: &Scene, new: &Scene) -> Vec<FieldChange> {
    let (old, new) = (fields(old), fields(new));
    let find = |fields: &[DescriptionField], name: &str| {
        fields.iter().find(|field| field.name == name).cloned()
    };
    let kept = old.iter().map(|field| FieldChange {
        name: field.name.clone(),
        old: Some(field.clone()),
        new: find(&new, &field.name),
    });
    let added = new.iter().filter(|field| find(&old, &field.name).is_none());
    let added = added.map(|field| FieldChange {
        name: field.name.clone(),
        old: None,
        new: Some(field.clone()),
    });
    let text = |field: &Option<DescriptionField>| field.as_ref().map(|field| field.text.clone());
    kept.chain(added)
        .filter(|change| text(&change.old) != text(&change.new))
        .collect()
}

/// Returns every field of a scene that has no default, and every field that differs from its default.
fn fields(scene: &Scene) -> Vec<DescriptionField> {
    let mut fields = vec![word("name", scene.name.clone())];
    for mass in &scene.masses {
        fields.push(number(format!("mass {}", mass.name), mass.value));
    }
    if let Some(first) = scene.masses.first() {
        fields.push(word("first mass (m1)", first.name.clone()));
    }
    let ends = |from, to| format!("{} - {}", scene.node_name(from), scene.node_name(to));
    for spring in &scene.springs {
        let name = format!("spring {}", ends(spring.from, spring.to));
        fields.push(number(name, spring.stiffness));
    }
    if let Some(first) = scene.springs.first() {
        fields.push(word("first spring (k1)", ends(first.from, first.to)));
    }
    if scene.joints.contacts.is_empty() {
        let name = match scene.contact_name.as_str() {
            CONTACT => CONTACT.to_owned(),
            name => format!("contact {name}"),
        };
        fields.push(word(&name, ends(scene.contact.from, scene.contact.to)));
    }
    for contact in &scene.joints.contacts {
        let (name, sides, law) = (&contact.name, &contact.sides, &contact.law);
        fields.push(word(&format!("contact {name}"), ends(sides.from, sides.to)));
        if let Some(stiffness) = law.stiffness {
            fields.push(number(format!("stiffness of {name}"), stiffness));
        }
        fields.push(number(format!("stiction of {name}"), law.stiction));
        fields.push(number(format!("share of {name}"), law.share));
        if law.speed != 0.0 {
            fields.push(number(format!("speed of {name}"), law.speed));
        }
    }
    for damper in &scene.joints.dampers {
        let name = format!("damper {}", ends(damper.from, damper.to));
        fields.push(number(name, damper.coefficient));
    }
    for stop in &scene.joints.stops {
        let (name, sides, law) = (&stop.name, stop.sides, stop.law);
        fields.push(word(&format!("stop {name}"), ends(sides.from, sides.to)));
        fields.push(number(format!("gap of {name}"), law.gap));
        match law.impact {
            Impact::Spring { stiffness, damping } => {
                fields.push(number(format!("stiffness of {name}"), stiffness));
                if damping != 0.0 {
                    fields.push(number(format!("damping of {name}"), damping));
                }
            }
            Impact::Restitution(ratio) => {
                fields.push(number(format!("restitution of {name}"), ratio));
            }
        }
    }
    let mass = |index: &usize| {
        scene
            .masses
            .get(*index)
            .map_or("?", |mass| mass.name.as_str())
    };
    for load in &scene.joints.constant {
        let name = format!("constant force on {}", mass(&load.mass));
        fields.push(number(name, load.force));
    }
    fields.push(word(
        "excitation",
        match scene.excitation {
            Excitation::Base => "base",
            Excitation::Force(index) => mass(&index),
        },
    ));
    damping(&scene.damping, &mut fields);
    if scene.damping_from == DampingFrom::Base {
        fields.push(word("damping_from", "base"));
    }
    fields.push(number("stiction".to_owned(), scene.stiction));
    if let Some(stiffness) = scene.stiffness {
        fields.push(number("stiffness of the contact".to_owned(), stiffness));
    }
    let list = |indices: &[usize]| indices.iter().map(mass).collect::<Vec<_>>().join(", ");
    let provided = scene.provide.iter().map(|item| match item {
        Provide::Limits => "limits".to_owned(),
        Provide::Motion(None) => "motion".to_owned(),
        Provide::Motion(Some(masses)) => format!("motion({})", list(masses)),
        Provide::Stuck => "stuck".to_owned(),
        Provide::Orbit => "orbit".to_owned(),
        Provide::Simulation => "simulation".to_owned(),
        Provide::Stepper => "stepper".to_owned(),
        Provide::SelfCheck => "self_check".to_owned(),
    });
    fields.push(word("provide", provided.collect::<Vec<_>>().join(", ")));
    fields.push(word(
        "scalar",
        match scene.precision {
            Precision::F64 => "f64",
            Precision::F32 => "f32",
        },
    ));
    tables(scene, &mut fields);
    if let FrictionLaw::Stribeck(points) = &scene.friction {
        let points = points
            .iter()
            .map(|[speed, level]| format!("{speed:?}: {level:?}"));
        let points = points.collect::<Vec<_>>().join(", ");
        fields.push(word("friction", format!("stribeck({points})")));
    }
    if let Some(step) = scene.stepping.step {
        fields.push(number("step".to_owned(), step));
    }
    if scene.stepping.input == StepInput::Hold {
        fields.push(word("input", "hold"));
    }
    if !scene.stepping.forces.is_empty() {
        fields.push(word("force", list(&scene.stepping.forces)));
    }
    fields
}

fn damping(damping: &Damping, fields: &mut Vec<DescriptionField>) {
    match damping {
        Damping::None => fields.push(word("damping", "none")),
        Damping::Uniform(ratio) => {
            fields.push(word("damping", "modal"));
            fields.push(number("damping of all modes".to_owned(), *ratio));
        }
        Damping::Modal(ratios) => {
            fields.push(word("damping", "modal"));
            for (mode, ratio) in ratios.iter().enumerate() {
                fields.push(number(format!("damping of mode {}", mode + 1), *ratio));
            }
        }
        Damping::Rayleigh { mass, stiffness } => {
            fields.push(word("damping", "rayleigh"));
            fields.push(number("damping a of aM".to_owned(), *mass));
            fields.push(number("damping b of bK".to_owned(), *stiffness));
        }
    }
}

/// Adds the fields that declare tables, such as `accuracy` and `range`.
fn tables(scene: &Scene, fields: &mut Vec<DescriptionField>) {
    let declared = &scene.declared;
    if let Accuracy::Relative(accuracy) = declared.accuracy {
        fields.push(DescriptionField {
            name: "accuracy".to_owned(),
            text: format!("{accuracy:e}"),
            number: Some(accuracy),
        });
    }
    if let Some(bytes) = declared.budget {
        fields.push(number("budget".to_owned(), bytes));
    }
    if let Some(range) = declared.range {
        for (name, (from, to)) in [("range of r", range.r), ("range of beta", range.beta)] {
            if (from, to) != (0.0, f64::INFINITY) {
                fields.push(word(name, format!("{from:?}..{to:?}")));
            }
        }
    }
    if declared.side == Side::Safe {
        fields.push(word("side", "safe"));
    }
    if declared.beyond == Beyond::Exact {
        fields.push(word("beyond", "exact"));
    }
}

fn number(name: String, value: f64) -> DescriptionField {
    DescriptionField {
        name,
        text: format!("{value:?}"),
        number: Some(value),
    }
}

fn word(name: &str, text: impl Into<String>) -> DescriptionField {
    DescriptionField {
        name: name.to_owned(),
        text: text.into(),
        number: None,
    }
}

#[cfg(test)]
mod tests {
    use super::changes;
    use frictiongen::System;

    /// Checks that each number of belts, stops and constant forces is a parameter.
    #[test]
    fn parameters_of_stops_and_constant_forces() {
        let read = |fields: &str| {
            let text = format!(
                "struct S {{ masses: {{ a: 1, b: 2 }}, springs: {{ base - a: 1, a - b: 1 }}, excitation: a, {fields} }}"
            );
            let system: System = text.parse().unwrap();
            system.scene().clone()
        };
        let old = read(
            "contacts: { pads: b - wall { speed: 0.1 } }, constant: { a: 1 },
            stops: { soft: a - b { gap: 1, stiffness: 2, damping: 3 }, hard: b - a { gap: 1, restitution: 0.5 } }",
        );
        let new = read(
            "contacts: { pads: b - wall { speed: 0.2 } }, constant: { a: 2, b: 3 },
            stops: { soft: b - a { gap: 2, stiffness: 3 }, hard: b - a { gap: 1, restitution: 0.6 } }",
        );
        let told = changes(&old, &new).into_iter().map(|change| {
            let text = |field: Option<super::DescriptionField>| {
                field.map_or("none".to_owned(), |field| field.text)
            };
            format!(
                "{}: {}, {}",
                change.name,
                text(change.old),
                text(change.new)
            )
        });
        assert_eq!(
            told.collect::<Vec<_>>(),
            [
                "speed of pads: 0.1, 0.2",
                "stop soft: a - b, b - a",
                "gap of soft: 1.0, 2.0",
                "stiffness of soft: 2.0, 3.0",
                "damping of soft: 3.0, none",
                "restitution of hard: 0.5, 0.6",
                "constant force on a: 1.0, 2.0",
                "constant force on b: none, 3.0",
            ]
        );
    }
}
