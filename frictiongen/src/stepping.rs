//! Steppers, of emitted solvers and of the run-time `System` alike.

use crate::OutOfDomain;
use frictiongen_kernel::Float;
use frictiongen_kernel::stepper::{ContactNow, MassNow, Stepped, Work};

/// A scene that also moves by steps of one length, under any input.
///
/// ```
/// use frictiongen::{OutOfDomain, StepLoad, Stepping, Steps, friction_system};
///
/// friction_system! {
///     struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: block,
///         provide: [stepper],
///     }
/// }
///
/// /// The contact's largest displacement under a force on the first mass, of any system.
/// fn largest<F>(system: &F, forces: &[f64]) -> Result<f64, OutOfDomain>
/// where
///     F: Steps<Scalar = f64>,
/// {
///     let (mut stepper, mut largest) = (system.stepper(0.01)?, 0.0_f64);
///     for force in forces {
///         stepper.step(&StepLoad { forces: &[(0, *force)], ..StepLoad::friction(0.4) })?;
///         largest = largest.max(stepper.contact().displacement().abs());
///     }
///     Ok(largest)
/// }
///
/// // A force below the friction force moves nothing at all.
/// assert_eq!(largest(&Block, &[0.1, 0.3, 0.399])?, 0.0);
/// assert!(largest(&Block, &[0.1, 0.5, 0.6])? > 0.0);
/// # Ok::<(), OutOfDomain>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no stepper",
    label = "add `stepper` to the scene's `provide: [...]`"
)]
pub trait Steps {
    /// The scene's scalar.
    type Scalar: Float;
    /// A stepper.
    type Stepper<'a>: Stepping<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// The motion by steps of dt, in s, from rest under no load.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a step that is not positive and finite, or in which the fastest oscillator turns by more
    /// than [`MAX_PARTS`](frictiongen_kernel::stepper::MAX_PARTS) radians.
    fn stepper(&self, dt: Self::Scalar) -> Result<Self::Stepper<'_>, OutOfDomain>;
}

/// What acts on any scene at an instant, in the scene's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLoad<'l, S> {
    /// Displacement and velocity of the base; zeros where the base is at rest.
    pub base: [S; 2],
    /// Forces on masses, by their places in the description.  Those on the same mass add up; there is none on others.
    pub forces: &'l [(usize, S)],
    /// The kinetic friction force F at rest, not negative.
    pub friction: S,
}

impl<S: Float> StepLoad<'_, S> {
    /// Friction alone.
    #[must_use]
    pub fn friction(friction: S) -> Self {
        Self {
            base: [S::constant(0.0); 2],
            forces: &[],
            friction,
        }
    }

    /// The forces on these masses.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a force on another mass, and for a motion of a base at rest.
    #[doc(hidden)]
    pub fn spread(&self, masses: &[usize], on_base: bool, to: &mut [S]) -> Result<(), OutOfDomain> {
        if !on_base && !self.base.iter().all(|value| value.is_zero()) {
            return Err(OutOfDomain { argument: "base" });
        }
        to.fill(S::constant(0.0));
        for (mass, force) in self.forces {
            let place = masses.iter().position(|loaded| loaded == mass);
            let sum = place.and_then(|place| to.get_mut(place));
            let sum = sum.ok_or(OutOfDomain { argument: "forces" })?;
            *sum = *sum + *force;
        }
        Ok(())
    }
}

/// A motion by steps of one length.
pub trait Stepping {
    /// The scene's scalar.
    type Scalar: Float;

    /// Says what acts before the first step; nothing unless said so.
    ///
    /// # Errors
    /// [`OutOfDomain`] as of [`step`](Self::step), and after the first step.
    fn begin_with(&mut self, load: &StepLoad<'_, Self::Scalar>) -> Result<(), OutOfDomain>;
    /// Takes a step: in a straight line to this load, or under it where the scene says `input: hold`.
    ///
    /// # Errors
    /// [`OutOfDomain`] for what is NaN or infinite, for friction below zero, for a force on a mass that the scene does
    /// not let be loaded and for a motion of a base at rest: the stepper is then what it was.
    fn step(
        &mut self,
        load: &StepLoad<'_, Self::Scalar>,
    ) -> Result<Stepped<Self::Scalar>, OutOfDomain>;
    /// A mass now, by its place in the description; at rest if there is no such mass.
    fn mass(&self, index: usize) -> MassNow<Self::Scalar>;
    /// The contact now.
    fn contact(&self) -> ContactNow<Self::Scalar>;
    /// The work done since the start.
    fn work(&self) -> Work<Self::Scalar>;
    /// How many steps were taken.
    fn steps(&self) -> u64;
    /// In how many steps more events happened than are followed.
    fn exceeded(&self) -> u64;
    /// The length of a step, in s.
    fn dt(&self) -> Self::Scalar;
    /// Another μ, from now on.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, infinity, and less than 1.
    fn set_stiction(&mut self, mu: Self::Scalar) -> Result<(), OutOfDomain>;
}

/// [`Steps`] of an emitted scene and [`Stepping`] of its stepper: the masses that may be loaded are all that the kernel
/// does not know.
#[doc(hidden)]
#[macro_export]
macro_rules! emitted_stepper {
    ($name:ident, $stepper:ident, $scalar:ty, $on_base:literal, [$($mass:literal),*]) => {
        impl $crate::Steps for $name {
            type Scalar = $scalar;
            type Stepper<'a> = $stepper;

            fn stepper(&self, dt: $scalar) -> ::core::result::Result<$stepper, $crate::OutOfDomain> {
                Self::stepper(dt)
            }
        }

        impl $crate::Stepping for $stepper {
            type Scalar = $scalar;

            fn begin_with(
                &mut self,
                load: &$crate::StepLoad<'_, $scalar>,
            ) -> ::core::result::Result<(), $crate::OutOfDomain> {
                const MASSES: &[::core::primitive::usize] = &[$($mass),*];
                let mut forces = [0.0; MASSES.len()];
                load.spread(MASSES, $on_base, &mut forces)?;
                self.0.begin($crate::kernel::stepper::Sample {
                    base: load.base,
                    forces: &forces,
                    friction: load.friction,
                })
            }
            fn step(
                &mut self,
                load: &$crate::StepLoad<'_, $scalar>,
            ) -> ::core::result::Result<
                $crate::kernel::stepper::Stepped<$scalar>,
                $crate::OutOfDomain,
            > {
                const MASSES: &[::core::primitive::usize] = &[$($mass),*];
                let mut forces = [0.0; MASSES.len()];
                load.spread(MASSES, $on_base, &mut forces)?;
                self.0.advance($crate::kernel::stepper::Sample {
                    base: load.base,
                    forces: &forces,
                    friction: load.friction,
                })
            }
            fn mass(
                &self,
                index: ::core::primitive::usize,
            ) -> $crate::kernel::stepper::MassNow<$scalar> {
                self.0.mass(index)
            }
            fn contact(&self) -> $crate::kernel::stepper::ContactNow<$scalar> {
                self.0.contact()
            }
            fn work(&self) -> $crate::kernel::stepper::Work<$scalar> {
                self.0.work()
            }
            fn steps(&self) -> ::core::primitive::u64 {
                self.0.steps()
            }
            fn exceeded(&self) -> ::core::primitive::u64 {
                self.0.exceeded()
            }
            fn dt(&self) -> $scalar {
                self.0.dt()
            }
            fn set_stiction(
                &mut self,
                mu: $scalar,
            ) -> ::core::result::Result<(), $crate::OutOfDomain> {
                self.0.set_stiction(mu)
            }
        }
    };
}
