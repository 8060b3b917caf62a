//! Sizes and inputs of an emitted stepper, for callers in other languages.

use crate::emit::joints::{sizes, step_layout};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Excitation, Scene};
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;

/// Sizes and inputs of the stepper that the macro emits for a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepperShape {
    /// True if the input is a motion of the base.
    pub on_base: bool,
    /// Indices of the masses on which the stepper accepts a force, in the order of the input's fields.
    pub forces: Vec<usize>,
    /// Names of the contacts.
    pub contacts: Vec<String>,
    /// Sizes of the stepper's arrays.
    pub sizes: StepperSizes,
}

/// Sizes of an emitted stepper's arrays.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StepperSizes {
    /// Sizes of a stepper with modes, for a scene with one contact without dashpots.
    Modes {
        /// Number of coefficients of an input's polynomial over a step.
        coefficients: usize,
        /// Number of modes of the chain in the tables.
        modes: usize,
        /// Number of modes of the chain with its contact stuck.
        held: usize,
        /// Number of inputs that the tables have.
        inputs: usize,
        /// True if the contact is elastic.
        elastic: bool,
    },
    /// Sizes of a stepper for a scene with several contacts or dashpots.
    Joints {
        /// Arguments of the type that fixes the lengths of all arrays.
        sizes: Vec<usize>,
        /// Number of points of the friction law.
        points: usize,
        /// Number of coordinates of the stepper.
        row: usize,
        /// Number of entries in the tables.
        entries: usize,
    },
}

impl StepperShape {
    /// Returns the sizes and inputs of a scene's stepper.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let modal = Modal::of(scene);
        let steps = StepperSettings::<Dd>::of(scene, &modal, std::iter::empty(), |value| value);
        let contacts = scene.named_contacts().into_iter();
        Self {
            on_base: scene.excitation == Excitation::Base,
            contacts: contacts.map(|contact| contact.name).collect(),
            sizes: if scene.is_joined() {
                StepperSizes::of_joints(scene, steps.forces.len())
            } else {
                let transient = Transient::<Dd>::of(scene, &modal, |value| value);
                StepperSizes::Modes {
                    coefficients: steps.coefficients(),
                    modes: transient.modes.len(),
                    held: transient.held.len(),
                    inputs: steps.inputs(),
                    elastic: scene.stiffness.is_some(),
                }
            },
            forces: steps.forces,
        }
    }
}

impl StepperSizes {
    fn of_joints(scene: &Scene, loads: usize) -> Self {
        let layout = step_layout(scene, loads);
        Self::Joints {
            sizes: sizes(scene, loads),
            points: scene.friction.points().len(),
            row: layout.map_or(0, |layout| layout.coordinates()),
            entries: layout.map_or(0, |layout| layout.entries()),
        }
    }

    /// Returns the type of a saved state in an exported crate. `scalar` is the scene's number type.
    #[must_use]
    pub fn saved_type(&self, scalar: &str) -> String {
        match self {
            Self::Modes {
                coefficients,
                modes,
                held,
                inputs,
                ..
            } => format!(
                "frictiongen::kernel::stepper::Saved<{scalar}, frictiongen::kernel::stepper::FixedStore<{scalar}, {coefficients}, {modes}, {held}, {inputs}>>"
            ),
            Self::Joints { sizes, .. } => {
                let sizes: Vec<String> = sizes.iter().map(usize::to_string).collect();
                format!(
                    "frictiongen::kernel::joints::Saved<{scalar}, frictiongen::kernel::joints::Fixed<{}>>",
                    sizes.join(", ")
                )
            }
        }
    }
}
