//! Facts about the emitted stepper of a scene: the cost of a step, and the numbers of its tables.

use super::emission::Emission;
use super::step_cost;
use super::step_table::{self, Sizes};
use crate::Description;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::Cost;
use frictiongen_model::scene::Provide;
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;
use syn::{Expr, Lit, Member, UnOp};

/// Facts about the emitted stepper of a scene with one contact.
#[derive(Clone, Debug, PartialEq)]
pub struct StepFacts {
    /// Upper bounds on the cost of a step, as in the documentation of the stepper. Without a declared step, the bounds
    /// are those of a step with a single part.
    pub cost: Cost,
    /// Number of equal parts into which the stepper divides a step.
    pub parts: u32,
    /// Numbers of the tables of the declared step, each with its path. A path consists of the names of fields and the
    /// indices that lead to the number in the tables. Without a declared step the list is empty.
    pub numbers: Vec<(String, f64)>,
}

/// Returns facts about the emitted stepper of a description. Returns `None` if the description provides no stepper, or
/// has several contacts or dashpots. A stepper for several contacts or dashpots has no tables and no stated cost.
#[must_use]
pub fn step_facts(description: &Description) -> Option<StepFacts> {
    let scene = &description.scene;
    if scene.is_joined() || !scene.provides(&Provide::Stepper) {
        return None;
    }
    let emission = Emission::of(description);
    let steps = StepperSettings::of(scene, &emission.modal, std::iter::empty(), |value| value);
    let transient = Transient::<Dd>::of(scene, &emission.modal, |value| value);
    let exact = steps.scene(transient.contact_dynamics());
    let sizes = Sizes {
        coefficients: steps.coefficients(),
        modes: transient.modes.len(),
        held: transient.held.len(),
        inputs: steps.inputs(),
    };
    let step = scene.stepping.step;
    let (cost, parts) = step_cost::cost(&exact, step, sizes.coefficients, scene.precision);
    let mut numbers = Vec::new();
    if let Some((tables, _)) =
        step.and_then(|step| step_table::emit(&emission, &exact, step, &sizes))
    {
        let item: syn::ItemConst = syn::parse2(tables).ok()?;
        collect(&item.expr, "", &mut numbers);
    }
    Some(StepFacts {
        cost,
        parts,
        numbers,
    })
}

/// Appends the numbers of a Rust expression to `to`, each with its path: the fields and indices that lead to the
/// number. `place` is the path of the expression. The expression consists of structures, arrays and literals.
fn collect(value: &Expr, place: &str, to: &mut Vec<(String, f64)>) {
    match value {
        Expr::Struct(structure) => {
            for field in &structure.fields {
                let name = match &field.member {
                    Member::Named(name) => name.to_string(),
                    Member::Unnamed(index) => index.index.to_string(),
                };
                let dot = if place.is_empty() { "" } else { "." };
                collect(&field.expr, &format!("{place}{dot}{name}"), to);
            }
        }
        Expr::Array(array) => {
            for (index, entry) in array.elems.iter().enumerate() {
                collect(entry, &format!("{place}[{index}]"), to);
            }
        }
        Expr::Unary(minus) if matches!(minus.op, UnOp::Neg(_)) => {
            let first = to.len();
            collect(&minus.expr, place, to);
            for (_, number) in to.iter_mut().skip(first) {
                *number = -*number;
            }
        }
        Expr::Lit(literal) => match &literal.lit {
            Lit::Float(number) => to.extend(number.base10_parse().map(|n| (place.to_owned(), n))),
            Lit::Int(number) => to.extend(number.base10_parse().map(|n| (place.to_owned(), n))),
            _ => {}
        },
        _ => {}
    }
}
