//! Steppers whose results have derivatives with respect to a number of the scene, the friction force or the load.

#[cfg(test)]
mod tests;

use super::sensitivity::{NoDerivative, Quantity, Sensitive, Varied};
use super::stepper::SystemStepper;
#[cfg(feature = "measure")]
use super::{system::System, varied::rounded};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
#[cfg(feature = "measure")]
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::stepper::Units;
use frictiongen_model::scene::{Node, Scene};
use frictiongen_model::stepping::StepperSettings;
#[cfg(feature = "measure")]
use frictiongen_model::transient::Transient;

impl Varied {
    /// Returns a stepper with time steps of `dt` seconds, which starts from rest without load. Every result
    /// (displacement, velocity, force, work) has a derivative with respect to the varied quantity.
    ///
    /// For derivatives with respect to the friction force or to the input, pass `Dual::variable` in a sample to a
    /// stepper of an [`unvaried`](super::System::unvaried) system. If the variable is a friction force that is
    /// constant in time, pass `Dual::variable` in every sample. For derivatives with respect to all other quantities,
    /// pass samples in the scene's units as constants.
    ///
    /// The derivatives stay correct after stops, break-aways and reversals. They take into account that the instants of
    /// these events change with the quantity. At some values of the quantity an event appears or vanishes. The motion
    /// has no derivative at such a value, and the stepper returns the derivative of one side.
    /// [`check_derivatives`](SystemStepper::check_derivatives) detects a motion without a derivative.
    ///
    /// ```
    /// use frictiongen::study::{System, SystemInput, sensitivity::Sensitive};
    ///
    /// # use frictiongen::scalar::Float;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 400 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let unvaried = block.unvaried();
    /// let mut stepper = unvaried.stepper(1e-3)?;
    /// let (mut low, mut high) = (block.stepper(1e-3)?, block.stepper(1e-3)?);
    /// for step in 1..=200_u32 {
    ///     let force = 4.0 * (18e-3 * f64::from(step)).sin();
    ///     let varied = SystemInput::force(Sensitive::fixed(force.into()));
    ///     stepper.advance(varied.friction(Sensitive::variable(1.0.into())))?;
    ///     for (friction, plain) in [(0.999, &mut low), (1.001, &mut high)] {
    ///         plain.advance(SystemInput::force(force).friction(friction))?;
    ///     }
    /// }
    /// // Displacement of the block per newton of friction, m/N.
    /// let slope = stepper.mass("block")?.displacement().slope.to_f64();
    /// let [low, high] = [low, high].map(|plain| plain.mass_at(0).displacement());
    /// assert!((slope - (high - low) / 0.002).abs() < 1e-5 * slope.abs());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoDerivative::Degenerate`] if the modes have no derivative. Otherwise the same errors as
    /// [`System::stepper`](super::System::stepper).
    pub fn stepper(&self, dt: f64) -> Result<SystemStepper<'_, Sensitive>, NoDerivative> {
        let transient = self.transient().ok_or(NoDerivative::Degenerate)?;
        // A scene may have no stepper. This call then returns the error.
        self.plain().stepper(dt)?;
        let settings = self.steps.get_or_init(|| self.settings());
        let dt = Sensitive::fixed(dt.into());
        let dynamics = transient.contact_dynamics();
        Ok(SystemStepper::new(
            (self.system(), settings),
            dynamics,
            dt,
            None,
        )?)
    }

    /// Returns the settings of a stepper. The factors that convert its non-dimensional groups to the scene's units
    /// have derivatives.
    fn settings(&self) -> StepperSettings<Sensitive> {
        let (scene, modal) = (self.system().scene(), self.modal());
        let fixed = Sensitive::fixed;
        let mut steps =
            StepperSettings::of(scene, &self.system().modal, 0..scene.masses.len(), fixed);
        let stiffness = fixed(Dd::from(scene.first_stiffness()));
        let stiffness = self.spring(0).unwrap_or(stiffness);
        steps.units = Units {
            stiffness,
            rate: modal.reference,
            support: self.support(scene) / stiffness,
        };
        steps.speed = if steps.on_base {
            modal.reference
        } else {
            modal.reference / stiffness
        };
        steps
    }

    /// Returns the stiffness of a spring. The stiffness is a variable if the derivatives are with respect to this
    /// stiffness.
    fn spring(&self, index: usize) -> Option<Sensitive> {
        let value = self.system().scene().springs.get(index)?.stiffness.into();
        Some(if self.quantity == Some(Quantity::Stiffness(index)) {
            Sensitive::variable(value)
        } else {
            Sensitive::fixed(value)
        })
    }

    /// Returns the sum of the stiffnesses of all springs that are connected to the base.
    fn support(&self, scene: &Scene) -> Sensitive {
        let springs = scene.springs.iter().enumerate();
        let on_base =
            springs.filter(|(_, spring)| spring.from == Node::Base || spring.to == Node::Base);
        let stiffnesses = on_base.filter_map(|(index, _)| self.spring(index));
        stiffnesses.fold(Sensitive::constant(0.0), |sum, stiffness| sum + stiffness)
    }
}

/// The data of steppers with derivatives in double precision. A step with these data takes a small fraction of the time
/// of a step with [`Sensitive`] numbers.
#[cfg(feature = "measure")]
pub(crate) struct RoundedSteps {
    system: System<Dual<f64>>,
    settings: StepperSettings<Dual<f64>>,
    transient: Transient<Dual<f64>>,
}

#[cfg(feature = "measure")]
impl Varied {
    /// Returns the data of steppers with derivatives in double precision. Each number is rounded once. Returns `None`
    /// if the modes have no derivative.
    pub(crate) fn rounded_steps(&self) -> Option<RoundedSteps> {
        let settings = self.settings();
        let Units {
            stiffness,
            rate,
            support,
        } = settings.units;
        let law = settings.law.into_iter();
        Some(RoundedSteps {
            system: self.rounded(),
            transient: Transient::along(self.system().scene(), self.modal(), rounded)?,
            settings: StepperSettings {
                units: Units {
                    stiffness: rounded(stiffness),
                    rate: rounded(rate),
                    support: rounded(support),
                },
                on_base: settings.on_base,
                damped_from_base: settings.damped_from_base,
                forces: settings.forces,
                input: settings.input,
                law: law.map(|point| point.map(rounded)).collect(),
                speed: rounded(settings.speed),
            },
        })
    }
}

#[cfg(feature = "measure")]
impl RoundedSteps {
    /// Returns a stepper with time steps of `dt` seconds, as [`Varied::stepper`] does, from the displacements and
    /// velocities of all masses. Returns `None` for a scene without a stepper.
    pub(crate) fn stepper(
        &self,
        dt: f64,
        (x, v): (Vec<f64>, Vec<f64>),
    ) -> Option<SystemStepper<'_, Dual<f64>>> {
        let dynamics = self.transient.contact_dynamics();
        let data = (&self.system, &self.settings);
        let [x, v] =
            [x, v].map(|values| -> Vec<_> { values.into_iter().map(Dual::fixed).collect() });
        SystemStepper::new(data, dynamics, Dual::fixed(dt), Some((&x, &v))).ok()
    }
}

impl SystemStepper<'_, Sensitive> {
    /// Fails if the derivatives are unreliable, because the motion has grazed an event since the start. In a graze,
    /// the contact's velocity or force very slowly crosses the value at which the event occurs. A rounding error of
    /// the input in `f64` then changes the derivative of the event's instant by more than a millionth of the
    /// derivative. The method also fails if a rounding error of the input may decide whether the contact stops or
    /// slides on.
    ///
    /// # Errors
    /// [`NoDerivative::Graze`] at the first graze and at all later instants.
    pub fn check_derivatives(&self) -> Result<(), NoDerivative> {
        if self.grazed() {
            return Err(NoDerivative::Graze);
        }
        Ok(())
    }
}
