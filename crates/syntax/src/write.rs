//! Writes a scene as a description.

use frictiongen_model::scene::{
    Accuracy, Beyond, CONTACT, ContactSides, Damping, DampingFrom, Declared, Excitation,
    FrictionLaw, Impact, JointLaw, Node, Precision, Provide, Proving, Range, Scene, Side,
    StepInput,
};
use std::fmt::{self, Display, Formatter, Write as _};

#[cfg(test)]
mod tests;

/// Returns the description of a scene, with one line for each field. Fields with their default value are left out.
/// Every number has the fewest digits that [`read_scene`](crate::read_scene) reads back as the same number. Reading
/// the text therefore returns an equal scene.
///
/// ```
/// use frictiongen_syntax::{Diagnostics, read_scene, written};
///
/// fn main() -> Result<(), Diagnostics> {
///     let scene = read_scene("struct Block { masses: { block: 1.0 + 1.0 }, springs: { base - block: 50.0 },
///         contact: block - wall, excitation: block }")?;
///     let text = written(&scene);
///     assert!(text.contains("masses: { block: 2.0 },"));
///     assert_eq!(read_scene(&text)?, scene);
///     Ok(())
/// }
/// ```
#[must_use]
pub fn written(scene: &Scene) -> String {
    let mut text = format!("struct {} {{\n", scene.name);
    for (name, value) in fields(scene) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    {name}: {value},");
    }
    text.push_str("}\n");
    text
}

/// Returns the names and values of the fields that differ from their defaults, in the usual order of a description.
fn fields(scene: &Scene) -> Vec<(&'static str, String)> {
    let node = |node: Node| scene.node_name(node);
    let pair = |from, to| format!("{} - {}", node(from), node(to));
    let sides = |contact: ContactSides| pair(contact.from, contact.to);
    let mut fields = vec![(
        "masses",
        braced(
            scene
                .masses
                .iter()
                .map(|mass| format!("{}: {:?}", mass.name, mass.value)),
        ),
    )];
    if !scene.springs.is_empty() {
        let springs = scene.springs.iter();
        let springs = springs
            .map(|spring| format!("{}: {:?}", pair(spring.from, spring.to), spring.stiffness));
        fields.push(("springs", braced(springs)));
    }
    let joints = &scene.joints;
    if is_unnamed(scene) {
        fields.push(("contact", sides(scene.contact)));
    } else {
        let contacts = scene.named_contacts().into_iter();
        let contacts = contacts.map(|contact| {
            format!(
                "{}: {}{}",
                contact.name,
                sides(contact.sides),
                LawText(contact.law)
            )
        });
        fields.push(("contacts", braced(contacts)));
    }
    if !joints.dampers.is_empty() {
        let dampers = joints.dampers.iter();
        let dampers = dampers
            .map(|damper| format!("{}: {:?}", pair(damper.from, damper.to), damper.coefficient));
        fields.push(("dampers", braced(dampers)));
    }
    if !joints.stops.is_empty() {
        let stops = joints.stops.iter();
        let stops = stops.map(|stop| {
            let law = stop.law;
            let impact = match law.impact {
                Impact::Spring {
                    stiffness,
                    damping: 0.0,
                } => {
                    format!("stiffness: {stiffness:?}")
                }
                Impact::Spring { stiffness, damping } => {
                    format!("stiffness: {stiffness:?}, damping: {damping:?}")
                }
                Impact::Restitution(ratio) => format!("restitution: {ratio:?}"),
            };
            let (name, sides, gap) = (&stop.name, sides(stop.sides), law.gap);
            format!("{name}: {sides} {{ gap: {gap:?}, {impact} }}")
        });
        fields.push(("stops", braced(stops)));
    }
    if !joints.constant.is_empty() {
        let constant = joints.constant.iter();
        let constant =
            constant.map(|load| format!("{}: {:?}", node(Node::Mass(load.mass)), load.force));
        fields.push(("constant", braced(constant)));
    }
    let excited = match scene.excitation {
        Excitation::Force(mass) => Node::Mass(mass),
        Excitation::Base => Node::Base,
    };
    fields.push(("excitation", node(excited).to_owned()));
    law(scene, &mut fields);
    declared(&scene.declared, &mut fields);
    emitted(scene, &mut fields);
    fields
}

/// Returns true if the field `contact` can describe the contact of the scene. Its name is then `contact`.
fn is_unnamed(scene: &Scene) -> bool {
    scene.joints.contacts.is_empty() && scene.contact_name == CONTACT
}

/// Adds the fields for damping, contact stiffness and friction to `fields`, in the notation of a description.
fn law(scene: &Scene, fields: &mut Vec<(&'static str, String)>) {
    match &scene.damping {
        Damping::None => {}
        Damping::Uniform(ratio) => fields.push(("damping", format!("modal({ratio:?})"))),
        Damping::Modal(ratios) => fields.push(("damping", format!("modal{ratios:?}"))),
        Damping::Rayleigh { mass, stiffness } => {
            fields.push(("damping", format!("rayleigh({mass:?}, {stiffness:?})")));
        }
    }
    if scene.damping_from == DampingFrom::Base {
        fields.push(("damping_from", "base".to_owned()));
    }
    // With the field `contacts`, each contact has its own stiffness and μ.
    if is_unnamed(scene) {
        if scene.stiction != 1.0 {
            fields.push(("stiction", format!("{:?}", scene.stiction)));
        }
        if let Some(stiffness) = scene.stiffness {
            fields.push(("stiffness", format!("{stiffness:?}")));
        }
    }
    if let FrictionLaw::Stribeck(points) = &scene.friction {
        let points = points
            .iter()
            .map(|[speed, level]| format!("{speed:?}: {level:?}"));
        fields.push(("friction", format!("stribeck({})", list(points))));
    }
}

/// Adds the fields that declare the accuracy of tables to `fields`, in the notation of a description.
fn declared(declared: &Declared, fields: &mut Vec<(&'static str, String)>) {
    if let Accuracy::Relative(error) = declared.accuracy {
        fields.push(("accuracy", format!("{error:?}")));
    }
    if let Some(bytes) = declared.budget {
        fields.push(("budget", format!("{bytes:?}")));
    }
    if let Some(Range { r, beta }) = declared.range {
        let any = (0.0, f64::INFINITY);
        let ends = [("r", r), ("beta", beta)].into_iter();
        let ends = ends.filter(|(_, ends)| *ends != any);
        let ends = ends.map(|(name, (low, high))| format!("{name}: {low:?}..{high:?}"));
        fields.push(("range", braced(ends)));
    }
    let words = [
        ("side", "safe", declared.side == Side::Safe),
        ("beyond", "exact", declared.beyond == Beyond::Exact),
        ("proof", "whole", declared.proof == Proving::Whole),
    ];
    let written = words.into_iter().filter(|(_, _, differs)| *differs);
    fields.extend(written.map(|(name, word, _)| (name, word.to_owned())));
}

/// Adds the fields about emitted code and about the stepper to `fields`, in the notation of a description.
fn emitted(scene: &Scene, fields: &mut Vec<(&'static str, String)>) {
    let name = |mass: &usize| scene.node_name(Node::Mass(*mass)).to_owned();
    if scene.precision == Precision::F32 {
        fields.push(("scalar", "f32".to_owned()));
    }
    if scene.provide != scene.default_provide() {
        let groups = scene.provide.iter().map(|group| match group {
            Provide::Limits => "limits".to_owned(),
            Provide::Motion(None) => "motion".to_owned(),
            Provide::Motion(Some(masses)) => format!("motion({})", list(masses.iter().map(name))),
            Provide::Stuck => "stuck".to_owned(),
            Provide::Orbit => "orbit".to_owned(),
            Provide::Simulation => "simulation".to_owned(),
            Provide::Stepper => "stepper".to_owned(),
            Provide::SelfCheck => "self_check".to_owned(),
        });
        fields.push(("provide", format!("[{}]", list(groups))));
    }
    let stepping = &scene.stepping;
    if let Some(step) = stepping.step {
        fields.push(("step", format!("{step:?}")));
    }
    if stepping.input == StepInput::Hold {
        fields.push(("input", "hold".to_owned()));
    }
    if !stepping.forces.is_empty() {
        fields.push(("force", braced(stepping.forces.iter().map(name))));
    }
}

/// The properties of one contact in the field `contacts`. `Display` writes the properties as the text between the
/// braces of the contact.
struct LawText(JointLaw);

impl Display for LawText {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let JointLaw {
            stiffness,
            stiction,
            share,
            speed,
        } = self.0;
        let unless = |default: f64, value: f64| (value != default).then_some(value);
        let fields = [
            ("stiffness", stiffness),
            ("stiction", unless(1.0, stiction)),
            ("share", unless(1.0, share)),
            ("speed", unless(0.0, speed)),
        ];
        let fields = fields.into_iter();
        let fields = fields.filter_map(|(name, value)| Some(format!("{name}: {:?}", value?)));
        let fields: Vec<String> = fields.collect();
        if fields.is_empty() {
            return Ok(());
        }
        write!(f, " {}", braced(fields.into_iter()))
    }
}

fn list(entries: impl Iterator<Item = String>) -> String {
    entries.collect::<Vec<_>>().join(", ")
}

fn braced(entries: impl Iterator<Item = String>) -> String {
    format!("{{ {} }}", list(entries))
}
