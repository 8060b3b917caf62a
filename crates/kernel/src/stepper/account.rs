//! Energy balance of a stepper: the work of the load, and the dissipated and stored energy since the start.

use super::law::StepContact;
use super::state::Store;
use super::table::StepTables;
use super::types::Stepper;
use crate::errors::OutOfDomain;
use crate::number::scalar::Float;

/// Energy balance of a stepper since its start: the work of the load, the dissipated energy and the stored energy. The
/// unit of these numbers is the scene's unit of force times its unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Work<S> {
    /// Work that the forces on the masses and the moving base have done on the chain since the start.
    pub load: S,
    /// Energy that friction in the contact has dissipated since the start.
    pub friction: S,
    /// Energy that modal damping has dissipated since the start. The code does not integrate this energy. It computes
    /// the work of the load, minus the energy that friction has dissipated, minus the stored energy.
    pub damping: S,
    /// Increase of the chain's kinetic and elastic energy since the start.
    pub stored: S,
}

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns the energy balance of the chain since the start.
    #[must_use]
    pub fn work(&self) -> Work<S> {
        let stiffness = self.scene.units.stiffness;
        let stored = self.energy() - self.status.energy;
        let pulled = self.pull() - self.status.pull;
        let stored = stored + pulled;
        let load = self.status.load.value + pulled;
        let friction = self.status.dissipated.value;
        Work {
            load: load * stiffness,
            friction: friction * stiffness,
            damping: (load - friction - stored) * stiffness,
            stored: stored * stiffness,
        }
    }

    /// Returns an error if the work since the start is so large that one more step could overflow the number type.
    pub(super) fn check_work(&self) -> Result<(), OutOfDomain> {
        let (_, most) = S::inverse_ratio_range();
        let status = &self.status;
        let work = status.load.value.abs().max(status.dissipated.value.abs());
        if work * self.scene.units.stiffness <= most * most {
            Ok(())
        } else {
            Err(OutOfDomain::Work)
        }
    }

    /// Returns the kinetic and elastic energy of the chain, divided by k₁. The result does not contain the elastic
    /// energy that the displacement of the base causes, which [`pull`](Self::pull) returns.
    pub(super) fn energy(&self) -> S {
        let half = S::constant(0.5);
        let modes = self.scene.dynamics.modes.iter().enumerate();
        let sum = modes.fold(S::constant(0.0), |sum, (index, mode)| {
            let [y, rate] = self.mode(index);
            sum + rate * rate + mode.resonance * mode.resonance * y * y
        });
        let chain = &self.scene.dynamics.chain;
        if 0 < chain.remembered() {
            // The spring of an elastic contact stores energy too.
            let force = self.status.contact_force;
            return (sum + chain.compliance() * force * force) * half;
        }
        sum * half
    }

    /// Returns the elastic energy that the displacement of the base adds to the springs between masses and base,
    /// divided by k₁.
    pub(super) fn pull(&self) -> S {
        let zero = S::constant(0.0);
        if !self.scene.on_base {
            return zero;
        }
        let modes = self.scene.dynamics.modes;
        let pulled = self.sum(|mode| modes.get(mode).map_or(zero, |mode| mode.load));
        let [place, _] = self.status.base;
        let half = S::constant(0.5) * self.scene.units.support;
        place * (half * place - pulled.displacement())
    }
}
