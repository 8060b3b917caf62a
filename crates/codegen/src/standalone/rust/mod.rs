//! Writes tables as a Rust file without dependencies.

mod check;
mod contact;
mod lacking;
mod stuck;

use super::formulas::Formulas;
use super::{
    COLUMNS, CONTINUOUS_EQUATIONS, Language, LoadWords, NumberFormat, RESPONSES, STATUSES,
    STUCK_EQUATIONS, Source, about, columns, first_step, meaning, quotient_about, wrapped,
};
use crate::units::{UnitConstants, domain};
use frictiongen_kernel::Float;
use frictiongen_model::table::Tables;

/// Writes the Rust file, for crates with and without std. Returns `None` if β*_lim is not stored as a product, because
/// then only the exact formulas have the accuracy.
#[must_use]
pub fn rust_source<S: Float>(source: &Source<'_, S>) -> Option<String> {
    let formulas = Formulas::of(source, Language::Rust)?;
    let tables = source.tables;
    let words = LoadWords::of(source.scene);
    let mut text = source.origin.rust_comment(source.scene);
    text.push_str(&format!(
        "\n//! {title} of the scene `{name}`.\n//!\n//! {about}\n//!\n\
         //! The file needs only `core`.  If std is linked, the file uses the square root and the arc tangent of std.\n\
         //! Like frictiongen, it needs Rust {version} or newer.\n\
         #![allow(dead_code, reason = \"a program may call only some of the functions\")]\n\
         #![allow(non_snake_case, reason = \"functions contain the names of masses from the description\")]\n\n",
        version = env!("CARGO_PKG_RUST_VERSION"),
        name = source.scene.name,
        title = title(source),
        about = about(source).join("\n//! "),
    ));
    text.push_str(&errors(tables));
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

/// Returns the answers of the file, as the first words of its documentation.
fn title<S: Float>(source: &Source<'_, S>) -> &'static str {
    let tables = source.tables;
    match (tables.moves(), tables.held.is_some()) {
        (false, false) => "Limits",
        (true, false) => "Limits and motion of the contact",
        (false, true) => "Limits and stuck responses",
        (true, true) => "Limits, motion of the contact and stuck responses",
    }
}

/// Writes the error type. Its values have the numbers of the C status.
fn errors<S: Float>(tables: &Tables<S>) -> String {
    let refused = STATUSES.into_iter().filter(|(of, ..)| *of != "Ok");
    let of = refused.map(|status| {
        let ((of, number, _), meaning) = (status, meaning(tables, status));
        format!("    /// {meaning}.\n    {of} = {number},\n")
    });
    let of: String = of.collect();
    format!(
        "/// Reason why a function returns no value.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\n#[repr(i8)]\npub enum Error {{\n{of}}}\n\n"
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
        "/// Stiffness k₁ of the spring `{spring}`, in N/m if the description uses N/m.\n{digits}pub const K1: {real} = {};\n\
         /// Mass m₁ of `{mass}`, in kg if the description uses kg.\n{digits}pub const M1: {real} = {};\n\
         /// Natural frequencies in ascending order.  They are in Hz if masses are in kg and springs in N/m.\n{digits}\
         pub const NATURAL_FREQUENCIES_HZ: [{real}; {modes}] = [{}];\n\
         /// Frequency ratios `ω_i √(m₁/k₁)` of the undamped resonances, in ascending order.\n{digits}\
         pub const RESONANCES: [{real}; {modes}] = [{}];\n\
         /// Smallest r that the functions accept.\n{digits}pub const R_MIN: {real} = {};\n\
         /// Largest r that the functions accept.\n{digits}pub const R_MAX: {real} = {};\n",
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
            "/// Smallest β that the functions accept.\n{digits}pub const BETA_MIN: {real} = {};\n\
             /// Largest β that the functions accept.  The largest finite number means no upper bound in the description.\n{digits}pub const BETA_MAX: {real} = {};\n",
            write(beta.0),
            write(beta.1),
        ));
    }
    text.push_str(&format!(
        "\n/// Converts an angular frequency ω in rad/s to the frequency ratio r = ω√(m₁/k₁).\n\
         #[must_use]\npub const fn frequency_ratio(omega: {real}) -> {real} {{\n    omega / numbers::REFERENCE\n}}\n\n\
         /// Returns the friction ratio β = {beta} of a kinetic friction force F.  `load` is {load}, {what}.\n\
         #[must_use]\npub const fn friction_ratio(friction: {real}, load: {real}) -> {real} {{\n    friction / load\n}}\n\n",
        beta = words.beta,
        load = words.load,
        what = words.load_means,
    ));
    text
}

/// The attribute of an emitted constant that is written with all its digits.
const DIGITS: &str = "#[allow(clippy::approx_constant, clippy::unreadable_literal, clippy::excessive_precision, reason = \"the generator writes all digits\")]\n";

/// Writes the functions for β_lim and β*_lim.
fn limits(formulas: &Formulas, words: &LoadWords) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let Formulas { sliding, .. } = formulas;
    // If β*_lim is constant, its expression does not contain r.
    let r = if sliding.contains("(r") { "r" } else { "_" };
    let quotient = quotient_about(sliding).replace('\n', "\n/// ");
    format!(
        "/// Returns the limits `β_lim` and `β*_lim` of β = {beta} at the frequency ratio r = ω√(m₁/k₁).\n///\n\
         /// For β < `β_lim` ({CONTINUOUS_EQUATIONS}) a motion exists in which the contact slides all the time.\n\
         /// For β ≥ `β*_lim` ({STUCK_EQUATIONS}) a stuck state exists.\n\
         /// Both depend on μ, the ratio of static to kinetic friction: `stiction` in the description.\n///\n\
         /// # Errors\n/// [`Error::OutOfDomain`] if r is outside its range or not a number.\n\
         pub fn limits(r: {real}) -> Result<({real}, {real}), Error> {{\n    \
         if !(R_MIN..=R_MAX).contains(&r) {{\n        return Err(Error::OutOfDomain);\n    }}\n    \
         let piece = found(r);\n    let continuous = polynomial(&piece.{column}, r - piece.origin);\n    \
         Ok((continuous, sliding_limit(r)))\n}}\n\n\
         /// Returns `β*_lim = |V|/(μ|H|)` for an r in the range.  V is the response of the contact to the load, and H its\n\
         /// response to a force in the contact.  μ is the ratio of static to kinetic friction.{quotient}\n\
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
                "\n/// Returns the factor (r − y)(r + y).\nfn zero(r: {real}, y: Zero) -> {real} {{\n    \
                 ((r - y.at) - y.rest) * (r + y.at)\n}}\n"
            ),
        ),
        (
            "pair",
            format!(
                "\n/// Returns the factor of four zeros or poles.  r + y does not need `rest`, because its digits do not cancel.\nfn pair(r: {real}, y: Pair) -> {real} {{\n    \
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
            "\n/// Returns true if r equals the resonance.  Two comparisons replace `==`, against which Clippy warns.\nfn is_at(r: {real}, own: {real}) -> bool {{\n    r <= own && own <= r\n}}\n"
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
        format!("    /// {about}.\n    {name}: [{real}; {terms}],\n")
    });
    let fields: String = fields.collect();
    let step = first_step(tables);
    let (index, search) = if step == 0 {
        ("let index", String::new())
    } else {
        (
            "let mut index",
            format!(
                "    // Binary search: at most {most} pieces begin in a bucket.\n    let mut step = {step};\n    while step > 0 {{\n        \
                 let further = index + step;\n        \
                 if further < pieces.len() && pieces[further].from <= r {{\n            index = further;\n        }}\n        \
                 step >>= 1;\n    }}\n",
                most = 2 * step - 1,
            ),
        )
    };
    let responses = if tables.moves() {
        RESPONSES.map(|line| format!("\n/// {line}")).concat()
    } else {
        String::new()
    };
    format!(
        "/// An interval of r with its polynomials.  A polynomial is the sum of `c[j] t^j`, with t = r − origin.{responses}\n\
         /// The generator chooses 4, 6, 8 or 10 coefficients by the accuracy, so that the table is small.\n\
         struct Piece {{\n    /// Smallest r of the interval, which ends where the next piece begins.\n    from: {real},\n    \
         /// Origin of t.\n    \
         origin: {real},\n{fields}}}\n\n\
         /// Returns the piece that contains r.  The range of r has buckets of equal width, and r gives the bucket.  Their\n\
         /// density is rounded down, so that `R_MAX` is in the last bucket.  Their number is a power of two.  The mask\n\
         /// `buckets.len() - 1` therefore keeps the index valid without a comparison.\n\
         #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = \"r is in the range\")]\n\
         fn found(r: {real}) -> &'static Piece {{\n    \
         let (pieces, buckets) = (&numbers::PIECES, &numbers::BUCKETS);\n    \
         let bucket = ((r - {low}) * {density}) as usize;\n    \
         {index} = usize::from(buckets[bucket & (buckets.len() - 1)]);\n{search}    &pieces[index]\n}}\n\n\
         /// Returns the sum of `c[j] t^j`, by Horner's rule in t² over pairs of terms.\n\
         fn polynomial(c: &[{real}; {terms}], t: {real}) -> {real} {{\n{sum}}}\n\n",
        sum = polynomial(terms),
    )
}

/// Writes the Rust statements that evaluate a polynomial with an even number of terms.
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
        "/// All numbers of the tables, of the formulas and of the self-check.\n\
         #[allow(clippy::approx_constant, clippy::unreadable_literal, clippy::excessive_precision, reason = \"the generator writes all digits\")]\n\
         mod numbers {{\n    use super::{{{known}Piece{used}}};\n\n    \
         /// Divisor √(k₁/m₁) of angular frequencies, in rad/s.\n    \
         pub(super) const REFERENCE: {real} = {reference};\n{constants}{checked}\n    \
         /// Index of the piece that contains the start of each bucket.\n    \
         pub(super) static BUCKETS: [{narrow}; {count}] = [\n    {buckets}\n    ];\n\n    \
         /// Pieces in ascending order of r.\n    \
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
