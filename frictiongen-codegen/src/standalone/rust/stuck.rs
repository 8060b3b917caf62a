//! Writes the stuck responses in Rust.

use super::super::Asked;
use super::super::stuck::{Expression, Function, Stuck};

/// Writes the responses while the contact is stuck, with the complex operations that they need.
pub(super) fn source(real: &str, asked: &Asked, stuck: &Stuck) -> String {
    let mut source = String::new();
    let (amplitude, load, outside) = (asked.amplitude, asked.load, &asked.r_outside);
    let on = stuck.resonances.iter().map(|own| format!("r == {own}"));
    let on: Vec<String> = on.collect();
    let resonant = if on.is_empty() {
        String::new()
    } else {
        format!(
            "    if {} {{\n        return Err(Error::Unbounded);\n    }}\n",
            on.join(" || ")
        )
    };
    let masses = stuck.masses.iter().map(|mass| {
        let about = format!(
            "/// While the contact is stuck: the complex amplitude of `{}`, whose displacement ({amplitude}) is\n\
             /// Re((re + i·im)e^{{iτ}}).\n///\n/// # Errors\n\
             /// [`Error::OutOfDomain`]; [`Error::Unbounded`] on an undamped resonance of the chain with its contact stuck.\n",
            mass.name
        );
        (about, format!("stuck_{}", mass.name), &mass.value)
    });
    let force = (
        format!(
            "/// The force over {load} that holds the contact, in the same way, positive against positive sliding.  Its modulus is\n\
             /// μβ*_lim.\n///\n/// # Errors\n/// The same.\n"
        ),
        "holding_force".to_owned(),
        &stuck.force,
    );
    for (about, name, value) in masses.chain([force]) {
        let value = match value {
            Expression::Real(value) => format!("({value}, 0.0)"),
            Expression::Complex(value) => value.clone(),
        };
        source.push_str(&format!(
            "\n{about}pub fn {name}(r: {real}) -> Result<({real}, {real}), Error> {{\n    \
             if {outside} {{\n        return Err(Error::OutOfDomain);\n    }}\n{resonant}    Ok({value})\n}}\n"
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
