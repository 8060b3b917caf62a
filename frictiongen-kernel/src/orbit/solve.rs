//! The steady state as a fixed point of the half-period map times −1, or of the period map.

use super::closed;
use super::flow::{Flow, Pattern, unit};
use super::matrix::Matrix;
use crate::complex::{self, Complex};
use crate::errors::NoOrbit;
use crate::pairs::pairs_mut;
use crate::scalar::Float;
use crate::simulation::{Contact, Stance};

/// So many cycles are followed at most before the search for a steady state is given up.
pub const MAX_CYCLES: u32 = 2048;
/// So many steps from one place of a motion to the next are made at most on the way: half of the steady
/// states of random scenes take a thousand, none has been seen to take half of this.  Modes a thousand
/// times as fast as the excitation would need as many for every cycle.
pub const MAX_STEPS: u32 = 1 << 20;
/// Nearer to the unit circle than this many roundings, a multiplier counts as on it.
pub(super) const ON_CIRCLE: f64 = 4096.0;
const NEWTON_STEPS: u32 = 12;
/// A motion that repeats after so many cycles at most is told to be subharmonic.
const MOST_REPEATED: u32 = 16;
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

/// Working space: the matrix, two states, and the multipliers.
pub(super) struct Room<'m, S> {
    pub matrix: &'m mut [S],
    pub state: &'m mut [S],
    pub other: &'m mut [S],
    pub multipliers: &'m mut [Complex<S>],
}

/// What is found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// Whether half a cycle repeats with the opposite sign.
    pub symmetric: bool,
    /// A member of a continuum, or at its end.
    pub marginal: bool,
}

/// Follows the motion until a steady state is settled.  The flow then stands on it.
pub(super) fn settle<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
) -> Result<Found, NoOrbit> {
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
                symmetric,
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
                Ok(Verdict::Found(found)) => return Ok(found),
                Ok(Verdict::Wait) => {
                    flow.restore(room.state, &candidate.here);
                    break;
                }
                Ok(Verdict::No) => {}
                Err(error) => failure = error,
            }
            flow.restore(room.state, &candidate.here);
        }
        wanted = cycles * 2;
    }
    Err(subharmonic(flow, room)?.unwrap_or(failure))
}

/// Whether the motion repeats after several cycles instead of one.
fn subharmonic<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
) -> Result<Option<NoOrbit>, NoOrbit> {
    flow.save(room.other);
    let same = flow.scale() * S::constant(1e-9_f64.max(1024.0 * S::EPSILON));
    for cycles in 1..=MOST_REPEATED {
        flow.half(None)?;
        flow.half(None)?;
        if flow.distance(room.other) <= same {
            return Ok((cycles > 1).then_some(NoOrbit::Subharmonic(cycles)));
        }
    }
    Ok(None)
}

/// What a fixed point is good for.
enum Verdict {
    Found(Found),
    /// One of a continuum: the motion must go on before it can be said which.
    Wait,
    No,
}

struct Candidate<S> {
    symmetric: bool,
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
        let Some(pattern) = newton(flow, room, self.symmetric)? else {
            return Ok(Verdict::No);
        };
        let scale = flow.scale();
        let far = flow.distance(room.state);
        let largest = multipliers(flow, room, self.symmetric)?;
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
        let near = far <= scale * S::constant(1e-9_f64.max(1024.0 * S::EPSILON));
        let same = pattern == self.wanted;
        if self.monotone || (same && (near || self.attracts(flow, room, largest)?)) {
            if self.symmetric && pattern == ONE_REVERSAL {
                closed::set(flow);
            }
            return Ok(Verdict::Found(Found {
                symmetric: self.symmetric,
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
        let rate = if self.symmetric {
            largest * largest
        } else {
            largest
        };
        let mut promised = S::constant(1.0);
        let mut cycles = 0;
        let mut keeps = true;
        while keeps && cycles < MOST_FOLLOWED && S::constant(0.01) < promised {
            let (first, second) = (flow.half(None)?, flow.half(None)?);
            keeps = if self.symmetric {
                first == self.wanted && second == self.wanted
            } else {
                first.and(second) == self.wanted
            };
            promised = promised * rate;
            cycles += 1;
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
                symmetric,
                marginal: true,
            }))
        };
        if far <= scale * S::constant(1e-9) {
            return found(self.symmetric);
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
        if !self.symmetric || cycles < 64 || !calm {
            return Ok(Verdict::Wait);
        }
        super::continuum::member(flow, room, self.monotone)?;
        found(false)
    }
}

/// Newton's method from where the flow stands; none if it does not converge.  The flow then stands
/// on the fixed point.
fn newton<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    symmetric: bool,
) -> Result<Option<Pattern>, NoOrbit> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let size = flow.size();
    let start = flow.stance;
    let mut last = S::constant(f64::MAX);
    let mut stance = start;
    for _ in 0..NEWTON_STEPS {
        flow.save(room.other);
        unit(room.matrix, size);
        let Ok((image, pattern)) = mapped(flow, room.matrix, symmetric) else {
            return Ok(None);
        };
        if (image == Contact::Stuck) != (stance.contact == Contact::Stuck) {
            // The section itself has changed hands; the image is as good a start.
            stance.contact = image;
            stance.t = start.t;
            flow.save(room.other);
            negate(room.other, symmetric);
            flow.restore(room.other, &stance);
            continue;
        }
        // δ = (1 − A)⁻¹(F(x) − x), in the place of F(x).
        let scale = flow.scale().max(S::constant(1e-290));
        let sign = if symmetric { -one } else { one };
        for (part, state) in flow.modes.iter_mut().zip(pairs_mut(room.other)) {
            if let [y, u] = state {
                let difference = [sign * part.y - *y, sign * part.u - *u];
                (part.y, part.u) = (*y, *u);
                [*y, *u] = difference;
            }
        }
        if symmetric {
            for entry in room.matrix.iter_mut() {
                *entry = -*entry;
            }
        }
        if !Matrix::new(room.matrix, size).solve_shifted(one, room.other) {
            return Ok(None);
        }
        let mut step = zero;
        for (part, state) in flow.modes.iter_mut().zip(pairs_mut(room.other)) {
            if let [y, u] = state {
                step = step.max(y.abs()).max(u.abs());
                (*y, *u) = (part.y + *y, part.u + *u);
            }
        }
        if !step.is_finite() {
            return Ok(None);
        }
        stance.t = start.t;
        flow.restore(room.other, &stance);
        let small = step <= scale * S::constant(1e-11_f64.max(256.0 * S::EPSILON));
        // Below rounding, or as far down as rounding lets it come.
        if step <= scale * S::constant(4.0 * S::EPSILON)
            || (small && last * S::constant(0.25) < step)
            || step <= scale * S::constant(1e-9) && step <= last * last / scale
        {
            return Ok(Some(pattern));
        }
        last = step;
    }
    Ok(None)
}

/// The map of half a cycle or a whole one with its deviations; how the contact stands then.
fn mapped<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    columns: &mut [S],
    symmetric: bool,
) -> Result<(Contact, Pattern), NoOrbit> {
    let mut pattern = flow.half(Some(columns))?;
    if symmetric {
        return Ok((flow.stance.contact.reversed(), pattern));
    }
    pattern = pattern.and(flow.half(Some(columns))?);
    Ok((flow.stance.contact, pattern))
}

pub(super) fn negate<S: Float>(state: &mut [S], really: bool) {
    if really {
        for value in state {
            *value = -*value;
        }
    }
}

/// The multipliers of the period, for which the flow stands on a fixed point and stays there; the
/// largest modulus of those of the map.
pub(super) fn multipliers<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    symmetric: bool,
) -> Result<S, NoOrbit> {
    let size = flow.size();
    let start: Stance<S> = flow.stance;
    flow.save(room.other);
    unit(room.matrix, size);
    mapped(flow, room.matrix, symmetric)?;
    flow.restore(room.other, &start);
    Matrix::new(room.matrix, size).eigenvalues(room.multipliers);
    let mut largest = S::constant(0.0);
    for multiplier in room.multipliers.iter_mut() {
        largest = largest.max(complex::modulus(*multiplier, true));
        if symmetric {
            *multiplier = complex::mul(*multiplier, *multiplier, true);
        }
    }
    Ok(largest)
}
