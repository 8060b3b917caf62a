//! Traits for steppers, which advance the motion by time steps of equal length. Emitted solvers and the run-time
//! `System` implement these traits.

use crate::OutOfDomain;
use frictiongen_kernel::Float;
use frictiongen_kernel::stepper::{ContactNow, MassNow, Stepped, Work};

/// A scene that provides a stepper, which computes the motion in time steps of equal length under any input.
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
/// /// Returns the largest displacement of the contact under a force on the first mass, for any system.
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
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;
    /// Type of the stepper that [`stepper`](Self::stepper) returns.
    type Stepper<'a>: Stepping<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Returns a stepper that starts from rest without load. `dt` is the length of every step in seconds.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a step that is not positive and finite, or in which the fastest oscillator advances by more
    /// than [`MAX_PARTS`](frictiongen_kernel::stepper::MAX_PARTS) radians.
    fn stepper(&self, dt: Self::Scalar) -> Result<Self::Stepper<'_>, OutOfDomain>;
}

/// The input of a stepper at one instant, in the scene's units: base motion, forces and friction force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StepLoad<'l, S> {
    /// Displacement and velocity of the base at this instant, or 0 and 0 for a base that does not move.
    pub base: [S; 2],
    /// Forces on masses. Each entry has the index of a mass in the scene description, and the force. Forces on the same
    /// mass add up. No force acts on a mass without an entry.
    pub forces: &'l [(usize, S)],
    /// Kinetic friction force F at zero sliding speed. F must not be negative.
    pub friction: S,
}

impl<S: Float> StepLoad<'_, S> {
    /// Returns an input with a friction force, without forces on the masses and without base motion.
    #[must_use]
    pub fn friction(friction: S) -> Self {
        Self {
            base: [S::constant(0.0); 2],
            forces: &[],
            friction,
        }
    }

    /// Writes the forces into `to`, which has one entry for each mass in `masses`.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a force on a mass that `masses` does not list. [`OutOfDomain`] also for motion of a base
    /// that is at rest in the scene.
    #[doc(hidden)]
    pub fn spread(&self, masses: &[usize], on_base: bool, to: &mut [S]) -> Result<(), OutOfDomain> {
        if !on_base && !self.base.iter().all(|value| value.is_zero()) {
            return Err(OutOfDomain::BaseAtRest);
        }
        to.fill(S::constant(0.0));
        for (mass, force) in self.forces {
            let place = masses.iter().position(|loaded| loaded == mass);
            let sum = place.and_then(|place| to.get_mut(place));
            let sum = sum.ok_or(OutOfDomain::Forces)?;
            *sum = *sum + *force;
        }
        Ok(())
    }
}

/// A motion that advances in time steps of equal length. The caller sets the input at every step.
pub trait Stepping {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Sets the input at the start of the first step. Without this call, the input at the start is 0.
    ///
    /// # Errors
    /// Same errors as [`step`](Self::step). A call after the first step returns [`OutOfDomain`].
    fn begin_with(&mut self, load: &StepLoad<'_, Self::Scalar>) -> Result<(), OutOfDomain>;
    /// Advances the motion by one time step. `load` is the input at the end of the step. With `input: linear` the
    /// forces change linearly during the step, and the base follows a cubic. With `input: hold` the load acts over the
    /// whole step.
    ///
    /// # Errors
    /// [`OutOfDomain`] for values that are NaN or infinite, and for friction below zero. [`OutOfDomain`] also for a
    /// force on a mass for which the scene accepts no force, and for motion of a base at rest. The stepper then stays
    /// unchanged.
    fn step(
        &mut self,
        load: &StepLoad<'_, Self::Scalar>,
    ) -> Result<Stepped<Self::Scalar>, OutOfDomain>;
    /// Returns the present displacement and velocity of a mass. `index` is the index in the scene description. For an
    /// invalid index, displacement and velocity are 0.
    fn mass(&self, index: usize) -> MassNow<Self::Scalar>;
    /// Returns the present state of the contact, with its relative motion and friction force.
    fn contact(&self) -> ContactNow<Self::Scalar>;
    /// Returns the energy balance since the start: the work of the loads, and the energy that friction and damping have
    /// dissipated.
    fn work(&self) -> Work<Self::Scalar>;
    /// Returns the number of steps that the stepper has taken.
    fn steps(&self) -> u64;
    /// Returns the number of steps in which the contact had more events (stops, break-aways and reversals) than the
    /// stepper follows.
    fn exceeded(&self) -> u64;
    /// Returns the time step of the stepper, in s.
    fn dt(&self) -> Self::Scalar;
    /// Sets μ, the ratio of static to kinetic friction, for the following steps.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, infinity, and values below 1.
    fn set_stiction(&mut self, mu: Self::Scalar) -> Result<(), OutOfDomain>;
}

/// Implements [`Steps`] for an emitted scene, and [`Stepping`] for its stepper. The argument of the macro lists the
/// masses on which the stepper accepts a force. All other data come from the kernel's types. With the word `declared`,
/// the macro implements [`Stepping`] for the stepper of a declared step.
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

        impl $name {
            /// Creates a stepper from the bytes of an image. The stepper has the step and the state of the stepper
            /// that wrote the image.
            ///
            /// # Errors
            /// `OutOfDomain` for an image of another scene or version, and for an image of which a bit has changed.
            pub fn stepper_from_image(
                bytes: &[::core::primitive::u8],
            ) -> ::core::result::Result<$stepper, $crate::OutOfDomain> {
                let mut stepper = Self::stepper($crate::kernel::stepper::image_step(bytes)?)?;
                stepper.restore_image(bytes)?;
                ::core::result::Result::Ok(stepper)
            }
        }

        $crate::emitted_stepper!(declared $stepper, $scalar, $on_base, [$($mass),*]);
    };
    (declared $stepper:ident, $scalar:ty, $on_base:literal, [$($mass:literal),*]) => {
        impl $stepper {
            /// Length of an image of the stepper's state, in bytes.
            pub const IMAGE: ::core::primitive::usize =
                <<Self as ::core::ops::Deref>::Target>::IMAGE;

            /// Returns the state as bytes, for a file or for flash memory. `stepper_from_image` continues from these
            /// bytes. The bytes contain a hash of the scene, the step, a version and a checksum.
            #[must_use]
            pub fn image(&self) -> [::core::primitive::u8; <<$stepper as ::core::ops::Deref>::Target>::IMAGE] {
                let mut bytes = [0; <<$stepper as ::core::ops::Deref>::Target>::IMAGE];
                self.0.write_image(&mut bytes);
                bytes
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
