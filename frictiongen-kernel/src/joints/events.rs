//! The next event of each contact, on the power series of a stretch.

use super::first::first_negative;
use super::room::{Found, JointState, Kind, Phase};
use super::stretch::Stretch;
use super::{Chain, Joint, ORDERS, Room, Series, TERMS, term, whole};
use crate::number::scalar::Float;

/// What the events of a contact depend on.
struct Seen<'a, T> {
    joint: &'a Joint<T>,
    force: &'a Series<T>,
    level: &'a Series<T>,
    velocity: Series<T>,
    span: T,
    /// Rounding errors of a velocity and of an acceleration.
    roundings: (T, T),
}

/// Writes the next event of each contact within the stretch.  Returns the instant of the first event, if there is one.
pub(super) fn next_events<T: Float>(
    chain: &Chain<'_, T>,
    room: &mut Room<'_, T>,
    stretch: &Stretch<T>,
    roundings: (T, T),
) -> Option<T> {
    let velocities = &*room.velocities;
    let mut earliest = None;
    let contacts = chain.joints.iter().zip(room.joints.iter_mut());
    for ((joint, state), (force, level)) in contacts.zip(room.forces.iter().zip(room.levels.iter()))
    {
        let mut velocity = [T::constant(0.0); TERMS];
        for (n, place) in velocity.iter_mut().take(ORDERS + 1).enumerate() {
            let relative = joint.link.coefficient(velocities, n);
            *place = relative - joint.link.base * stretch.base_velocity(n);
        }
        let seen = Seen {
            joint,
            force,
            level,
            velocity,
            span: stretch.span,
            roundings,
        };
        state.next = next_event(&seen, state);
        if let Some(found) = state.next {
            earliest = Some(earliest.map_or(found.at, |at: T| at.min(found.at)));
        }
    }
    earliest
}

/// Returns the first event of a contact.
fn next_event<T: Float>(seen: &Seen<'_, T>, state: &JointState<T>) -> Option<Found<T>> {
    let zero = T::constant(0.0);
    let one = T::constant(1.0);
    let mut first: Option<Found<T>> = None;
    let mut ask = |kind: Kind, floors: [T; 3], function: &dyn Fn(usize) -> T| {
        let mut series = [zero; TERMS];
        for (n, place) in series.iter_mut().take(ORDERS).enumerate() {
            *place = function(n);
        }
        let most = first.map_or(one, |found| found.at);
        if let Some(at) = first_negative(&series, most, state.fresh.then_some(floors)) {
            first = Some(Found { at, kind });
        }
    };
    let none = [zero; 3];
    let (of_velocity, of_acceleration) = seen.roundings;
    if state.phase == Phase::Free {
        ask(Kind::Closes, none, &|n| -term(seen.level, n));
        return first;
    }
    if seen.level.iter().skip(1).any(|term| !term.is_zero()) {
        ask(Kind::Opens, none, &|n| term(seen.level, n));
    }
    if state.phase == Phase::Stuck {
        let stiction = seen.joint.stiction;
        let floors = seen.joint.stiffness.map_or(none, |stiffness| {
            let velocity = stiffness * seen.span * of_velocity;
            [
                zero,
                velocity,
                stiffness * seen.span * seen.span * of_acceleration,
            ]
        });
        ask(Kind::Breaks(Phase::Positive), floors, &|n| {
            stiction * term(seen.level, n) - term(seen.force, n)
        });
        ask(Kind::Breaks(Phase::Negative), floors, &|n| {
            stiction * term(seen.level, n) + term(seen.force, n)
        });
    } else {
        // The slider of an elastic contact moves with the spring's force taken off.
        let slack = seen
            .joint
            .stiffness
            .map_or(zero, |stiffness| one / (stiffness * seen.span));
        let of_later = of_acceleration * seen.span;
        let floors = [of_velocity, of_later, of_later];
        ask(Kind::Stops, floors, &|n| {
            state.phase.signed(term(&seen.velocity, n))
                - slack * whole(n + 1) * term(seen.level, n + 1)
        });
    }
    first
}
