//! Writes the header of the C file.

use super::super::{
    CONTINUOUS_EQUATIONS, Language, LoadWords, NumberFormat, STATUSES, STUCK_EQUATIONS, Source,
    about, meaning, motion_in_contact, piece_numbers,
};
use super::{check, constant, status};
use crate::standalone::origin::c_text;
use crate::units::{UnitConstants, domain};
use frictiongen_kernel::Float;

/// Writes the C header with its declarations. The names of its functions and constants begin with `name`.
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
        .into_iter()
        .map(|own| {
            let ((of, number, _), meaning) = (own, meaning(source.tables, own));
            format!("    {} = {number}, /* {meaning} */\n", status(name, of))
        })
        .collect();
    let head = format!(
        "{origin}/* {about} */\n\
         /* The number in the include guard is a hash of tables and scene.  It detects two different headers of one name. */\n\
         #if defined({guard}) && ({guard} != {mark})\n\
         #error \"two different tables are both called {name}: compile one of them with --name\"\n#endif\n\
         #ifndef {guard}\n#define {guard} {mark}\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
        origin = origin.c_comment(scene),
    );
    let functions = format!(
        "/* Status of the functions of r and beta.  They write values only with {ok}. */\n\
         enum {name}_status {{\n{statuses}}};\n\n\
         /* Limits of beta = {beta} at the frequency ratio r = omega sqrt(m1/k1).\n \
         * For beta < continuous (beta_lim: {CONTINUOUS_EQUATIONS}) a motion exists in which the contact slides all the time.\n \
         * For beta >= sliding (beta*_lim: {STUCK_EQUATIONS}) a stuck state exists.\n \
         * Both depend on mu, the ratio of static to kinetic friction: `stiction` in the description. */\n\
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
        "Stiffness k1 of the spring {}, in N/m if the description uses N/m.",
        c_text(&units.spring)
    );
    define(Some(&about), "K1", write(units.k1));
    let about = format!(
        "Mass m1 of {}, in kg if the description uses kg.",
        c_text(&units.mass)
    );
    define(Some(&about), "M1", write(units.m1));
    let about = "Natural frequencies in ascending order.  They are in Hz if masses are in kg and springs in N/m.";
    for (mode, hertz) in units.hertz.iter().enumerate() {
        let of = format!("NATURAL_FREQUENCY_{}_HZ", mode + 1);
        define((mode == 0).then_some(about), &of, write(*hertz));
    }
    let about =
        "Frequency ratios omega_i sqrt(m1/k1) of the undamped resonances, in ascending order.";
    for (mode, own) in units.resonances.iter().enumerate() {
        define(
            (mode == 0).then_some(about),
            &format!("RESONANCE_{}", mode + 1),
            write(*own),
        );
    }
    define(
        Some("Smallest and largest r that the functions accept."),
        "R_MIN",
        write(r.0),
    );
    define(None, "R_MAX", write(r.1));
    if source.tables.moves() {
        define(
            Some(
                "Smallest and largest beta that the functions accept.  The largest finite number means no upper bound.",
            ),
            "BETA_MIN",
            write(beta.0),
        );
        define(None, "BETA_MAX", write(beta.1));
    }
    let NumberFormat { real, .. } = numbers;
    text.push_str(&format!(
        "\n/* Converts an angular frequency omega in rad/s to the frequency ratio r = omega sqrt(m1/k1). */\n\
         {real} {name}_frequency_ratio({real} omega);\n\n\
         /* Returns the friction ratio beta = {beta} of a kinetic friction force F.  `load` is {load}, {what}. */\n\
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
    let sign = c_text(&motion_in_contact(source.scene));
    let beside = if stuck_beside.is_empty() {
        String::new()
    } else {
        format!("\n * {stuck_beside}")
    };
    format!(
        "\n/* Amplitude ({amplitude}) and phase of the relative motion in the contact, if the contact slides all the time.\n \
         * The phase is the lag of its maximum behind the maximum of the excitation, in rad, in (-pi, pi].\n \
         * {sign}\n \
         * This motion exists for beta = {beta} below beta_lim.{beside} */\n\
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
        amplitude,
        signal,
        load,
        ..
    } = words;
    format!(
        "\n/* Complex amplitude of a mass while the contact is stuck ({STUCK_EQUATIONS}).\n \
         * Its absolute displacement ({amplitude}) is Re((re + i im) e^(i tau)) under a {signal}, with tau = omega t. */\n{masses}\n\
         /* Complex amplitude of the force that keeps the contact stuck, divided by {load} ({STUCK_EQUATIONS}).\n \
         * It is positive if it acts against positive sliding.  Its modulus is mu beta*_lim. */\n\
         enum {name}_status {name}_holding_force({real} r, {real} *re, {real} *im);\n"
    )
}
