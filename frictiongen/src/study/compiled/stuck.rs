//! The response of a [`CompiledSystem`] while its contact is stuck.

use super::system::CompiledSystem;
use crate::Complex;
use crate::study::error::UnknownMass;
use frictiongen_kernel::Float;
use frictiongen_kernel::response::{ProvidesStuck, Stuck};
use frictiongen_kernel::table::{Sticking, TabledStuck};
use std::ops::Deref;

impl<S: Float> ProvidesStuck for &CompiledSystem<'_, S> {
    type Stuck = Stuck<Self>;
}

impl<'a, S: Float> TabledStuck for &'a CompiledSystem<'a, S> {
    type Sticking = CompiledStuck<'a, S>;

    fn holds_stuck(&self) -> bool {
        self.tables().held.is_some()
    }
    fn stuck_resonances(&self) -> &[S] {
        let held = self.tables().held.as_ref();
        held.map_or(&[], |held| &held.resonances)
    }
    fn tabled_stuck(&self, mass: usize, r: S) -> Option<Complex<S>> {
        let form = self.tables().held.as_ref()?.masses.get(mass)?;
        Some(form.response().value(r))
    }
    fn tabled_holding_force(&self, r: S) -> Option<Complex<S>> {
        Some(self.tables().held.as_ref()?.force.response().value(r))
    }
}

/// The response of a [`CompiledSystem`] at one frequency ratio while its contact is stuck.
#[derive(Clone, Debug)]
pub struct CompiledStuck<'a, S: Float = f64>(Sticking<&'a CompiledSystem<'a, S>>);

impl<'a, S: Float> CompiledStuck<'a, S> {
    /// Returns the complex amplitude of the mass called `name` while the contact is stuck, divided by P/k₁ (by Y for
    /// base motion).
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<Complex<S>, UnknownMass> {
        let system = self.at().scene().system();
        let amplitude = self.mass_at(system.mass_index(name)?);
        amplitude.ok_or_else(|| system.unknown(name))
    }
}

impl<'a, S: Float> From<Sticking<&'a CompiledSystem<'a, S>>> for CompiledStuck<'a, S> {
    fn from(response: Sticking<&'a CompiledSystem<'a, S>>) -> Self {
        Self(response)
    }
}

impl<'a, S: Float> Deref for CompiledStuck<'a, S> {
    type Target = Sticking<&'a CompiledSystem<'a, S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}
