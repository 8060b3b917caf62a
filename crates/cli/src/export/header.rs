//! Writes the C header of an exported crate.

use super::face::{ExportedFunction, ExportedItems, ExportedStruct, FieldType, Opaque, Passed};
use super::status::STATUSES;
use frictiongen::study::scene::{Provide, Scene};
use frictiongen_codegen::standalone::{UnitConstants, c_text, scene_hash};

/// Comment in the C header that states the rules for all functions.
const CONTRACT: &str = "Every function returns a status.  Unless it is 0, no result is written, and a stepper keeps its state.\n \
     * A null pointer gives a status.  Any other pointer must point to memory of its type, and no other thread may\n \
     * change that memory during the call.  Results and inputs may not overlap.  The memory of a stepper and of a saved\n \
     * state must be initialised before the first call: a static variable is, any other needs memset to 0.\n \
     * All functions are reentrant, allocate nothing and print nothing.";

/// Returns the text of the C header.
pub fn header(
    face: &ExportedItems,
    scene: &Scene,
    (prefix, origin, real): (&str, &str, &str),
) -> String {
    let upper = prefix.to_uppercase();
    let records: String = face
        .records
        .iter()
        .map(|of| record(of, prefix, real))
        .collect();
    let opaque: String = face.opaque.iter().map(|of| opaque(of, prefix)).collect();
    let functions: String = face
        .functions
        .iter()
        .map(|of| function(of, prefix, real))
        .collect();
    let statuses = STATUSES.iter().enumerate().map(|(index, status)| {
        let comma = if index + 1 < STATUSES.len() { "," } else { "" };
        format!(
            "    {upper}_{} = {}{comma} /* {} */\n",
            status.name, status.number, status.about
        )
    });
    let statuses: String = statuses.collect();
    let regimes = if scene.provides(&Provide::Limits) {
        let names = ["CONTINUOUS", "STICK_SLIP", "STUCK", "BISTABLE"]
            .into_iter()
            .enumerate();
        let names: Vec<String> = names
            .map(|(number, name)| format!("    {upper}_REGIME_{name} = {number}"))
            .collect();
        format!(
            "/* Numbers of regimes. */\nenum {prefix}_regimes {{\n{}\n}};\n\n",
            names.join(",\n")
        )
    } else {
        String::new()
    };
    format!(
        "{origin}#ifndef {upper}_H\n#define {upper}_H\n\n#include <stdint.h>\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n\
         /* {CONTRACT} */\n\n{constants}\n\
         /* Statuses.  A number keeps its meaning in all versions. */\nenum {prefix}_status {{\n{statuses}}};\n\n\
         /* Returns the meaning of a status as a text that lives as long as the program. */\n\
         const char *{prefix}_status_text(int32_t status);\n\n\
         {regimes}{records}{opaque}{functions}\
         #ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        constants = constants(scene, &upper),
    )
}

/// Returns the constants of the C header that convert between non-dimensional ratios and units.
fn constants(scene: &Scene, upper: &str) -> String {
    let units = UnitConstants::of::<f64>(scene);
    let mut text = format!(
        "/* Number of masses. */\n#define {upper}_MASSES {}\n\
         /* Hash of the scene: it changes with every field of the description. */\n\
         #define {upper}_SCENE_HASH UINT64_C(0x{})\n\
         /* k1, the stiffness of the spring {}: N/m, if springs are in N/m. */\n#define {upper}_K1 {:?}\n\
         /* m1, the mass {}: kg, if masses are in kg. */\n#define {upper}_M1 {:?}\n\
         /* sqrt(k1/m1), rad/s: r = omega over this number. */\n#define {upper}_REFERENCE {:?}\n",
        scene.masses.len(),
        scene_hash(scene),
        c_text(&units.spring),
        units.k1,
        c_text(&units.mass),
        units.m1,
        units.reference,
    );
    for (mode, hertz) in units.hertz.iter().enumerate() {
        text.push_str(&format!(
            "/* Natural frequency {number}, Hz. */\n#define {upper}_NATURAL_FREQUENCY_{number}_HZ {hertz:?}\n",
            number = mode + 1
        ));
    }
    text
}

fn kind(kind: &FieldType, prefix: &str, real: &str) -> String {
    match kind {
        FieldType::Real => real.to_owned(),
        FieldType::Int => "int32_t".to_owned(),
        FieldType::Count => "uint32_t".to_owned(),
        FieldType::Long => "uint64_t".to_owned(),
        FieldType::Record(name) => format!("struct {prefix}_{name}"),
        FieldType::Bytes(_) => "uint8_t".to_owned(),
    }
}

fn record(of: &ExportedStruct, prefix: &str, real: &str) -> String {
    let fields = of.fields.iter().map(|field| {
        let kind = kind(&field.kind, prefix, real);
        let array = match field.kind {
            FieldType::Bytes(length) => format!("[{length}]"),
            _ => String::new(),
        };
        format!(
            "    {kind} {}{array}; /* {} */\n",
            field.name,
            c_text(&field.about)
        )
    });
    format!(
        "/* {} */\nstruct {prefix}_{} {{\n{}}};\n\n",
        c_text(&of.about),
        of.name,
        fields.collect::<String>()
    )
}

fn opaque(of: &Opaque, prefix: &str) -> String {
    let size = format!("{}_{}_WORDS", prefix, of.name).to_uppercase();
    format!(
        "/* {} */\n#define {size} {}\nstruct {prefix}_{} {{\n    uint64_t opaque[{size}];\n}};\n\n",
        c_text(of.about),
        of.words,
        of.name
    )
}

fn function(of: &ExportedFunction, prefix: &str, real: &str) -> String {
    let parameters = of.parameters.iter().map(|(name, passed)| match passed {
        Passed::Value(of) => format!("{} {name}", kind(of, prefix, real)),
        Passed::Input(of) | Passed::Read(of) => format!("const struct {prefix}_{of} *{name}"),
        Passed::Output(of) => format!("{} *{name}", kind(of, prefix, real)),
        Passed::Fresh(of) | Passed::Changed(of) => format!("struct {prefix}_{of} *{name}"),
    });
    let parameters: Vec<String> = parameters.collect();
    let parameters = if parameters.is_empty() {
        "void".to_owned()
    } else {
        parameters.join(", ")
    };
    format!(
        "/* {} */\nint32_t {prefix}_{}({parameters});\n\n",
        c_text(&of.about),
        of.name
    )
}
