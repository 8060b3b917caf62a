//! Writes `modelDescription.xml`, the description of an FMU.

use super::variables::{Variability, Variables};
use frictiongen::study::scene::Scene;

/// The units of an FMU's variables, with their exponents of kg, m and s.
const UNITS: [(&str, &str); 5] = [
    ("N", "kg=\"1\" m=\"1\" s=\"-2\""),
    ("m", "m=\"1\""),
    ("m/s", "m=\"1\" s=\"-1\""),
    ("J", "kg=\"1\" m=\"2\" s=\"-2\""),
    ("s", "s=\"1\""),
];

/// Returns the text of `modelDescription.xml`. `identifier` is the name of the FMU's binary without the extension.
/// `step` is the length of a step in s, in the precision of the binary.
pub fn write(
    scene: &Scene,
    variables: &Variables,
    (identifier, token, step): (&str, &str, f64),
) -> String {
    let convention = if is_structured(variables) {
        "structured"
    } else {
        "flat"
    };
    let units = UNITS.map(|(name, base)| {
        format!("    <Unit name=\"{name}\">\n      <BaseUnit {base}/>\n    </Unit>\n")
    });
    let (listed, outputs) = listed(variables);
    let structure = ["Output", "InitialUnknown"].map(|kind| {
        let lines = outputs.clone();
        lines
            .map(|reference| format!("    <{kind} valueReference=\"{reference}\"/>\n"))
            .collect::<String>()
    });
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription\n  fmiVersion=\"3.0\"\n  modelName=\"{name}\"\n  instantiationToken=\"{token}\"\n  \
         description=\"Stepper of a chain with friction contacts\"\n  generationTool=\"frictiongen {version}\"\n  \
         variableNamingConvention=\"{convention}\">\n  \
         <CoSimulation\n    modelIdentifier=\"{identifier}\"\n    fixedInternalStepSize=\"{step:?}\"\n    \
         canHandleVariableCommunicationStepSize=\"false\"\n    mightReturnEarlyFromDoStep=\"true\"\n    canGetAndSetFMUState=\"true\"\n    \
         canSerializeFMUState=\"true\"/>\n  \
         <UnitDefinitions>\n{units}  </UnitDefinitions>\n  \
         <LogCategories>\n    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>\n  </LogCategories>\n  \
         <DefaultExperiment startTime=\"0\" stepSize=\"{step:?}\"/>\n  \
         <ModelVariables>\n{listed}  </ModelVariables>\n  \
         <ModelStructure>\n{structure}  </ModelStructure>\n</fmiModelDescription>\n",
        name = escaped(&scene.name),
        version = env!("CARGO_PKG_VERSION"),
        units = units.concat(),
        structure = structure.concat(),
    )
}

/// Returns the text of all variables, and the value references of the outputs.
fn listed(variables: &Variables) -> (String, std::ops::Range<usize>) {
    let mut text = variable(
        "Float64",
        (0, "time", "time"),
        "causality=\"independent\" variability=\"continuous\" unit=\"s\"",
    );
    for (index, of) in variables.settable.iter().enumerate() {
        let causality = match of.kind {
            Variability::Input => "causality=\"input\" variability=\"continuous\"",
            Variability::Tunable => "causality=\"parameter\" variability=\"tunable\"",
            Variability::Initial => "causality=\"parameter\" variability=\"fixed\"",
        };
        let least = of
            .least
            .map_or(String::new(), |least| format!(" min=\"{least:?}\""));
        let unit = match of.unit {
            "" => String::new(),
            unit => format!(" unit=\"{unit}\""),
        };
        let more = format!("{causality} start=\"{:?}\"{unit}{least}", of.start);
        text.push_str(&variable(
            "Float64",
            (index + 1, &of.name, &of.about),
            &more,
        ));
    }
    let first = variables.settable.len() + 1;
    for (index, of) in variables.outputs.iter().enumerate() {
        let more = format!(
            "causality=\"output\" variability=\"continuous\" initial=\"calculated\" unit=\"{}\"",
            of.unit
        );
        text.push_str(&variable(
            "Float64",
            (first + index, &of.name, &of.about),
            &more,
        ));
    }
    let rest = first + variables.outputs.len();
    let discrete = discrete(variables);
    for (index, (kind, name, about)) in discrete.iter().enumerate() {
        let unit = if *kind == "Float64" {
            " unit=\"s\""
        } else {
            ""
        };
        let more =
            format!("causality=\"output\" variability=\"discrete\" initial=\"calculated\"{unit}");
        text.push_str(&variable(kind, (rest + index, name, about), &more));
    }
    (text, first..rest + discrete.len())
}

/// Returns type, name and meaning of the outputs that change at events: a flag and a direction of each contact, and three
/// numbers of all events.
fn discrete(variables: &Variables) -> Vec<(&'static str, String, String)> {
    let names = || variables.contacts.iter().map(|[name, _]| name);
    let sticks = names().map(|name| {
        let about = "true while the contact sticks";
        ("Boolean", format!("{name}.sticks"), about.to_owned())
    });
    let directions = names().map(|name| {
        let about = "0 while the contact sticks, otherwise the sign of its velocity";
        ("Int32", format!("{name}.direction"), about.to_owned())
    });
    let all = match variables.contacts.as_slice() {
        [[name, _]] => name,
        _ => "contacts",
    };
    let events = [
        (
            "UInt64",
            "events",
            "number of stops, break-aways and reversals in the last communication step",
        ),
        (
            "UInt64",
            "exceeded",
            "number of steps since the start that reached the bound on events",
        ),
        (
            "Float64",
            "last_event_time",
            "instant of the last stop, break-away or reversal; the start time before the first of them",
        ),
    ];
    let events =
        events.map(|(kind, name, about)| (kind, format!("{all}.{name}"), about.to_owned()));
    sticks.chain(directions).chain(events).collect()
}

fn variable(kind: &str, (reference, name, about): (usize, &str, &str), more: &str) -> String {
    format!(
        "    <{kind} name=\"{}\" valueReference=\"{reference}\" {more} description=\"{}\"/>\n",
        escaped(name),
        escaped(about)
    )
}

/// Returns true if every name has the form of the standard's structured names, `a.b` in ASCII.
fn is_structured(variables: &Variables) -> bool {
    let mut names = variables.outputs.iter().map(|output| &output.name);
    names.all(|name| name.is_ascii())
}

/// Escapes a text for an XML attribute. Names of a description contain no characters that XML reserves, but comments
/// may.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
