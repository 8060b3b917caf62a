//! Initial states from which the search follows a motion to its steady state.

use super::closed;
use super::cycle_map::CycleMap;
use super::newton::Workspace;
use super::types::MAX_STEPS;
use crate::errors::{NoOrbit, OutOfDomain};
use crate::motion::ContactChain;
use crate::number::scalar::Float;

/// Number of cycles that a motion runs at a neighbouring friction ratio before it continues at the given β.
const NEIGHBOURING: u32 = 64;

/// Initial state of a motion. The excitation is then at its maximum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start<'s, S> {
    /// Every mass has the displacement x̄ = 0 and no velocity. A contact that never slides is then answered in the
    /// middle of its interval, as [`At::orbit`](crate::response::At::orbit) describes.
    Rest,
    /// The masses have the given displacements x̄ (first slice) and velocities dx̄/dτ (second slice).
    State(&'s [S], &'s [S]),
    /// The masses have the given displacements and velocities, as of [`State`](Self::State), and the motion repeats after
    /// this number of cycles, stable or not. No motion is followed to it.
    Cycle(&'s [S], &'s [S], u32),
    /// The contact sticks at z̄ = 0. This state exists for β ≥ β*_lim.
    Stuck,
    /// The state of the closed form at the given friction ratio. The search may have another β. The motion from this
    /// state then differs from the closed form.
    ClosedForm(S),
    /// The state of a motion from rest that has run at the given neighbouring friction ratio for some cycles.
    Neighbour(S),
}

impl<S: Float> Start<'_, S> {
    /// Sets the oscillators and the contact of the cycle map to this initial state. The initial state `Stuck` does not
    /// use this function.
    pub(super) fn set_start<K: ContactChain<S>>(
        self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        workspace: &mut Workspace<'_, S>,
    ) -> Result<(), NoOrbit> {
        let (zero, setting) = (S::constant(0.0), cycle_map.setting);
        match self {
            Self::Rest | Self::Stuck => {}
            Self::State(displacements, velocities) | Self::Cycle(displacements, velocities, _) => {
                setting.check_state((displacements, velocities))?;
                setting.load_state(displacements, velocities, cycle_map.modes);
                cycle_map.contact_state = setting.contact_state(cycle_map.modes, zero);
            }
            Self::ClosedForm(beta) => {
                closed::set(cycle_map, beta);
                cycle_map.check_finite()?;
                if beta != setting.beta {
                    let t = cycle_map.contact_state.t;
                    cycle_map.contact_state = setting.contact_state(cycle_map.modes, t);
                }
            }
            Self::Neighbour(beta) => {
                let mut neighbour = *setting;
                neighbour.beta = beta;
                let mut there = CycleMap {
                    setting: &neighbour,
                    modes: &mut *cycle_map.modes,
                    stuck_modes: &mut *cycle_map.stuck_modes,
                    step_budget: MAX_STEPS,
                    ..*cycle_map
                };
                there.contact_state = neighbour.contact_state(there.modes, zero);
                for _ in 0..2 * NEIGHBOURING {
                    there.advance_half(None)?;
                }
                there.save(workspace.state);
                let contact_state = there.contact_state;
                cycle_map.restore(workspace.state, &contact_state);
                cycle_map.check_finite()?;
            }
        }
        Ok(())
    }

    /// Returns this initial state, or an error if it does not exist at the given β. `holds` is true if a stuck state
    /// exists at this β.
    pub(super) fn checked(self, holds: bool) -> Result<Self, OutOfDomain> {
        if self == Self::Stuck && !holds {
            return Err(OutOfDomain::StuckStart);
        }
        Ok(self)
    }
}
