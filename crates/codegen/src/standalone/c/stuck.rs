//! Writes the stuck responses in C.

use super::super::NumberFormat;
use super::super::formulas::Formulas;
use super::super::stuck::{Expression, FunctionOfR, StuckExpressions};
use super::{outside, refusal, status};

/// Writes the functions for the responses while the contact is stuck, and the complex operations that they call.
pub(super) fn source(formulas: &Formulas, stuck: &StuckExpressions, name: &str) -> String {
    let numbers = formulas.numbers;
    let NumberFormat { real, .. } = numbers;
    let [outside, _] = outside(name);
    let status = |of: &str| status(name, of);
    let zero = numbers.write(0.0);
    let mut functions = String::new();
    for FunctionOfR { name, value } in &stuck.poles {
        let (of, value) = match value {
            Expression::Real(value) => (real, value),
            Expression::Complex(value) => ("struct number", value),
        };
        functions.push_str(&format!(
            "\n/* Returns the product over the poles, which several responses share. */\nstatic {of} {name}({real} r)\n{{\n    return {value};\n}}\n"
        ));
    }
    let resonant = Formulas::on(&stuck.resonances);
    let resonant = resonant.map_or_else(String::new, |on| refusal(&on, &status("Unbounded")));
    let masses = stuck
        .masses
        .iter()
        .map(|mass| (format!("{name}_stuck_{}", mass.name), &mass.value));
    let returns = format!("enum {name}_status");
    for (name, value) in masses.chain([(format!("{name}_holding_force"), &stuck.force)]) {
        let answer = match value {
            Expression::Real(value) => format!("    *re = {value};\n    *im = {zero};\n"),
            Expression::Complex(value) => format!(
                "    const struct number value = {value};\n    *re = value.re;\n    *im = value.im;\n"
            ),
        };
        functions.push_str(&format!(
            "\n{returns} {name}({real} r, {real} *re, {real} *im)\n{{\n{outside}{resonant}{answer}    return {ok};\n}}\n",
            outside = refusal(&outside, &status("OutOfDomain")),
            ok = status("Ok"),
        ));
    }
    format!("{}{functions}", operations(formulas, stuck))
}

/// Writes only those complex operations that the file calls, because an unused one would cause a compiler warning.
fn operations(formulas: &Formulas, stuck: &StuckExpressions) -> String {
    let numbers = formulas.numbers;
    let (NumberFormat { real, .. }, letter) = (numbers, numbers.letter());
    let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
    let value = |re: &str, im: &str| {
        format!("    const struct number value = {{{re}, {im}}};\n    return value;\n")
    };
    let operations = [
        (
            "pair_root",
            format!("{real} r, struct root_pair y"),
            value("y.off - (((r - y.at) - y.rest) * (r + y.at))", "y.rate * r"),
        ),
        (
            "real_root",
            format!("{real} r, {real} rate"),
            value("rate", "r"),
        ),
        ("real_number", format!("{real} re"), value("re", &zero)),
        (
            "scaled",
            format!("struct number a, {real} k"),
            value("a.re * k", "a.im * k"),
        ),
        (
            "times",
            "struct number a, struct number b".to_owned(),
            value(
                "(a.re * b.re) - (a.im * b.im)",
                "(a.re * b.im) + (a.im * b.re)",
            ),
        ),
        (
            "inverse",
            "struct number a".to_owned(),
            format!(
                "    /* Divides by |re| + |im| first, so that no square overflows. */\n    \
                 const {real} over = {one} / (fabs{letter}(a.re) + fabs{letter}(a.im));\n    \
                 const {real} re = a.re * over;\n    const {real} im = a.im * over;\n    \
                 const {real} k = over / ((re * re) + (im * im));\n{}",
                value("re * k", "-(im * k)")
            ),
        ),
    ];
    let mut source = String::new();
    for (name, takes, body) in operations {
        if formulas.calls(name) {
            let about = match name {
                "pair_root" => "/* Returns the factor of two complex roots at s = ir. */\n",
                "real_root" => {
                    "/* Returns the factor s - x of a real root at s = ir, with rate = -x. */\n"
                }
                _ => "",
            };
            source.push_str(&format!(
                "\n{about}static inline struct number {name}({takes})\n{{\n{body}}}\n"
            ));
        }
    }
    if stuck.is_complex() {
        source = format!(
            "\n/* A complex number. */\nstruct number {{\n    {real} re;\n    {real} im;\n}};\n{source}"
        );
    }
    source
}
