//! Builds the responses while the contact is stuck, as expressions that C and Rust share.

use super::{Numbers, factor_product, quotient_over};
use frictiongen_kernel::Float;
use frictiongen_kernel::table::Root;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::{Held, HeldForm};

/// An expression in r.
pub(super) enum Expression {
    /// An expression with a real value.
    Real(String),
    /// An expression with a complex value.
    Complex(String),
}

/// A named function of r.
pub(super) struct Function {
    pub name: String,
    pub value: Expression,
}

/// The stuck responses of a scene as expressions.
pub(super) struct Stuck {
    /// Products over the poles that several responses share.
    pub poles: Vec<Function>,
    /// The response of each mass, by the name of the mass, and the force that holds the contact.
    pub masses: Vec<Function>,
    pub force: Expression,
    /// Frequency ratios of the undamped resonances.
    pub resonances: Vec<String>,
}

impl Stuck {
    /// Builds the expressions of a scene for one number format.
    pub fn of<S: Float>(numbers: Numbers, scene: &Scene, held: &Held<S>) -> Self {
        let sets = held.pole_sets();
        let poles = sets.iter().enumerate().filter_map(|(place, form)| {
            let value = match form {
                HeldForm::Undamped(product) if !product.denominator.is_empty() => {
                    Expression::Real(factor_product(numbers, &product.denominator))
                }
                HeldForm::Damped { denominator, .. } => {
                    Expression::Complex(root_product(numbers, denominator)?)
                }
                _ => return None,
            };
            let name = poles_name(place);
            Some(Function { name, value })
        });
        let value = |form: &HeldForm<S>| response(numbers, &sets, form);
        let named = scene.masses.iter().zip(&held.masses);
        Self {
            poles: poles.collect(),
            masses: named
                .map(|(mass, form)| Function {
                    name: mass.name.clone(),
                    value: value(form),
                })
                .collect(),
            force: value(&held.force),
            resonances: held
                .resonances
                .iter()
                .map(|own| numbers.write(own.to_f64()))
                .collect(),
        }
    }

    /// Returns whether an expression calls this operation.
    pub fn calls(&self, operation: &str) -> bool {
        let call = format!("{operation}(");
        let functions = self.poles.iter().chain(&self.masses);
        let values = functions.map(|function| &function.value);
        values.chain([&self.force]).any(|value| {
            let (Expression::Real(text) | Expression::Complex(text)) = value;
            text.contains(&call)
        })
    }
}

fn poles_name(place: usize) -> String {
    if place == 0 {
        "held_poles".to_owned()
    } else {
        format!("held_poles_{}", place + 1)
    }
}

fn response<S: Float>(numbers: Numbers, sets: &[&HeldForm<S>], form: &HeldForm<S>) -> Expression {
    let place = sets.iter().position(|set| set.shares_poles(form));
    let poles = format!("{}(r)", poles_name(place.unwrap_or_default()));
    match form {
        HeldForm::Fixed(amplitude) => Expression::Real(numbers.write(amplitude.to_f64())),
        HeldForm::Undamped(product) => {
            Expression::Real(quotient_over(numbers, product, &poles, ""))
        }
        HeldForm::Damped {
            gain,
            numerator,
            denominator,
        } => {
            let gain = numbers.write(gain.to_f64());
            let above = match root_product(numbers, numerator) {
                Some(product) => format!("scaled({product}, {gain})"),
                None => format!("real_number({gain})"),
            };
            Expression::Complex(if denominator.is_empty() {
                above
            } else {
                format!("times({above},\n        inverse({poles}))")
            })
        }
    }
}

/// Writes the product of the roots. Returns `None` if there are no roots.
fn root_product<S: Float>(numbers: Numbers, roots: &[Root<S>]) -> Option<String> {
    let write = |value: S| numbers.write(value.to_f64());
    let roots = roots.iter().map(|root| match *root {
        Root::Pair {
            at,
            rest,
            off,
            rate,
        } => {
            let (at, rest, off, rate) = (write(at), write(rest), write(off), write(rate));
            format!("pair_root(r, {at}, {rest}, {off}, {rate})")
        }
        Root::Real { rate } => format!("real_root(r, {})", write(rate)),
    });
    roots.reduce(|product, root| format!("times({product},\n        {root})"))
}
