//! Saves and restores the state of a stepper.

use super::input::Input;
use super::law::StepContact;
use super::state::{Status, Store};
use super::table::{StepTables, View};
use super::types::Stepper;
use crate::errors::OutOfDomain;
use crate::number::scalar::Float;

/// Saved state of a stepper without its tables. [`Stepper::save`](super::Stepper::save) returns it.
///
/// With the feature `serde`, serde can write and read a saved state. Reading fails for a state in another version of
/// the format.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saved<S, V> {
    pub(super) status: Status<S>,
    pub(super) store: V,
    /// Hash of the scene and of the time step. `Stepper::mark` computes it.
    pub(super) mark: u64,
}

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns the present state of the stepper. [`restore`](Self::restore) continues the run from this state.
    #[must_use]
    pub fn save(&self) -> Saved<S, V>
    where
        V: Clone,
    {
        Saved {
            status: self.status,
            store: self.store.clone(),
            mark: self.mark(),
        }
    }

    /// Restores a saved state of the stepper. From this state, the same inputs give the same results to the last bit.
    ///
    /// # Errors
    /// [`OutOfDomain::Saved`] if the state comes from a stepper with another scene or time step. A hash of the scene
    /// and the time step detects the difference.
    pub fn restore(&mut self, saved: &Saved<S, V>) -> Result<(), OutOfDomain>
    where
        V: Clone,
    {
        let size = |store: &V| {
            let store = store.read();
            (store.modes.len(), store.held.len(), store.last.len())
        };
        let other = size(&self.store) != size(&saved.store) || self.mark() != saved.mark;
        if other || self.scene.law.len() < saved.status.line {
            return Err(OutOfDomain::Saved);
        }
        self.status = saved.status;
        self.store = saved.store.clone();
        Ok(())
    }

    /// Returns a hash of the scene (with its units and loads) and of the time step. A saved state is valid only for the
    /// same scene and time step.
    pub(super) fn mark(&self) -> u64 {
        let View {
            pace,
            modes,
            held,
            loads,
            ..
        } = self.tables.view();
        let (scene, units) = (&self.scene, &self.scene.units);
        let mut hash = Hash::new();
        hash.count(usize::from(scene.on_base));
        hash.count(usize::from(scene.input == Input::Linear));
        hash.number(units.stiffness).number(units.rate);
        hash.number(units.support).number(pace.step);
        hash.number(scene.dynamics.chain().inverse_mass);
        for mass in scene.forces {
            hash.count(*mass);
        }
        for [speed, level] in scene.law {
            hash.number(*speed).number(*level);
        }
        for mode in modes {
            hash.number(mode.angle).number(mode.zeta);
            hash.number(mode.contact);
        }
        for mode in held {
            hash.number(mode.angle).number(mode.force);
        }
        for load in loads {
            hash.number(*load);
        }
        if 0 < scene.dynamics.chain.remembered() {
            hash.number(scene.dynamics.chain.compliance());
        }
        hash.0
    }
}

/// Hash of numbers by the algorithm FNV-1a, for words of 64 bits. After each word the code combines the upper half of
/// the hash with its lower half.
pub(crate) struct Hash(pub(crate) u64);

impl Hash {
    pub(crate) fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) fn word(&mut self, word: u64) -> &mut Self {
        let mixed = (self.0 ^ word).wrapping_mul(0x0100_0000_01b3);
        // In a product, carries go only to higher bits. The code must therefore combine the upper half with the lower
        // half.
        self.0 = mixed ^ (mixed >> 32);
        self
    }

    pub(crate) fn number<S: Float>(&mut self, number: S) -> &mut Self {
        self.word(number.bits())
    }

    pub(crate) fn count(&mut self, count: usize) -> &mut Self {
        self.word(u64::try_from(count).unwrap_or(u64::MAX))
    }
}
