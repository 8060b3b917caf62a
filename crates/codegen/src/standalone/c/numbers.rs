//! Writes the file of numbers in C: the tables, the constants of the formulas, the checksums and the known answers.

use super::super::formulas::Formulas;
use super::super::known::{known_answers, numbers as known_numbers, rows, status as known_status};
use super::super::{
    Language, NumberFormat, RESPONSES, Source, about, checksum, columns, piece_numbers, wrapped,
};
use super::{status, units};
use crate::standalone::origin::c_text;
use crate::units::UnitConstants;
use frictiongen_kernel::Float;

/// Writes the C file of numbers, such as `frame_tables.h`, which `frame.c` includes. Returns `None` if β*_lim is not
/// stored as a product.
#[must_use]
pub fn c_tables<S: Float>(source: &Source<'_, S>, name: &str) -> Option<String> {
    let lines = about(source);
    let lines: Vec<String> = lines.iter().map(|line| c_text(line)).collect();
    let origin = source.origin.c_comment(source.scene);
    let about = format!(
        "/* Numbers of {name}.  Only its source file includes this file.\n * {} */\n",
        lines.join("\n * ")
    );
    Some(format!("{origin}{about}{}", without_head(source, name)?))
}

/// Writes the numbers, without the comments about origin and tables, for a file that also contains the header.
pub(super) fn without_head<S: Float>(source: &Source<'_, S>, name: &str) -> Option<String> {
    let formulas = Formulas::of(source, Language::C)?;
    let guard = format!("{}_NUMBERS_H", name.to_uppercase());
    let mut text = format!("#ifndef {guard}\n#define {guard}\n\n");
    text.push_str(&pieces(source, formulas.numbers));
    text.push_str(&formulas.constants.types());
    let reference = UnitConstants::of::<S>(source.scene).reference;
    text.push_str(&format!(
        "/* Divisor sqrt(k1/m1) of angular frequencies, in rad/s. */\n\
         static const {} REFERENCE = {};\n\n/* Constants of the formulas. */\n",
        formulas.numbers.real,
        formulas.numbers.write(reference),
    ));
    text.push_str(&formulas.constants.written());
    text.push_str(&known(source, formulas.numbers, name));
    text.push_str(&checksums(source, &formulas));
    text.push_str("\n#endif\n");
    Some(text)
}

/// Writes the pieces of the tables in C, and the buckets. A piece is an interval of r with its polynomials. The
/// buckets are equal intervals of r, by which the code finds a piece.
fn pieces<S: Float>(source: &Source<'_, S>, numbers: NumberFormat) -> String {
    let tables = source.tables;
    let NumberFormat { real, .. } = numbers;
    let write = |value: S| numbers.write(value.to_f64());
    let fields = columns(tables).iter();
    let fields =
        fields.map(|(name, about)| format!("    {real} {name}[{}]; /* {about} */\n", tables.terms));
    let fields: String = fields.collect();
    let mut rows = String::new();
    for piece in &tables.pieces {
        let of = piece.coefficients.iter().map(|of| {
            let list = numbers.list(of.iter().map(|coefficient| coefficient.to_f64()));
            format!("{{{list}}}")
        });
        let of: Vec<String> = of.collect();
        rows.push_str(&format!(
            "    {{{}, {},\n        {}}},\n",
            write(piece.from),
            write(piece.origin),
            of.join(",\n        ")
        ));
    }
    let responses = if tables.moves() {
        RESPONSES.map(|line| format!("\n * {line}")).concat()
    } else {
        String::new()
    };
    format!(
        "#define PIECES {count}u\n#define BUCKETS {buckets_count}u\n\n\
         /* An interval of r with its polynomials.  A polynomial is the sum of c[j] t^j, with t = r - origin.{responses}\n \
         * The generator chooses 4, 6, 8 or 10 coefficients by the accuracy, so that the table is small. */\n\
         struct piece {{\n    {real} from;   /* smallest r of the interval, which ends where the next piece begins */\n    \
         {real} origin; /* origin of t */\n{fields}}};\n\n\
         /* Index of the piece that contains the start of each bucket. */\n\
         static const {narrow} buckets[BUCKETS] = {{\n    {buckets}\n}};\n\n\
         static const struct piece pieces[PIECES] = {{\n{rows}}};\n\n",
        count = tables.pieces.len(),
        buckets_count = tables.index.buckets.len(),
        narrow = if tables.pieces.len() <= 256 {
            "unsigned char"
        } else {
            "unsigned short"
        },
        buckets = wrapped(&tables.index.buckets),
    )
}

/// Writes the known answers of the self-check in C.
fn known<S: Float>(source: &Source<'_, S>, numbers: NumberFormat, name: &str) -> String {
    let (tolerance, all) = known_answers(source);
    if all.is_empty() {
        return String::new();
    }
    let NumberFormat { real, .. } = numbers;
    let mut fields =
        format!("    {real} r;\n    {real} beta_lim;\n    {real} sliding; /* beta*_lim */\n");
    if source.tables.moves() {
        fields.push_str(&format!(
            "    {real} beta;\n    {real} amplitude; /* of the contact, or 0 if its motion is not continuous */\n    {real} phase;     /* of the contact, in the same way */\n    \
             enum {name}_status status;\n"
        ));
    }
    let forces = all.first().map_or(0, |known| known.stuck.len());
    if forces > 0 {
        fields.push_str(&format!(
            "    {real} stuck[{forces}][2]; /* re and im for each mass, then for the holding force */\n"
        ));
    }
    let lines = rows(numbers, &all).into_iter().zip(&all);
    let lines = lines.map(|([head, motion, stuck], known)| {
        let mut line = format!("    {{{head}");
        if !motion.is_empty() {
            line.push_str(&format!(
                ",\n        {motion}, {}",
                status(name, known_status(known))
            ));
        }
        if !stuck.is_empty() {
            line.push_str(&format!(",\n        {{{stuck}}}"));
        }
        line + "},\n"
    });
    format!(
        "\n#define KNOWN {count}u\n/* Largest allowed error of an answer: the accuracy of the table plus 64 rounding units, each {unit}.  They are a margin for\n \
         * the roundings of the arithmetic, of r and of beta. */\n\
         static const {real} TOLERANCE = {tolerance};\n\n\
         /* Answers of the exact formulas, computed with 32 digits.  At each r, a change of r by 32 rounding units changes an\n \
         * answer by at most 1/8 of the tolerance. */\n\
         struct known {{\n{fields}}};\n\nstatic const struct known known[KNOWN] = {{\n{lines}}};\n",
        count = all.len(),
        unit = if numbers.single { "2^-23" } else { "2^-52" },
        tolerance = numbers.write(tolerance),
        lines = lines.collect::<String>(),
    )
}

/// Writes the expected checksums of all numbers as constants in C.
fn checksums<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let numbers = formulas.numbers;
    let (tolerance, known) = known_answers(source);
    let mut sums = vec![
        (
            "BUCKETS",
            checksum::of_indices(&source.tables.index.buckets),
        ),
        (
            "PIECES",
            checksum::of_numbers(numbers, piece_numbers(source.tables)),
        ),
        (
            "CONSTANTS",
            checksum::of_numbers(numbers, formulas.constants.values()),
        ),
        ("UNITS", units::checksum_of_units(source)),
    ];
    if !known.is_empty() {
        let known = [tolerance]
            .into_iter()
            .chain(known.iter().flat_map(known_numbers));
        sums.push(("KNOWN", checksum::of_numbers(numbers, known)));
    }
    let sums = sums.into_iter();
    let sums = sums.map(|(of, sum)| format!("#define SUM_OF_{of} {sum:#010x}u\n"));
    format!(
        "\n/* Checksums of the numbers above and of those in the header, without `status`. */\n{}",
        sums.collect::<String>()
    )
}
