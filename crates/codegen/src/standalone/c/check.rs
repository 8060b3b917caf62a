//! Writes the self-check in C.

use super::super::formulas::Formulas;
use super::super::known::known_answers;
use super::super::{NumberFormat, Source, checksum, columns};
use super::{constant, status, units};
use crate::standalone::origin::c_text;
use frictiongen_kernel::Float;

/// Returns the values of the enumeration of faults, each with its name and meaning.
fn faults<S: Float>(source: &Source<'_, S>) -> Vec<(String, String)> {
    let mut faults = [
        ("NONE", "no fault"),
        ("BUCKETS", "wrong checksum of the buckets"),
        ("PIECES", "wrong checksum of the pieces"),
        (
            "CONSTANTS",
            "wrong checksum of the constants of the formulas",
        ),
        (
            "UNITS",
            "wrong checksum of the constants in the header, or of REFERENCE",
        ),
        ("KNOWN", "wrong checksum of TOLERANCE and the known answers"),
        (
            "RATIOS",
            "wrong answer of frequency_ratio or friction_ratio",
        ),
        ("LIMITS", "wrong answer of limits"),
    ]
    .map(|(name, about)| (name.to_owned(), about.to_owned()))
    .to_vec();
    if source.tables.moves() {
        faults.push(("CONTACT".to_owned(), "wrong answer of contact".to_owned()));
    }
    if source.tables.held.is_some() {
        let masses = source.scene.masses.iter().enumerate();
        // Names with the mass's name could collide, because two masses may have names that differ only in their case.
        faults.extend(masses.map(|(place, mass)| {
            let about = format!("wrong answer of stuck_{}", mass.name);
            (format!("STUCK_{}", place + 1), about)
        }));
        faults.push((
            "HOLDING_FORCE".to_owned(),
            "wrong answer of holding_force".to_owned(),
        ));
    }
    faults
}

fn fault(name: &str, of: &str) -> String {
    constant(name, &format!("FAULT_{of}"))
}

/// Writes the declaration of the self-check for the header file.
pub(super) fn declared<S: Float>(source: &Source<'_, S>, name: &str) -> String {
    let faults = faults(source);
    let values = faults.iter().enumerate().map(|(number, (of, about))| {
        format!(
            "    {} = {number}, /* {} */\n",
            fault(name, of),
            c_text(about)
        )
    });
    let values: String = values.collect();
    format!(
        "\n/* First fault that the self-check finds. */\nenum {name}_fault {{\n{values}}};\n\n\
         /* Compares the checksums of tables, constants and known answers, then the answers at some r with known answers.\n \
         * It needs only the stack, so that it can run at power-up.  Returns {none} if it finds no fault. */\n\
         enum {name}_fault {name}_self_check(void);\n",
        none = fault(name, "NONE"),
    )
}

/// Writes the self-check in C.
pub(super) fn source<S: Float>(source: &Source<'_, S>, formulas: &Formulas, name: &str) -> String {
    let (_, known) = known_answers(source);
    let mut text = sums(source, formulas);
    text.push_str(&near(formulas.numbers));
    let differs = |sum: &str, of: &str| {
        format!(
            "    if ({sum} != SUM_OF_{of}) {{\n        return {};\n    }}\n",
            fault(name, of)
        )
    };
    let NumberFormat { real, .. } = formulas.numbers;
    text.push_str(&format!(
        "/* The compiler may compute the checksums of constants and units at compile time.  These two then protect only the\n \
         * source text.  The known answers test the compiled code, to TOLERANCE. */\n\
         enum {name}_fault {name}_self_check(void)\n{{\n    \
         const {real} constants[] = {{\n{}    }};\n    const {real} units[] = {{\n{}    }};\n",
        formulas.constants.expressions(),
        units::unit_names(source, name)
            .into_iter()
            .map(|unit| format!("        {unit},\n"))
            .collect::<String>(),
    ));
    text.push_str(&differs("sum_of_buckets()", "BUCKETS"));
    text.push_str(&differs("sum_of_pieces()", "PIECES"));
    let sum = |of: &str| format!("sum_of({of}, sizeof {of} / sizeof {of}[0])");
    text.push_str(&differs(&sum("constants"), "CONSTANTS"));
    text.push_str(&differs(&sum("units"), "UNITS"));
    if !known.is_empty() {
        text.push_str(&differs("sum_of_known()", "KNOWN"));
    }
    text.push_str(&ratios(source, formulas.numbers, name));
    if !known.is_empty() {
        text.push_str("    for (size_t i = 0u; i < KNOWN; ++i) {\n");
        text.push_str(&answers(source, formulas.numbers, name));
        text.push_str("    }\n");
    }
    text.push_str(&format!("    return {};\n}}\n", fault(name, "NONE")));
    text
}

/// Writes the C statements that compare `frequency_ratio` with the resonances, and `friction_ratio` with a known
/// quotient.
fn ratios<S: Float>(source: &Source<'_, S>, numbers: NumberFormat, name: &str) -> String {
    let NumberFormat { real, .. } = numbers;
    let turn = numbers.write(2.0 * std::f64::consts::PI);
    let roundings = numbers.write(16.0 * S::EPSILON);
    let modes = 1..=source.scene.masses.len();
    let compared = modes.map(|mode| {
        let hertz = constant(name, &format!("NATURAL_FREQUENCY_{mode}_HZ"));
        let own = constant(name, &format!("RESONANCE_{mode}"));
        format!(
            "    if (!is_near({name}_frequency_ratio({turn} * {hertz}), {own}, roundings * {own})) {{\n        return {};\n    }}\n",
            fault(name, "RATIOS")
        )
    });
    let [three, two, half] = [3.0, 2.0, 1.5].map(|value| numbers.write(value));
    let friction = format!(
        "    if (!is_near({name}_friction_ratio({three}, {two}), {half}, roundings)) {{\n        return {};\n    }}\n",
        fault(name, "RATIOS")
    );
    format!(
        "    /* The roundings of constants, product and quotient add up to at most 4 rounding units.  16 leaves a margin. */\n    \
         const {real} roundings = {roundings};\n{}{friction}",
        compared.collect::<String>()
    )
}

/// Writes the C statements that compare the answers at one frequency ratio with the known answers.
fn answers<S: Float>(source: &Source<'_, S>, numbers: NumberFormat, name: &str) -> String {
    let NumberFormat { real, .. } = numbers;
    let letter = numbers.letter();
    let (zero, ok) = (numbers.write(0.0), status(name, "Ok"));
    let wrong = |condition: &str, of: &str| {
        format!(
            "        if ({condition}) {{\n            return {};\n        }}\n",
            fault(name, of)
        )
    };
    let mut text = format!(
        "        const struct known *const is = &known[i];\n        \
         {real} first = {zero};\n        {real} second = {zero};\n"
    );
    text.push_str(&wrong(
        &format!(
            "({name}_limits(is->r, &first, &second) != {ok})\n            \
             || !is_near(first, is->beta_lim, TOLERANCE * is->beta_lim)\n            \
             || !is_near(second, is->sliding, TOLERANCE * is->sliding)"
        ),
        "LIMITS",
    ));
    if source.tables.moves() {
        text.push_str(&format!(
            "        first = {zero};\n        second = {zero};\n"
        ));
        text.push_str(&wrong(
            &format!(
                "({name}_contact(is->r, is->beta, &first, &second) != is->status)\n            \
                 || !is_near(first, is->amplitude, TOLERANCE * is->amplitude)\n            \
                 || !is_near(second, is->phase, TOLERANCE)"
            ),
            "CONTACT",
        ));
    }
    if source.tables.held.is_some() {
        let masses = source.scene.masses.iter().enumerate();
        let masses = masses.map(|(place, mass)| {
            (
                format!("stuck_{}", mass.name),
                format!("STUCK_{}", place + 1),
            )
        });
        let force = ("holding_force".to_owned(), "HOLDING_FORCE".to_owned());
        for (place, (function, of)) in masses.chain([force]).enumerate() {
            let known = |part: usize| format!("is->stuck[{place}][{part}]");
            let (re, im) = (known(0), known(1));
            let size = format!("TOLERANCE * (fabs{letter}({re}) + fabs{letter}({im}))");
            text.push_str(&wrong(
                &format!(
                    "({name}_{function}(is->r, &first, &second) != {ok})\n            \
                     || !is_near(first, {re}, {size})\n            \
                     || !is_near(second, {im}, {size})"
                ),
                &of,
            ));
        }
    }
    text
}

/// Writes the C functions that compute the checksums of all numbers.
fn sums<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let NumberFormat { real, single, .. } = formulas.numbers;
    let (left, right) = (checksum::TURN, u32::BITS - checksum::TURN);
    let multiplier = checksum::MULTIPLIER;
    let words = if single {
        "    uint32_t bits;\n    (void)memcpy(&bits, &number, sizeof bits);\n    return mixed(sum, bits);\n"
    } else {
        "    uint64_t bits;\n    (void)memcpy(&bits, &number, sizeof bits);\n    \
         return mixed(mixed(sum, (uint32_t)(bits & 0xffffffffu)), (uint32_t)(bits >> 32u));\n"
    };
    let terms = source.tables.terms;
    let column = |of: &str, count: usize| {
        format!(
            "        for (size_t k = 0u; k < {count}u; ++k) {{\n            sum = with(sum, {of}[k]);\n        }}\n"
        )
    };
    let pieces = columns(source.tables).iter();
    let pieces: String = pieces
        .map(|(name, _)| column(&format!("piece->{name}"), terms))
        .collect();
    let (_, known) = known_answers(source);
    let mut known_sum = String::new();
    if let Some(first) = known.first() {
        let mut fields = vec!["r", "beta_lim", "sliding"];
        if first.motion.is_some() {
            fields.extend(["beta", "amplitude", "phase"]);
        }
        let fields = fields.iter();
        let fields: String = fields
            .map(|field| format!("        sum = with(sum, is->{field});\n"))
            .collect();
        let stuck = if first.stuck.is_empty() {
            String::new()
        } else {
            format!(
                "        for (size_t k = 0u; k < {}u; ++k) {{\n            sum = with(with(sum, is->stuck[k][0]), is->stuck[k][1]);\n        }}\n",
                first.stuck.len()
            )
        };
        known_sum = format!(
            "/* Without `status`: a wrong one makes the answers differ. */\nstatic uint32_t sum_of_known(void)\n{{\n    uint32_t sum = with(0u, TOLERANCE);\n    \
             for (size_t i = 0u; i < KNOWN; ++i) {{\n        const volatile struct known *const is = &known[i];\n{fields}{stuck}    }}\n    return sum;\n}}\n\n"
        );
    }
    format!(
        "\n/* Makes one step of a checksum.\n * {about} */\n\
         static uint32_t mixed(uint32_t sum, uint32_t word)\n{{\n    \
         return (((sum << {left}u) | (sum >> {right}u)) ^ word) * {multiplier:#010x}u;\n}}\n\n\
         static uint32_t with(uint32_t sum, {real} number)\n{{\n{words}}}\n\n\
         static uint32_t sum_of(const {real} numbers[], size_t count)\n{{\n    uint32_t sum = 0u;\n    \
         for (size_t i = 0u; i < count; ++i) {{\n        sum = with(sum, numbers[i]);\n    }}\n    return sum;\n}}\n\n\
         /* `volatile` makes the compiler read the memory.  It could otherwise compute the sum at compile time. */\n\
         static uint32_t sum_of_buckets(void)\n{{\n    \
         const volatile {narrow} *const entries = buckets;\n    uint32_t sum = 0u;\n    \
         for (size_t i = 0u; i < BUCKETS; ++i) {{\n        sum = mixed(sum, entries[i]);\n    }}\n    return sum;\n}}\n\n\
         static uint32_t sum_of_pieces(void)\n{{\n    uint32_t sum = 0u;\n    \
         for (size_t i = 0u; i < PIECES; ++i) {{\n        const volatile struct piece *const piece = &pieces[i];\n        \
         sum = with(with(sum, piece->from), piece->origin);\n{pieces}    }}\n    return sum;\n}}\n\n{known_sum}",
        about = checksum::ABOUT,
        narrow = if source.tables.pieces.len() <= 256 {
            "unsigned char"
        } else {
            "unsigned short"
        },
    )
}

/// Writes the C function that compares two numbers.
fn near(numbers: NumberFormat) -> String {
    let (NumberFormat { real, .. }, letter) = (numbers, numbers.letter());
    format!(
        "/* True if value and expected differ by at most error.  False if one of them is not a number. */\n\
         static bool is_near({real} value, {real} expected, {real} error)\n{{\n    \
         return fabs{letter}(value - expected) <= error;\n}}\n\n"
    )
}
