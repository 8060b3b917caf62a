//! One segment of the motion, from one event of the contact to the next.

use super::clock::{moved, phase};
use super::contact::{
    Contact, ContactChain, ContactState, Law, SegmentEnd, SegmentOutcome, Sought,
};
use super::oscillator::{Part, advanced};
use super::series::OscillatorSum;
use super::setting::MotionSetting;
use super::walk::{WalkResult, WalkStart, first_reach, first_zero};
use crate::number::scalar::Float;

/// Searches for the event that ends the segment after a contact state. The search covers the time `reach` in τ (rad of
/// the excitation). Also prepares the oscillators for the segment.
pub(crate) fn seek<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    modes: &mut [Part<S>],
    stuck_modes: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> Sought<S> {
    let zero = S::constant(0.0);
    let mut sought = Sought::none(contact_state);
    if contact_state.contact == Contact::Stuck {
        let (sum, offset) = setting.start_sticking(modes, stuck_modes, &contact_state, reach);
        let start = if contact_state.wedged {
            WalkStart::Wedged
        } else {
            WalkStart::Anywhere
        };
        let grip = setting.law().grip();
        let walk = first_reach(&sum, grip, zero, start, &mut sought.steps);
        (sought.tau, sought.outcome) = match walk {
            WalkResult::Zero(tau, negative) => {
                (tau, SegmentOutcome::Breaks(Contact::towards(negative)))
            }
            WalkResult::Until(tau) => (tau, SegmentOutcome::Goes),
            WalkResult::NoStart => (reach, SegmentOutcome::Goes),
        };
        sought.offset = offset;
        if S::CARRIES {
            let level = match sought.outcome {
                SegmentOutcome::Breaks(contact) => Some(grip.copysign(contact.sign())),
                _ => None,
            };
            sought.tau = carried(&sum, sought.tau, level);
        }
        sought.slope = sum.local(sought.tau).slope;
    } else {
        let sum = setting.start_sliding(modes, &contact_state, reach);
        let start = contact_state
            .memory
            .map_or(WalkStart::Anywhere, WalkStart::Zero);
        (sought.tau, sought.outcome) = match first_zero(&sum, start, &mut sought.steps) {
            WalkResult::Zero(tau, _) => (tau, SegmentOutcome::Halts),
            WalkResult::Until(tau) => (tau, SegmentOutcome::Goes),
            WalkResult::NoStart => (zero, SegmentOutcome::Holds),
        };
        if S::CARRIES {
            let level = (sought.outcome == SegmentOutcome::Halts).then_some(zero);
            sought.tau = carried(&sum, sought.tau, level);
        }
    }
    sought
}

/// Adds derivatives to the instant `tau` at which a sum reaches its level, if the scalar carries derivatives. One
/// Newton step from the known instant gives the derivatives. If `level` is `None`, no event ends the segment. If `tau`
/// is then the whole searched length, `tau` gets the derivatives of this length, and otherwise no derivatives.
fn carried<S: Float>(sum: &OscillatorSum<'_, S>, tau: S, level: Option<S>) -> S {
    let Some(level) = level else {
        return if tau < sum.reach {
            tau.primal()
        } else {
            sum.reach
        };
    };
    let local = sum.local(tau.primal());
    let gap = local.value - level;
    tau.primal() - (gap - gap.primal()) / local.slope.primal()
}

/// Sets the oscillators to their state at the time `tau` after the start of the segment. `to` is sine and cosine of
/// the excitation's phase at that instant.
pub(crate) fn place<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    (modes, stuck_modes): (&mut [Part<S>], &mut [Part<S>]),
    sought: &Sought<S>,
    tau: S,
    to: (S, S),
) {
    let from = phase(sought.contact_state.t);
    if sought.contact_state.contact != Contact::Stuck {
        return advanced(modes, tau, from, to);
    }
    advanced(stuck_modes, tau, from, to);
    let driven = setting.dynamics.in_contact().min(modes.len());
    let (modes, others) = modes.split_at_mut(driven);
    advanced(others, tau, from, to);
    let states = modes.iter_mut().map(|part| (&mut part.y, &mut part.u));
    setting.release(stuck_modes, setting.lifted(sought.offset, to), states);
}

/// Returns the end of a segment: its event, and the contact state after the event. The caller must already have
/// advanced the oscillators to the end.
pub(crate) fn ended<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    (modes, stuck_modes): (&[Part<S>], &[Part<S>]),
    sought: &Sought<S>,
    to: (S, S),
) -> SegmentEnd<S> {
    let mut end = quiet(sought.tau, sought.contact_state, sought.steps);
    match sought.outcome {
        SegmentOutcome::Goes if sought.contact_state.contact == Contact::Stuck => {
            end.contact_state.memory = K::memory_at(setting, stuck_modes, sought.offset, to);
        }
        SegmentOutcome::Goes => {}
        SegmentOutcome::Holds => {
            end.contact_state.memory = K::memory_at_stop(setting, sought.contact_state.contact);
            end.contact_state.contact = Contact::Stuck;
            end.contact_state.wedged = true;
        }
        SegmentOutcome::Breaks(contact) => {
            end.slope = sought.slope;
            K::break_away(setting, contact, &mut end);
        }
        SegmentOutcome::Halts => K::halt(setting, modes, to, &mut end),
    }
    end
}

/// Returns the time τ from a contact state to the next event, or `reach` if the event is later. The result is 0 if the
/// contact cannot start to move from zero velocity.
pub(crate) fn span<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    modes: &mut [Part<S>],
    stuck_modes: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> S {
    let sought = seek(setting, modes, stuck_modes, contact_state, reach);
    if sought.holds() {
        return S::constant(0.0);
    }
    sought.tau
}

/// Advances the oscillators from a contact state to the next event, or by `reach` if the event is later, and returns
/// the end of the segment.
pub(crate) fn leap<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    modes: &mut [Part<S>],
    stuck_modes: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> SegmentEnd<S> {
    let sought = seek(setting, modes, stuck_modes, contact_state, reach);
    let to = phase(moved(contact_state.t, sought.tau));
    if sought.outcome != SegmentOutcome::Holds {
        place(setting, (modes, stuck_modes), &sought, sought.tau, to);
    }
    ended(setting, (&*modes, &*stuck_modes), &sought, to)
}

/// Returns the [`SegmentEnd`] of a segment of length `tau` in which no event occurs.
fn quiet<S: Float>(tau: S, contact_state: ContactState<S>, steps: u32) -> SegmentEnd<S> {
    let zero = S::constant(0.0);
    SegmentEnd {
        tau,
        event: None,
        contact_state: ContactState {
            t: moved(contact_state.t, tau),
            memory: None,
            wedged: false,
            ..contact_state
        },
        slope: zero,
        jump: zero,
        steps,
    }
}
