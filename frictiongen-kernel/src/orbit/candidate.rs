//! Tests whether a motion is near a fixed point of the half-period or period map, and whether the motion tends to that
//! point.

use super::cycle_map::{CycleMap, EventPattern};
use super::newton::{PeriodMap, Workspace, multipliers, newton, same};
use super::{closed, continuum};
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, ContactState};
use crate::number::scalar::Float;

/// Distance from the unit circle, in roundings, below which a multiplier counts as lying on the circle.
pub(super) const ON_CIRCLE: f64 = 4096.0;

/// Upper bound on the period of a subharmonic motion, in cycles of the excitation.
pub const MAX_PERIOD: u32 = 64;

/// Upper bound on the cycles of a motion that the test follows to see whether the motion approaches a fixed point.
const MOST_FOLLOWED: u32 = 64;

/// Upper bound on the size of a marginal state over the size of the motion that tends to it.  The motion counts as at
/// least P/k₁. Away from a resonance both sizes are of the order of the excitation.
const MOST_GROWN: f64 = 64.0;

/// Number of successive equal half cycles, with at most two stops or reversals a cycle, after which a motion counts as
/// tending to a member of a continuum.  A motion with more events may still end elsewhere.
const CALM: u32 = 64;

/// The test stops following when the multipliers predict that the distance from the fixed point has fallen to this
/// fraction.
const FAR_ENOUGH: f64 = 0.01;
/// Allowance: the distance from the fixed point may fall by this fraction less than the multipliers predict.
const SPARE: f64 = 0.1;
/// Largest relative difference of the sticking times of two motions that count as having the same stops.
const STICKS_ALIKE: f64 = 0.25;
/// Distance from the fixed point, relative to the state, below which the motion counts as having reached it.
const REACHED: f64 = 1e-9;
/// Distance from the fixed point, in P/k₁, below which the contact hardly moves, so that rounding decides its motion.
const HARDLY_MOVES: f64 = 1e-6;
/// Lower bound on the cycles of a motion that the search follows before it chooses a member of a continuum.
const LEAST_FOLLOWED: u32 = 64;

/// Events of half a cycle of continuous motion: one reversal.
const ONE_REVERSAL: EventPattern = EventPattern {
    stops: 0,
    reversals: 1,
    slips: 0,
};

/// Properties of a steady state that the search has found.
#[derive(Clone, Copy, Debug)]
pub(super) struct FoundState<S> {
    /// True if the motion repeats.
    pub settled: bool,
    /// Period in cycles of the excitation.
    pub period: u32,
    /// True if the motion after half a period is the opposite of the motion before.
    pub symmetric: bool,
    /// True if the state is a member of a continuum of steady states, or at the end of one.
    pub marginal: bool,
    /// Offset of the last member of a continuum over the offset of this member.
    pub reach: Option<S>,
}

impl<S> FoundState<S> {
    /// Properties of a motion that does not repeat, of which only the last cycles are known.
    pub(super) const NONE: Self = Self {
        settled: false,
        period: MAX_PERIOD,
        symmetric: false,
        marginal: false,
        reach: None,
    };
}

/// Result of the test of a fixed point.
pub(super) enum CandidateVerdict<S> {
    Found(FoundState<S>),
    /// The fixed point belongs to a continuum, and the motion must be followed further to select the member.
    Wait,
    No,
}

pub(super) struct Candidate<S> {
    pub map: PeriodMap,
    /// Events of the motion during the last map.
    pub wanted: EventPattern,
    /// Events of the motion in the last cycle.
    pub recent: EventPattern,
    /// Number of successive half cycles with the same events as a cycle before.
    pub alike: u32,
    /// True if μ = 1.
    pub monotone: bool,
    /// Number of cycles followed since the start of the motion.
    pub cycles: u32,
    /// State of the contact in the motion.  `Workspace::state` has the oscillators of the motion.
    pub here: ContactState<S>,
}

impl<S: Float> Candidate<S> {
    pub fn try_from<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        workspace: &mut Workspace<'_, S>,
    ) -> Result<CandidateVerdict<S>, NoOrbit> {
        let Some(pattern) = newton(cycle_map, workspace, self.map)? else {
            return Ok(CandidateVerdict::No);
        };
        let scale = cycle_map.scale();
        let far = cycle_map.distance(workspace.state);
        let largest = multipliers(cycle_map, workspace, self.map)?;
        let one = S::constant(1.0);
        let margin = S::constant(ON_CIRCLE * S::EPSILON);
        if one + margin < largest {
            return Err(NoOrbit::Unstable);
        }
        let on_circle = one - margin < largest;
        if on_circle {
            return self.marginal(cycle_map, workspace, far, scale, self.cycles);
        }
        // With μ = 1 the distance of two motions never grows.  The fixed point is therefore the state to which the
        // motion tends.
        let near = far <= same(scale);
        let same = pattern == self.wanted;
        if self.monotone || (same && (near || self.attracts(cycle_map, workspace, largest)?)) {
            if self.map.symmetric && self.map.period == 1 && pattern == ONE_REVERSAL {
                closed::set(cycle_map, cycle_map.setting.beta);
            }
            return Ok(CandidateVerdict::Found(FoundState {
                settled: true,
                period: self.map.period,
                symmetric: self.map.symmetric,
                marginal: false,
                reach: None,
            }));
        }
        Ok(CandidateVerdict::No)
    }

    /// Returns true if the motion keeps its events and approaches the fixed point as fast as the multipliers predict.
    /// With μ > 1 other steady states may be close.  The cycle map is at the fixed point before and after a true
    /// result.
    fn attracts<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        workspace: &mut Workspace<'_, S>,
        largest: S,
    ) -> Result<bool, NoOrbit> {
        let (fixed, stuck) = (cycle_map.contact_state, cycle_map.stuck);
        cycle_map.save(workspace.other);
        cycle_map.restore(workspace.state, &self.here);
        let before = cycle_map.energy_between(workspace.other);
        let rate = if self.map.symmetric {
            largest * largest
        } else {
            largest
        };
        let mut promised = S::constant(1.0);
        let mut cycles = 0;
        let mut keeps = true;
        while keeps && cycles < MOST_FOLLOWED && S::constant(FAR_ENOUGH) < promised {
            // Each turn of the loop follows one whole period.
            let maps = if self.map.symmetric { 2 } else { 1 };
            for _ in 0..maps {
                let mut pattern = EventPattern::default();
                for _ in 0..self.map.halves() {
                    pattern = pattern.and(cycle_map.advance_half(None)?);
                }
                keeps = keeps && pattern == self.wanted;
            }
            promised = promised * rate;
            cycles += self.map.period;
        }
        self.cycles += cycles;
        self.here = cycle_map.contact_state;
        cycle_map.save(workspace.state);
        let after = cycle_map.energy_between(workspace.other).sqrt();
        let enough = S::constant(SPARE) + S::constant(1.0 - SPARE) * promised;
        // At a graze the states may be close although one motion stops and the other does not.
        let change = (cycle_map.stuck - stuck).abs();
        let alike = change <= S::constant(STICKS_ALIKE) * cycle_map.stuck.max(stuck);
        if !keeps || !alike || !(after <= enough * before.sqrt()) {
            return Ok(false);
        }
        cycle_map.restore(workspace.other, &fixed);
        Ok(true)
    }

    /// Tests a steady state whose neighbours are steady too.  The motion itself must select one of them.
    fn marginal<K: ContactChain<S>>(
        &self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        workspace: &mut Workspace<'_, S>,
        far: S,
        scale: S,
        cycles: u32,
    ) -> Result<CandidateVerdict<S>, NoOrbit> {
        let found = |symmetric, reach| {
            Ok(CandidateVerdict::Found(FoundState {
                settled: true,
                period: self.map.period,
                symmetric,
                marginal: true,
                reach,
            }))
        };
        // A motion may be so large that load and friction are below rounding.  Every state then seems steady.
        let forces = cycle_map.setting.beta.max(S::constant(1.0));
        if forces < scale * S::constant(ON_CIRCLE * S::EPSILON) {
            return Ok(CandidateVerdict::No);
        }
        if far <= scale * S::constant(REACHED) {
            return found(self.map.symmetric, None);
        }
        if self.map.period != 1 {
            return Ok(CandidateVerdict::No);
        }
        // A motion may be so large that friction is below rounding.  Every state then seems steady.
        let own = workspace.state.iter();
        let own = own.fold(S::constant(1.0), |most, value| most.max(value.abs()));
        if own * S::constant(MOST_GROWN) < scale {
            return Ok(CandidateVerdict::No);
        }
        // With μ > 1 a stop does not become shorter.  A motion with stops is then no member of the continuum, and does
        // not tend to one.
        if !self.monotone && self.recent.stops > 0 {
            return Ok(CandidateVerdict::No);
        }
        // Where the contact hardly moves, rounding decides its motion.  Any distance below the limit then counts as
        // reached.
        let turns = self.recent.stops + self.recent.reversals;
        let calm = far <= S::constant(HARDLY_MOVES) || (turns <= 2 && CALM <= self.alike);
        if !self.map.symmetric || cycles < LEAST_FOLLOWED || !calm {
            return Ok(CandidateVerdict::Wait);
        }
        let reach = continuum::member(cycle_map, workspace, self.monotone)?;
        found(false, Some(reach))
    }
}
