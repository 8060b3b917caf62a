//! The steady state as a fixed point of the half-period map times −1, or of the period map; the period is one cycle of
//! the excitation, or several.

use super::closed;
use super::flow::{Flow, Pattern};
use super::newton::{Map, Room, multipliers, newton, same};
use crate::errors::NoOrbit;
use crate::number::scalar::Float;
use crate::simulation::Stance;

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

/// Follows the motion until a steady state is settled.  The flow then stands on it, or on the motion.
pub(super) fn settle<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
) -> Result<Settled, NoOrbit> {
    let monotone = flow.setting.dynamics.chain.stiction <= S::constant(1.0);
    let mut failure = NoOrbit::Unsettled;
    let (mut cycles, mut wanted) = (0, 2);
    let mut halves = [Pattern::default(); 4];
    // How many half cycles in a row have had the pattern of the one or two before.
    let mut settled = [0u32; 2];
    while cycles < MAX_CYCLES {
        while cycles < wanted {
            for _ in 0..2 {
                let half = flow.half(None)?;
                let [a, b, c, _] = halves;
                halves = [half, a, b, c];
                settled[0] = if half == a { settled[0] + 1 } else { 0 };
                settled[1] = if half == b { settled[1] + 1 } else { 0 };
            }
            cycles += 1;
        }
        // A section where no event is near.
        let middle = flow.middle * S::pi();
        flow.on(middle, None)?;
        let [last, before, ..] = halves;
        for symmetric in [true, false] {
            let steady = if symmetric { settled[0] } else { settled[1] };
            if !monotone && steady == 0 {
                continue;
            }
            flow.save(room.state);
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
                here: flow.stance,
            };
            let verdict = candidate.try_from(flow, room);
            cycles = candidate.cycles;
            match verdict {
                Ok(Verdict::Found(found)) => return Ok(Settled::Found(found)),
                Ok(Verdict::Wait) => {
                    flow.restore(room.state, &candidate.here);
                    break;
                }
                Ok(Verdict::No) => {}
                Err(error) => failure = error,
            }
            flow.restore(room.state, &candidate.here);
        }
        // With μ = 1 two motions never part: what repeats after several cycles is one of a continuum.
        if FIRST_ASKED <= cycles && (!monotone || MAX_CYCLES <= cycles * 2) {
            match several(flow, room, &mut cycles, failure)? {
                Settled::Found(found) => return Ok(Settled::Found(found)),
                Settled::Not(error) => failure = error,
            }
        }
        wanted = cycles * 2;
    }
    Ok(Settled::Not(failure))
}

/// The steady state that repeats after several cycles and that the motion is near to; where none is, the flow stands on
/// the motion.
fn several<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    cycles: &mut u32,
    mut failure: NoOrbit,
) -> Result<Settled, NoOrbit> {
    let mut after = 1;
    for _ in 0..MOST_TRIED {
        let most = MAX_PERIOD.min(*cycles);
        let Some((period, total)) = comes_back(flow, room, cycles, after, most)? else {
            break;
        };
        for symmetric in [true, false] {
            let Some(wanted) = wanted(total, symmetric, period) else {
                continue;
            };
            flow.save(room.state);
            let mut candidate = Candidate {
                map: Map { period, symmetric },
                wanted,
                recent: total,
                alike: 0,
                monotone: false,
                cycles: *cycles,
                here: flow.stance,
            };
            let mut verdict = candidate.try_from(flow, room);
            if matches!(verdict, Ok(Verdict::Found(_)))
                && let Some(sooner) = repeats_sooner(flow, room, period)?
            {
                // The same state as one of fewer cycles.
                candidate.map.period = sooner;
                verdict = match candidate
                    .wanted
                    .divided(period.checked_div(sooner).unwrap_or(1))
                {
                    Some(wanted) => {
                        candidate.wanted = wanted;
                        candidate.try_from(flow, room)
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
            flow.restore(room.state, &candidate.here);
        }
        after = period;
    }
    Ok(Settled::Not(failure))
}

/// The number of cycles, fewer than `period`, after which the fixed point repeats, if there is one: a free vibration that
/// dies slowly comes back to itself, and looks like a longer period.  The flow stands on the fixed point, and stays there.
fn repeats_sooner<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    period: u32,
) -> Result<Option<u32>, NoOrbit> {
    let stance = flow.stance;
    flow.save(room.other);
    let limit = same(flow.scale());
    let mut sooner = None;
    for cycles in 1..period {
        flow.half(None)?;
        flow.half(None)?;
        if sooner.is_none() && flow.distance(room.other) <= limit {
            sooner = Some(cycles);
        }
    }
    flow.restore(room.other, &stance);
    Ok(sooner)
}

/// After how many cycles, more than `after` and at most `most`, the motion comes back near to where it is now, nearer
/// than after fewer; with what happens on the way.
fn comes_back<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    cycles: &mut u32,
    after: u32,
    most: u32,
) -> Result<Option<(u32, Pattern)>, NoOrbit> {
    let mut total = Pattern::default();
    flow.save(room.state);
    let mut near = flow.scale() * S::constant(NEARLY_BACK);
    for period in 1..=most {
        total = total.and(flow.half(None)?).and(flow.half(None)?);
        *cycles += 1;
        let distance = flow.distance(room.state);
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
    /// How the contact stands in the motion, whose state is in `Room::state`.
    here: Stance<S>,
}

impl<S: Float> Candidate<S> {
    fn try_from(
        &mut self,
        flow: &mut Flow<'_, '_, S>,
        room: &mut Room<'_, S>,
    ) -> Result<Verdict, NoOrbit> {
        let Some(pattern) = newton(flow, room, self.map)? else {
            return Ok(Verdict::No);
        };
        let scale = flow.scale();
        let far = flow.distance(room.state);
        let largest = multipliers(flow, room, self.map)?;
        let one = S::constant(1.0);
        let margin = S::constant(ON_CIRCLE * S::EPSILON);
        if one + margin < largest {
            return Err(NoOrbit::Unstable);
        }
        let on_circle = one - margin < largest;
        if on_circle {
            return self.marginal(flow, room, far, scale, self.cycles);
        }
        // With μ = 1 two motions never part, so there is no second steady state to mistake this for.
        let near = far <= same(scale);
        let same = pattern == self.wanted;
        if self.monotone || (same && (near || self.attracts(flow, room, largest)?)) {
            if self.map.symmetric && self.map.period == 1 && pattern == ONE_REVERSAL {
                closed::set(flow);
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

    /// Whether the motion keeps the pattern and comes as near to the fixed point, on which the flow
    /// stands, as its multipliers promise: with μ > 1 other steady states may lie close by.
    fn attracts(
        &mut self,
        flow: &mut Flow<'_, '_, S>,
        room: &mut Room<'_, S>,
        largest: S,
    ) -> Result<bool, NoOrbit> {
        let (fixed, stuck) = (flow.stance, flow.stuck);
        flow.save(room.other);
        flow.restore(room.state, &self.here);
        let before = flow.energy_between(room.other);
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
                    pattern = pattern.and(flow.half(None)?);
                }
                keeps = keeps && pattern == self.wanted;
            }
            promised = promised * rate;
            cycles += self.map.period;
        }
        self.cycles += cycles;
        self.here = flow.stance;
        flow.save(room.state);
        let after = flow.energy_between(room.other).sqrt();
        let enough = S::constant(0.1) + S::constant(0.9) * promised;
        // Across a graze the states may be close, but not the stops.
        let apart = (flow.stuck - stuck).abs();
        let alike = apart <= S::constant(0.25) * flow.stuck.max(stuck);
        if !keeps || !alike || !(after <= enough * before.sqrt()) {
            return Ok(false);
        }
        flow.restore(room.other, &fixed);
        Ok(true)
    }

    /// A steady state with neighbours that are steady too: the motion itself must say which.
    fn marginal(
        &self,
        flow: &mut Flow<'_, '_, S>,
        room: &mut Room<'_, S>,
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
        let own = room.state.iter();
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
        super::continuum::member(flow, room, self.monotone)?;
        found(false)
    }
}
