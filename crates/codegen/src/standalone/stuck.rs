//! Expressions for the responses while the contact is stuck. Each expression is valid in C and in Rust.

use super::constants::{ConstantForm, FileConstants};
use super::products::{FIXED, factors, gain_about, quotient_over, roots};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::{Held, HeldForm};

/// An expression in r of the written file.
pub(super) enum Expression {
    /// An expression with a real value.
    Real(String),
    /// An expression with a complex value.
    Complex(String),
}

/// A function of r in the written file: its name and its expression.
pub(super) struct FunctionOfR {
    pub name: String,
    pub value: Expression,
}

/// The stuck responses of a scene as expressions.
pub(super) struct StuckExpressions {
    /// Products over the poles that several responses share.
    pub poles: Vec<FunctionOfR>,
    /// The response of each mass, under the name of the mass, and the force that keeps the contact stuck.
    pub masses: Vec<FunctionOfR>,
    pub force: Expression,
    /// Expressions for the frequency ratios of the undamped resonances of the stuck chain.
    pub resonances: Vec<String>,
}

impl StuckExpressions {
    /// Creates the expressions of a scene, and adds their constants to `constants`.
    pub fn of<S: Float>(constants: &mut FileConstants, scene: &Scene, held: &Held<S>) -> Self {
        let sets = held.pole_sets();
        let mut poles = Vec::new();
        for (place, form) in sets.iter().enumerate() {
            let key = format!("HELD_POLE{}", numbered(place));
            let value = match form {
                HeldForm::Undamped(product) => {
                    factors(constants, &key, &product.denominator).map(Expression::Real)
                }
                HeldForm::Damped { denominator, .. } => {
                    roots(constants, &key, denominator).map(Expression::Complex)
                }
                HeldForm::Fixed(_) => None,
            };
            let name = poles_name(place);
            poles.extend(value.map(|value| FunctionOfR { name, value }));
        }
        let mut masses = Vec::new();
        for (place, (mass, form)) in scene.masses.iter().zip(&held.masses).enumerate() {
            // Keys with the mass's name could collide, because two masses may have names that differ only in their
            // case.
            let key = format!("STUCK_{}", place + 1);
            masses.push(FunctionOfR {
                name: mass.name.clone(),
                value: response(constants, &key, &sets, form),
            });
        }
        let force = response(constants, "HOLDING", &sets, &held.force);
        let resonances = held.resonances.iter().enumerate().map(|(place, own)| {
            let name = format!("HELD_RESONANCE_{}", place + 1);
            let about = "r of an undamped resonance of the chain with its contact stuck";
            constants.add(name, ConstantForm::Number, &[own.to_f64()], about)
        });
        Self {
            resonances: resonances.collect(),
            poles,
            masses,
            force,
        }
    }

    /// Returns the texts of all expressions.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        let functions = self.poles.iter().chain(&self.masses);
        let values = functions.map(|function| &function.value);
        values.chain([&self.force]).map(|value| {
            let (Expression::Real(text) | Expression::Complex(text)) = value;
            text.as_str()
        })
    }

    /// Returns true if some response is complex.
    pub fn is_complex(&self) -> bool {
        let values = self.masses.iter().map(|mass| &mass.value);
        values
            .chain([&self.force])
            .any(|value| matches!(value, Expression::Complex(_)))
    }
}

fn numbered(place: usize) -> String {
    if place == 0 {
        String::new()
    } else {
        format!("_SET_{}", place + 1)
    }
}

fn poles_name(place: usize) -> String {
    if place == 0 {
        "held_poles".to_owned()
    } else {
        format!("held_poles_{}", place + 1)
    }
}

fn response<S: Float>(
    constants: &mut FileConstants,
    key: &str,
    sets: &[&HeldForm<S>],
    form: &HeldForm<S>,
) -> Expression {
    let place = sets.iter().position(|set| set.shares_poles(form));
    let poles = format!("{}(r)", poles_name(place.unwrap_or_default()));
    match form {
        HeldForm::Fixed(amplitude) => {
            let amplitude = [amplitude.to_f64()];
            Expression::Real(constants.add(key, ConstantForm::Number, &amplitude, FIXED))
        }
        HeldForm::Undamped(product) => {
            let poles = (!product.denominator.is_empty()).then_some(poles);
            Expression::Real(quotient_over(constants, key, product, (poles, "")))
        }
        HeldForm::Damped {
            gain,
            numerator,
            denominator,
        } => {
            let gain = [gain.to_f64()];
            let about = gain_about(numerator.is_empty() && denominator.is_empty());
            let gain = constants.add(format!("{key}_GAIN"), ConstantForm::Number, &gain, about);
            let above = match roots(constants, &format!("{key}_ZERO"), numerator) {
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
