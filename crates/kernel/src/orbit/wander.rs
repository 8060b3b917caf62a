//! Follows a motion with μ > 1 further, if the search of [`settle`](super::shooting::settle) has not found the steady
//! state in which the motion ends.
//!
//! With μ > 1 a motion may wander for thousands of cycles before it settles, or for ever. A stable steady state may
//! nevertheless exist. Newton's method finds this state from some of the states that the motion visits. The search then
//! follows the motion until the motion approaches the state, or until the largest number of cycles.
//!
//! A wandering motion may also come close to a subharmonic state. It then nearly repeats after the period of this
//! state. The search therefore starts Newton's method for the period after which the motion comes back closest.
//!
//! Only the run-time system uses this search. Emitted code does not contain it.

use super::candidate::{CandidateVerdict, FoundState, MAX_PERIOD};
use super::cycle_map::{CycleMap, EventPattern};
use super::newton::{PeriodMap, Workspace};
use super::shooting::{
    FollowedMotion, MAX_CYCLES_NEAR, Settled, place_section, settle, several, try_period,
};
use super::types::{MAX_CYCLES, MAX_STEPS};
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, ContactState};
use crate::number::scalar::Float;

/// Number of visited states that are [`NEARBY`] cycles apart. In a trial with 225 motions, more of these states gave no
/// further steady state.
const VISITS: u32 = 64;
/// Number of cycles between two visited states from which Newton's method starts.
const NEARBY: u32 = 4;
/// Number of cycles between two visited states after the first [`VISITS`] states. A motion that has reached a
/// subharmonic state repeats within this number of cycles.
const APART: u32 = MAX_PERIOD;
/// Largest distance of two states of a motion, divided by their size, at which the motion counts as coming back.
const COMES_BACK: f64 = 0.1;
/// Largest number of cycles that the search follows. Tests of a candidate may add up to 64 cycles.
pub const MAX_CYCLES_FOLLOWED: u32 = 4 * MAX_CYCLES;
/// Largest number of steps that the searches for events may take together while the motion wanders. With fewer steps,
/// the search would leave an ordinary motion of several modes before [`MAX_CYCLES_FOLLOWED`].
const MAX_STEPS_FOLLOWED: u32 = 4 * MAX_STEPS;

/// Stable steady state that the motion has not reached.
struct KnownState<S> {
    contact_state: ContactState<S>,
    /// Relative distance of this steady state from the visited state at which Newton's method started.
    far: S,
}

/// Memory for the stable steady state that is closest to a visited state.
struct Closest<'m, S> {
    known: Option<KnownState<S>>,
    /// State of the oscillators.
    state: &'m mut [S],
}

impl<S: Float> Closest<'_, S> {
    /// Keeps the steady state in the cycle map if it is closer to a visited state than the known one. `far` is its
    /// relative distance from the visited state.
    fn offer<K: ContactChain<S>>(&mut self, cycle_map: &CycleMap<'_, '_, S, K>, far: S) {
        if self.known.as_ref().is_none_or(|known| far < known.far) {
            let contact_state = cycle_map.contact_state;
            cycle_map.save(self.state);
            self.known = Some(KnownState { contact_state, far });
        }
    }
}

/// Follows the motion, and starts Newton's method from the states that the motion visits. Afterwards the cycle map
/// contains the steady state in which the motion ends. If the motion does not settle, the cycle map contains the stable
/// steady state that is closest to a visited state. If there is none, the cycle map contains a state of the motion.
///
/// The second result is true if the motion ends in the steady state. `failure` is the reason why the motion has not
/// settled yet. `holding` is that of [`FollowedMotion::new`]. `spare` is working memory for two states.
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
    let (state, end) = spare.split_at_mut(spare.len() / 2);
    let mut closest = Closest { known: None, state };
    cycle_map.step_budget = MAX_STEPS_FOLLOWED;
    let ends = match visit(cycle_map, workspace, motion, &mut closest, end) {
        Ok(Settled::Not(_)) => several(cycle_map, workspace, &mut motion.cycles, failure),
        ends => ends,
    };
    if let Ok(ends @ (Settled::Found(_) | Settled::Stuck(_))) = ends {
        return (ends, true);
    }
    if let Some(known) = closest.known {
        cycle_map.restore(closest.state, &known.contact_state);
        cycle_map.step_budget = MAX_STEPS;
        let mut motion = FollowedMotion::new(holding, false);
        let found = settle(cycle_map, workspace, &mut motion, MAX_CYCLES_NEAR, end);
        if let Ok(found @ (Settled::Found(_) | Settled::Stuck(_))) = found {
            return (found, false);
        }
    }
    (Settled::Not(failure), false)
}

/// Follows the motion until it ends in a steady state, or until the largest number of cycles. `closest` receives the
/// stable steady state that the motion has come closest to. `end` is working memory for a state.
fn visit<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    motion: &mut FollowedMotion<S>,
    closest: &mut Closest<'_, S>,
    end: &mut [S],
) -> Result<Settled<S>, NoOrbit> {
    let mut visits = 0;
    while motion.cycles < MAX_CYCLES_FOLLOWED {
        let cycles = if visits < VISITS { NEARBY } else { APART };
        visits += 1;
        let here = cycle_map.contact_state;
        cycle_map.save(workspace.state);
        match follow(cycle_map, workspace, motion, cycles)? {
            Followed::Sticks(offset) => return Ok(Settled::Stuck(offset)),
            Followed::Moves(None) => {}
            Followed::Moves(Some(back)) => {
                let last = cycle_map.contact_state;
                cycle_map.save(end);
                cycle_map.restore(workspace.state, &here);
                let found = subharmonic(cycle_map, workspace, back, motion.cycles, closest)?;
                if let Some(found) = found {
                    return Ok(Settled::Found(found));
                }
                cycle_map.restore(end, &last);
            }
        }
        place_section(cycle_map)?;
        for symmetric in [true, false] {
            let mut candidate = motion.candidate(cycle_map, workspace, symmetric);
            let verdict = candidate.try_from(cycle_map, workspace);
            motion.cycles = candidate.cycles;
            match verdict {
                Ok(CandidateVerdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(CandidateVerdict::Apart { far }) => closest.offer(cycle_map, far),
                _ => {}
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
    }
    Ok(Settled::Not(NoOrbit::Unsettled))
}

/// Result of following a motion for some cycles.
enum Followed<S> {
    /// The contact sticks for ever, at this relative displacement z̄.
    Sticks(S),
    /// The period in cycles after which the motion has come back closest to its first state, with the events of this
    /// period. `None` if the motion has not come back, or comes back in one cycle.
    Moves(Option<(u32, EventPattern)>),
}

/// Follows the motion for some cycles. The caller has saved the first state in `workspace.state`.
fn follow<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &Workspace<'_, S>,
    motion: &mut FollowedMotion<S>,
    cycles: u32,
) -> Result<Followed<S>, NoOrbit> {
    let mut total = EventPattern::default();
    let mut nearest = cycle_map.scale() * S::constant(COMES_BACK);
    let mut back = None;
    for period in 1..=cycles {
        if let Some(offset) = motion.follow(cycle_map, motion.cycles + 1)? {
            return Ok(Followed::Sticks(offset));
        }
        total = total.and(motion.last_cycle());
        let distance = cycle_map.distance(workspace.state);
        if distance < nearest {
            (nearest, back) = (distance, Some((period, total)));
        }
    }
    Ok(Followed::Moves(back.filter(|(period, _)| *period > 1)))
}

/// Starts Newton's method from the state of the cycle map, which comes back after the period `back` with its events.
/// `closest` receives a stable steady state that the motion does not approach.
fn subharmonic<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    (period, total): (u32, EventPattern),
    cycles: u32,
    closest: &mut Closest<'_, S>,
) -> Result<Option<FoundState<S>>, NoOrbit> {
    for symmetric in [true, false] {
        let map = PeriodMap { period, symmetric };
        let tried = try_period(cycle_map, workspace, map, total, cycles)?;
        let Some((candidate, verdict)) = tried else {
            continue;
        };
        match verdict {
            Ok(CandidateVerdict::Found(found)) => return Ok(Some(found)),
            Ok(CandidateVerdict::Apart { far }) => closest.offer(cycle_map, far),
            _ => {}
        }
        cycle_map.restore(workspace.state, &candidate.here);
    }
    Ok(None)
}
