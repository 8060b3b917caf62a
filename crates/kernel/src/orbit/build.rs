//! Computes the steady state of a scene at a frequency ratio r and a friction ratio β.

use super::candidate::{FoundState, ON_CIRCLE};
use super::cycle_map::{CycleMap, MOST_EVENTS};
use super::newton::{PeriodMap, Workspace, multipliers, newton, same};
use super::question::OrbitQuestion;
use super::record::{OrbitRecord, RecordedPeriod};
use super::shooting::{FollowedMotion, Settled, settle};
use super::start::Start;
use super::types::{MAX_CYCLES, MAX_SEGMENTS, MAX_STEPS, Orbit, SegmentStart};
use super::wander::wander;
use crate::errors::{NoOrbit, OutOfDomain, Slice};
use crate::motion::{
    Contact, ContactChain, ContactState, Dynamics, Law, MotionSetting, Part, leap,
};
use crate::number::complex::Complex;
use crate::number::scalar::{Float, Plain};
use crate::oscillator::mode::{Kind, Mode};
use core::f64::consts::FRAC_PI_4;

impl<'a, S, P, V, C, K> Orbit<'a, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    /// Computes a steady state with the function [`answer`](Self::answer). The arguments have the order in which
    /// emitted code passes them.
    ///
    /// # Errors
    /// The errors of [`answer`](Self::answer).
    #[inline]
    #[allow(
        clippy::too_many_arguments,
        reason = "emitted code names as few types as possible"
    )]
    pub fn new(
        dynamics: Dynamics<'a, S, K>,
        r: S,
        beta: S,
        sliding: S,
        start: Start<'_, S>,
        last: bool,
        parts: P,
        numbers: V,
        multipliers: C,
    ) -> Result<Self, NoOrbit>
    where
        S: Plain,
    {
        let question = OrbitQuestion {
            dynamics,
            r,
            beta,
            sliding,
            start,
            last,
        };
        Self::answer(&question, parts, numbers, multipliers)
    }

    /// Computes the steady state that a motion reaches from the given start, at the frequency ratio r and the friction
    /// ratio β. The motion starts at a maximum of the excitation. If the motion does not settle and `question.last` is
    /// true, the result contains the last cycles of the motion. [`Self::is_settled`] then returns false.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why no steady state exists or was found. Slices of a wrong length return the error
    /// `OutOfDomain`.
    pub fn answer(
        question: &OrbitQuestion<'a, '_, S, K>,
        parts: P,
        numbers: V,
        multipliers: C,
    ) -> Result<Self, NoOrbit>
    where
        S: Plain,
    {
        Self::search::<false>(question, parts, numbers, multipliers, &mut None)
    }

    /// Computes the steady state of [`answer`](Self::answer) with a longer search, if the motion does not settle in
    /// [`MAX_CYCLES`] cycles. With μ > 1 the search then follows the motion for up to
    /// [`MAX_CYCLES_FOLLOWED`](super::MAX_CYCLES_FOLLOWED) cycles. Newton's method starts from the states that the
    /// motion visits. A cycle may have more than [`MAX_SEGMENTS`] segments.
    ///
    /// If the motion still does not settle, `unsettled` receives the number of cycles that the search has followed. The
    /// result is then a stable steady state that Newton's method found, or for motion from rest the
    /// stuck state, if it exists.
    ///
    /// # Errors
    /// The errors of [`answer`](Self::answer).
    pub fn answer_at_length(
        question: &OrbitQuestion<'a, '_, S, K>,
        parts: P,
        numbers: V,
        multipliers: C,
        unsettled: &mut Option<u32>,
    ) -> Result<Self, NoOrbit>
    where
        S: Plain,
    {
        Self::search::<true>(question, parts, numbers, multipliers, unsettled)
    }

    /// Computes the steady state of [`answer`](Self::answer), or of [`answer_at_length`](Self::answer_at_length) if
    /// `AT_LENGTH` is true. Emitted code calls the function only with `false`, and then does not contain the code of
    /// the longer search.
    fn search<const AT_LENGTH: bool>(
        question: &OrbitQuestion<'a, '_, S, K>,
        mut parts: P,
        mut numbers: V,
        mut multipliers: C,
        unsettled: &mut Option<u32>,
    ) -> Result<Self, NoOrbit>
    where
        S: Plain,
    {
        let (dynamics, beta, start) = (question.dynamics, question.beta, question.start);
        let setting = MotionSetting::new(dynamics, question.r, beta, parts.as_mut())?;
        let (modes, size) = (dynamics.modes.len(), dynamics.state_size());
        if numbers.as_ref().len() != super::numbers_of(modes, size) {
            return Err(OutOfDomain::Length(Slice::Storage).into());
        }
        if multipliers.as_ref().len() != size {
            return Err(OutOfDomain::Length(Slice::Multipliers).into());
        }
        // A stuck state exists for β ≥ β*_lim. The code must follow the motion to find out whether the motion ends in
        // the stuck state.
        let holding =
            (!(beta < question.sliding)).then_some(setting.law_at(question.sliding).grip());
        let unbounded = unbounded(&dynamics, question.r, beta)?;
        if let (Some(error), None) = (unbounded, holding) {
            return Err(error);
        }
        let clean = parts.clone();
        let (own, stuck_modes) = setting.split(parts.as_mut());
        let contact_state = setting.contact_state(own, S::constant(0.0));
        let mut cycle_map = CycleMap::new(&setting, (own, stuck_modes), contact_state);
        let (states, mut workspace) =
            Workspace::divided(numbers.as_mut(), multipliers.as_mut(), (modes, size));
        let mut marks = [SegmentStart::empty(); MAX_SEGMENTS];
        start
            .checked(holding.is_some())?
            .set_start(&mut cycle_map, &mut workspace)?;
        let spare = states.get_mut(..2 * size).unwrap_or_default();
        let asked = (start, holding);
        let settled =
            reach::<AT_LENGTH, _, _>(&mut cycle_map, &mut workspace, asked, spare, unsettled)?;
        let settled = match (settled, unbounded) {
            (Settled::Not(_), Some(error)) => return Err(error),
            (_, Some(error)) if AT_LENGTH && unsettled.is_some() => return Err(error),
            (Settled::Not(error), None) if !question.last => return Err(error),
            (settled, _) => settled,
        };
        let (settled, mut left_at) = match settled {
            Settled::Stuck(offset) if start == Start::Rest && unsettled.is_none() => (
                Settled::Stuck(S::constant(0.0)),
                Some(setting.mean_at(offset)),
            ),
            settled => (settled, None),
        };
        let most = if AT_LENGTH {
            MOST_EVENTS as usize
        } else {
            MAX_SEGMENTS
        };
        let mut record = OrbitRecord::new(&mut marks, states, 2 * modes, most);
        let mut found = followed(&mut cycle_map, &mut workspace, settled, &mut record)?;
        let mut period = record.done();
        // The search may find a state in which the contact only touches its limit, and sticks in between.
        let touches = holding.is_some() && start == Start::Rest && left_at.is_none();
        if touches && found.settled && sticks(&marks, &period) {
            let zero = S::constant(0.0);
            let (_, offset) = setting.start_sticking(
                cycle_map.modes,
                cycle_map.stuck_modes,
                &cycle_map.contact_state,
                zero,
            );
            left_at = Some(setting.mean_at(offset));
            let mut record = OrbitRecord::new(&mut marks, states, 2 * modes, most);
            let stuck = Settled::Stuck(zero);
            found = followed(&mut cycle_map, &mut workspace, stuck, &mut record)?;
            period = record.done();
        }
        let RecordedPeriod {
            count,
            stops,
            reversals,
            origin,
        } = period;
        let mut orbit = Self {
            setting,
            parts: clean,
            numbers,
            multipliers,
            marks,
            count,
            period: found.period,
            stops,
            reversals,
            symmetric: found.symmetric,
            marginal: found.marginal,
            settled: found.settled,
            left_at,
            offset_range: None,
            origin: origin.0,
            origin_cycle: origin.1,
        };
        let steady = holding.filter(|_| orbit.never_slides());
        let range = steady.map(|force| setting.offset_range(force));
        orbit.offset_range = range.or(found.reach.map(|reach| orbit.offset().abs() * reach));
        Ok(orbit)
    }
}

/// Returns true if the contact sticks in every segment of a recorded period.
fn sticks<S: Float>(marks: &[SegmentStart<S>], period: &RecordedPeriod<S>) -> bool {
    let mut marks = marks.iter().take(period.count);
    period.stops == 0 && marks.all(|mark| mark.contact_state.contact == Contact::Stuck)
}

/// Follows the motion from its initial state `start` to a steady state. If a stuck state exists, `holding` is the
/// amplitude of its contact force |V/H|. With `AT_LENGTH` the function can search longer, and `unsettled` receives the
/// number of followed cycles if the motion does not settle. `spare` is working memory for two states.
fn reach<const AT_LENGTH: bool, S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    (start, holding): (Start<'_, S>, Option<S>),
    spare: &mut [S],
    unsettled: &mut Option<u32>,
) -> Result<Settled<S>, NoOrbit> {
    let setting = cycle_map.setting;
    match (setting.beta.is_zero() || start == Start::Stuck, holding) {
        (true, None) => return Ok(Settled::Found(linear(cycle_map, workspace)?)),
        // β = 0 in this case means that β*_lim is 0. The load then does not move the contact.
        (true, Some(_)) => return Ok(Settled::Stuck(S::constant(0.0))),
        _ => {}
    }
    if let Start::Cycle(.., period) = start {
        return repeating(cycle_map, workspace, period);
    }
    let most = start.most_cycles();
    let mut motion = FollowedMotion::new(holding, setting.law().is_contraction());
    let settled = settle(cycle_map, workspace, &mut motion, most, spare)?;
    match settled {
        Settled::Not(failure) if AT_LENGTH && most == MAX_CYCLES => {
            let followed = (&mut motion, holding);
            let (found, reached) = wander(cycle_map, workspace, followed, failure, spare);
            *unsettled = (!reached).then_some(motion.cycles);
            Ok(match found {
                // The stuck state is an answer to a motion from rest. A sweep, or another start, asks for the state that
                // its own motion reaches.
                Settled::Not(_) if start == Start::Rest && holding.is_some() => {
                    Settled::Stuck(S::constant(0.0))
                }
                found => found,
            })
        }
        settled => Ok(settled),
    }
}

/// Refines a state from which the motion repeats after a number of cycles, stable or not.
fn repeating<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    period: u32,
) -> Result<Settled<S>, NoOrbit> {
    let map = PeriodMap {
        period,
        symmetric: false,
    };
    cycle_map.save(workspace.state);
    if newton(cycle_map, workspace, map)?.is_none() {
        return Ok(Settled::Not(NoOrbit::Unsettled));
    }
    multipliers(cycle_map, workspace, map)?;
    Ok(Settled::Found(FoundState {
        settled: true,
        period,
        ..FoundState::NONE
    }))
}

/// Follows the motion from the state that the search has reached, and records one period of the motion.
fn followed<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    settled: Settled<S>,
    record: &mut OrbitRecord<'_, S>,
) -> Result<FoundState<S>, NoOrbit> {
    let found = match settled {
        Settled::Stuck(offset) => {
            let found = stuck(cycle_map, workspace, offset)?;
            record.stuck(cycle_map, offset);
            return Ok(found);
        }
        Settled::Found(found) => found,
        Settled::Not(_) => FoundState::NONE,
    };
    // The search may have used up the step budget. The record of the period gets a new step budget.
    cycle_map.step_budget = MAX_STEPS;
    record_period(cycle_map, record, found.period)?;
    let symmetric = found.symmetric || is_symmetric(cycle_map, workspace, found.period)?;
    Ok(FoundState { symmetric, ..found })
}

/// Records one period of the motion. The record starts at the first event of the period.
pub(super) fn record_period<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    record: &mut OrbitRecord<'_, S>,
    period: u32,
) -> Result<(), NoOrbit> {
    to_event(cycle_map, period)?;
    let at = cycle_map.contact_state.t.sin_cos_pi();
    settle_free(cycle_map, at)?;
    record.follow(cycle_map, period)
}

/// Returns the reason why a sliding motion grows without bound, or `None` if the motion stays bounded.
///
/// # Errors
/// [`NoOrbit::Undamped`] if the load drives a mode whose vibration neither damping nor the contact dissipates.
fn unbounded<S: Float, K: ContactChain<S>>(
    dynamics: &Dynamics<'_, S, K>,
    r: S,
    beta: S,
) -> Result<Option<NoOrbit>, NoOrbit> {
    let mut unbounded = None;
    for (index, mode) in dynamics.modes.iter().enumerate() {
        settles(dynamics, mode, index)?;
        unbounded = unbounded.or(bounded(mode, r, beta).err());
    }
    Ok(unbounded)
}

/// Returns an error if the load drives a mode whose vibration neither damping nor the contact dissipates.
fn settles<S: Float, K: ContactChain<S>>(
    dynamics: &Dynamics<'_, S, K>,
    mode: &Mode<S>,
    index: usize,
) -> Result<(), NoOrbit> {
    if mode.kind != Kind::Undamped || mode.load.is_zero() || mode.in_contact {
        return Ok(());
    }
    let below = |other: &&Mode<S>| other.resonance < mode.resonance;
    let earlier = dynamics.modes.iter().filter(below).count();
    let equal = dynamics.modes.iter().take(index);
    let twins = equal.filter(|other| other.resonance == mode.resonance);
    Err(NoOrbit::Undamped(earlier + twins.count()))
}

/// Returns an error if the amplitude of the mode grows without bound while the contact slides.
fn bounded<S: Float>(mode: &Mode<S>, r: S, beta: S) -> Result<(), NoOrbit> {
    // If β is smaller than β_n = (π/4)|φᵀp/φᵀw|, friction dissipates less energy than the load supplies (6.2, 6.26).
    // φᵀp and φᵀw are the components of the mode in the load and in the contact's displacement.
    let threshold = S::constant(FRAC_PI_4) * mode.load.abs();
    let resonant = mode.kind == Kind::Undamped && mode.resonance == r;
    if resonant && beta * mode.contact.abs() < threshold {
        return Err(NoOrbit::Unbounded);
    }
    Ok(())
}

/// Sets the cycle map to the steady state in which the contact never slides (6.11, 6.27, 6.33). Every mode of the
/// chain with its contact stuck has its steady motion, and the relative displacement z̄ is always `offset`.
pub(super) fn stuck<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    offset: S,
) -> Result<FoundState<S>, NoOrbit> {
    let zero = S::constant(0.0);
    let at = (zero, S::constant(1.0));
    for part in cycle_map.stuck_modes.iter_mut() {
        part.settle(at).ok_or(NoOrbit::Unbounded)?;
    }
    settle_free(cycle_map, at)?;
    let driven = cycle_map.setting.dynamics.in_contact();
    let states = cycle_map.modes.iter_mut().take(driven);
    let states = states.map(|part| (&mut part.y, &mut part.u));
    let lifted = cycle_map.setting.lifted(offset, at);
    cycle_map
        .setting
        .release(cycle_map.stuck_modes, lifted, states);
    cycle_map.contact_state = ContactState {
        memory: K::memory_at(cycle_map.setting, cycle_map.stuck_modes, offset, at),
        ..ContactState::stuck(zero)
    };
    // While the contact sticks, small deviations of the modes decay independently of each other.
    let two_pi = S::pi() + S::pi();
    let mut out = workspace.multipliers.iter_mut();
    // `zip` takes an item of its first argument before it finds that its second argument is empty. `lost` therefore
    // comes first, so that no element of `out` is skipped.
    let lost = cycle_map.setting.dynamics.chain.stuck_multipliers();
    for (is_one, out) in lost.iter().zip(out.by_ref()) {
        let re = if *is_one { S::constant(1.0) } else { zero };
        *out = Complex::new(re, zero);
    }
    for part in cycle_map.stuck_modes.iter() {
        for multiplier in part.multipliers(two_pi) {
            if let Some(out) = out.next() {
                *out = multiplier;
            }
        }
    }
    Ok(FoundState {
        settled: true,
        period: 1,
        symmetric: offset.is_zero(),
        marginal: true,
        reach: None,
    })
}

/// Sets every mode to its steady motion without friction, which is the steady state for β = 0.
fn linear<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
) -> Result<FoundState<S>, NoOrbit> {
    let at = (S::constant(0.0), S::constant(1.0));
    let driven = cycle_map.setting.dynamics.in_contact();
    for part in cycle_map.modes.iter_mut().take(driven) {
        part.settle(at).ok_or(NoOrbit::Unbounded)?;
    }
    settle_free(cycle_map, at)?;
    cycle_map.contact_state = cycle_map
        .setting
        .contact_state(cycle_map.modes, S::constant(0.0));
    let largest = multipliers(cycle_map, workspace, PeriodMap::HALF_CYCLE)?;
    Ok(FoundState {
        settled: true,
        period: 1,
        symmetric: true,
        marginal: S::constant(1.0 - ON_CIRCLE * S::EPSILON) < largest,
        reach: None,
    })
}

/// Sets every mode that the contact does not drive to its steady motion.
fn settle_free<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    at: (S, S),
) -> Result<(), NoOrbit> {
    let driven = cycle_map.setting.dynamics.in_contact();
    for part in cycle_map.modes.iter_mut().skip(driven) {
        part.settle(at).ok_or(NoOrbit::Unbounded)?;
    }
    Ok(())
}

/// Advances the cycle map to the next event of the period. If no event occurs before the end of the period, the contact
/// state does not change.
fn to_event<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    period: u32,
) -> Result<(), NoOrbit> {
    let section: ContactState<S> = cycle_map.contact_state;
    let mut left = (S::pi() + S::pi()) * S::constant(f64::from(period));
    loop {
        let end = leap(
            cycle_map.setting,
            cycle_map.modes,
            cycle_map.stuck_modes,
            cycle_map.contact_state,
            left,
        );
        // A search that is too long ends without an event. If a mode oscillates faster than the precision of r
        // resolves, every search ends without an event. The loop then ends when the step budget is used up.
        cycle_map.spend(end.steps)?;
        cycle_map.contact_state = end.contact_state;
        left = left - end.tau;
        if end.event.is_some() {
            return Ok(());
        }
        if !(S::constant(0.0) < left) {
            cycle_map.contact_state = section;
            return Ok(());
        }
    }
}

/// Returns true if the state half a period later is the present state with the opposite sign. If the period has an even
/// number of cycles, the result is false, because the load then has the same sign half a period later.
fn is_symmetric<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    period: u32,
) -> Result<bool, NoOrbit> {
    if period.is_multiple_of(2) {
        return Ok(false);
    }
    cycle_map.save(workspace.other);
    for _ in 0..period {
        cycle_map.advance_half(None)?;
    }
    cycle_map.save(workspace.state);
    let distance = workspace.state.iter().zip(workspace.other.iter());
    let distance = distance.fold(S::constant(0.0), |most, (a, b)| most.max((*a + *b).abs()));
    Ok(distance <= same(cycle_map.scale()))
}
