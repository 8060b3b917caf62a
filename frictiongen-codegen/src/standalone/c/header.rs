//! Writes the header of the C file.

use super::super::units::UnitConstants;
use super::super::{
    Language, LoadWords, NumberFormat, STATUSES, Source, about, domain, piece_numbers,
};
use super::{check, constant, status};
use crate::standalone::origin::c_text;
use frictiongen_kernel::Float;

/// Writes the header with the declarations. Its functions and constants begin with `name`.
#[must_use]
pub fn c_header<S: Float>(source: &Source<'_, S>, name: &str) -> String {
    let Source { scene, origin, .. } = source;
    let numbers = NumberFormat::of::<S>(Language::C);
    let NumberFormat { real, .. } = numbers;
    let words = LoadWords::of(scene);
    let guard = format!("{}_TABLES_H", name.to_uppercase());
    let mark = mark(source);
    let lines = about(source);
    let lines: Vec<String> = lines.iter().map(|line| c_text(line)).collect();
    let about = lines.join("\n * ");
    let statuses: String = STATUSES
        .iter()
        .map(|(of, number, meaning)| {
            format!("    {} = {number}, /* {meaning} */\n", status(name, of))
        })
        .collect();
    let head = format!(
        "{origin}/* {about} */\n\
         #if defined({guard}) && ({guard} != {mark})\n\
         #error \"two different tables are both called {name}: compile one of them with --name\"\n#endif\n\
         #ifndef {guard}\n#define {guard} {mark}\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
        origin = origin.c_comment(scene),
    );
    let functions = format!(
        "/* What every function returns.  Unless it is {ok} no value is written. */\n\
         enum {name}_status {{\n{statuses}}};\n\n\
         /* Both limits of beta = {beta} at the frequency ratio r = omega sqrt(m1/k1).  Below `continuous` (beta_lim) a motion\n \
         * exists in which the contact slides all the time; from `sliding` (beta*_lim) on a stuck state exists. */\n\
         enum {name}_status {name}_limits({real} r, {real} *continuous, {real} *sliding);\n",
        ok = status(name, "Ok"),
        beta = words.beta,
    );
    let mut text = head;
    text.push_str(&units(source, name, &words));
    text.push_str(&functions);
    text.push_str(&contact(source, name, &words));
    text.push_str(&stuck(source, name, &words));
    text.push_str(&check::declared(source, name));
    text.push_str("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    text
}

/// Returns a number for the header's include guard, so that headers of different tables have different guards. The
/// number is the FNV-1a hash of all pieces of the tables, of the summary and of the scene.
fn mark<S: Float>(source: &Source<'_, S>) -> String {
    let numbers = piece_numbers(source.tables).into_iter();
    let bytes = numbers.flat_map(|number| number.to_bits().to_le_bytes());
    let about = about(source).join("\n") + &super::super::scene_hash(source.scene);
    let hash = bytes
        .chain(about.into_bytes())
        .fold(0x811c_9dc5_u32, |hash, byte| {
            (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
        });
    format!("{hash:#010x}")
}

/// Writes the constants that convert between ratios and units, the declared ranges, and the conversions.
fn units<S: Float>(source: &Source<'_, S>, name: &str, words: &LoadWords) -> String {
    let numbers = NumberFormat::of::<S>(Language::C);
    let units = UnitConstants::of::<S>(source.scene);
    let [r, beta] = domain(source.scene, source.tables);
    let mut text = String::new();
    let mut define = |about: Option<&str>, of: &str, value: String| {
        if let Some(about) = about {
            text.push_str(&format!("/* {about} */\n"));
        }
        text.push_str(&format!("#define {} {value}\n", constant(name, of)));
    };
    let write = |value: f64| numbers.write(value);
    let about = format!(
        "k1, the stiffness of the spring {}: N/m, if springs are in N/m.",
        c_text(&units.spring)
    );
    define(Some(&about), "K1", write(units.k1));
    let about = format!(
        "m1, the mass {}: kg, if masses are in kg.",
        c_text(&units.mass)
    );
    define(Some(&about), "M1", write(units.m1));
    let about = "Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.";
    for (mode, hertz) in units.hertz.iter().enumerate() {
        let of = format!("NATURAL_FREQUENCY_{}_HZ", mode + 1);
        define((mode == 0).then_some(about), &of, write(*hertz));
    }
    let about = "Frequency ratios r of the undamped resonances, omega_i sqrt(m1/k1).";
    for (mode, own) in units.resonances.iter().enumerate() {
        define(
            (mode == 0).then_some(about),
            &format!("RESONANCE_{}", mode + 1),
            write(*own),
        );
    }
    define(
        Some("The range of r in which the functions answer."),
        "R_MIN",
        write(r.0),
    );
    define(None, "R_MAX", write(r.1));
    if source.tables.moves() {
        define(
            Some("The range of beta in which the functions answer."),
            "BETA_MIN",
            write(beta.0),
        );
        define(None, "BETA_MAX", write(beta.1));
    }
    let NumberFormat { real, .. } = numbers;
    text.push_str(&format!(
        "\n/* An angular frequency, rad/s, as the frequency ratio r = omega sqrt(m1/k1). */\n\
         {real} {name}_frequency_ratio({real} omega);\n\n\
         /* The friction ratio beta = {beta} of a kinetic friction force F.  `load` is {load}, {what}. */\n\
         {real} {name}_friction_ratio({real} friction, {real} load);\n\n",
        beta = words.beta,
        load = words.load,
        what = words.load_means,
    ));
    text
}

fn contact<S: Float>(source: &Source<'_, S>, name: &str, words: &LoadWords) -> String {
    if !source.tables.moves() {
        return String::new();
    }
    let NumberFormat { real, .. } = NumberFormat::of::<S>(Language::C);
    let LoadWords {
        amplitude,
        beta,
        stuck_beside,
        ..
    } = words;
    let beside = if stuck_beside.is_empty() {
        String::new()
    } else {
        format!("\n * {stuck_beside}")
    };
    format!(
        "\n/* Amplitude ({amplitude}) and phase (lag of the maximum behind the excitation's, rad) of the contact's relative motion\n \
         * that slides all the time, at the friction ratio beta = {beta}.  It exists for beta < beta_lim.{beside} */\n\
         enum {name}_status {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase);\n"
    )
}

fn stuck<S: Float>(source: &Source<'_, S>, name: &str, words: &LoadWords) -> String {
    if source.tables.held.is_none() {
        return String::new();
    }
    let NumberFormat { real, .. } = NumberFormat::of::<S>(Language::C);
    let masses = source.scene.masses.iter();
    let masses = masses.map(|mass| {
        format!(
            "enum {name}_status {name}_stuck_{}({real} r, {real} *re, {real} *im);\n",
            mass.name
        )
    });
    let masses: String = masses.collect();
    let LoadWords {
        amplitude, load, ..
    } = words;
    format!(
        "\n/* While the contact is stuck: the complex amplitude of a mass, so that its displacement ({amplitude}) is\n \
         * Re((re + i im) e^(i tau)). */\n{masses}\n\
         /* The force over {load} that holds the contact, in the same way, positive against positive sliding.  Its modulus is mu\n \
         * beta*_lim. */\n\
         enum {name}_status {name}_holding_force({real} r, {real} *re, {real} *im);\n"
    )
}
