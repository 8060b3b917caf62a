//! Positions and velocities of masses that stuck contacts tie together.

use super::{Chain, MAX_JOINTS, Room, term};
use crate::number::scalar::Float;

/// Sets the velocities of tied masses equal, and their positions to the places of the contacts, for the contacts of
/// `tied`.  Without it the roundings of the series would add up to a creep.  `base` has displacement and velocity of the
/// base.  The contacts form no loop.
pub(super) fn tie<T: Float>(
    chain: &Chain<'_, T>,
    room: &mut Room<'_, T>,
    tied: &[bool; MAX_JOINTS],
    (displacement, velocity): (T, T),
) {
    let mut done = [false; MAX_JOINTS];
    let set = |room: &mut Room<'_, T>, index: usize, forward: bool| {
        let (Some(joint), Some(state)) = (chain.joints.get(index), room.joints.get(index)) else {
            return;
        };
        let (link, place) = (joint.link, state.place);
        let (near, far) = if forward {
            (link.from, link.to)
        } else {
            (link.to, link.from)
        };
        let sign = T::constant(if forward { 1.0 } else { -1.0 });
        let of = |x: &[T]| near.map_or(T::constant(0.0), |mass| term(x, mass));
        let x = of(room.x) + sign * (place + link.base * displacement);
        let v = of(room.v) + sign * (link.base * velocity);
        let Some(far) = far else { return };
        if let Some(place) = room.x.get_mut(far) {
            *place = x;
        }
        if let Some(place) = room.v.get_mut(far) {
            *place = v;
        }
    };
    // From the ground outwards, then from the first mass of each group that nothing holds.
    for _ in 0..=chain.joints.len() {
        let held =
            |end: Option<usize>, done: &[bool; MAX_JOINTS]| {
                end.is_none()
                    || chain.joints.iter().zip(done).any(|(joint, &done)| {
                        done && (joint.link.from == end || joint.link.to == end)
                    })
            };
        let mut pick = None;
        for (index, (joint, (&tied, &is_done))) in
            chain.joints.iter().zip(tied.iter().zip(&done)).enumerate()
        {
            if !tied || is_done {
                continue;
            }
            if held(joint.link.from, &done) {
                pick = Some((index, true));
                break;
            }
            if held(joint.link.to, &done) {
                pick = Some((index, false));
                break;
            }
            pick = pick.or(Some((index, true)));
        }
        let Some((index, forward)) = pick else { return };
        set(room, index, forward);
        if let Some(place) = done.get_mut(index) {
            *place = true;
        }
    }
}
