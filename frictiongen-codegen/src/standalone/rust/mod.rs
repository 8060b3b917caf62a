//! Writes tables as a Rust file without dependencies.

mod check;
mod contact;
mod lacking;
mod stuck;

use super::formulas::Formulas;
use super::units::UnitConstants;
use super::{
    COLUMNS, Language, LoadWords, NumberFormat, RESPONSES, STATUSES, Source, about, columns,
    domain, first_step, wrapped,
};
use frictiongen_kernel::Float;
use frictiongen_model::table::Tables;

/// Writes the file, for crates with and without std. Returns `None` if β*_lim is not stored as a product, because then
/// only the exact formulas have the accuracy.
#[must_use]
pub fn rust_source<S: Float>(source: &Source<'_, S>) -> Option<String> {
    let formulas = Formulas::of(source, Language::Rust)?;
    let tables = source.tables;
    let words = LoadWords::of(source.scene);
    let mut text = source.origin.rust_comment(source.scene);
    text.push_str(&format!(
        "\n//! Limits of the scene `{name}`.\n//!\n//! {about}\n//!\n\
         //! It builds with `core` alone.  Where std is linked its square root and arc tangent are taken.\n\
         #![allow(dead_code, reason = \"a program may call some of the functions\")]\n\
         #![allow(non_snake_case, reason = \"masses have the names of the description\")]\n\n",
        name = source.scene.name,
        about = about(source).join("\n//! "),
    ));
    text.push_str(&errors());
    text.push_str(&units(source, &words));
    text.push_str(&limits(&formulas, &words));
    if tables.moves() {
        text.push_str(&contact::source(source, &formulas, &words));
    }
    if let Some(stuck) = &formulas.stuck {
        text.push_str(&stuck::source(&formulas, stuck, &words));
    }
    text.push_str(&factors(&formulas));
    if formulas.calls("sqrt") || tables.moves() {
        text.push_str(&lacking::source(formulas.numbers));
    }
    text.push_str(&lookup(&formulas, tables));
    text.push_str(&formulas.constants.types());
    text.push_str(&check::source(source, &formulas));
    text.push_str(&numbers(source, &formulas));
    text.push_str(&check::test());
    Some(text)
}

/// Writes the error type. Its values have the numbers of the C status.
fn errors() -> String {
    let refused = STATUSES.iter().filter(|(of, ..)| *of != "Ok");
    let of = refused.map(|(of, number, meaning)| {
        let meaning = meaning.replace(
            "beta_lim <= beta < beta*_lim",
            "`beta_lim <= beta < beta*_lim`",
        );
        format!("    /// {meaning}.\n    {of} = {number},\n")
    });
    let of: String = of.collect();
    format!(
        "/// Why a function does not answer.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\n#[repr(i8)]\npub enum Error {{\n{of}}}\n\n"
    )
}

/// Writes the constants that convert between ratios and units, the declared ranges, and the conversions.
fn units<S: Float>(source: &Source<'_, S>, words: &LoadWords) -> String {
    let numbers = NumberFormat::of::<S>(Language::Rust);
    let NumberFormat { real, .. } = numbers;
    let units = UnitConstants::of::<S>(source.scene);
    let [r, beta] = domain(source.scene, source.tables);
    let write = |value: f64| numbers.write(value);
    let modes = units.hertz.len();
    let digits = DIGITS;
    let mut text = format!(
        "/// k₁, the stiffness of the spring `{spring}`: N/m, if springs are in N/m.\n{digits}pub const K1: {real} = {};\n\
         /// m₁, the mass `{mass}`: kg, if masses are in kg.\n{digits}pub const M1: {real} = {};\n\
         /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.\n{digits}\
         pub const NATURAL_FREQUENCIES_HZ: [{real}; {modes}] = [{}];\n\
         /// Frequency ratios r of the undamped resonances, `ω_i √(m₁/k₁)`.\n{digits}\
         pub const RESONANCES: [{real}; {modes}] = [{}];\n\
         /// The smallest r at which the functions answer.\n{digits}pub const R_MIN: {real} = {};\n\
         /// The largest r at which the functions answer.\n{digits}pub const R_MAX: {real} = {};\n",
        write(units.k1),
        write(units.m1),
        numbers.list(units.hertz.iter().copied()),
        numbers.list(units.resonances.iter().copied()),
        write(r.0),
        write(r.1),
        spring = units.spring,
        mass = units.mass,
    );
    if source.tables.moves() {
        text.push_str(&format!(
            "/// The smallest β at which the functions answer.\n{digits}pub const BETA_MIN: {real} = {};\n\
             /// The largest β at which the functions answer.\n{digits}pub const BETA_MAX: {real} = {};\n",
            write(beta.0),
            write(beta.1),
        ));
    }
    text.push_str(&format!(
        "\n/// An angular frequency, rad/s, as the frequency ratio r = ω√(m₁/k₁).\n\
         #[must_use]\npub const fn frequency_ratio(omega: {real}) -> {real} {{\n    omega / numbers::REFERENCE\n}}\n\n\
         /// The friction ratio β = {beta} of a kinetic friction force F; `load` is {load}, {what}.\n\
         #[must_use]\npub const fn friction_ratio(friction: {real}, load: {real}) -> {real} {{\n    friction / load\n}}\n\n",
        beta = words.beta,
        load = words.load,
        what = words.load_means,
    ));
    text
}

/// The attribute of an emitted constant that is written with all its digits.
const DIGITS: &str = "#[allow(clippy::approx_constant, clippy::unreadable_literal, clippy::excessive_precision, reason = \"all digits, as they are printed\")]\n";

/// Writes the functions for β_lim and β*_lim.
fn limits(formulas: &Formulas, words: &LoadWords) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let Formulas { sliding, .. } = formulas;
    // If β*_lim is constant, its expression does not contain r.
    let r = if sliding.contains("(r") { "r" } else { "_" };
    format!(
        "/// Both limits (`β_lim`, `β*_lim`) of β = {beta} at the frequency ratio r = ω√(m₁/k₁).  Below the first a motion exists in\n\
         /// which the contact slides all the time; from the second on a stuck state exists.\n///\n\
         /// # Errors\n/// [`Error::OutOfDomain`].\n\
         pub fn limits(r: {real}) -> Result<({real}, {real}), Error> {{\n    \
         if !(R_MIN..=R_MAX).contains(&r) {{\n        return Err(Error::OutOfDomain);\n    }}\n    \
         let piece = found(r);\n    let continuous = polynomial(&piece.{column}, r - piece.origin);\n    \
         Ok((continuous, sliding_limit(r)))\n}}\n\n\
         /// `β*_lim` at an r in the range.\n\
         fn sliding_limit({r}: {real}) -> {real} {{\n    {sliding}\n}}\n",
        beta = words.beta,
        column = COLUMNS.first().map_or("beta_lim", |(name, _)| *name),
    )
}

/// Writes the functions that evaluate one factor of a product, if the formulas call them.
fn factors(formulas: &Formulas) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let all = [
        (
            "zero",
            format!(
                "\n/// (r − y)(r + y), y in two parts.\nfn zero(r: {real}, y: Zero) -> {real} {{\n    \
                 ((r - y.at) - y.rest) * (r + y.at)\n}}\n"
            ),
        ),
        (
            "pair",
            format!(
                "\n/// The factor of four zeros s = +-x +- iy at s = ir; `rest` matters in the first difference alone.\nfn pair(r: {real}, y: Pair) -> {real} {{\n    \
                 let beside = ((r - y.at) - y.rest) * (r + y.at) + y.off;\n    beside * beside + y.least\n}}\n"
            ),
        ),
    ];
    let mut text: String = all
        .into_iter()
        .filter(|(name, _)| formulas.calls(name))
        .map(|(_, text)| text)
        .collect();
    if formulas.compares() {
        text.push_str(&format!(
            "\n/// Exactly on a resonance.\nfn is_at(r: {real}, own: {real}) -> bool {{\n    r <= own && own <= r\n}}\n"
        ));
    }
    text.push('\n');
    text
}

/// Writes the function that finds a piece of the tables, and the function that evaluates a piece.
fn lookup<S: Float>(formulas: &Formulas, tables: &Tables<S>) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let terms = tables.terms;
    let [low, density] = &formulas.index;
    let fields = columns(tables).iter();
    let fields = fields.map(|(name, about)| {
        let about = about
            .replace("beta_lim U", "β_lim·U")
            .replace("beta_lim G", "β_lim·G");
        format!("    /// `{about}`\n    {name}: [{real}; {terms}],\n")
    });
    let fields: String = fields.collect();
    let step = first_step(tables);
    let (index, search) = if step == 0 {
        ("let index", String::new())
    } else {
        (
            "let mut index",
            format!(
                "    // Halves the step: one comparison each.\n    let mut step = {step};\n    while step > 0 {{\n        \
                 let further = index + step;\n        \
                 if further < pieces.len() && pieces[further].from <= r {{\n            index = further;\n        }}\n        \
                 step >>= 1;\n    }}\n"
            ),
        )
    };
    let responses = if tables.moves() {
        format!("  {RESPONSES}")
    } else {
        String::new()
    };
    format!(
        "/// A piece of the table.  Each function is the sum of `c[j] t^j`, with t = r − origin.{responses}\n\
         struct Piece {{\n    /// The smallest r of the piece.\n    from: {real},\n    /// From where r is counted.\n    origin: {real},\n{fields}}}\n\n\
         /// The piece that contains r.\n\
         #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = \"r is in the range\")]\n\
         fn found(r: {real}) -> &'static Piece {{\n    \
         let (pieces, buckets) = (&numbers::PIECES, &numbers::BUCKETS);\n    \
         let bucket = ((r - {low}) * {density}) as usize;\n    \
         {index} = usize::from(buckets[bucket & (buckets.len() - 1)]);\n{search}    &pieces[index]\n}}\n\n\
         /// The sum of `c[j] t^j`.\n\
         fn polynomial(c: &[{real}; {terms}], t: {real}) -> {real} {{\n{sum}}}\n\n",
        sum = polynomial(terms),
    )
}

/// Writes the statements of a polynomial of an even number of terms.
fn polynomial(terms: usize) -> String {
    let pair = |k: usize| format!("c[{k}] + c[{}] * t", k + 1);
    let last = 2 * (terms / 2).saturating_sub(1);
    if last == 0 {
        return format!("    {}\n", pair(0));
    }
    let mut sum = format!("    let square = t * t;\n    let sum = {};\n", pair(last));
    for k in (1..last / 2).rev() {
        sum.push_str(&format!(
            "    let sum = ({}) + sum * square;\n",
            pair(2 * k)
        ));
    }
    sum.push_str(&format!("    ({}) + sum * square\n", pair(0)));
    sum
}

/// Writes the module that contains all numbers.
fn numbers<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let tables = source.tables;
    let numbers = formulas.numbers;
    let NumberFormat { real, .. } = numbers;
    let write = |value: S| numbers.write(value.to_f64());
    let mut pieces = String::new();
    for piece in &tables.pieces {
        let named = columns(tables).iter().zip(&piece.coefficients);
        let named = named.map(|((name, _), of)| {
            let list = numbers.list(of.iter().map(|coefficient| coefficient.to_f64()));
            format!("            {name}: [{list}],\n")
        });
        pieces.push_str(&format!(
            "        Piece {{\n            from: {},\n            origin: {},\n{}        }},\n",
            write(piece.from),
            write(piece.origin),
            named.collect::<String>()
        ));
    }
    let narrow = if tables.pieces.len() <= 256 {
        "u8"
    } else {
        "u16"
    };
    let used = ["Zero", "Pair", "RootPair"].into_iter();
    let types = formulas.constants.types();
    let used = used.filter(|name| types.contains(&format!("struct {name} ")));
    let used: String = used.map(|name| format!(", {name}")).collect();
    let reference = UnitConstants::of::<S>(source.scene).reference;
    format!(
        "/// All numbers.\n\
         #[allow(clippy::approx_constant, clippy::unreadable_literal, clippy::excessive_precision, reason = \"all digits, as they are printed\")]\n\
         mod numbers {{\n    use super::{{{known}Piece{used}}};\n\n    \
         /// √(k₁/m₁), by which angular frequencies are divided: rad/s.\n    \
         pub(super) const REFERENCE: {real} = {reference};\n{constants}{checked}\n    \
         /// The piece in which each bucket begins.\n    \
         pub(super) static BUCKETS: [{narrow}; {count}] = [\n    {buckets}\n    ];\n\n    \
         pub(super) static PIECES: [Piece; {pieces_count}] = [\n{pieces}    ];\n}}\n",
        known = check::imported(source),
        constants = formulas.constants.written(),
        checked = check::numbers(source, formulas),
        reference = numbers.write(reference),
        count = tables.index.buckets.len(),
        buckets = wrapped(&tables.index.buckets),
        pieces_count = tables.pieces.len(),
    )
}
