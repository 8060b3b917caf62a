//! Writes tables as C99. The templates `header.h.in` and `source.c.in` are format strings: a field has its name in
//! braces, and a brace of C is doubled.

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
        include_str!("header.h.in"),
        about = about,
        beta = asked.beta,
        contact = contact,
        guard = guard,
        mark = mark(tables),
        name = name,
        ok = status(name, "Ok"),
        real = real,
        scene = scene.name,
        statuses = statuses,
        stuck = stuck,
        version = env!("CARGO_PKG_VERSION"),
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
    let write = |value: S| numbers.write(value.to_f64());
    let index = &tables.index;
    let mut source = format!(
        include_str!("source.c.in"),
        buckets = wrapped(&index.buckets),
        buckets_count = index.buckets.len(),
        count = tables.pieces.len(),
        density = write(index.density),
        functions = tables.functions,
        halvings = index.halvings,
        include = include,
        index_low = write(index.low),
        last = 2 * (tables.terms / 2 - 1),
        letter = letter,
        name = name,
        narrow = if tables.pieces.len() <= 256 {
            "unsigned char"
        } else {
            "unsigned short"
        },
        ok = status(name, "Ok"),
        out_of_domain = status(name, "OutOfDomain"),
        outside = asked.r_outside,
        pieces = pieces(numbers, tables),
        real = real,
        sliding = sliding,
        terms = tables.terms,
    );
    source.extend(contact);
    source.extend(stuck);
    Some(source)
}

/// Writes the pieces of the table.
fn pieces<S: Float>(numbers: Numbers, tables: &Tables<S>) -> String {
    let write = |value: S| numbers.write(value.to_f64());
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
    pieces
}
