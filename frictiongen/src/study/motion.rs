//! Continuous and stuck motions of a run-time system. A caller can request the motion of a mass by the name of the
//! mass.

use super::error::UnknownMass;
use super::system::System;
use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::response::{Continuous, MotionOf, Stuck};
use std::ops::Deref;

/// The exact continuous motion of a system at one frequency ratio and one friction ratio.
#[derive(Clone, Debug)]
pub struct SystemMotion<'a, S: Float = f64> {
    motion: Continuous<&'a System<S>>,
    from_rest: bool,
}

/// The continuous motion of the contact or of a mass of a run-time system.
pub type SystemSteady<'a, S = f64> = MotionOf<&'a System<S>>;

impl<'a, S: Float> SystemMotion<'a, S> {
    /// Stores whether the motion from rest ends in this continuous motion.
    pub(super) fn with_start(mut self, from_rest: bool) -> Self {
        self.from_rest = from_rest;
        self
    }

    pub(super) fn is_from_rest(&self) -> bool {
        self.from_rest
    }

    /// Returns the continuous motion of the mass called `name`.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<SystemSteady<'a, S>, UnknownMass> {
        let system = self.at().scene();
        let motion = self.mass_at(system.mass_index(name)?);
        motion.ok_or_else(|| system.unknown(name))
    }
}

impl<'a, S: Float> From<Continuous<&'a System<S>>> for SystemMotion<'a, S> {
    fn from(motion: Continuous<&'a System<S>>) -> Self {
        Self {
            motion,
            from_rest: true,
        }
    }
}

impl<'a, S: Float> Deref for SystemMotion<'a, S> {
    type Target = Continuous<&'a System<S>>;

    fn deref(&self) -> &Self::Target {
        &self.motion
    }
}

/// The response of a system at one frequency ratio while its contact is stuck.
#[derive(Clone, Debug)]
pub struct SystemStuck<'a, S: Float = f64>(Stuck<&'a System<S>>);

impl<S: Float> SystemStuck<'_, S> {
    /// Returns the complex amplitude of the mass called `name` while the contact is stuck.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<Complex<S>, UnknownMass> {
        let system = self.at().scene();
        let amplitude = self.mass_at(system.mass_index(name)?);
        amplitude.ok_or_else(|| system.unknown(name))
    }
}

impl<'a, S: Float> From<Stuck<&'a System<S>>> for SystemStuck<'a, S> {
    fn from(stuck: Stuck<&'a System<S>>) -> Self {
        Self(stuck)
    }
}

impl<'a, S: Float> Deref for SystemStuck<'a, S> {
    type Target = Stuck<&'a System<S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}
