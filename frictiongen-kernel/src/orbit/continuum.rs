//! Where a whole family of motions is steady (r = 1/2n without damping): which of them is reached.
//!
//! Two members differ by a free vibration at an even multiple of the excitation's frequency, in step
//! with the reversals.  The motion from the start keeps its share of it while it never stops; where
//! it stops, each stop takes a little, ever more slowly, down to the last member that need not stop.

use super::flow::Flow;
use super::flow::unit;
use super::matrix::Matrix;
use super::newton::Room;
use crate::errors::NoOrbit;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// The flow stands on the symmetric member, and `room.state` is the motion in the same section; sets
/// the flow to the member that the motion tends to.  `monotone` says that μ = 1: with more, a stop does not
/// shrink, because the contact holds until the force has grown, and only a motion that never stops stays.
pub(super) fn member<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    monotone: bool,
) -> Result<(), NoOrbit> {
    let (zero, one, half) = (S::constant(0.0), S::constant(1.0), S::constant(0.5));
    let size = flow.size();
    let stance = flow.stance;
    let scale = flow.scale();
    // The direction of the family: the eigenvector for 1 of the half-period map, by inverse
    // iteration from the difference of the motion and the symmetric member.
    for (part, state) in flow.modes.iter().zip(pairs_mut(room.state)) {
        if let [y, u] = state {
            (*y, *u) = (*y - part.y, *u - part.u);
        }
    }
    for _ in 0..2 {
        // The symmetric member is kept where the direction is not needed: in the flow.
        flow.save(room.other);
        unit(room.matrix, size);
        flow.half(Some(room.matrix))?;
        flow.restore(room.other, &stance);
        for (other, state) in room.other.iter_mut().zip(room.state.iter()) {
            *other = *state;
        }
        let shift = one + S::constant(1e-8_f64.max(256.0 * S::EPSILON));
        if !Matrix::new(room.matrix, size).solve_shifted(shift, room.other) {
            return Err(NoOrbit::Unsettled);
        }
        // (shift − D)⁻¹ divides the family's share by shift − 1, and leaves all others as they are.
        let weight = shift - one;
        for (state, other) in room.state.iter_mut().zip(room.other.iter()) {
            *state = *other * weight;
        }
    }
    // The largest share up to the motion's own with which no stop is needed.
    flow.save(room.other);
    let shifted = |flow: &mut Flow<'_, '_, S>, share: S| -> Result<bool, NoOrbit> {
        let set = |flow: &mut Flow<'_, '_, S>| {
            let states = pairs(room.other).zip(pairs(room.state));
            for (part, (from, along)) in flow.modes.iter_mut().zip(states) {
                if let ([y, u], [dy, du]) = (from, along) {
                    (part.y, part.u) = (*y + share * *dy, *u + share * *du);
                }
            }
            flow.stance = flow.setting.stance(flow.modes, stance.t);
        };
        set(flow);
        let pattern = flow.half(None)?.and(flow.half(None)?);
        let states = pairs(room.other).zip(pairs(room.state));
        let apart = flow
            .modes
            .iter()
            .zip(states)
            .fold(zero, |most, (part, (from, along))| {
                if let ([y, u], [dy, du]) = (from, along) {
                    most.max((part.y - *y - share * *dy).abs())
                        .max((part.u - *u - share * *du).abs())
                } else {
                    most
                }
            });
        set(flow);
        let tolerance = S::constant(256.0 * S::EPSILON);
        Ok(pattern.stops == 0 && apart <= scale * tolerance)
    };
    if shifted(flow, one)? {
        return Ok(());
    }
    if !monotone {
        return Err(NoOrbit::Unsettled);
    }
    let (mut inside, mut outside) = (zero, one);
    for _ in 0..60 {
        let middle = (inside + outside) * half;
        if shifted(flow, middle)? {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    // A little less: at the very end rounding decides whether it stops.
    let inside = inside * (one - S::constant(256.0 * S::EPSILON));
    if inside.is_zero() || !shifted(flow, inside)? {
        return Err(NoOrbit::Unsettled);
    }
    Ok(())
}
