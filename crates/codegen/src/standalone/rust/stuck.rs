//! Writes the stuck responses in Rust.

use super::super::formulas::Formulas;
use super::super::stuck::{Expression, FunctionOfR, StuckExpressions};
use super::super::{LoadWords, NumberFormat, STUCK_EQUATIONS};

/// Writes the functions for the responses while the contact is stuck, and the complex operations that they call.
pub(super) fn source(formulas: &Formulas, stuck: &StuckExpressions, words: &LoadWords) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let mut source = String::new();
    let (amplitude, load, signal) = (words.amplitude, words.load, words.signal);
    let resonant = Formulas::on(&stuck.resonances).map_or_else(String::new, |on| {
        format!("    if {on} {{\n        return Err(Error::Unbounded);\n    }}\n")
    });
    let errors = if stuck.resonances.is_empty() {
        "/// # Errors\n/// [`Error::OutOfDomain`] if r is outside its range or not a number.\n"
    } else {
        "/// # Errors\n/// [`Error::OutOfDomain`] if r is outside its range or not a number.\n\
         /// [`Error::Unbounded`] if r is an undamped resonance of the chain with its contact stuck.\n"
    };
    let masses = stuck.masses.iter().map(|mass| {
        let about = format!(
            "/// Returns the complex amplitude (re, im) of `{}` while the contact is stuck ({STUCK_EQUATIONS}).\n\
             /// The absolute displacement ({amplitude}) is `Re((re + i im) e^(i tau))` under a {signal}, with `tau` = ωt.\n///\n{errors}",
            mass.name
        );
        (about, format!("stuck_{}", mass.name), &mass.value)
    });
    let force = (
        format!(
            "/// Returns the complex amplitude (re, im) of the force that keeps the contact stuck, divided by {load}\n\
             /// ({STUCK_EQUATIONS}).  It is positive if it acts against positive sliding.  Its modulus is `μ β*_lim`.\n///\n{errors}"
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
             if !(R_MIN..=R_MAX).contains(&r) {{\n        return Err(Error::OutOfDomain);\n    }}\n{resonant}    Ok({value})\n}}\n"
        ));
    }
    for FunctionOfR { name, value } in &stuck.poles {
        let (of, value) = match value {
            Expression::Real(value) => (real.to_owned(), value),
            Expression::Complex(value) => (format!("({real}, {real})"), value),
        };
        source.push_str(&format!(
            "\n/// Returns the product over the poles, which several responses share.\nfn {name}(r: {real}) -> {of} {{\n    {value}\n}}\n"
        ));
    }
    source + &operations(formulas)
}

/// Writes the complex operations that the file calls.
fn operations(formulas: &Formulas) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let number = format!("({real}, {real})");
    let all = [
        (
            "pair_root",
            format!(
                "\n/// Returns the factor (s − x)² + y² at s = ir.\nfn pair_root(r: {real}, y: RootPair) -> {number} {{\n    \
                 (y.off - ((r - y.at) - y.rest) * (r + y.at), y.rate * r)\n}}\n"
            ),
        ),
        (
            "real_root",
            format!(
                "\n/// Returns the factor s − x at s = ir, with rate = −x.\nconst fn real_root(r: {real}, rate: {real}) -> {number} {{\n    (rate, r)\n}}\n"
            ),
        ),
        (
            "real_number",
            format!("\nconst fn real_number(re: {real}) -> {number} {{\n    (re, 0.0)\n}}\n"),
        ),
        (
            "scaled",
            format!(
                "\nfn scaled(a: {number}, k: {real}) -> {number} {{\n    (a.0 * k, a.1 * k)\n}}\n"
            ),
        ),
        (
            "times",
            format!(
                "\nfn times(a: {number}, b: {number}) -> {number} {{\n    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)\n}}\n"
            ),
        ),
        (
            "inverse",
            format!(
                "\nfn inverse(a: {number}) -> {number} {{\n    \
                 // Divides by |re| + |im| first, so that no square overflows.\n    \
                 let over = 1.0 / (a.0.abs() + a.1.abs());\n    \
                 let (re, im) = (a.0 * over, a.1 * over);\n    let k = over / (re * re + im * im);\n    (re * k, -(im * k))\n}}\n"
            ),
        ),
    ];
    let called = all.into_iter().filter(|(name, _)| formulas.calls(name));
    called.map(|(_, text)| text).collect()
}
