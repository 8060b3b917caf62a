//! Searches for the steady state as a fixed point of a map. The map advances a state by one period, or by half a
//! period with a change of sign. The period is one or several cycles of the excitation.

use super::candidate::{Candidate, CandidateVerdict, FoundState, MAX_PERIOD};
use super::cycle_map::{CycleMap, EventPattern};
use super::hold::Hold;
use super::newton::{PeriodMap, Workspace, same};
use super::relaxed::relax;
use super::start::Start;
use super::types::MAX_CYCLES;
use crate::errors::NoOrbit;
use crate::motion::ContactChain;
use crate::number::scalar::Float;

/// Largest number of cycles that the search follows from an initial state that may be near a steady state. Initial
/// states of this kind are the stuck state, the closed form, and a motion at a neighbouring friction ratio.
pub(super) const MAX_CYCLES_NEAR: u32 = 128;
/// Largest number of possible periods that one search for a subharmonic state tests.
const MOST_TRIED: u32 = 3;
/// Number of cycles that the search follows before it first tests for a subharmonic state.
const FIRST_ASKED: u32 = 16;
/// Limit for a possible period n: the largest difference between two states n cycles apart, divided by the size of the
/// motion.
const NEARLY_BACK: f64 = 1e-2;
/// Limit for a possible period n: the largest distance between two states n cycles apart, divided by the smallest
/// distance after fewer than n cycles. The limit is small, so that n cycles bring the motion much closer to its
/// present state than any smaller number of cycles.
const NEARER: f64 = 0.1;

impl<S> Start<'_, S> {
    /// Returns the largest number of cycles that the search follows from this initial state.
    pub(super) fn most_cycles(&self) -> u32 {
        match self {
            Self::Rest | Self::State(..) | Self::Cycle(..) => MAX_CYCLES,
            Self::Stuck | Self::ClosedForm(_) | Self::Neighbour(_) => MAX_CYCLES_NEAR,
        }
    }
}

/// Result of a search that follows a motion towards its steady state.
pub(super) enum Settled<S> {
    Found(FoundState<S>),
    /// The contact sticks for ever, at this relative displacement z̄.
    Stuck(S),
    /// The search found no steady state before it reached its largest number of cycles. The [`NoOrbit`] gives the
    /// reason.
    Not(NoOrbit),
}

/// Motion that the search follows: the number of its cycles, and the events of its last half cycles.
pub(super) struct FollowedMotion<S> {
    /// Observer of a contact that may stick for ever. `None` if β is too small for a stuck state.
    hold: Option<Hold<S>>,
    /// True if the stiction μ is 1. The distance between two motions then never grows.
    pub monotone: bool,
    /// Number of excitation cycles that the search has followed.
    pub cycles: u32,
    halves: [EventPattern; 4],
    /// Numbers of successive half cycles with unchanged events. The first number counts half cycles with the events of
    /// the previous half cycle. The second number counts half cycles with the events of the half cycle one cycle
    /// earlier.
    settled: [u32; 2],
}

impl<S: Float> FollowedMotion<S> {
    /// Creates the record of a motion that has not moved yet. If β is large enough for a stuck state, `holding` is
    /// |V/H|, the amplitude of the contact force in the stuck state. Otherwise `holding` is `None`.
    pub(super) fn new(holding: Option<S>, monotone: bool) -> Self {
        Self {
            hold: holding.map(|steady| Hold::new(steady, monotone)),
            monotone,
            cycles: 0,
            halves: [EventPattern::default(); 4],
            settled: [0; 2],
        }
    }

    /// Returns the offset z̄ of a contact that sticks for ever, or `None`.
    fn lasting_offset<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
    ) -> Option<S> {
        let hold = self.hold.as_mut()?;
        hold.lasting_offset(cycle_map)
    }

    /// Follows the motion until it has `wanted` cycles. If the contact starts to stick for ever, the function returns
    /// the contact's offset z̄.
    pub(super) fn follow<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        wanted: u32,
    ) -> Result<Option<S>, NoOrbit> {
        while self.cycles < wanted {
            for _ in 0..2 {
                let half = cycle_map.advance_half(None)?;
                let [a, b, c, _] = self.halves;
                self.halves = [half, a, b, c];
                let count = |same: bool, count: u32| if same { count + 1 } else { 0 };
                self.settled = [
                    count(half == a, self.settled[0]),
                    count(half == b, self.settled[1]),
                ];
                if let Some(hold) = &mut self.hold {
                    hold.note(half);
                    if let Some(offset) = hold.lasting_offset(cycle_map) {
                        return Ok(Some(offset));
                    }
                }
            }
            self.cycles += 1;
        }
        Ok(None)
    }

    /// Returns the events of the last cycle.
    pub(super) fn last_cycle(&self) -> EventPattern {
        let [last, before, ..] = self.halves;
        last.and(before)
    }

    /// Returns the candidate for a steady state that repeats after one cycle. The search starts at the present state of
    /// the motion, which the function saves in `workspace.state`.
    pub(super) fn candidate<K: ContactChain<S>>(
        &self,
        cycle_map: &CycleMap<'_, '_, S, K>,
        workspace: &mut Workspace<'_, S>,
        symmetric: bool,
    ) -> Candidate<S> {
        cycle_map.save(workspace.state);
        let [last, before, ..] = self.halves;
        Candidate {
            map: PeriodMap {
                period: 1,
                symmetric,
            },
            wanted: if symmetric { last } else { last.and(before) },
            recent: last.and(before),
            alike: self.settled[1],
            monotone: self.monotone,
            cycles: self.cycles,
            here: cycle_map.contact_state,
        }
    }
}

/// Moves the section (the phase at which the map starts) to the middle of the longest segment, far from all events.
pub(super) fn place_section<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
) -> Result<(), NoOrbit> {
    let middle = cycle_map.middle * S::pi();
    cycle_map.advance(middle, None)?;
    Ok(())
}

/// Follows the motion until it reaches a steady state. Afterwards the cycle map contains the steady state if the search
/// found one. Otherwise it contains the last state of the motion.
///
/// The search follows at most `most` cycles. `spare` is working memory for two states.
pub(super) fn settle<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    motion: &mut FollowedMotion<S>,
    most: u32,
    spare: &mut [S],
) -> Result<Settled<S>, NoOrbit> {
    let monotone = motion.monotone;
    if let Some(offset) = motion.lasting_offset(cycle_map) {
        return Ok(Settled::Stuck(offset));
    }
    let mut failure = NoOrbit::Unsettled;
    let mut wanted = 2;
    while motion.cycles < most {
        if let Some(offset) = motion.follow(cycle_map, wanted)? {
            return Ok(Settled::Stuck(offset));
        }
        if monotone && motion.hold.is_some() {
            // With μ = 1 the distance between two motions never grows. Because a stuck state exists, no other state can
            // be steady.
            wanted = motion.cycles * 2;
            continue;
        }
        place_section(cycle_map)?;
        for symmetric in [true, false] {
            let [in_half, in_cycle] = motion.settled;
            let steady = if symmetric { in_half } else { in_cycle };
            if !monotone && steady == 0 {
                continue;
            }
            let mut candidate = motion.candidate(cycle_map, workspace, symmetric);
            let verdict = candidate.try_from(cycle_map, workspace);
            motion.cycles = candidate.cycles;
            match verdict {
                Ok(CandidateVerdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(CandidateVerdict::Wait) => {
                    cycle_map.restore(workspace.state, &candidate.here);
                    break;
                }
                Ok(CandidateVerdict::Apart { .. } | CandidateVerdict::No) => {}
                Err(error) => failure = error,
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
        // With μ = 1 the distance between two motions never grows. A motion that repeats only after several cycles
        // therefore belongs to a continuum of steady states.
        if FIRST_ASKED <= motion.cycles && (!monotone || most <= motion.cycles * 2) {
            match several(cycle_map, workspace, &mut motion.cycles, failure)? {
                Settled::Not(error) => failure = error,
                found => return Ok(found),
            }
        }
        wanted = motion.cycles * 2;
    }
    if monotone
        && motion.hold.is_none()
        && cycle_map.remembered() == 0
        && let Some(found) = slow(cycle_map, workspace, motion.halves, spare)
    {
        return Ok(Settled::Found(found));
    }
    Ok(Settled::Not(failure))
}

/// Finds the only steady state of a scene with μ = 1, if the motion approaches it very slowly. If the function finds no
/// steady state, the cycle map keeps the state of the motion.
fn slow<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    [last, before, ..]: [EventPattern; 4],
    spare: &mut [S],
) -> Option<FoundState<S>> {
    let here = cycle_map.contact_state;
    let (motion, taken) = spare.split_at_mut(spare.len() / 2);
    cycle_map.save(motion);
    let mut candidate = Candidate {
        map: PeriodMap::HALF_CYCLE,
        wanted: last,
        recent: last.and(before),
        alike: 0,
        monotone: true,
        cycles: MAX_CYCLES,
        here,
    };
    if relax(cycle_map, workspace, taken).is_ok() {
        cycle_map.save(workspace.state);
        candidate.here = cycle_map.contact_state;
        if let Ok(CandidateVerdict::Found(found)) = candidate.try_from(cycle_map, workspace) {
            return Some(found);
        }
    }
    cycle_map.restore(motion, &here);
    None
}

/// Finds a steady state close to the motion that repeats after several cycles. If the function finds no steady state,
/// the cycle map keeps the state of the motion.
pub(super) fn several<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    cycles: &mut u32,
    mut failure: NoOrbit,
) -> Result<Settled<S>, NoOrbit> {
    let mut after = 1;
    for _ in 0..MOST_TRIED {
        let most = MAX_PERIOD.min(*cycles);
        let Some((period, total)) = comes_back(cycle_map, workspace, cycles, after, most)? else {
            break;
        };
        for symmetric in [true, false] {
            let map = PeriodMap { period, symmetric };
            let tried = try_period(cycle_map, workspace, map, total, *cycles)?;
            let Some((candidate, verdict)) = tried else {
                continue;
            };
            *cycles = candidate.cycles;
            match verdict {
                Ok(CandidateVerdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(_) => {}
                Err(error) => failure = error,
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
        after = period;
    }
    Ok(Settled::Not(failure))
}

/// Candidate for a steady state, and the result of its test.
type Tried<S> = (Candidate<S>, Result<CandidateVerdict<S>, NoOrbit>);

/// Tests whether the motion is near a steady state with the period of `map`. The function saves the state of the motion
/// in `workspace.state`. `total` contains the events of the motion during the period, and `cycles` the number of its
/// cycles. Returns `None` if a symmetric map cannot have these events.
pub(super) fn try_period<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    map: PeriodMap,
    total: EventPattern,
    cycles: u32,
) -> Result<Option<Tried<S>>, NoOrbit> {
    let Some(wanted) = wanted(total, map.symmetric, map.period) else {
        return Ok(None);
    };
    cycle_map.save(workspace.state);
    let mut candidate = Candidate {
        map,
        wanted,
        recent: total,
        alike: 0,
        monotone: false,
        cycles,
        here: cycle_map.contact_state,
    };
    let mut verdict = candidate.try_from(cycle_map, workspace);
    if matches!(verdict, Ok(CandidateVerdict::Found(_)))
        && let Some(sooner) = repeats_sooner(cycle_map, workspace, map.period)?
    {
        // The search tries the same state again. The period is now the smaller number of cycles.
        candidate.map.period = sooner;
        verdict = match candidate
            .wanted
            .divided(map.period.checked_div(sooner).unwrap_or(1))
        {
            Some(wanted) => {
                candidate.wanted = wanted;
                candidate.try_from(cycle_map, workspace)
            }
            None => Ok(CandidateVerdict::No),
        };
    }
    Ok(Some((candidate, verdict)))
}

/// Returns the smallest number of cycles below `period` after which the motion of the fixed point repeats. Returns
/// `None` if no smaller number exists. This test is necessary because a slowly decaying free vibration can look like a
/// longer period. The cycle map is at the fixed point before and after the call.
fn repeats_sooner<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    period: u32,
) -> Result<Option<u32>, NoOrbit> {
    let contact_state = cycle_map.contact_state;
    cycle_map.save(workspace.other);
    let limit = same(cycle_map.scale());
    let mut sooner = None;
    for cycles in 1..period {
        cycle_map.advance_half(None)?;
        cycle_map.advance_half(None)?;
        if sooner.is_none() && cycle_map.distance(workspace.other) <= limit {
            sooner = Some(cycles);
        }
    }
    cycle_map.restore(workspace.other, &contact_state);
    Ok(sooner)
}

/// Finds the number of cycles after which the motion returns close to its present state, with the events during these
/// cycles. The number is more than `after` and at most `most`. No smaller number of cycles brings the motion as close.
/// Returns `None` if no such number exists.
fn comes_back<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    cycles: &mut u32,
    after: u32,
    most: u32,
) -> Result<Option<(u32, EventPattern)>, NoOrbit> {
    let mut total = EventPattern::default();
    cycle_map.save(workspace.state);
    let mut near = cycle_map.scale() * S::constant(NEARLY_BACK);
    for period in 1..=most {
        total = total
            .and(cycle_map.advance_half(None)?)
            .and(cycle_map.advance_half(None)?);
        *cycles += 1;
        let distance = cycle_map.distance(workspace.state);
        if period > after && distance <= near {
            return Ok(Some((period, total)));
        }
        near = near.min(distance * S::constant(NEARER));
    }
    Ok(None)
}

/// Returns the events during one application of a map, for a whole period with the events `total`. A symmetric map
/// advances a state by half a period, with half of the events. If the period has an even number of cycles, the load has
/// the same sign after half a period. No symmetric map then exists, and the result is `None`.
fn wanted(total: EventPattern, symmetric: bool, period: u32) -> Option<EventPattern> {
    if !symmetric {
        return Some(total);
    }
    if period.is_multiple_of(2) {
        return None;
    }
    total.divided(2)
}
