//! Construction of the steady state of a scene at r and β.

use super::candidate::{Found, ON_CIRCLE};
use super::cycle_map::CycleMap;
use super::newton::{Map, Workspace, multipliers, same};
use super::record::{Record, Recorded};
use super::shooting::{Settled, settle};
use super::start::Start;
use super::types::{MAX_SEGMENTS, MAX_STEPS, Orbit, SegmentStart};
use crate::errors::{NoOrbit, OutOfDomain, Slice};
use crate::motion::{ContactState, Dynamics, Part, STUCK_MULTIPLIERS, Setting, leap};
use crate::number::complex::Complex;
use crate::number::scalar::{Float, Plain};
use crate::oscillator::mode::{Kind, Mode};
use core::f64::consts::FRAC_PI_4;

impl<'a, S, P, V, C> Orbit<'a, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    /// Computes the steady state at r and β that is reached from a start at a maximum of the excitation.  `sliding` is
    /// β*_lim, from which on the motion may end with the contact stuck.
    ///
    /// `last` decides the result where the motion does not settle.  If `last` is true, the result is the motion's last
    /// [`MAX_PERIOD`](super::MAX_PERIOD) cycles, and [`Self::is_settled`] is false.  If `last` is false, the result is
    /// an error.
    ///
    /// # Errors
    /// [`NoOrbit`] gives the reason why there is no steady state.  Slices of a wrong length give `OutOfDomain`.
    #[allow(
        clippy::too_many_arguments,
        reason = "one question and the room for its answer"
    )]
    pub fn new(
        dynamics: Dynamics<'a, S>,
        r: S,
        beta: S,
        sliding: S,
        start: Start<'_, S>,
        last: bool,
        mut parts: P,
        mut numbers: V,
        mut multipliers: C,
    ) -> Result<Self, NoOrbit>
    where
        S: Plain,
    {
        let zero = S::constant(0.0);
        let setting = Setting::new(dynamics, r, beta, parts.as_mut())?;
        let driven = dynamics.in_contact();
        for (found, needed, slice) in [
            (
                numbers.as_ref().len(),
                super::numbers(dynamics.modes.len(), driven),
                Slice::Storage,
            ),
            (multipliers.as_ref().len(), 2 * driven, Slice::Multipliers),
        ] {
            if found != needed {
                return Err(OutOfDomain::Length(slice).into());
            }
        }
        // From β*_lim on a stuck state exists.  The motion decides whether that state is reached.
        let holding = (!(beta < sliding)).then_some(setting.law_at(sliding).grip());
        let mut unbounded = None;
        for (index, mode) in dynamics.modes.iter().enumerate() {
            settles(&dynamics, mode, index)?;
            unbounded = unbounded.or(bounded(mode, r, beta).err());
        }
        if let (Some(error), None) = (unbounded, holding) {
            return Err(error);
        }
        let clean = parts.clone();
        let (modes, stuck_modes) = setting.split(parts.as_mut());
        let mut cycle_map = CycleMap {
            contact_state: setting.contact_state(modes, zero),
            setting: &setting,
            modes,
            stuck_modes,
            middle: zero,
            stuck: zero,
            step_budget: MAX_STEPS,
            slid: false,
        };
        let workspace = numbers.as_mut();
        let (states, rest) =
            workspace.split_at_mut(workspace.len().min(MAX_SEGMENTS * 2 * dynamics.modes.len()));
        let (matrix, rest) = rest.split_at_mut(rest.len().min(4 * driven * driven));
        let (state, other) = rest.split_at_mut(rest.len() / 2);
        let mut workspace = Workspace {
            matrix,
            state,
            other,
            multipliers: multipliers.as_mut(),
        };
        let mut marks = [SegmentStart::empty(); MAX_SEGMENTS];
        start
            .checked(holding.is_some())?
            .set_start(&mut cycle_map, &mut workspace)?;
        let settled = match (beta.is_zero() || start == Start::Stuck, holding) {
            (true, None) => Settled::Found(linear(&mut cycle_map, &mut workspace)?),
            // With β = 0 this case means β*_lim = 0 as well, so that the load does not move the contact.
            (true, Some(_)) => Settled::Stuck(zero),
            _ => {
                let spare = states.get_mut(..4 * driven).unwrap_or_default();
                let most = start.most_cycles();
                settle(&mut cycle_map, &mut workspace, holding, most, spare)?
            }
        };
        let mut record = Record::new(&mut marks, states, 2 * dynamics.modes.len());
        let found = if let Settled::Stuck(offset) = settled {
            let found = stuck(&mut cycle_map, &mut workspace, offset)?;
            record.stuck(&cycle_map, offset);
            found
        } else {
            let found = match (settled, unbounded) {
                (Settled::Not(_), Some(error)) => return Err(error),
                (Settled::Not(error), None) if !last => return Err(error),
                (Settled::Found(found), _) => found,
                _ => Found::NONE,
            };
            // The search may have used up the steps.  The record of the period may take as many again.
            cycle_map.step_budget = MAX_STEPS;
            to_event(&mut cycle_map, found.period)?;
            let at = cycle_map.contact_state.t.sin_cos_pi();
            settle_free(&mut cycle_map, at)?;
            record.follow(&mut cycle_map, found.period)?;
            let symmetric =
                found.symmetric || is_symmetric(&mut cycle_map, &mut workspace, found.period)?;
            Found { symmetric, ..found }
        };
        let Recorded {
            count,
            stops,
            reversals,
            origin,
        } = record.done();
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

/// Fails if the load drives a mode for ever that neither damping nor the contact dissipates.
fn settles<S: Float>(
    dynamics: &Dynamics<'_, S>,
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

/// Fails if a sliding mode grows without bound.
fn bounded<S: Float>(mode: &Mode<S>, r: S, beta: S) -> Result<(), NoOrbit> {
    // Below β_n = (π/4)|φᵀp/φᵀw| friction dissipates less than the load supplies (6.2, 6.26).
    let threshold = S::constant(FRAC_PI_4) * mode.load.abs();
    let resonant = mode.kind == Kind::Undamped && mode.resonance == r;
    if resonant && beta * mode.contact.abs() < threshold {
        return Err(NoOrbit::Unbounded);
    }
    Ok(())
}

/// Sets the state in which the contact never slides (6.11, 6.27, 6.33).  Every mode of the stuck chain is in its steady
/// motion, with z̄ fixed at `offset`.
pub(super) fn stuck<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    offset: S,
) -> Result<Found<S>, NoOrbit> {
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
    cycle_map.contact_state = ContactState::stuck(zero);
    // Deviations of the stuck chain's modes decay independently.
    let two_pi = S::pi() + S::pi();
    let mut out = workspace.multipliers.iter_mut();
    // The array has to be the first argument of `zip`.  Otherwise `zip` would take one more multiplier and drop it.
    for (re, out) in STUCK_MULTIPLIERS.into_iter().zip(out.by_ref()) {
        *out = Complex::new(S::constant(re), zero);
    }
    for part in cycle_map.stuck_modes.iter() {
        for multiplier in part.multipliers(two_pi) {
            if let Some(out) = out.next() {
                *out = multiplier;
            }
        }
    }
    Ok(Found {
        settled: true,
        period: 1,
        symmetric: offset.is_zero(),
        marginal: true,
        reach: None,
    })
}

/// Sets every mode to its steady motion, for β = 0.
fn linear<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
) -> Result<Found<S>, NoOrbit> {
    let at = (S::constant(0.0), S::constant(1.0));
    let driven = cycle_map.setting.dynamics.in_contact();
    for part in cycle_map.modes.iter_mut().take(driven) {
        part.settle(at).ok_or(NoOrbit::Unbounded)?;
    }
    settle_free(cycle_map, at)?;
    cycle_map.contact_state = cycle_map
        .setting
        .contact_state(cycle_map.modes, S::constant(0.0));
    let largest = multipliers(cycle_map, workspace, Map::HALF_CYCLE)?;
    Ok(Found {
        settled: true,
        period: 1,
        symmetric: true,
        marginal: S::constant(1.0 - ON_CIRCLE * S::EPSILON) < largest,
        reach: None,
    })
}

/// Sets the modes that the contact does not touch to their steady motion.
pub(super) fn settle_free<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    at: (S, S),
) -> Result<(), NoOrbit> {
    let driven = cycle_map.setting.dynamics.in_contact();
    for part in cycle_map.modes.iter_mut().skip(driven) {
        part.settle(at).ok_or(NoOrbit::Unbounded)?;
    }
    Ok(())
}

/// Advances to the first event of a period.  A period without an event leaves the contact state as it was.
pub(super) fn to_event<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
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
        // A leap too long for one search ends without an event.  A mode may turn faster than the precision of r
        // resolves.  Such leaps then never end, so that the step budget has to end them.
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

/// Returns true if half a period takes the state to its opposite.  For an even number of cycles the load has the same
/// sign half a period later, so no state is opposite.
fn is_symmetric<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
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
