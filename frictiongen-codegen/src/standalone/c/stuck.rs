//! Writes the stuck responses in C.

use super::super::Asked;
use super::super::stuck::{Expression, Function, Stuck};
use super::status;

/// Writes the responses while the contact is stuck, with the complex operations that they need.
pub(super) fn source(
    name: &str,
    (real, letter): (&str, &str),
    asked: &Asked,
    stuck: &Stuck,
) -> String {
    let numbers = asked.numbers;
    let outside = &asked.r_outside;
    let status = |of: &str| status(name, of);
    let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
    let mut functions = String::new();
    for Function { name, value } in &stuck.poles {
        let (of, value) = match value {
            Expression::Real(value) => (real, value),
            Expression::Complex(value) => ("struct number", value),
        };
        functions.push_str(&format!(
            "\n/* The poles of responses. */\nstatic {of} {name}({real} r)\n{{\n    return {value};\n}}\n"
        ));
    }
    let resonances: Vec<String> = stuck
        .resonances
        .iter()
        .map(|own| format!("r == {own}"))
        .collect();
    let resonant = if resonances.is_empty() {
        String::new()
    } else {
        let resonant = resonances.join(" || ");
        format!(
            "    if ({resonant})\n        return {};\n",
            status("Unbounded")
        )
    };
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
            "\n{returns} {name}({real} r, {real} *re, {real} *im)\n{{\n    \
             if ({outside})\n        return {};\n{resonant}{answer}    return {};\n}}\n",
            status("OutOfDomain"),
            status("Ok"),
        ));
    }
    format!(
        "{}{functions}",
        operations((real, letter), (&one, &zero), stuck)
    )
}

/// Writes the complex operations that the file calls. An unused operation would cause a compiler
/// warning.
fn operations((real, letter): (&str, &str), (one, zero): (&str, &str), stuck: &Stuck) -> String {
    let operations = [
        (
            "pair_root",
            format!("{real} r, {real} at, {real} rest, {real} off, {real} rate"),
            "    return (struct number){off - ((r - at) - rest) * (r + at), rate * r};\n"
                .to_owned(),
        ),
        (
            "real_root",
            format!("{real} r, {real} rate"),
            "    return (struct number){rate, r};\n".to_owned(),
        ),
        (
            "real_number",
            format!("{real} re"),
            format!("    return (struct number){{re, {zero}}};\n"),
        ),
        (
            "scaled",
            format!("struct number a, {real} k"),
            "    return (struct number){a.re * k, a.im * k};\n".to_owned(),
        ),
        (
            "times",
            "struct number a, struct number b".to_owned(),
            "    return (struct number){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};\n"
                .to_owned(),
        ),
        (
            "inverse",
            "struct number a".to_owned(),
            format!(
                "    const {real} over = {one} / (fabs{letter}(a.re) + fabs{letter}(a.im));\n    \
                 const {real} re = a.re * over, im = a.im * over;\n    \
                 const {real} k = over / (re * re + im * im);\n    \
                 return (struct number){{re * k, -(im * k)}};\n"
            ),
        ),
    ];
    let mut source = String::new();
    for (name, takes, body) in operations {
        if stuck.calls(name) {
            source.push_str(&format!(
                "\nstatic inline struct number {name}({takes})\n{{\n{body}}}\n"
            ));
        }
    }
    if !source.is_empty() {
        let about = "A pair of roots is (s - x)^2 + y^2 at s = ir: off = x^2, rate = -2x; a real one is s - x: rate = -x.";
        source = format!(
            "\n/* A complex number.  {about} */\nstruct number {{\n    {real} re, im;\n}};\n{source}"
        );
    }
    source
}
