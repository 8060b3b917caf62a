//! The motions of a run-time system, continuous and stuck.

use super::at::SystemAt;
use super::error::UnknownMass;
use crate::system::{ContinuousMotion, Of, Steady, StuckAt};
use crate::{Complex, StuckResonance};
use frictiongen_kernel::Float;
use frictiongen_kernel::chain::ModeAt;
use frictiongen_kernel::decay::Damped;
use frictiongen_kernel::mode::Mode;
use frictiongen_kernel::motion::Friction;
use frictiongen_kernel::steady::Motion;
use frictiongen_kernel::wave::Wave;
use frictiongen_model::modal::Reduced;

/// The exact continuous motion of a system.
#[derive(Clone, Debug)]
pub struct SystemMotion<'a, S = f64> {
    pub(super) at: SystemAt<'a, S>,
    pub(super) friction: Friction<S>,
}

/// The motion of the contact or of a mass of a run-time system.
pub type SystemSteady<S = f64> = Motion<S, Damped<S>, Vec<Wave<S, Damped<S>>>>;

impl<S: Float> SystemMotion<'_, S> {
    /// The relative motion in the contact.
    #[must_use]
    pub fn contact(&self) -> SystemSteady<S> {
        let SystemAt {
            system,
            contact,
            inverse_r,
            ..
        } = &self.at;
        let chain = &system.reduced.chain;
        let carrier = chain.contact_carrier(contact, &self.friction);
        let waves = self
            .waves(|_, mode, at| chain.contact_wave(mode, at, contact, &self.friction, *inverse_r));
        Motion::of_contact(self.friction, carrier, waves)
    }

    /// The motion of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<SystemSteady<S>, UnknownMass> {
        let index = self.at.system.mass_index(name)?;
        self.mass_at(index)
            .ok_or_else(|| self.at.system.unknown(name))
    }

    /// The motion of a mass, by its place in the description.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> Option<SystemSteady<S>> {
        let SystemAt {
            system,
            contact,
            modes,
            inverse_r,
            ..
        } = &self.at;
        let Reduced {
            modes: constants,
            chain,
            shapes,
            ..
        } = &system.reduced;
        let shape = shapes.get(index)?;
        if chain.on_moving_base.is_none() && system.modal.contact == (index, None) {
            return Some(self.contact());
        }
        let carrier = chain.carrier(shape, constants, modes, contact, &self.friction, *inverse_r);
        let waves = self.waves(|i, mode, at| {
            let component = shape.get(i).copied().unwrap_or(S::constant(0.0));
            chain.mass_wave(mode, component, at, contact, &self.friction, *inverse_r)
        });
        Some(Motion::of_mass(self.friction, carrier, waves))
    }

    /// The waves of the modes that the contact drives.
    fn waves(
        &self,
        of: impl Fn(usize, &Mode<S>, &ModeAt<S>) -> Wave<S, Damped<S>>,
    ) -> Vec<Wave<S, Damped<S>>> {
        let modes = self.at.system.reduced.modes.iter().zip(&self.at.modes);
        modes
            .enumerate()
            .filter(|(_, (mode, _))| mode.in_contact)
            .map(|(index, (mode, at))| of(index, mode, at))
            .collect()
    }
}

/// The response of a system while its contact is stuck.
#[derive(Clone, Debug)]
pub struct SystemStuck<'a, S = f64> {
    pub(super) at: SystemAt<'a, S>,
}

impl<S: Float> SystemStuck<'_, S> {
    /// The complex amplitude of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<Complex<S>, UnknownMass> {
        let index = self.at.system.mass_index(name)?;
        self.mass_at(index)
            .ok_or_else(|| self.at.system.unknown(name))
    }

    /// The complex amplitude of a mass, by its place in the description.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> Option<Complex<S>> {
        let SystemAt {
            system,
            contact,
            modes,
            inverse_r,
            ..
        } = &self.at;
        let Reduced {
            modes: constants,
            chain,
            shapes,
            ..
        } = &system.reduced;
        let shape = shapes.get(index)?;
        if let Some(held) = system.modal.held(index) {
            return Some(Complex::new(S::constant(held), S::constant(0.0)));
        }
        if let Some(force) = chain.absorbed_force(contact, constants, modes) {
            let amplitude = chain.stuck_under(force, shape, constants, modes, contact, *inverse_r);
            return Some(Complex::new(amplitude, S::constant(0.0)));
        }
        Some(chain.stuck(shape, constants, modes, contact, *inverse_r))
    }
}

impl<S: Float> StuckAt for SystemAt<'_, S> {
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<S>>, StuckResonance> {
        Ok(self.stuck()?.mass_at(index))
    }
}

impl<S: Float> ContinuousMotion for SystemMotion<'_, S> {
    type Scalar = S;

    fn ask<T>(&self, of: Of, question: impl FnOnce(&dyn Steady<Scalar = S>) -> T) -> Option<T> {
        match of {
            Of::Contact => Some(question(&self.contact())),
            Of::Mass(index) => self.mass_at(index).map(|motion| question(&motion)),
        }
    }
}
