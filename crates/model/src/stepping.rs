//! Data of the stepper: units, loads and the friction law. The stepper additionally needs the data for the motion in
//! time.

use crate::modal::Modal;
use crate::scene::{Excitation, FrictionLaw, Node, Precision, Scene, StepInput};
use crate::transient::Transient;
use frictiongen_kernel::errors::OutOfDomain;
use frictiongen_kernel::motion::{ContactChain, Dynamics, Lines};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Channel, HeldLoad, HeldStep, Input, MAX_PARTS, ModeStep, Pace, StepScene, Units, fill,
};
use frictiongen_kernel::{Float, Scalar};

/// Settings of the stepper of a scene, in a solver's number type.
#[derive(Clone, Debug)]
pub struct StepperSettings<S> {
    /// Factors that convert non-dimensional groups to the scene's units.
    pub units: Units<S>,
    /// True if the excitation is a motion of the base.
    pub on_base: bool,
    /// True if damping acts on velocities relative to the moving base.
    pub damped_from_base: bool,
    /// Indices of the masses on which a force may act. The excited mass comes first, then the masses of the
    /// description's field `force`, then the masses that the caller adds.
    pub forces: Vec<usize>,
    /// Course of the input between two samples.
    pub input: Input,
    /// Points (speed, level) of the friction law. The level is the kinetic friction force divided by F. The list is
    /// empty for Coulomb's law.
    pub law: Vec<[S; 2]>,
    /// Velocity in the scene's units that corresponds to dz̄/dτ = 1, at r = 1 under a load of amplitude 1. It is
    /// √(k₁/m₁), divided by k₁ if the load is a force.
    pub speed: S,
}

impl<S: Scalar> StepperSettings<S> {
    /// Creates the settings of a scene. `to` rounds each number once from double-double. `more` lists masses on which a
    /// force may act in addition to those in the scene.
    #[must_use]
    pub fn of(
        scene: &Scene,
        modal: &Modal,
        more: impl Iterator<Item = usize>,
        to: impl Fn(Dd) -> S,
    ) -> Self {
        let excited = match scene.excitation {
            Excitation::Force(mass) => Some(mass),
            Excitation::Base => None,
        };
        let mut forces: Vec<usize> = excited.into_iter().collect();
        forces.extend(&scene.stepping.forces);
        for mass in more {
            if !forces.contains(&mass) {
                forces.push(mass);
            }
        }
        let reference = scene.first_stiffness();
        let speed = match scene.excitation {
            Excitation::Force(_) => modal.reference / Dd::from(reference),
            Excitation::Base => modal.reference,
        };
        let on_base = scene.springs.iter().filter(|spring| {
            let ends = [spring.from, spring.to];
            ends.contains(&Node::Base)
        });
        let support = on_base.fold(Dd::ZERO, |sum, spring| sum + Dd::from(spring.stiffness));
        Self {
            units: Units {
                stiffness: to(Dd::from(reference)),
                rate: to(modal.reference),
                support: to(support / Dd::from(reference)),
            },
            on_base: excited.is_none(),
            damped_from_base: !modal.participations.is_empty(),
            forces,
            input: scene.stepping.input.into(),
            law: match &scene.friction {
                FrictionLaw::Coulomb => Vec::new(),
                FrictionLaw::Stribeck(points) => {
                    let points = points.iter();
                    let point = points.map(|point| point.map(|value| to(Dd::from(value))));
                    point.collect()
                }
            },
            speed: to(speed),
        }
    }

    /// Returns the number of coefficients of the polynomial that describes an input during a step.
    #[must_use]
    pub fn coefficients(&self) -> usize {
        match (self.on_base, self.input) {
            (true, Input::Linear) => 4,
            (true, Input::Hold) | (false, Input::Linear) => 2,
            (false, Input::Hold) => 1,
        }
    }

    /// Returns the number of inputs. The inputs are the displacement of a moving base, the velocity of the base if
    /// damping acts relative to the base, and a force for each loaded mass.
    #[must_use]
    pub fn inputs(&self) -> usize {
        usize::from(self.on_base) + usize::from(self.damped_from_base) + self.forces.len()
    }
}

impl<S: Float> StepperSettings<S> {
    /// Returns the friction law for a simulation at the frequency ratio r. `amplitude` is the amplitude of the load.
    #[must_use]
    pub fn lines(&self, r: S, amplitude: S) -> Lines<'_, S> {
        Lines::under(&self.law, r, amplitude, self.speed)
    }

    /// Returns the settings and `dynamics` as [`StepScene`] of the kernel crate.
    #[must_use]
    pub fn scene<'a, K>(&'a self, dynamics: Dynamics<'a, S, K>) -> StepScene<'a, S, K> {
        StepScene {
            dynamics,
            units: self.units,
            on_base: self.on_base,
            forces: &self.forces,
            input: self.input,
            law: &self.law,
        }
    }
}

/// Returns the number and length of the parts into which the kernel divides a step of a scene.
///
/// # Errors
/// [`OutOfDomain`] for a step that the kernel does not accept.
pub fn pace<S: Float, K: ContactChain<S>>(
    scene: &StepScene<'_, S, K>,
    step: S,
) -> Result<Pace<S>, OutOfDomain> {
    let (modes, held) = (scene.dynamics.modes.len(), scene.dynamics.held.len());
    let inputs = scene.channels();
    fill::<S, 1, K>(
        scene,
        step,
        (
            &mut vec![ModeStep::zero(); modes],
            &mut vec![HeldStep::zero(); held],
        ),
        (
            &mut vec![S::constant(0.0); modes * inputs],
            &mut vec![HeldLoad::zero(); held * inputs],
            &mut vec![Channel::zero(); inputs],
        ),
    )
}

/// Returns the reason why a stepper refuses the step of a scene, or `None` if it accepts the step. The first number
/// is the angle in rad by which the fastest oscillator turns in one step. The second is the range of angles that a
/// stepper accepts.
#[must_use]
pub fn refused_step(scene: &Scene, modal: &Modal) -> Option<(f64, [f64; 2])> {
    let step = scene.stepping.step?;
    let turned = match scene.precision {
        Precision::F64 => turned::<f64>(scene, modal, step),
        Precision::F32 => turned::<f32>(scene, modal, step),
    };
    turned.err()
}

fn turned<S: Float>(scene: &Scene, modal: &Modal, step: f64) -> Result<(), (f64, [f64; 2])> {
    let to = |value: Dd| S::constant(value.to_f64());
    let transient = Transient::of(scene, modal, to);
    let steps = StepperSettings::of(scene, modal, std::iter::empty(), to);
    let scene = steps.scene(transient.contact_dynamics());
    let step = S::constant(step);
    match pace(&scene, step) {
        Ok(_) => Ok(()),
        Err(_) => {
            let (_, most) = S::inverse_ratio_range();
            let within = [1.0 / most.to_f64(), f64::from(MAX_PARTS)];
            Err((scene.fastest().to_f64() * step.to_f64(), within))
        }
    }
}

impl From<StepInput> for Input {
    fn from(input: StepInput) -> Self {
        match input {
            StepInput::Hold => Self::Hold,
            StepInput::Linear => Self::Linear,
        }
    }
}
