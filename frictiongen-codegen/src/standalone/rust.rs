//! Tables as a Rust file without dependencies.

use super::stuck::{Expression, Function, Stuck};
use super::{Numbers, about, quotient, sticks_late, wrapped};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::Tables;

/// The file.  None where β*_lim has no form of its own: only the exact formulas keep the accuracy then.
#[must_use]
pub fn rust_source<S: Float>(scene: &Scene, tables: &Tables<S>) -> Option<String> {
    let numbers = Numbers::of::<S>("");
    let real = if numbers.single { "f32" } else { "f64" };
    let write = |value: S| numbers.write(value.to_f64());
    let (low, high) = tables.request.r;
    let ends = [low, high].map(|end| write(S::constant(end)));
    let [low, high] = ends;
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
    let root = format!("{real}::sqrt");
    let sliding = quotient(numbers, tables.sliding.as_ref()?, &root);
    let sticks_late = sticks_late(scene);
    let contact = tables.moves().then(|| {
        let excitation = tables.excitation.as_ref();
        let excitation = excitation.map_or_else(String::new, |product| {
            let product = quotient(numbers, product, &root);
            format!("    let excitation = {product};\n")
        });
        let (shares, displacement) = match functions {
            5 => (
                "    let [continuous, quadrature, displacement, direction, excitation] = piece.of.map(|of| polynomial(&of, t));\n",
                "displacement",
            ),
            4 => (
                "    let [continuous, quadrature, displacement, direction] = piece.of.map(|of| polynomial(&of, t));\n",
                "displacement",
            ),
            _ => (
                "    let [continuous, quadrature] = piece.of.map(|of| polynomial(&of, t));\n    \
                 let negative = excitation < 0.0;\n    \
                 let quadrature = if negative { -quadrature } else { quadrature };\n    \
                 let direction = if negative { PI } else { 0.0 };\n",
                "0.0",
            ),
        };
        let also = if sticks_late {
            ""
        } else {
            " && beta < sliding_limit(r)"
        };
        format!(
            "\n/// Why there is no continuous motion.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum NotContinuous {{\n    \
             /// r or β is out of the domain.\n    OutOfDomain,\n    /// The contact stops and slides in turn.\n    StickSlip,\n    \
             /// The contact never slides.\n    Stuck,\n}}\n\n\
             /// Amplitude (x̄ k₁/P; for base motion over Y) and phase (lag of the maximum behind the excitation's, rad) of the\n\
             /// contact's relative motion at the friction ratio β = F/P.\n///\n/// # Errors\n/// [`NotContinuous`] says which regime it is instead.\n\
             pub fn contact(r: {real}, beta: {real}) -> Result<({real}, {real}), NotContinuous> {{\n    \
             if !({low} <= r && r <= {high} && 0.0 <= beta) {{\n        return Err(NotContinuous::OutOfDomain);\n    }}\n    \
             let piece = found(r);\n    let t = r - piece.origin;\n\
             {excitation}{shares}    \
             if !(beta < continuous{also}) {{\n        \
             let slides = beta < sliding_limit(r);\n        \
             return Err(if slides {{ NotContinuous::StickSlip }} else {{ NotContinuous::Stuck }});\n    }}\n    \
             let share = beta / continuous;\n    let turned = share * quadrature;\n    \
             let product = (1.0 - turned) * (1.0 + turned);\n    \
             let in_phase = product.abs().sqrt();\n    \
             let amplitude = {real}::abs(excitation) * (in_phase - share * {displacement});\n    \
             let lag = {real}::atan2(-turned + 0.0, in_phase + 0.0) - direction;\n    \
             Ok((amplitude, wrapped(wrapped(lag))))\n}}\n\n\
             const PI: {real} = std::{real}::consts::PI;\n\n\
             /// An angle moved by a turn into (−π, π].\n\
             fn wrapped(angle: {real}) -> {real} {{\n    \
             let angle = if PI < angle {{ angle - (PI + PI) }} else {{ angle }};\n    \
             if -PI < angle {{ angle }} else {{ angle + (PI + PI) }}\n}}\n"
        )
    });
    let contact = contact.unwrap_or_default();
    let stuck = tables.held.as_ref();
    let stuck = stuck.map(|held| {
        let stuck = Stuck::of(numbers, scene, held);
        stuck_source(real, &format!("!({low} <= r && r <= {high})"), &stuck)
    });
    let stuck = stuck.unwrap_or_default();
    let about = about(tables).join("\n//! ");
    Some(format!(
        "//! Emitted by frictiongen {version} for the scene {scene}.\n//!\n//! {about}\n\
         #![allow(clippy::all, clippy::pedantic, dead_code, non_snake_case, unused_parens)]\n\n\
         /// Both limits (β_lim, β*_lim) at the frequency ratio r = ω√(m₁/k₁); none beyond the range.  Below the first the\n\
         /// contact slides all the time, from the second on it never does.\n\
         pub fn limits(r: {real}) -> Option<({real}, {real})> {{\n    \
         if !({low} <= r && r <= {high}) {{\n        return None;\n    }}\n    \
         let piece = found(r);\n    let continuous = polynomial(&piece.of[0], r - piece.origin);\n    \
         Some((continuous, sliding_limit(r)))\n}}\n\n\
         /// β*_lim at an r in the range.\n\
         fn sliding_limit(r: {real}) -> {real} {{\n    let _ = r;\n    {real}::abs({sliding})\n}}\n{contact}{stuck}\n\
         struct Piece {{\n    from: {real},\n    origin: {real},\n    of: [[{real}; {terms}]; {functions}],\n}}\n\n\
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
         /// (r − y)(r + y), y in two parts.\nfn zero(r: {real}, at: {real}, rest: {real}) -> {real} {{\n    ((r - at) - rest) * (r + at)\n}}\n\n\
         /// Of a pair of zeros x + iy beside the axis: off = x², least = 4x²y².\n\
         fn pair(r: {real}, at: {real}, rest: {real}, off: {real}, least: {real}) -> {real} {{\n    \
         let beside = ((r - at) - rest) * (r + at) + off;\n    beside * beside + least\n}}\n\n\
         /// The piece in which each bucket begins.\nstatic BUCKETS: [{narrow}; {count}] = [\n    {buckets}\n];\n\n\
         static PIECES: [Piece; {pieces_count}] = [\n{pieces}];\n",
        version = env!("CARGO_PKG_VERSION"),
        scene = scene.name,
        count = index.buckets.len(),
        buckets = wrapped(&index.buckets),
        pieces_count = tables.pieces.len(),
        index_low = write(index.low),
        density = write(index.density),
        halvings = index.halvings,
    ))
}

/// The responses while the contact is stuck, with the complex operations that they need.
fn stuck_source(real: &str, outside: &str, stuck: &Stuck) -> String {
    let mut source = String::new();
    let outside = stuck
        .resonances
        .iter()
        .fold(outside.to_owned(), |all, own| {
            format!("{all} || r == {own}")
        });
    let masses = stuck.masses.iter().map(|mass| {
        let about = format!(
            "/// While the contact is stuck: the complex amplitude of `{}`, whose displacement (x̄ k₁/P; for base motion over Y) is\n\
             /// Re((re + i·im)e^{{iτ}}).  None beyond the range, and on an undamped resonance of the chain with its contact stuck.\n",
            mass.name
        );
        (about, format!("stuck_{}", mass.name), &mass.value)
    });
    let force = (
        "/// The force over P that holds the contact, in the same way, positive against positive sliding.  Its modulus is μβ*_lim.\n".to_owned(),
        "holding_force".to_owned(),
        &stuck.force,
    );
    for (about, name, value) in masses.chain([force]) {
        let value = match value {
            Expression::Real(value) => format!("({value}, 0.0)"),
            Expression::Complex(value) => value.clone(),
        };
        source.push_str(&format!(
            "\n{about}pub fn {name}(r: {real}) -> Option<({real}, {real})> {{\n    \
             if {outside} {{\n        return None;\n    }}\n    Some({value})\n}}\n"
        ));
    }
    for Function { name, value } in &stuck.poles {
        let (of, value) = match value {
            Expression::Real(value) => (real.to_owned(), value),
            Expression::Complex(value) => (format!("({real}, {real})"), value),
        };
        source.push_str(&format!(
            "\n/// The poles of responses.\nfn {name}(r: {real}) -> {of} {{\n    {value}\n}}\n"
        ));
    }
    let number = format!("({real}, {real})");
    source.push_str(&format!(
        "\n/// (s − x)² + y² at s = ir: off = x², rate = −2x.\n\
         fn pair_root(r: {real}, at: {real}, rest: {real}, off: {real}, rate: {real}) -> {number} {{\n    \
         (off - ((r - at) - rest) * (r + at), rate * r)\n}}\n\n\
         /// s − x: rate = −x.\nfn real_root(r: {real}, rate: {real}) -> {number} {{\n    (rate, r)\n}}\n\n\
         fn real_number(re: {real}) -> {number} {{\n    (re, 0.0)\n}}\n\n\
         fn scaled(a: {number}, k: {real}) -> {number} {{\n    (a.0 * k, a.1 * k)\n}}\n\n\
         fn times(a: {number}, b: {number}) -> {number} {{\n    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)\n}}\n\n\
         fn inverse(a: {number}) -> {number} {{\n    let over = 1.0 / (a.0.abs() + a.1.abs());\n    \
         let (re, im) = (a.0 * over, a.1 * over);\n    let k = over / (re * re + im * im);\n    (re * k, -(im * k))\n}}\n"
    ));
    source
}
