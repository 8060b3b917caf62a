//! Sizes and inputs of an emitted stepper, for callers in other languages.

use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Scene;
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;

/// Sizes and inputs of the stepper that the macro emits for a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepperShape {
    /// Number of coefficients of an input's polynomial over a step.
    pub coefficients: usize,
    /// Number of modes of the chain in the tables.
    pub modes: usize,
    /// Number of modes of the chain with its contact stuck.
    pub held: usize,
    /// Number of inputs that the tables have.
    pub inputs: usize,
    /// True if the input is a motion of the base.
    pub on_base: bool,
    /// Indices of the masses on which the stepper accepts a force, in the order of the input's fields.
    pub forces: Vec<usize>,
    /// True if the contact is elastic.
    pub elastic: bool,
}

impl StepperShape {
    /// Returns the sizes and inputs of a scene's stepper.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let modal = Modal::of(scene);
        let steps = StepperSettings::<Dd>::of(scene, &modal, std::iter::empty(), |value| value);
        let transient = Transient::<Dd>::of(scene, &modal, |value| value);
        Self {
            coefficients: steps.coefficients(),
            modes: transient.modes.len(),
            held: transient.held.len(),
            inputs: steps.inputs(),
            on_base: steps.on_base,
            forces: steps.forces.clone(),
            elastic: scene.stiffness.is_some(),
        }
    }

    /// Returns the four sizes as arguments of the kernel's stepper types: `4, 2, 1, 1`.
    #[must_use]
    pub fn arguments(&self) -> String {
        let Self {
            coefficients,
            modes,
            held,
            inputs,
            ..
        } = self;
        format!("{coefficients}, {modes}, {held}, {inputs}")
    }
}
