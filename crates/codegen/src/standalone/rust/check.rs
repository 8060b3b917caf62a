//! Writes the self-check in Rust.

use super::super::formulas::Formulas;
use super::super::known::{known_answers, numbers as known_numbers, rows, status};
use super::super::units::unit_numbers;
use super::super::{Language, NumberFormat, Source, checksum, columns, piece_numbers};
use frictiongen_kernel::Float;

/// Returns the names of the types that the known answers use, as the beginning of an import list. Returns an empty text
/// without known answers.
pub(super) fn imported<S: Float>(source: &Source<'_, S>) -> &'static str {
    let (_, known) = known_answers(source);
    if known.is_empty() {
        ""
    } else if known.iter().any(|known| status(known) != "Ok") {
        "Error, Known, "
    } else {
        "Known, "
    }
}

/// Writes the constants of the self-check: the checksums of the tables' numbers, and the known answers.
pub(super) fn numbers<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let numbers = formulas.numbers;
    let NumberFormat { real, .. } = numbers;
    let (tolerance, known) = known_answers(source);
    let tables = source.tables;
    let mut sums = vec![
        ("BUCKETS", checksum::of_indices(&tables.index.buckets)),
        (
            "PIECES",
            checksum::of_numbers(numbers, piece_numbers(tables)),
        ),
        (
            "CONSTANTS",
            checksum::of_numbers(numbers, formulas.constants.values()),
        ),
        ("UNITS", checksum::of_numbers(numbers, unit_numbers(source))),
    ];
    let mut text = String::new();
    if !known.is_empty() {
        let all = [tolerance]
            .into_iter()
            .chain(known.iter().flat_map(known_numbers));
        sums.push(("KNOWN", checksum::of_numbers(numbers, all)));
        let lines = rows(numbers, &known).into_iter().zip(&known);
        let lines = lines.map(|([head, motion, stuck], known)| {
            let mut line = format!("        Known {{\n            head: [{head}],\n");
            if !motion.is_empty() {
                let status = match status(known) {
                    "Ok" => "None".to_owned(),
                    other => format!("Some(Error::{other})"),
                };
                line.push_str(&format!(
                    "            motion: [{motion}],\n            error: {status},\n"
                ));
            }
            if !stuck.is_empty() {
                line.push_str(&format!("            stuck: [{stuck}],\n"));
            }
            line + "        },\n"
        });
        text.push_str(&format!(
            "\n    /// Largest allowed error of an answer: the accuracy of the table plus 64 rounding units (`EPSILON`).  The 64 units\n    \
             /// are a margin for the roundings of the arithmetic, of r and of β.\n    \
             pub(super) const TOLERANCE: {real} = {tolerance};\n    \
             /// Answers of the exact formulas, computed with 32 digits.  At each r, a change of r by 32 rounding units changes\n    \
             /// an answer by at most 1/8 of the tolerance.\n    \
             pub(super) static KNOWN: [Known; {count}] = [\n{lines}    ];\n",
            tolerance = numbers.write(tolerance),
            count = known.len(),
            lines = lines.collect::<String>(),
        ));
    }
    let sums = sums.into_iter();
    let sums =
        sums.map(|(of, sum)| format!("    pub(super) const SUM_OF_{of}: u32 = {sum:#010x};\n"));
    format!(
        "{text}\n    // Checksums that the self-check expects.\n{}",
        sums.collect::<String>()
    )
}

/// Writes the test that runs the self-check.
pub(super) fn test() -> String {
    "\n#[cfg(test)]\nmod tests {\n    #[test]\n    fn self_check() {\n        \
     assert_eq!(super::self_check(), Ok(()));\n    }\n}\n"
        .to_owned()
}

/// Writes the self-check in Rust.
pub(super) fn source<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let (_, known) = known_answers(source);
    let mut text = faults(source, !known.is_empty());
    text.push_str(&sums(formulas.numbers));
    let mut calls = vec!["checked_numbers()?;"];
    let mut functions = checked_numbers(source, formulas, !known.is_empty());
    functions.push_str(&ratios(formulas.numbers));
    calls.push("checked_ratios()?;");
    if let Some(first) = known.first() {
        functions.push_str(LIMITS);
        calls.push("numbers::KNOWN.iter().try_for_each(checked_limits)?;");
        if first.motion.is_some() {
            functions.push_str(CONTACT);
            calls.push("numbers::KNOWN.iter().try_for_each(checked_contact)?;");
        }
        if !first.stuck.is_empty() {
            functions.push_str(&stuck(source));
            calls.push("numbers::KNOWN.iter().try_for_each(checked_stuck)?;");
        }
    }
    let last = calls.pop().unwrap_or_default();
    calls.push(last.trim_end_matches("?;"));
    text.push_str(&format!(
        "/// Compares the checksums of tables, constants and known answers, then the answers at some r with known answers.\n\
         /// It needs only the stack, so that it can run at power-up.  The checksums cover the tables in memory, and\n\
         /// a copy of each constant.  The compiler may copy constants into the code.  Only the known answers test these copies, to `TOLERANCE`.\n///\n\
         /// # Errors\n/// The first fault.\n\
         pub fn self_check() -> Result<(), Fault> {{\n    {}\n}}\n\n{functions}",
        calls.join("\n    ")
    ));
    text
}

/// Writes the types that the self-check in Rust uses.
fn faults<S: Float>(source: &Source<'_, S>, knows: bool) -> String {
    let NumberFormat { real, .. } = NumberFormat::of::<S>(Language::Rust);
    let moves = source.tables.moves();
    let stuck = source.tables.held.is_some();
    let mut text = "/// First fault that the self-check finds.\n\
         #[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum Fault {\n    \
         /// The checksum of the named numbers is wrong.\n    Numbers(&'static str),\n    \
         /// An answer of the named function is wrong.\n    Answer(&'static str),\n}\n\n"
        .to_owned();
    if !knows {
        return text;
    }
    let mut fields = format!("    /// r, `β_lim` and `β*_lim`.\n    head: [{real}; 3],\n");
    if moves {
        fields.push_str(&format!(
            "    /// β, amplitude and phase of the contact.  Amplitude and phase are 0 if its motion is not continuous.\n    motion: [{real}; 3],\n    \
             /// Expected error if the motion is not continuous.\n    error: Option<Error>,\n"
        ));
    }
    if stuck {
        let count = source.scene.masses.len() + 1;
        fields.push_str(&format!(
            "    /// Real and imaginary part for each mass, then for the holding force.\n    stuck: [[{real}; 2]; {count}],\n"
        ));
    }
    text.push_str(&format!(
        "/// Known answers at one r.\nstruct Known {{\n{fields}}}\n\n"
    ));
    text
}

/// Writes the function for checksums in Rust.
fn sums(numbers: NumberFormat) -> String {
    let NumberFormat { real, single, .. } = numbers;
    let (turn, multiplier) = (checksum::TURN, checksum::MULTIPLIER);
    let multiplier = format!("{:#06x}_{:04x}", multiplier >> 16, multiplier & 0xffff);
    let words = if single {
        "    mixed(sum, number.to_bits())\n"
    } else {
        "    let [a, b, c, d, e, f, g, h] = number.to_bits().to_le_bytes();\n    \
         mixed(mixed(sum, u32::from_le_bytes([a, b, c, d])), u32::from_le_bytes([e, f, g, h]))\n"
    };
    let names = if single {
        ""
    } else {
        "#[allow(clippy::many_single_char_names, reason = \"the bytes of a number\")]\n"
    };
    format!(
        "/// Makes one step of a checksum.\n/// {about}\n\
         const fn mixed(sum: u32, word: u32) -> u32 {{\n    (sum.rotate_left({turn}) ^ word).wrapping_mul({multiplier})\n}}\n\n\
         {names}const fn with(sum: u32, number: {real}) -> u32 {{\n{words}}}\n\n\
         fn sum_of<'n>(numbers: impl IntoIterator<Item = &'n {real}>) -> u32 {{\n    \
         numbers.into_iter().fold(0, |sum, number| with(sum, *number))\n}}\n\n\
         fn is_near(value: {real}, known: {real}, error: {real}) -> bool {{\n    (value - known).abs() <= error\n}}\n\n",
        about = checksum::ABOUT,
    )
}

/// Writes the Rust function that compares the checksums of all numbers with the expected checksums.
fn checked_numbers<S: Float>(source: &Source<'_, S>, formulas: &Formulas, knows: bool) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let tables = source.tables;
    let columns = columns(tables).iter();
    let columns = columns.map(|(name, _)| format!(".chain(&piece.{name})"));
    let columns: String = columns.collect();
    let beta = if tables.moves() {
        ", BETA_MIN, BETA_MAX"
    } else {
        ""
    };
    let known = if knows {
        let mut fields = "known.head.iter()".to_owned();
        if tables.moves() {
            fields.push_str(".chain(&known.motion)");
        }
        if tables.held.is_some() {
            fields.push_str(".chain(known.stuck.as_flattened())");
        }
        format!(
            "    let known = core::hint::black_box(&numbers::KNOWN).iter();\n    \
             let known = known.flat_map(|known| {fields});\n    \
             let known = core::iter::once(core::hint::black_box(&numbers::TOLERANCE)).chain(known);\n    \
             compared(sum_of(known), numbers::SUM_OF_KNOWN, \"KNOWN\")?;\n"
        )
    } else {
        String::new()
    };
    format!(
        "/// Compares the checksums.  `black_box` hides the numbers from the compiler, which could otherwise compute the sums at\n\
         /// compile time.\n\
         fn checked_numbers() -> Result<(), Fault> {{\n    \
         let buckets = core::hint::black_box(&numbers::BUCKETS).iter();\n    \
         let sum = buckets.fold(0, |sum, index| mixed(sum, u32::from(*index)));\n    \
         compared(sum, numbers::SUM_OF_BUCKETS, \"BUCKETS\")?;\n    \
         let pieces = core::hint::black_box(&numbers::PIECES).iter();\n    \
         let pieces = pieces.flat_map(|piece| [&piece.from, &piece.origin].into_iter(){columns});\n    \
         compared(sum_of(pieces), numbers::SUM_OF_PIECES, \"PIECES\")?;\n    \
         let constants: &[{real}] = &[\n{constants}    ];\n    \
         compared(sum_of(core::hint::black_box(constants)), numbers::SUM_OF_CONSTANTS, \"CONSTANTS\")?;\n\
         {known}    \
         let units = core::hint::black_box(&[K1, M1, numbers::REFERENCE]);\n    \
         let (hertz, resonances) = core::hint::black_box((&NATURAL_FREQUENCIES_HZ, &RESONANCES));\n    \
         let ranges = core::hint::black_box(&[R_MIN, R_MAX{beta}]);\n    \
         let units = units.iter().chain(hertz).chain(resonances).chain(ranges);\n    \
         compared(sum_of(units), numbers::SUM_OF_UNITS, \"UNITS\")\n}}\n\n\
         fn compared(sum: u32, known: u32, numbers: &'static str) -> Result<(), Fault> {{\n    \
         if sum == known {{ Ok(()) }} else {{ Err(Fault::Numbers(numbers)) }}\n}}\n\n",
        constants = formulas.constants.expressions(),
    )
}

/// Writes the Rust function that compares `frequency_ratio` with the resonances, and `friction_ratio` with a known
/// quotient.
fn ratios(numbers: NumberFormat) -> String {
    let NumberFormat { real, .. } = numbers;
    format!(
        "fn checked_ratios() -> Result<(), Fault> {{\n    \
         // The roundings of constants, product and quotient add up to at most 4 rounding units.  16 leaves a margin.\n    \
         let roundings = 16.0 * {real}::EPSILON;\n    \
         let both = NATURAL_FREQUENCIES_HZ.iter().zip(&RESONANCES);\n    \
         for (hertz, own) in both {{\n        \
         let r = frequency_ratio(core::{real}::consts::TAU * hertz);\n        \
         if !is_near(r, *own, roundings * own) {{\n            return Err(Fault::Answer(\"frequency_ratio\"));\n        }}\n    }}\n    if is_near(friction_ratio(3.0, 2.0), 1.5, roundings) {{ Ok(()) }} else {{ Err(Fault::Answer(\"friction_ratio\")) }}\n}}\n\n"
    )
}

/// Function of the Rust file that compares both limits, β_lim and β*_lim, with the known limits.
const LIMITS: &str = "fn checked_limits(known: &Known) -> Result<(), Fault> {\n    \
     let [r, continuous, sliding] = known.head;\n    \
     match limits(r) {\n        \
     Ok((own, held)) if is_near(own, continuous, numbers::TOLERANCE * continuous)\n            \
     && is_near(held, sliding, numbers::TOLERANCE * sliding) => Ok(()),\n        \
     _ => Err(Fault::Answer(\"limits\")),\n    }\n}\n\n";

/// Function of the Rust file that compares the contact's motion with the known motion.
const CONTACT: &str = "fn checked_contact(known: &Known) -> Result<(), Fault> {\n    \
     let ([r, ..], [beta, amplitude, phase]) = (known.head, known.motion);\n    \
     let is_right = match (contact(r, beta), known.error) {\n        \
     (Ok((size, lag)), None) => {\n            \
     is_near(size, amplitude, numbers::TOLERANCE * amplitude) && is_near(lag, phase, numbers::TOLERANCE)\n        }\n        \
     (Err(error), Some(known)) => error == known,\n        \
     _ => false,\n    };\n    \
     if is_right { Ok(()) } else { Err(Fault::Answer(\"contact\")) }\n}\n\n";

/// Writes the Rust function that compares the stuck responses with the known responses.
fn stuck<S: Float>(source: &Source<'_, S>) -> String {
    let masses = source.scene.masses.iter();
    let names = masses.map(|mass| format!("stuck_{}", mass.name));
    let names: Vec<String> = names.chain(["holding_force".to_owned()]).collect();
    let answers = names
        .iter()
        .map(|name| format!("        (\"{name}\", {name}(r)),\n"));
    format!(
        "fn checked_stuck(known: &Known) -> Result<(), Fault> {{\n    \
         let [r, ..] = known.head;\n    let answers = [\n{}    ];\n    \
         for ((function, answer), [re, im]) in answers.into_iter().zip(known.stuck) {{\n        \
         let error = numbers::TOLERANCE * (re.abs() + im.abs());\n        \
         match answer {{\n            \
         Ok((own, other)) if is_near(own, re, error) && is_near(other, im, error) => {{}}\n            \
         _ => return Err(Fault::Answer(function)),\n        }}\n    }}\n    Ok(())\n}}\n\n",
        answers.collect::<String>()
    )
}
