//! Follows a motion with μ > 1 further, if the search of [`settle`](super::shooting::settle) has not found the steady
//! state in which the motion ends.
//!
//! With μ > 1 a motion may wander for thousands of cycles before it settles, or for ever. A stable steady state may
//! nevertheless exist. Newton's method finds this state from some of the states that the motion visits. The search then
//! follows the motion until the motion approaches the state, or until the largest number of cycles.
//!
//! Only the run-time system uses this search. Emitted code does not contain it.

use super::candidate::CandidateVerdict;
use super::cycle_map::CycleMap;
use super::newton::Workspace;
use super::shooting::{FollowedMotion, MAX_CYCLES_NEAR, Settled, place_section, settle, several};
use super::types::{MAX_CYCLES, MAX_STEPS};
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, ContactState};
use crate::number::scalar::Float;

/// Number of visited states that are [`NEARBY`] cycles apart. In a trial with 225 motions, more of these states gave no
/// further steady state.
const VISITS: u32 = 64;
/// Number of cycles between two visited states from which Newton's method starts.
const NEARBY: u32 = 4;
/// Number of cycles between two visited states after the first [`VISITS`] states.
const APART: u32 = 32;
/// Largest number of cycles that the search follows while it knows no stable steady state.
const MAX_CYCLES_ALONE: u32 = 2 * MAX_CYCLES;
/// Largest number of cycles that the search follows if it knows a stable steady state, in which the motion may end.
/// Tests of a candidate may add up to 64 cycles.
pub const MAX_CYCLES_FOLLOWED: u32 = 4 * MAX_CYCLES;

/// Stable steady state that the motion has not reached. Working memory contains the state of the oscillators.
struct KnownState<S> {
    contact_state: ContactState<S>,
    /// Relative distance of this steady state from the visited state at which Newton's method started.
    far: S,
}

/// Follows the motion, and starts Newton's method from the states that the motion visits. Afterwards the cycle map
/// contains the steady state in which the motion ends. If the motion does not settle, the cycle map contains the stable
/// steady state that is closest to a visited state. If there is none, the cycle map contains a state of the motion.
///
/// The second result is true if the motion ends in the steady state. `failure` is the reason why the motion has not
/// settled yet. `holding` is that of [`FollowedMotion::new`]. `spare` is working memory for at least one state.
pub(super) fn wander<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    (motion, holding): (&mut FollowedMotion<S>, Option<S>),
    failure: NoOrbit,
    spare: &mut [S],
) -> (Settled<S>, bool) {
    // With μ = 1 every motion approaches every stable steady state, so that Newton's method has nothing else to find.
    if motion.monotone {
        return (Settled::Not(failure), false);
    }
    // A state vector contains the force of an elastic contact only if the slice has exactly the length of a state.
    let memory = spare.get_mut(..cycle_map.size()).unwrap_or_default();
    cycle_map.step_budget = MAX_STEPS;
    let mut known = None;
    let ends = match visit(cycle_map, workspace, motion, (&mut known, memory)) {
        Ok(Settled::Not(_)) => several(cycle_map, workspace, &mut motion.cycles, failure),
        ends => ends,
    };
    if let Ok(ends @ (Settled::Found(_) | Settled::Stuck(_))) = ends {
        return (ends, true);
    }
    if let Some(known) = known {
        cycle_map.restore(memory, &known.contact_state);
        cycle_map.step_budget = MAX_STEPS;
        let mut motion = FollowedMotion::new(holding, false);
        let found = settle(cycle_map, workspace, &mut motion, MAX_CYCLES_NEAR, memory);
        if let Ok(found) = found {
            return (found, false);
        }
    }
    (Settled::Not(failure), false)
}

/// Follows the motion until it ends in a steady state, or until the largest number of cycles. `known` receives the
/// stable steady state that the motion has come closest to, and the slice receives the state of its oscillators.
fn visit<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    motion: &mut FollowedMotion<S>,
    (known, memory): (&mut Option<KnownState<S>>, &mut [S]),
) -> Result<Settled<S>, NoOrbit> {
    let mut visits = 0;
    loop {
        let most = if known.is_some() {
            MAX_CYCLES_FOLLOWED
        } else {
            MAX_CYCLES_ALONE
        };
        if most <= motion.cycles {
            return Ok(Settled::Not(NoOrbit::Unsettled));
        }
        let cycles = if visits < VISITS { NEARBY } else { APART };
        visits += 1;
        if let Some(offset) = motion.follow(cycle_map, motion.cycles + cycles)? {
            return Ok(Settled::Stuck(offset));
        }
        place_section(cycle_map)?;
        for symmetric in [true, false] {
            let mut candidate = motion.candidate(cycle_map, workspace, symmetric);
            let verdict = candidate.try_from(cycle_map, workspace);
            motion.cycles = candidate.cycles;
            match verdict {
                Ok(CandidateVerdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(CandidateVerdict::Apart { far })
                    if known.as_ref().is_none_or(|known| far < known.far) =>
                {
                    let contact_state = cycle_map.contact_state;
                    cycle_map.save(memory);
                    *known = Some(KnownState { contact_state, far });
                }
                _ => {}
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
    }
}
