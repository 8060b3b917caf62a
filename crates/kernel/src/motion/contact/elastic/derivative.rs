//! Growth of small deviations along a motion with an elastic contact.
//!
//! A deviation consists of the displacement y and the scaled velocity u of each mode, and of the contact force. While
//! the contact slides, the deviation of the force is zero. When the slider stops, a deviation does not jump, because
//! the force is continuous and its slope is zero at this instant.

use super::ElasticChain;
use crate::motion::contact::state::{Contact, ContactState, SegmentEnd};
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// Advances small deviations of the state through a segment (the motion between two events), one column after another.
/// A column contains the displacement y and the scaled velocity u of each mode, and then the contact force. `modes` and
/// `stuck_modes` are the oscillators after the segment. The function overwrites the states in `stuck_modes`.
pub(super) fn carry<S: Float>(
    setting: &MotionSetting<'_, S, ElasticChain<S>>,
    (modes, stuck_modes): (&[Part<S>], &mut [Part<S>]),
    contact_state: &ContactState<S>,
    end: &SegmentEnd<S>,
    columns: &mut [S],
) {
    let zero = S::constant(0.0);
    let driven = setting.dynamics.in_contact();
    let t = end.tau * S::inverse_pi();
    for column in columns.chunks_exact_mut((2 * driven + 1).max(1)) {
        let (column, force) = column.split_at_mut(2 * driven);
        let Some(force) = force.first_mut() else {
            continue;
        };
        if contact_state.contact == Contact::Stuck {
            stuck(setting, stuck_modes, (t, end.tau), column, force);
            if end.event.is_some() {
                if !end.jump.is_zero() {
                    setting.delay(end.jump, -(*force / end.slope), column);
                }
                *force = zero;
            }
        } else {
            for (part, state) in modes.iter().take(driven).zip(pairs_mut(column)) {
                let turn = part.turn(t, end.tau);
                if let [y, u] = state {
                    [*y, *u] = part.turned([*y, *u], &turn);
                }
            }
            *force = zero;
        }
    }
}

/// Advances small deviations of the state while the contact sticks. The deviation of the slider's displacement stays
/// constant. The rest of a deviation moves with the modes of the chain with its contact stuck.
fn stuck<S: Float>(
    setting: &MotionSetting<'_, S, ElasticChain<S>>,
    stuck_modes: &mut [Part<S>],
    (t, tau): (S, S),
    column: &mut [S],
    force: &mut S,
) {
    let zero = S::constant(0.0);
    let states = pairs(column).map(|state| match state {
        [y, u] => [*y, *u],
        _ => [zero; 2],
    });
    let driven = setting.dynamics.driven().iter().zip(states.clone());
    let place = driven.fold(
        -(setting.dynamics.chain.compliance * *force),
        |sum, (mode, [y, _])| sum + mode.contact * y,
    );
    setting.project(states, (place, zero), stuck_modes);
    setting.set_elastic_force(stuck_modes, place, *force);
    for part in stuck_modes.iter_mut() {
        let turn = part.turn(t, tau);
        [part.y, part.u] = part.turned([part.y, part.u], &turn);
    }
    *force = setting.elastic_force(stuck_modes, place);
    let states = pairs_mut(column).filter_map(|state| match state {
        [y, u] => Some((y, u)),
        _ => None,
    });
    setting.release(stuck_modes, (place, zero), states);
}
