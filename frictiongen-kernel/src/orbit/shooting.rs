//! The steady state as a fixed point of the half-period map times −1, or of the period map; the period is one cycle of
//! the excitation, or several.

use super::closed;
use super::cycle_map::{CycleMap, Pattern};
use super::newton::{Map, Workspace, multipliers, newton, same};
use crate::errors::NoOrbit;
use crate::number::scalar::Float;
use crate::simulation::ContactState;

/// So many cycles are followed at most before the search for a steady state is given up.
pub const MAX_CYCLES: u32 = 2048;
/// So many steps from one place of a motion to the next are made at most on the way: half of the steady
/// states of random scenes take a thousand, none has been seen to take half of this.  Modes a thousand
/// times as fast as the excitation would need as many for every cycle.
pub const MAX_STEPS: u32 = 1 << 20;
/// Nearer to the unit circle than this many roundings, a multiplier counts as on it.
pub(super) const ON_CIRCLE: f64 = 4096.0;
/// So many periods are tried at a time.
const MOST_TRIED: u32 = 3;
/// A subharmonic motion repeats after so many cycles at most.
pub const MAX_PERIOD: u32 = 64;
/// After so many cycles a subharmonic state is looked for.
const FIRST_ASKED: u32 = 16;
/// One of a period is tried if the motion comes back after it to within this share of itself,
const NEARLY_BACK: f64 = 1e-2;
/// and to within this share of how near it comes after fewer cycles.
const NEARER: f64 = 0.1;
/// For so many cycles at most is a motion followed that should come near to a fixed point.
const MOST_FOLLOWED: u32 = 64;
/// By so much at most is a marginal state larger than the motion that tends to it, or than P/k₁: away from
/// a resonance both are of the order of the excitation.
const MOST_GROWN: f64 = 64.0;
/// So many half cycles alike, with two turns a cycle at most, tell that a motion has lost what the members of a
/// continuum do not have: one that still turns more often may end elsewhere.
const CALM: u32 = 64;
/// Half a cycle of the continuous regime.
const ONE_REVERSAL: Pattern = Pattern {
    stops: 0,
    reversals: 1,
    slips: 0,
};

/// What is found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// Whether the motion repeats at all.
    pub settled: bool,
    /// In cycles of the excitation.
    pub period: u32,
    /// Whether half a period repeats with the opposite sign.
    pub symmetric: bool,
    /// A member of a continuum, or at its end.
    pub marginal: bool,
}

impl Found {
    /// The last cycles of a motion that does not repeat.
    pub(super) const NONE: Self = Self {
        settled: false,
        period: MAX_PERIOD,
        symmetric: false,
        marginal: false,
    };
}

/// Where a motion leads to.
pub(super) enum Settled {
    Found(Found),
    /// It has gone through all its cycles, and why none of them repeats.
    Not(NoOrbit),
}

/// Follows the motion until a steady state is settled.  The cycle map then stands on it, or on the motion.
pub(super) fn settle<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
) -> Result<Settled, NoOrbit> {
    let monotone = cycle_map.setting.dynamics.chain.stiction <= S::constant(1.0);
    let mut failure = NoOrbit::Unsettled;
    let (mut cycles, mut wanted) = (0, 2);
    let mut halves = [Pattern::default(); 4];
    // How many half cycles in a row have had the pattern of the one or two before.
    let mut settled = [0u32; 2];
    while cycles < MAX_CYCLES {
        while cycles < wanted {
            for _ in 0..2 {
                let half = cycle_map.half(None)?;
                let [a, b, c, _] = halves;
                halves = [half, a, b, c];
                settled[0] = if half == a { settled[0] + 1 } else { 0 };
                settled[1] = if half == b { settled[1] + 1 } else { 0 };
            }
            cycles += 1;
        }
        // A section where no event is near.
        let middle = cycle_map.middle * S::pi();
        cycle_map.on(middle, None)?;
        let [last, before, ..] = halves;
        for symmetric in [true, false] {
            let steady = if symmetric { settled[0] } else { settled[1] };
            if !monotone && steady == 0 {
                continue;
            }
            cycle_map.save(workspace.state);
            let mut candidate = Candidate {
                map: Map {
                    period: 1,
                    symmetric,
                },
                wanted: if symmetric { last } else { last.and(before) },
                recent: last.and(before),
                alike: settled[1],
                monotone,
                cycles,
                here: cycle_map.contact_state,
            };
            let verdict = candidate.try_from(cycle_map, workspace);
            cycles = candidate.cycles;
            match verdict {
                Ok(Verdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(Verdict::Wait) => {
                    cycle_map.restore(workspace.state, &candidate.here);
                    break;
                }
                Ok(Verdict::No) => {}
                Err(error) => failure = error,
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
        // With μ = 1 two motions never part: what repeats after several cycles is one of a continuum.
        if FIRST_ASKED <= cycles && (!monotone || MAX_CYCLES <= cycles * 2) {
            match several(cycle_map, workspace, &mut cycles, failure)? {
                Settled::Found(found) => return Ok(Settled::Found(found)),
                Settled::Not(error) => failure = error,
            }
        }
        wanted = cycles * 2;
    }
    Ok(Settled::Not(failure))
}

/// The steady state that repeats after several cycles and that the motion is near to; where none is, the cycle map stands on
/// the motion.
fn several<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    cycles: &mut u32,
    mut failure: NoOrbit,
) -> Result<Settled, NoOrbit> {
    let mut after = 1;
    for _ in 0..MOST_TRIED {
        let most = MAX_PERIOD.min(*cycles);
        let Some((period, total)) = comes_back(cycle_map, workspace, cycles, after, most)? else {
            break;
        };
        for symmetric in [true, false] {
            let Some(wanted) = wanted(total, symmetric, period) else {
                continue;
            };
            cycle_map.save(workspace.state);
            let mut candidate = Candidate {
                map: Map { period, symmetric },
                wanted,
                recent: total,
                alike: 0,
                monotone: false,
                cycles: *cycles,
                here: cycle_map.contact_state,
            };
            let mut verdict = candidate.try_from(cycle_map, workspace);
            if matches!(verdict, Ok(Verdict::Found(_)))
                && let Some(sooner) = repeats_sooner(cycle_map, workspace, period)?
            {
                // The same state as one of fewer cycles.
                candidate.map.period = sooner;
                verdict = match candidate
                    .wanted
                    .divided(period.checked_div(sooner).unwrap_or(1))
                {
                    Some(wanted) => {
                        candidate.wanted = wanted;
                        candidate.try_from(cycle_map, workspace)
                    }
                    None => Ok(Verdict::No),
                };
            }
            *cycles = candidate.cycles;
            match verdict {
                Ok(Verdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(_) => {}
                Err(error) => failure = error,
            }
            cycle_map.restore(workspace.state, &candidate.here);
        }
        after = period;
    }
    Ok(Settled::Not(failure))
}

/// The number of cycles, fewer than `period`, after which the fixed point repeats, if there is one: a free vibration that
/// dies slowly comes back to itself, and looks like a longer period.  The cycle map stands on the fixed point, and stays there.
fn repeats_sooner<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    period: u32,
) -> Result<Option<u32>, NoOrbit> {
    let contact_state = cycle_map.contact_state;
    cycle_map.save(workspace.other);
    let limit = same(cycle_map.scale());
    let mut sooner = None;
    for cycles in 1..period {
        cycle_map.half(None)?;
        cycle_map.half(None)?;
        if sooner.is_none() && cycle_map.distance(workspace.other) <= limit {
            sooner = Some(cycles);
        }
    }
    cycle_map.restore(workspace.other, &contact_state);
    Ok(sooner)
}

/// After how many cycles, more than `after` and at most `most`, the motion comes back near to where it is now, nearer
/// than after fewer; with what happens on the way.
fn comes_back<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    cycles: &mut u32,
    after: u32,
    most: u32,
) -> Result<Option<(u32, Pattern)>, NoOrbit> {
    let mut total = Pattern::default();
    cycle_map.save(workspace.state);
    let mut near = cycle_map.scale() * S::constant(NEARLY_BACK);
    for period in 1..=most {
        total = total.and(cycle_map.half(None)?).and(cycle_map.half(None)?);
        *cycles += 1;
        let distance = cycle_map.distance(workspace.state);
        if period > after && distance <= near {
            return Ok(Some((period, total)));
        }
        near = near.min(distance * S::constant(NEARER));
    }
    Ok(None)
}

/// The pattern of half a period, or of a whole one.  Half of an even number of cycles later the load has the same sign,
/// and no motion is opposite.
fn wanted(total: Pattern, symmetric: bool, period: u32) -> Option<Pattern> {
    if !symmetric {
        return Some(total);
    }
    if period.is_multiple_of(2) {
        return None;
    }
    total.divided(2)
}

/// What a fixed point is good for.
enum Verdict {
    Found(Found),
    /// One of a continuum: the motion must go on before it can be said which.
    Wait,
    No,
}

struct Candidate<S> {
    map: Map,
    /// The pattern of the motion so far.
    wanted: Pattern,
    /// Of the last cycle.
    recent: Pattern,
    /// So many half cycles in a row have been like the one but one before.
    alike: u32,
    /// μ = 1.
    monotone: bool,
    /// How many cycles the motion has gone through.
    cycles: u32,
    /// How the contact stands in the motion, whose state is in `Workspace::state`.
    here: ContactState<S>,
}

impl<S: Float> Candidate<S> {
    fn try_from(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S>,
        workspace: &mut Workspace<'_, S>,
    ) -> Result<Verdict, NoOrbit> {
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
                closed::set(cycle_map);
            }
            return Ok(Verdict::Found(Found {
                settled: true,
                period: self.map.period,
                symmetric: self.map.symmetric,
                marginal: false,
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
        while keeps && cycles < MOST_FOLLOWED && S::constant(0.01) < promised {
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
        let enough = S::constant(0.1) + S::constant(0.9) * promised;
        // Across a graze the states may be close, but not the stops.
        let change = (cycle_map.stuck - stuck).abs();
        let alike = change <= S::constant(0.25) * cycle_map.stuck.max(stuck);
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
    ) -> Result<Verdict, NoOrbit> {
        let found = |symmetric| {
            Ok(Verdict::Found(Found {
                settled: true,
                period: self.map.period,
                symmetric,
                marginal: true,
            }))
        };
        if far <= scale * S::constant(1e-9) {
            return found(self.map.symmetric);
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
        let calm = far <= S::constant(1e-6) || (turns <= 2 && CALM <= self.alike);
        if !self.map.symmetric || cycles < 64 || !calm {
            return Ok(Verdict::Wait);
        }
        super::continuum::member(cycle_map, workspace, self.monotone)?;
        found(false)
    }
}
