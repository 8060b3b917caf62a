//! Writes products over zeros and poles as expressions in r. Each expression is valid in C and in Rust.

use super::{ConstantForm, FileConstants};
use frictiongen_kernel::Float;
use frictiongen_kernel::table::{Factor, Root};
use frictiongen_model::table::Product;

/// Writes a product of factors. The names of its constants begin with `name`. Returns `None` if there are no factors.
pub(super) fn factors<S: Float>(
    constants: &mut FileConstants,
    name: &str,
    factors: &[Factor<S>],
) -> Option<String> {
    let of = zeros_or_poles(name);
    let mut all = Vec::new();
    for (place, factor) in factors.iter().enumerate() {
        let name = format!("{name}_{}", place + 1);
        all.push(match *factor {
            Factor::Zero { at, rest } => {
                let values = [at, rest].map(Float::to_f64);
                format!(
                    "zero(r, {})",
                    constants.add(name, ConstantForm::Zero, &values, "")
                )
            }
            Factor::Pair {
                at,
                rest,
                off,
                least,
            } => {
                let values = [at, rest, off, least].map(Float::to_f64);
                format!(
                    "pair(r, {})",
                    constants.add(name, ConstantForm::Pair, &values, "")
                )
            }
            Factor::Real { off } => {
                let values = [off.to_f64()];
                let about = format!("x^2 in the factor r^2 + x^2 of the {of} s = +-x, at s = ir");
                let name = constants.add(name, ConstantForm::Number, &values, about);
                format!("((r * r) + {name})")
            }
        });
    }
    (!all.is_empty()).then(|| all.join("\n        * "))
}

/// Returns the word for the roots to which the constants of a product belong, from the name of these constants.
fn zeros_or_poles(name: &str) -> &'static str {
    if name.contains("POLE") {
        "poles"
    } else {
        "zeros"
    }
}

/// Explanation of a gain, for a comment in the file.
const GAIN: &str = "scale that makes the product exact at an r far from all zeros and poles";

/// Explanation of a response that does not depend on r, for a comment in the file.
pub(super) const FIXED: &str = "response, which does not depend on r";

/// Returns the explanation of a gain. `is_fixed` is true if the response has no zeros and no poles.
pub(super) fn gain_about(is_fixed: bool) -> &'static str {
    if is_fixed { FIXED } else { GAIN }
}

/// Writes the expression of a product over zeros, divided by a product over poles.
pub(super) fn quotient<S: Float>(
    constants: &mut FileConstants,
    name: &str,
    product: &Product<S>,
    root: &str,
) -> String {
    let poles = factors(constants, &format!("{name}_POLE"), &product.denominator);
    let poles = poles.map(grouped);
    quotient_over(constants, name, product, (poles, root))
}

/// Puts brackets around a product of several factors.
fn grouped(factors: String) -> String {
    if factors.contains("\n        * ") {
        format!("({factors})")
    } else {
        factors
    }
}

/// Writes the expression of a product over zeros, divided by the expression `poles`.
pub(super) fn quotient_over<S: Float>(
    constants: &mut FileConstants,
    name: &str,
    product: &Product<S>,
    (poles, root): (Option<String>, &str),
) -> String {
    let gain = product.gain.to_f64();
    let about = gain_about(poles.is_none() && product.numerator.is_empty());
    let gain = constants.add(format!("{name}_GAIN"), ConstantForm::Number, &[gain], about);
    let above = factors(constants, &format!("{name}_ZERO"), &product.numerator);
    let one = constants.numbers.write(1.0);
    let value = match (above, poles) {
        (None, None) => return gain,
        (Some(above), None) => above,
        (None, Some(poles)) => format!("{one} / {poles}"),
        (Some(above), Some(poles)) => format!("{}\n        / {poles}", grouped(above)),
    };
    format!(
        "{gain} * {}({value})",
        if product.squared { root } else { "" }
    )
}

/// Writes the product of complex roots. Returns `None` if there are no roots.
pub(super) fn roots<S: Float>(
    constants: &mut FileConstants,
    name: &str,
    roots: &[Root<S>],
) -> Option<String> {
    let of = zeros_or_poles(name);
    let mut all = Vec::new();
    for (place, root) in roots.iter().enumerate() {
        let name = format!("{name}_{}", place + 1);
        all.push(match *root {
            Root::Pair {
                at,
                rest,
                off,
                rate,
            } => {
                let values = [at, rest, off, rate].map(Float::to_f64);
                let name = constants.add(name, ConstantForm::RootPair, &values, "");
                format!("pair_root(r, {name})")
            }
            Root::Real { rate } => {
                let about = format!("-x in the factor s - x, one of the {of}");
                let name = constants.add(name, ConstantForm::Number, &[rate.to_f64()], about);
                format!("real_root(r, {name})")
            }
        });
    }
    all.into_iter()
        .reduce(|product, root| format!("times({product},\n        {root})"))
}
