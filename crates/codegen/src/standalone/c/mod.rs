//! Writes tables as C99: a header, a file of numbers, and the code.

mod check;
mod contact;
mod header;
mod numbers;
mod stuck;
mod units;

pub use header::c_header;
pub use numbers::c_tables;

use super::formulas::Formulas;
use super::{Language, NumberFormat, Source, columns, first_step, quotient_about, snake};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;

/// Returns the default prefix of the C functions, which is the scene's name in snake case.
#[must_use]
pub fn c_name(scene: &Scene) -> String {
    snake(&scene.name)
}

/// Returns the name of the file with the numbers, derived from the name of the header: `frame.h` gives
/// `frame_tables.h`.
#[must_use]
pub fn c_tables_name(header: &str) -> String {
    format!("{}_tables.h", header.strip_suffix(".h").unwrap_or(header))
}

/// Returns the name of a constant in the status enumeration.
fn status(name: &str, of: &str) -> String {
    constant(name, &snake(of))
}

/// Returns the name of a constant in capital letters, with the prefix.
fn constant(name: &str, of: &str) -> String {
    format!("{}_{}", name.to_uppercase(), of.to_uppercase())
}

/// Returns two conditions in C: the first is true if r is outside the domain, the second if r or β is outside the
/// domain.
fn outside(name: &str) -> [String; 2] {
    let of = |of: &str| constant(name, of);
    let within = |value: &str| {
        let [least, most] = ["MIN", "MAX"].map(|end| of(&format!("{value}_{end}")));
        format!(
            "({least} <= {value_small}) && ({value_small} <= {most})",
            value_small = value.to_lowercase()
        )
    };
    let r = within("R");
    [format!("!({r})"), format!("!({r} && {})", within("BETA"))]
}

/// Writes a statement that returns `status` if a condition is true.
fn refusal(condition: &str, status: &str) -> String {
    format!("    if ({condition}) {{\n        return {status};\n    }}\n")
}

/// Writes the C source file. If `header` is `None`, this file contains the header and the numbers as well. The names
/// of its functions begin with `name`, as in the header.
///
/// Returns `None` if β*_lim is not stored as a product, because then only the exact formulas have the accuracy.
#[must_use]
pub fn c_source<S: Float>(
    source: &Source<'_, S>,
    name: &str,
    header: Option<&str>,
) -> Option<String> {
    let formulas = Formulas::of(source, Language::C)?;
    let mut text = match header {
        Some(header) => {
            let tables = c_tables_name(header);
            let origin = source.origin.c_comment(source.scene);
            format!("{origin}#include \"{header}\"\n#include \"{tables}\"\n\n")
        }
        None => format!(
            "{}{}\n",
            c_header(source, name),
            numbers::without_head(source, name)?
        ),
    };
    text.push_str(
        "#include <math.h>\n#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n\n\
         /* Compile with -ffp-contract=off, and with FLT_EVAL_METHOD 0.  Then results have the same bits as those of\n \
         * `--format rust`, if Rust links std and both use the same atan2. */\n\n",
    );
    text.push_str(&lookup(source, &formulas));
    text.push_str(&factors(&formulas));
    text.push_str(&limits(source, &formulas, name));
    text.push_str(&units(&formulas, name));
    if source.tables.moves() {
        text.push_str(&contact::source(source, &formulas, name));
    }
    if let Some(stuck) = &formulas.stuck {
        text.push_str(&stuck::source(&formulas, stuck, name));
    }
    text.push_str(&check::source(source, &formulas, name));
    Some(text)
}

/// Writes the function that finds a piece of the tables, and the function that evaluates a piece.
fn lookup<S: Float>(source: &Source<'_, S>, formulas: &Formulas) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let [low, density] = &formulas.index;
    let step = first_step(source.tables);
    let search = if step == 0 {
        "    const size_t index = buckets[bucket & (BUCKETS - 1u)];\n".to_owned()
    } else {
        format!(
            "    size_t index = buckets[bucket & (BUCKETS - 1u)];\n    \
             /* Binary search: at most {most} pieces begin in a bucket. */\n    \
             for (size_t step = {step}u; step > 0u; step >>= 1u) {{\n        \
             const size_t further = index + step;\n        \
             if ((further < PIECES) && (pieces[further].from <= r)) {{\n            index = further;\n        }}\n    }}\n",
            most = 2 * step - 1,
        )
    };
    format!(
        "/* Returns the piece that contains r.  The range of r has buckets of equal width, and r gives the bucket.  {density} is\n \
         * rounded down, so that R_MAX is in the last bucket.  The number of buckets is a power of two.  The mask BUCKETS - 1\n \
         * therefore keeps the index valid without a comparison. */\n\
         static const struct piece *found({real} r)\n{{\n    \
         const size_t bucket = (size_t)((r - {low}) * {density});\n{search}    return &pieces[index];\n}}\n\n\
         /* Returns the sum of c[j] t^j with t = r - origin, by Horner's rule in t^2 over pairs of terms. */\n\
         static {real} polynomial(const {real} c[{terms}], {real} t)\n{{\n{sum}}}\n\n",
        terms = source.tables.terms,
        sum = polynomial(real, source.tables.terms),
    )
}

/// Writes the C statements that evaluate a polynomial with an even number of terms.
fn polynomial(real: &str, terms: usize) -> String {
    let pair = |k: usize| format!("c[{k}] + (c[{}] * t)", k + 1);
    let last = 2 * (terms / 2).saturating_sub(1);
    if last == 0 {
        return format!("    return {};\n", pair(0));
    }
    let mut sum = format!(
        "    const {real} square = t * t;\n    {real} sum = {};\n",
        pair(last)
    );
    for k in (0..last / 2).rev() {
        sum.push_str(&format!("    sum = ({}) + (sum * square);\n", pair(2 * k)));
    }
    sum.push_str("    return sum;\n");
    sum
}

/// Writes the functions for the factors of products, if the formulas call them.
fn factors(formulas: &Formulas) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let all = [
        (
            "zero",
            format!(
                "/* Returns the factor (r - y)(r + y). */\n\
                 static inline {real} zero({real} r, struct zero y)\n{{\n    \
                 return ((r - y.at) - y.rest) * (r + y.at);\n}}\n\n"
            ),
        ),
        (
            "pair",
            format!(
                "/* Returns the factor of four zeros or poles.  r + y does not need `rest`, because its digits do not cancel. */\n\
                 static inline {real} pair({real} r, struct pair y)\n{{\n    \
                 const {real} beside = (((r - y.at) - y.rest) * (r + y.at)) + y.off;\n    \
                 return (beside * beside) + y.least;\n}}\n\n"
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
            "/* True if r equals the resonance.  Two comparisons replace ==, against which compilers warn. */\nstatic inline bool is_at({real} r, {real} own)\n{{\n    \
             return (r <= own) && (own <= r);\n}}\n\n"
        ));
    }
    text
}

/// Writes the functions for β_lim and β*_lim.
fn limits<S: Float>(source: &Source<'_, S>, formulas: &Formulas, name: &str) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let Formulas { sliding, .. } = formulas;
    let [r_outside, _] = outside(name);
    let column = columns(source.tables);
    let column = column.first().map_or("beta_lim", |(name, _)| *name);
    let quotient = quotient_about(sliding).replace('\n', "\n * ");
    // If β*_lim is constant, its expression does not contain r.
    let ignored = if sliding.contains("(r") {
        ""
    } else {
        "    (void)r;\n"
    };
    format!(
        "/* Returns beta*_lim = |V|/(mu |H|) for an r in the range.  V is the response of the contact to the load, and H its\n \
         * response to a force in the contact.  mu is the ratio of static to kinetic friction.{quotient} */\nstatic {real} sliding_limit({real} r)\n{{\n{ignored}    return {sliding};\n}}\n\n\
         enum {name}_status {name}_limits({real} r, {real} *continuous, {real} *sliding)\n{{\n{refusal}    \
         const struct piece *const piece = found(r);\n    \
         *continuous = polynomial(piece->{column}, r - piece->origin);\n    \
         *sliding = sliding_limit(r);\n    return {ok};\n}}\n",
        refusal = refusal(&r_outside, &status(name, "OutOfDomain")),
        ok = status(name, "Ok"),
    )
}

/// Writes the functions that convert between ratios and units.
fn units(formulas: &Formulas, name: &str) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    format!(
        "\n{real} {name}_frequency_ratio({real} omega)\n{{\n    return omega / REFERENCE;\n}}\n\n\
         {real} {name}_friction_ratio({real} friction, {real} load)\n{{\n    return friction / load;\n}}\n"
    )
}
