//! Growth of small deviations along a motion with a rigid contact. Between events the growth has a closed form. At each
//! event a deviation jumps (saltation), because the event then occurs slightly earlier or later.

use crate::motion::contact::state::{Contact, ContactState, SegmentEnd};
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// Advances small deviations of the state through a segment (the motion between two events), one column after another.
/// A column contains the displacement y and the scaled velocity u of each mode. `modes` and `stuck_modes` are the
/// oscillators after the segment. The function overwrites the states in `stuck_modes`.
pub(super) fn carry<S: Float>(
    setting: &MotionSetting<'_, S>,
    (modes, stuck_modes): (&[Part<S>], &mut [Part<S>]),
    contact_state: &ContactState<S>,
    end: &SegmentEnd<S>,
    columns: &mut [S],
) {
    let size = 2 * setting.dynamics.in_contact();
    let t = end.tau * S::inverse_pi();
    if contact_state.contact == Contact::Stuck {
        for column in columns.chunks_exact_mut(size.max(1)) {
            stuck(setting, stuck_modes, t, end, column);
        }
    } else {
        for (index, part) in modes.iter().enumerate().take(size / 2) {
            let turn = part.turn(t, end.tau);
            for column in columns.chunks_exact_mut(size.max(1)) {
                if let Some([y, u]) = column.get_mut(2 * index..2 * index + 2) {
                    [*y, *u] = part.turned([*y, *u], &turn);
                }
            }
        }
    }
    if end.event.is_some() {
        for column in columns.chunks_exact_mut(size.max(1)) {
            jump(setting, contact_state, end, column);
        }
    }
}

/// Advances small deviations of the state while the contact sticks. The deviation of the contact's displacement stays
/// constant. The rest of a deviation moves with the modes of the chain with its contact stuck.
fn stuck<S: Float>(
    setting: &MotionSetting<'_, S>,
    stuck_modes: &mut [Part<S>],
    t: S,
    end: &SegmentEnd<S>,
    column: &mut [S],
) {
    let zero = S::constant(0.0);
    let driven = setting.dynamics.driven();
    let states = pairs(column).map(|state| match state {
        [y, u] => [*y, *u],
        _ => [zero; 2],
    });
    let moved = driven
        .iter()
        .zip(states.clone())
        .fold(zero, |sum, (mode, [y, _])| sum + mode.contact * y);
    setting.project(states, (moved, zero), stuck_modes);
    for part in stuck_modes.iter_mut() {
        let turn = part.turn(t, end.tau);
        [part.y, part.u] = part.turned([part.y, part.u], &turn);
    }
    let states = pairs_mut(column).filter_map(|state| match state {
        [y, u] => Some((y, u)),
        _ => None,
    });
    setting.release(stuck_modes, (moved, zero), states);
}

/// Applies the jump of a deviation at an event. The deviation shifts the event by the time δτ = −δf/f′, where f is the
/// function whose zero is the event. During this time the state has its slope before the event, and not its slope after
/// the event. The two slopes differ by the jump of the contact force.
fn jump<S: Float>(
    setting: &MotionSetting<'_, S>,
    contact_state: &ContactState<S>,
    end: &SegmentEnd<S>,
    column: &mut [S],
) {
    if end.jump.is_zero() {
        return;
    }
    let (zero, two) = (S::constant(0.0), S::constant(2.0));
    let driven = setting.dynamics.driven();
    let mut deviation = zero;
    for (mode, state) in driven.iter().zip(pairs(column)) {
        let [y, u] = state else { continue };
        let sigma = mode.resonance;
        deviation = deviation
            + mode.contact
                * if contact_state.contact == Contact::Stuck {
                    // This number is the deviation of the contact force, times −m* (inverse effective mass of the
                    // contact).
                    sigma * sigma * (*y + two * mode.zeta * *u)
                } else {
                    sigma / setting.r * *u
                };
    }
    if contact_state.contact == Contact::Stuck {
        deviation = -(deviation / setting.dynamics.chain.inverse_mass);
    }
    setting.delay(end.jump, -(deviation / end.slope), column);
}
