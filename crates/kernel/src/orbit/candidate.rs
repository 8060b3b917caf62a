//! Tests whether a motion is near a fixed point of the half-period map or of the period map, and whether the motion
//! converges to that point.

use super::cycle_map::{CycleMap, EventPattern};
use super::newton::{PeriodMap, Workspace, multipliers, newton, same};
use super::{closed, continuum};
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, ContactState};
use crate::number::scalar::Float;

/// Largest distance of a Floquet multiplier from the unit circle at which the multiplier counts as lying on the
/// circle, in rounding units of the number type.
pub(super) const ON_CIRCLE: f64 = 4096.0;

/// Largest period of a subharmonic motion, in cycles of the excitation.
pub const MAX_PERIOD: u32 = 64;

/// Largest number of cycles over which [`Candidate`] follows a motion, to test whether it approaches a fixed point.
const MOST_FOLLOWED: u32 = 64;

/// Largest allowed size of a marginal steady state, divided by the size of the motion that converges to it. A marginal
/// state belongs to a continuum of steady states. If the size of the motion is below P/k₁, the code uses P/k₁ instead.
/// Away from a resonance both sizes are of the order of P/k₁.
const MOST_GROWN: f64 = 64.0;

/// Number of successive half cycles with unchanged numbers of events after which the code assumes that a motion
/// converges to a member of a continuum of steady states. The assumption applies to motions with at most two stops or
/// reversals in a cycle. A motion with more events may still converge to another state.
const CALM: u32 = 64;

/// Ratio at which the test whether a motion approaches a fixed point ends: the distance of the motion from the fixed
/// point, divided by the initial distance. The code predicts this ratio from the Floquet multipliers.
const FAR_ENOUGH: f64 = 0.01;
/// Tolerance of the test whether a motion approaches a fixed point. The distance of the motion from the fixed point
/// may exceed the prediction of the Floquet multipliers by this fraction of the initial distance.
const SPARE: f64 = 0.1;
/// Largest relative difference of the sticking times of two motions at which the code treats their stops as the same.
const STICKS_ALIKE: f64 = 0.25;
/// Largest distance of the motion from the fixed point, divided by the size of the state, at which the code assumes
/// that the motion has reached the fixed point.
const REACHED: f64 = 1e-9;
/// Largest distance of the motion from the fixed point, in units of P/k₁, at which the contact hardly moves. Rounding
/// then decides the motion of the contact.
const HARDLY_MOVES: f64 = 1e-6;
/// Smallest number of cycles that the search follows before it selects a member of a continuum of steady states.
const LEAST_FOLLOWED: u32 = 64;

/// Events of a continuous motion in half a cycle: one reversal.
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
    /// Period of the steady state, in cycles of the excitation.
    pub period: u32,
    /// True if the motion half a period later is the present motion with the opposite sign.
    pub symmetric: bool,
    /// True if the state belongs to a continuum of steady states, or lies at the end of one.
    pub marginal: bool,
    /// Ratio of two contact offsets: the largest offset in the continuum of steady states, divided by the offset of
    /// this state. `None` if the ratio is unknown.
    pub reach: Option<S>,
}

impl<S> FoundState<S> {
    /// Result for a motion that does not repeat. Only the last cycles of this motion are known.
    pub(super) const NONE: Self = Self {
        settled: false,
        period: MAX_PERIOD,
        symmetric: false,
        marginal: false,
        reach: None,
    };
}

/// Result of the test whether a motion converges to a fixed point.
pub(super) enum CandidateVerdict<S> {
    Found(FoundState<S>),
    /// The fixed point belongs to a continuum of steady states. The search must follow the motion further, because the
    /// motion selects one state of the continuum.
    Wait,
    /// The fixed point is stable, but the motion does not approach it. `far` is the distance of the motion from the
    /// fixed point, divided by the size of the fixed point's state.
    Apart {
        far: S,
    },
    No,
}

pub(super) struct Candidate<S> {
    pub map: PeriodMap,
    /// Numbers of stops, break-aways and reversals of the motion in the last period. A steady state must have the same
    /// numbers.
    pub wanted: EventPattern,
    /// Numbers of stops, break-aways and reversals of the motion in the last cycle of the excitation.
    pub recent: EventPattern,
    /// Number of successive half cycles whose numbers of stops, break-aways and reversals equal those of the half
    /// cycle one cycle earlier.
    pub alike: u32,
    /// True if the stiction μ is 1. The distance between two motions then never grows.
    pub monotone: bool,
    /// Number of excitation cycles that the search has followed since the start of the motion.
    pub cycles: u32,
    /// State of the contact in the motion. `Workspace::state` contains the states of the oscillators.
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
        // With μ = 1 the distance between two motions never grows, so that every motion tends to a fixed point whose
        // multipliers lie inside the unit circle. With μ > 1 the motion must have the events of the fixed point. It
        // must also be near the fixed point, or approach the fixed point.
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
        Ok(CandidateVerdict::Apart { far: far / scale })
    }

    /// Returns true if the motion keeps its events and approaches the fixed point as fast as the multipliers predict.
    /// With μ > 1 other steady states may be close, so that a small distance proves nothing. The cycle map is at the
    /// fixed point before and after the call.
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
            // Each pass of the loop follows the motion over one whole period.
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
        // At a graze the contact almost stops. Two states may then be close although the contact stops in only one of
        // the motions. The sticking times show the difference.
        let change = (cycle_map.stuck - stuck).abs();
        let alike = change <= S::constant(STICKS_ALIKE) * cycle_map.stuck.max(stuck);
        cycle_map.restore(workspace.other, &fixed);
        Ok(keeps && alike && after <= enough * before.sqrt())
    }

    /// Tests a fixed point that belongs to a continuum of steady states. The motion itself selects one state of the
    /// continuum. `far` is the distance of the motion from the fixed point, and `scale` the size of the fixed point.
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
        // A motion may be so large that load and friction are smaller than its rounding error. Every state then seems
        // steady.
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
        // In a very large motion, friction may be smaller than the rounding error. Every state then seems steady.
        let own = workspace.state.iter();
        let own = own.fold(S::constant(1.0), |most, value| most.max(value.abs()));
        if own * S::constant(MOST_GROWN) < scale {
            return Ok(CandidateVerdict::No);
        }
        // With μ > 1 stops do not become shorter from cycle to cycle. A motion with stops is then no member of the
        // continuum, and does not tend to a member.
        if !self.monotone && self.recent.stops > 0 {
            return Ok(CandidateVerdict::No);
        }
        // If the contact hardly moves, rounding decides its motion. The code then assumes that the motion has reached
        // the fixed point.
        let turns = self.recent.stops + self.recent.reversals;
        let calm = far <= S::constant(HARDLY_MOVES) || (turns <= 2 && CALM <= self.alike);
        if !self.map.symmetric || cycles < LEAST_FOLLOWED || !calm {
            return Ok(CandidateVerdict::Wait);
        }
        let reach = continuum::member(cycle_map, workspace, self.monotone)?;
        found(false, Some(reach))
    }
}
