//! A fixed point that a motion may tend to: whether it is one, and whether the motion is on its way there.

use super::cycle_map::{CycleMap, Pattern};
use super::newton::{Map, Workspace, multipliers, newton, same};
use super::{closed, continuum};
use crate::errors::NoOrbit;
use crate::number::scalar::Float;
use crate::simulation::ContactState;

/// Nearer to the unit circle than this many roundings, a multiplier counts as on it.
pub(super) const ON_CIRCLE: f64 = 4096.0;

/// A subharmonic motion repeats after so many cycles at most.
pub const MAX_PERIOD: u32 = 64;

/// For so many cycles at most is a motion followed that should come near to a fixed point.
const MOST_FOLLOWED: u32 = 64;

/// By so much at most is a marginal state larger than the motion that tends to it, or than P/k₁: away from
/// a resonance both are of the order of the excitation.
const MOST_GROWN: f64 = 64.0;

/// So many half cycles alike, with two turns a cycle at most, tell that a motion has lost what the members of a
/// continuum do not have: one that still turns more often may end elsewhere.
const CALM: u32 = 64;

/// A motion is followed until the multipliers promise that this ratio is left of its distance from the fixed point.
const FAR_ENOUGH: f64 = 0.01;
/// Of the distance that the multipliers promise to take away, so much may stay.
const SPARE: f64 = 0.1;
/// The times for which motions stick differ by no more than this ratio where they stop alike.
const STICKS_ALIKE: f64 = 0.25;
/// Nearer than this, relative to the state, a motion has reached its fixed point.
const REACHED: f64 = 1e-9;
/// A motion nearer than this, in P/k₁, is near enough where the contact hardly moves.
const HARDLY_MOVES: f64 = 1e-6;
/// For so many cycles at least is a motion followed before one of a continuum is chosen for it.
const LEAST_FOLLOWED: u32 = 64;

/// Half a cycle of the continuous regime.
const ONE_REVERSAL: Pattern = Pattern {
    stops: 0,
    reversals: 1,
    slips: 0,
};

/// What is found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found<S> {
    /// Whether the motion repeats at all.
    pub settled: bool,
    /// In cycles of the excitation.
    pub period: u32,
    /// Whether half a period repeats with the opposite sign.
    pub symmetric: bool,
    /// A member of a continuum, or at its end.
    pub marginal: bool,
    /// Of a continuum: by how much more than this member the last one is off its centre.
    pub reach: Option<S>,
}

impl<S> Found<S> {
    /// The last cycles of a motion that does not repeat.
    pub(super) const NONE: Self = Self {
        settled: false,
        period: MAX_PERIOD,
        symmetric: false,
        marginal: false,
        reach: None,
    };
}

/// What a fixed point is good for.
pub(super) enum Verdict<S> {
    Found(Found<S>),
    /// One of a continuum: the motion must go on before it can be said which.
    Wait,
    No,
}

pub(super) struct Candidate<S> {
    pub map: Map,
    /// The pattern of the motion so far.
    pub wanted: Pattern,
    /// Of the last cycle.
    pub recent: Pattern,
    /// So many half cycles in a row have been like the one but one before.
    pub alike: u32,
    /// μ = 1.
    pub monotone: bool,
    /// How many cycles the motion has gone through.
    pub cycles: u32,
    /// How the contact stands in the motion, whose state is in `Workspace::state`.
    pub here: ContactState<S>,
}

impl<S: Float> Candidate<S> {
    pub fn try_from(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S>,
        workspace: &mut Workspace<'_, S>,
    ) -> Result<Verdict<S>, NoOrbit> {
        let Some(pattern) = newton(cycle_map, workspace, self.map)? else {
            return Ok(Verdict::No);
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
        // With μ = 1 two motions never part, so there is no second steady state to mistake this for.
        let near = far <= same(scale);
        let same = pattern == self.wanted;
        if self.monotone || (same && (near || self.attracts(cycle_map, workspace, largest)?)) {
            if self.map.symmetric && self.map.period == 1 && pattern == ONE_REVERSAL {
                closed::set(cycle_map, cycle_map.setting.beta);
            }
            return Ok(Verdict::Found(Found {
                settled: true,
                period: self.map.period,
                symmetric: self.map.symmetric,
                marginal: false,
                reach: None,
            }));
        }
        Ok(Verdict::No)
    }

    /// Whether the motion keeps the pattern and comes as near to the fixed point, on which the cycle map
    /// stands, as its multipliers promise: with μ > 1 other steady states may lie close by.
    fn attracts(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S>,
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
            // A whole period.
            let maps = if self.map.symmetric { 2 } else { 1 };
            for _ in 0..maps {
                let mut pattern = Pattern::default();
                for _ in 0..self.map.halves() {
                    pattern = pattern.and(cycle_map.half(None)?);
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
        // Across a graze the states may be close, but not the stops.
        let change = (cycle_map.stuck - stuck).abs();
        let alike = change <= S::constant(STICKS_ALIKE) * cycle_map.stuck.max(stuck);
        if !keeps || !alike || !(after <= enough * before.sqrt()) {
            return Ok(false);
        }
        cycle_map.restore(workspace.other, &fixed);
        Ok(true)
    }

    /// A steady state with neighbours that are steady too: the motion itself must say which.
    fn marginal(
        &self,
        cycle_map: &mut CycleMap<'_, '_, S>,
        workspace: &mut Workspace<'_, S>,
        far: S,
        scale: S,
        cycles: u32,
    ) -> Result<Verdict<S>, NoOrbit> {
        let found = |symmetric, reach| {
            Ok(Verdict::Found(Found {
                settled: true,
                period: self.map.period,
                symmetric,
                marginal: true,
                reach,
            }))
        };
        if far <= scale * S::constant(REACHED) {
            return found(self.map.symmetric, None);
        }
        if self.map.period != 1 {
            return Ok(Verdict::No);
        }
        // Of a motion so large that friction is below rounding every one seems steady.
        let own = workspace.state.iter();
        let own = own.fold(S::constant(1.0), |most, value| most.max(value.abs()));
        if own * S::constant(MOST_GROWN) < scale {
            return Ok(Verdict::No);
        }
        // With more than μ = 1 a stop does not shrink: the motion is no member, nor does it tend to one.
        if !self.monotone && self.recent.stops > 0 {
            return Ok(Verdict::No);
        }
        // Where the contact hardly moves, what it does is rounding's, and the motion is near enough.
        let turns = self.recent.stops + self.recent.reversals;
        let calm = far <= S::constant(HARDLY_MOVES) || (turns <= 2 && CALM <= self.alike);
        if !self.map.symmetric || cycles < LEAST_FOLLOWED || !calm {
            return Ok(Verdict::Wait);
        }
        let reach = continuum::member(cycle_map, workspace, self.monotone)?;
        found(false, Some(reach))
    }
}
