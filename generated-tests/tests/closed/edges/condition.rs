//! Computes the condition number of an answer f, Σ|x ∂f/∂x| over its inputs x, by dual numbers.
//!
//! To first order, inputs that are off by k rounding units ε change an exact answer by kε Σ|x ∂f/∂x|. The inputs are
//! r, β and one of two sets of numbers. For the closed forms this set is the modal data. For a description it is
//! masses, springs, damping and μ.

use frictiongen::study::{
    System,
    scene::Damping,
    sensitivity::{Quantity, Sensitive},
};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;
use generated_tests::data::Data;

/// The quantity of a scene whose condition number is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    ContinuousLimit,
    WithoutSearch,
    SlidingLimit,
    ContactAmplitude,
    ContactPhase,
    /// Displacement of the mass with this index at τ = 1.
    Displacement(usize),
}

impl Asked {
    pub fn is_angle(self) -> bool {
        matches!(self, Self::ContactPhase)
    }
}

/// Returns the answer of the closed form, even if β is above the limits.
pub fn answer<S: Float>(data: &Data<S>, r: S, beta: S, asked: Asked) -> S {
    let at = data.at(r);
    match asked {
        Asked::ContinuousLimit => at.continuous_limit(),
        Asked::WithoutSearch => at.continuous_limit_without_search(),
        Asked::SlidingLimit => at.sliding_limit(),
        Asked::ContactAmplitude => at.contact(beta).amplitude(),
        Asked::ContactPhase => at.contact(beta).phase(),
        Asked::Displacement(mass) => at.mass(mass, beta).displacement(S::constant(1.0)),
    }
}

/// Returns the modal data of a system, converted to another scalar type.
pub fn data<T: Float, S: Float>(modal: &Modal<T>, to: impl Fn(T) -> S) -> Data<S> {
    Data {
        reduced: modal.reduced(to),
    }
}

/// A point (r, β), and the quantity that is computed at this point.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    pub r: Dd,
    pub beta: Dd,
    pub asked: Asked,
}

impl Question {
    pub fn at(r: impl Float, beta: impl Float, asked: Asked) -> Self {
        let [r, beta] = [r.to_f64(), beta.to_f64()].map(Dd::from);
        Self { r, beta, asked }
    }
}

/// Returns the answer f and its derivative ∂f/∂q with respect to a quantity q of the scene.
pub fn along<S: Float>(system: &System<S>, question: Question, quantity: Quantity) -> Sensitive {
    let modal = system.modal().along(system.scene(), quantity);
    let data = data(&modal.expect("a quantity of the scene"), |value| value);
    let Question { r, beta, asked } = question;
    answer(&data, Dual::fixed(r), Dual::fixed(beta), asked)
}

/// Returns the answer f, ∂f/∂r and ∂f/∂β.
pub fn along_place<S: Float>(system: &System<S>, question: Question) -> (Dd, Dd, Dd) {
    let data = data(&system.modal().fixed(), |value| value);
    let Question { r, beta, asked } = question;
    let over_r = answer(&data, Dual::variable(r), Dual::fixed(beta), asked);
    let over_beta = answer(&data, Dual::fixed(r), Dual::variable(beta), asked);
    (over_r.value, over_r.slope, over_beta.slope)
}

/// Returns |r ∂f/∂r| + |β ∂f/∂β| + |f| + Σ|x ∂f/∂x| for the answer f. For an angle, π replaces |f|. The sum is over
/// the quantities x in `quantities`, where each quantity comes with its value.
fn over<S: Float>(system: &System<S>, question: Question, quantities: &[(Quantity, Dd)]) -> f64 {
    let (value, over_r, over_beta) = along_place(system, question);
    let own = if question.asked.is_angle() {
        Dd::PI
    } else {
        value.abs()
    };
    let place = (question.r * over_r).abs() + (question.beta * over_beta).abs();
    let terms = quantities.iter().filter(|(_, size)| !size.is_zero());
    terms
        .map(|(quantity, size)| (*size * along(system, question, *quantity).slope).abs())
        .fold(own + place, |sum, term| sum + term)
        .to_f64()
}

/// Returns the condition number with respect to the modal data. It bounds the accuracy of the closed forms.
pub fn modal_condition<S: Float>(system: &System<S>, question: Question) -> f64 {
    let modal = system.modal();
    let mut quantities = vec![(Quantity::Stiction, modal.stiction)];
    for mode in 0..modal.resonances.len() {
        quantities.extend([
            (Quantity::Resonance(mode), modal.resonances[mode]),
            (Quantity::DampingRatio(mode), modal.damping_ratios[mode]),
            (Quantity::Load(mode), modal.loads[mode]),
            (Quantity::Contact(mode), modal.contacts[mode]),
        ]);
        if let Asked::Displacement(mass) = question.asked {
            let shape = Quantity::Shape { mode, mass };
            quantities.push((shape, modal.shapes[mode][mass]));
        }
    }
    over(system, question, &quantities)
}

/// Returns the condition number with respect to the numbers of the description.
pub fn scene_condition<S: Float>(system: &System<S>, question: Question) -> f64 {
    let scene = system.scene();
    let mut quantities = vec![(Quantity::Stiction, Dd::from(scene.stiction))];
    let masses = scene.masses.iter().enumerate();
    quantities.extend(masses.map(|(i, mass)| (Quantity::Mass(i), Dd::from(mass.value))));
    let springs = scene.springs.iter().enumerate();
    quantities
        .extend(springs.map(|(i, spring)| (Quantity::Stiffness(i), Dd::from(spring.stiffness))));
    match scene.damping {
        Damping::Rayleigh { mass, stiffness } => quantities.extend([
            (Quantity::MassDamping, Dd::from(mass)),
            (Quantity::StiffnessDamping, Dd::from(stiffness)),
        ]),
        _ => {
            let ratios = system.modal().damping_ratios.iter().enumerate();
            quantities.extend(ratios.map(|(i, zeta)| (Quantity::DampingRatio(i), *zeta)));
        }
    }
    over(system, question, &quantities)
}
