//! Writes tables as C99.

mod contact;
mod stuck;

use super::stuck::Stuck;
use super::{Asked, Numbers, STATUSES, about, quotient, snake, wrapped};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::Tables;

/// Suffix of a C `float` literal.
const FLOAT: &str = "f";

/// Returns the default prefix of the C functions, which is the scene's name in snake case.
#[must_use]
pub fn c_name(scene: &Scene) -> String {
    snake(&scene.name)
}

/// Returns a constant of the status enumeration.
fn status(name: &str, of: &str) -> String {
    format!("{}_{}", name.to_uppercase(), snake(of).to_uppercase())
}

/// Writes the header with the declarations. Its functions and constants begin with `name`.
#[must_use]
pub fn c_header<S: Float>(scene: &Scene, tables: &Tables<S>, name: &str) -> String {
    let upper = name.to_uppercase();
    let guard = format!("{upper}_TABLES_H");
    let numbers = Numbers::of::<S>(FLOAT);
    let real = if numbers.single { "float" } else { "double" };
    let asked = Asked::of(numbers, scene, tables);
    let about = about(tables).join("\n * ");
    let statuses: String = STATUSES
        .iter()
        .map(|(of, number, meaning)| {
            format!("    {} = {number}, /* {meaning} */\n", status(name, of))
        })
        .collect();
    let (contact, stuck) = (
        contact_declared(name, real, &asked, tables),
        stuck_declared(name, real, &asked, (scene, tables)),
    );
    format!(
        "/* Emitted by frictiongen {version} for the scene {scene}.\n * {about} */\n\
         #if defined({guard}) && {guard} != {mark}\n\
         #error \"two different tables are both called {name}: compile one of them with --name\"\n\
         #endif\n\
         #ifndef {guard}\n#define {guard} {mark}\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n\
         /* What every function returns.  Unless it is {ok} no value is written. */\n\
         enum {name}_status {{\n{statuses}}};\n\n\
         /* Both limits of beta = {beta} at the frequency ratio r = omega sqrt(m1/k1).  Below `continuous` (beta_lim) a motion\n \
         * exists in which the contact slides all the time; from `sliding` (beta*_lim) on a stuck state exists. */\n\
         enum {name}_status {name}_limits({real} r, {real} *continuous, {real} *sliding);\n\
         {contact}{stuck}\n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        version = env!("CARGO_PKG_VERSION"),
        scene = scene.name,
        ok = status(name, "Ok"),
        beta = asked.beta,
        mark = mark(tables),
    )
}

/// Returns a number for the header's guard that differs between different tables. It is the FNV-1a hash of all
/// coefficients, of the start and origin of each piece, and of the summary.
fn mark<S: Float>(tables: &Tables<S>) -> String {
    let pieces = tables.pieces.iter().flat_map(|piece| {
        let coefficients = piece.coefficients.iter().flatten();
        coefficients.chain([&piece.from, &piece.origin])
    });
    let bytes = pieces.flat_map(|number| number.to_f64().to_bits().to_le_bytes());
    let about = about(tables).join("\n").into_bytes();
    let hash = bytes.chain(about).fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    format!("{hash:#010x}")
}

fn contact_declared<S>(name: &str, real: &str, asked: &Asked, tables: &Tables<S>) -> String
where
    S: Float,
{
    if !tables.moves() {
        return String::new();
    }
    let Asked {
        amplitude, beta, ..
    } = asked;
    format!(
        "\n/* Amplitude ({amplitude}) and phase (lag of the maximum behind the excitation's, rad) of the contact's relative motion\n \
         * that slides all the time, at the friction ratio beta = {beta}.  It exists for beta < beta_lim; from beta*_lim on a\n \
         * stuck state exists beside it, if the static friction exceeds the kinetic. */\n\
         enum {name}_status {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase);\n"
    )
}

fn stuck_declared<S: Float>(
    name: &str,
    real: &str,
    asked: &Asked,
    (scene, tables): (&Scene, &Tables<S>),
) -> String {
    if tables.held.is_none() {
        return String::new();
    }
    let masses: String = scene
        .masses
        .iter()
        .map(|mass| {
            format!(
                "enum {name}_status {name}_stuck_{}({real} r, {real} *re, {real} *im);\n",
                mass.name
            )
        })
        .collect();
    let Asked {
        amplitude, load, ..
    } = asked;
    format!(
        "\n/* While the contact is stuck: the complex amplitude of a mass, so that its displacement ({amplitude}) is\n \
         * Re((re + i im) e^(i tau)). */\n{masses}\n\
         /* The force over {load} that holds the contact, in the same way, positive against positive sliding.  Its modulus is mu\n \
         * beta*_lim. */\n\
         enum {name}_status {name}_holding_force({real} r, {real} *re, {real} *im);\n"
    )
}

/// Writes the source file. Without a header name it contains the text of the header. Its functions begin with `name`,
/// as those of the header do.
///
/// Returns `None` if β*_lim has no closed product form. Only the exact formulas keep the accuracy then.
#[must_use]
pub fn c_source<S: Float>(
    scene: &Scene,
    tables: &Tables<S>,
    name: &str,
    header: Option<&str>,
) -> Option<String> {
    let numbers = Numbers::of::<S>(FLOAT);
    let (real, letter) = if numbers.single {
        ("float", "f")
    } else {
        ("double", "")
    };
    let include = match header {
        Some(header) => format!("#include \"{header}\"\n"),
        None => c_header(scene, tables, name),
    };
    let asked = Asked::of(numbers, scene, tables);
    let sliding = quotient(numbers, tables.sliding.as_ref()?, &format!("sqrt{letter}"));
    let contact = tables
        .moves()
        .then(|| contact::source(name, (real, letter), &asked, tables));
    let stuck = tables.held.as_ref().map(|held| {
        let stuck = Stuck::of(numbers, scene, held);
        stuck::source(name, (real, letter), &asked, &stuck)
    });
    Some(format!(
        "{include}\n#include <math.h>\n#include <stddef.h>\n\n\
         /* The digits are those of separate multiplications and additions: compile without contraction (-std=c99 or\n \
         * -ffp-contract=off) where they must agree with the Rust to the last one. */\n\n\
         {lookup}\
         /* (r - y)(r + y), y in two parts. */\n\
         static inline {real} zero({real} r, {real} at, {real} rest)\n{{\n    \
         return ((r - at) - rest) * (r + at);\n}}\n\n\
         /* Of a pair of zeros x + iy beside the axis: off = x^2, least = 4 x^2 y^2. */\n\
         static inline {real} pair({real} r, {real} at, {real} rest, {real} off, {real} least)\n{{\n    \
         const {real} beside = ((r - at) - rest) * (r + at) + off;\n    \
         return beside * beside + least;\n}}\n\n\
         /* beta*_lim at an r in the range. */\n\
         static {real} sliding_limit({real} r)\n{{\n    \
         (void)r;\n    (void)zero;\n    (void)pair;\n    return fabs{letter}({sliding});\n}}\n\n\
         enum {name}_status {name}_limits({real} r, {real} *continuous, {real} *sliding)\n{{\n    \
         if ({outside})\n        return {};\n    \
         const struct piece *piece = found(r);\n    \
         *continuous = polynomial(piece->c[0], r - piece->origin);\n    \
         *sliding = sliding_limit(r);\n    return {};\n}}\n{contact}{stuck}",
        status(name, "OutOfDomain"),
        status(name, "Ok"),
        lookup = lookup(numbers, real, tables),
        outside = asked.r_outside,
        contact = contact.unwrap_or_default(),
        stuck = stuck.unwrap_or_default(),
    ))
}

/// Writes the pieces of the table, the search for a piece, and its evaluation.
fn lookup<S: Float>(numbers: Numbers, real: &str, tables: &Tables<S>) -> String {
    let write = |value: S| numbers.write(value.to_f64());
    let index = &tables.index;
    let (functions, terms) = (tables.functions, tables.terms);
    let narrow = if tables.pieces.len() <= 256 {
        "unsigned char"
    } else {
        "unsigned short"
    };
    let mut pieces = String::new();
    for piece in &tables.pieces {
        let (from, origin) = (write(piece.from), write(piece.origin));
        let of = piece.coefficients.iter().map(|of| {
            let list = numbers.list(of.iter().map(|coefficient| coefficient.to_f64()));
            format!("{{{list}}}")
        });
        let of: Vec<String> = of.collect();
        pieces.push_str(&format!(
            "    {{{from}, {origin}, {{{}}}}},\n",
            of.join(",\n        ")
        ));
    }
    format!(
        "#define PIECES {count}\n#define BUCKETS {buckets_count}\n\n\
         struct piece {{\n    {real} from;      /* the smallest r of the piece */\n    \
         {real} origin;    /* from where r is counted */\n    \
         {real} c[{functions}][{terms}];\n}};\n\n\
         /* The piece in which each bucket begins. */\n\
         static const {narrow} buckets[BUCKETS] = {{\n    {buckets}\n}};\n\n\
         static const struct piece pieces[PIECES] = {{\n{pieces}}};\n\n\
         static const struct piece *found({real} r)\n{{\n    \
         const size_t bucket = (size_t)((r - {index_low}) * {density});\n    \
         size_t index = buckets[bucket & (BUCKETS - 1)];\n    \
         for (size_t step = (size_t)1 << {halvings} >> 1; step > 0; step >>= 1) {{\n        \
         const size_t further = index + step;\n        \
         if (further < PIECES && pieces[further].from <= r)\n            index = further;\n    }}\n    \
         return &pieces[index];\n}}\n\n\
         static {real} polynomial(const {real} *c, {real} t)\n{{\n    \
         const {real} square = t * t;\n    \
         {real} sum = c[{last}] + c[{last} + 1] * t;\n    \
         for (int k = {last} - 2; k >= 0; k -= 2)\n        \
         sum = (c[k] + c[k + 1] * t) + sum * square;\n    \
         return sum;\n}}\n\n",
        count = tables.pieces.len(),
        buckets_count = index.buckets.len(),
        buckets = wrapped(&index.buckets),
        index_low = write(index.low),
        density = write(index.density),
        halvings = index.halvings,
        last = 2 * (terms / 2 - 1),
    )
}
