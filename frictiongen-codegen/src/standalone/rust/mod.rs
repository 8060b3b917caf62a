//! Writes tables as a Rust file without dependencies.

mod contact;
mod lacking;
mod stuck;

use super::stuck::Stuck;
use super::{Asked, Numbers, STATUSES, about, quotient, wrapped};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::Tables;

/// Writes the file, for crates with and without std. Returns `None` if β*_lim has no closed product form. Only the
/// exact formulas keep the accuracy then.
#[must_use]
pub fn rust_source<S: Float>(scene: &Scene, tables: &Tables<S>) -> Option<String> {
    let numbers = Numbers::of::<S>("");
    let real = if numbers.single { "f32" } else { "f64" };
    let asked = Asked::of(numbers, scene, tables);
    let root = format!("{real}::sqrt");
    let sliding = quotient(numbers, tables.sliding.as_ref()?, &root);
    let contact = tables
        .moves()
        .then(|| contact::source(real, &root, &asked, tables));
    let stuck = tables.held.as_ref().map(|held| {
        let stuck = Stuck::of(numbers, scene, held);
        stuck::source(real, &asked, &stuck)
    });
    let about = about(tables).join("\n//! ");
    Some(format!(
        "//! Emitted by frictiongen {version} for the scene {scene}.\n//!\n//! {about}\n//!\n\
         //! It builds with `core` alone.  Where std is linked its square root and arc tangent are taken.\n\
         #![allow(clippy::all, clippy::pedantic, dead_code, non_snake_case, unused_parens)]\n\n\
         {errors}\
         /// Both limits (β_lim, β*_lim) of β = {beta} at the frequency ratio r = ω√(m₁/k₁).  Below the first a motion exists in\n\
         /// which the contact slides all the time; from the second on a stuck state exists.\n///\n\
         /// # Errors\n/// [`Error::OutOfDomain`].\n\
         pub fn limits(r: {real}) -> Result<({real}, {real}), Error> {{\n    \
         if {outside} {{\n        return Err(Error::OutOfDomain);\n    }}\n    \
         let piece = found(r);\n    let continuous = polynomial(&piece.of[0], r - piece.origin);\n    \
         Ok((continuous, sliding_limit(r)))\n}}\n\n\
         /// β*_lim at an r in the range.\n\
         fn sliding_limit(r: {real}) -> {real} {{\n    let _ = r;\n    {real}::abs({sliding})\n}}\n{contact}{stuck}\n\
         /// (r − y)(r + y), y in two parts.\nfn zero(r: {real}, at: {real}, rest: {real}) -> {real} {{\n    ((r - at) - rest) * (r + at)\n}}\n\n\
         /// Of a pair of zeros x + iy beside the axis: off = x², least = 4x²y².\n\
         fn pair(r: {real}, at: {real}, rest: {real}, off: {real}, least: {real}) -> {real} {{\n    \
         let beside = ((r - at) - rest) * (r + at) + off;\n    beside * beside + least\n}}\n\n\
         {lacking}{lookup}",
        version = env!("CARGO_PKG_VERSION"),
        scene = scene.name,
        errors = errors(),
        beta = asked.beta,
        outside = asked.r_outside,
        contact = contact.unwrap_or_default(),
        stuck = stuck.unwrap_or_default(),
        lacking = lacking::source(numbers),
        lookup = lookup(numbers, real, tables),
    ))
}

/// Writes the error type. Its values have the numbers of the C status.
fn errors() -> String {
    let refused = STATUSES.iter().filter(|(of, ..)| *of != "Ok");
    let of =
        refused.map(|(of, number, meaning)| format!("    /// {meaning}.\n    {of} = {number},\n"));
    let of: String = of.collect();
    format!(
        "/// Why a function does not answer.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\n#[repr(i8)]\npub enum Error {{\n{of}}}\n\n"
    )
}

/// Writes the pieces of the table, the search for a piece, and its evaluation.
fn lookup<S: Float>(numbers: Numbers, real: &str, tables: &Tables<S>) -> String {
    let write = |value: S| numbers.write(value.to_f64());
    let index = &tables.index;
    let (functions, terms) = (tables.functions, tables.terms);
    let narrow = if tables.pieces.len() <= 256 {
        "u8"
    } else {
        "u16"
    };
    let mut pieces = String::new();
    for piece in &tables.pieces {
        let (from, origin) = (write(piece.from), write(piece.origin));
        let of = piece.coefficients.iter().map(|of| {
            let list = numbers.list(of.iter().map(|coefficient| coefficient.to_f64()));
            format!("[{list}]")
        });
        let of: Vec<String> = of.collect();
        let of = of.join(",\n            ");
        pieces.push_str(&format!(
            "    Piece {{\n        from: {from},\n        origin: {origin},\n        of: [\n            {of},\n        ],\n    }},\n"
        ));
    }
    format!(
        "struct Piece {{\n    from: {real},\n    origin: {real},\n    of: [[{real}; {terms}]; {functions}],\n}}\n\n\
         fn found(r: {real}) -> &'static Piece {{\n    \
         let bucket = ((r - {index_low}) * {density}) as usize;\n    \
         let mut index = BUCKETS[bucket & (BUCKETS.len() - 1)] as usize;\n    \
         let mut step = 1 << {halvings} >> 1;\n    while step > 0 {{\n        \
         let further = index + step;\n        \
         if further < PIECES.len() && PIECES[further].from <= r {{\n            index = further;\n        }}\n        \
         step >>= 1;\n    }}\n    &PIECES[index]\n}}\n\n\
         fn polynomial(of: &[{real}; {terms}], t: {real}) -> {real} {{\n    \
         let square = t * t;\n    let mut k = {terms} - 2;\n    let mut sum = of[k] + of[k + 1] * t;\n    \
         while k > 0 {{\n        k -= 2;\n        sum = (of[k] + of[k + 1] * t) + sum * square;\n    }}\n    sum\n}}\n\n\
         /// The piece in which each bucket begins.\nstatic BUCKETS: [{narrow}; {count}] = [\n    {buckets}\n];\n\n\
         static PIECES: [Piece; {pieces_count}] = [\n{pieces}];\n",
        count = index.buckets.len(),
        buckets = wrapped(&index.buckets),
        pieces_count = tables.pieces.len(),
        index_low = write(index.low),
        density = write(index.density),
        halvings = index.halvings,
    )
}
