//! Where a whole family of motions is steady (r = 1/2n without damping): which of them is reached.
//!
//! Two members differ by a free vibration at an even multiple of the excitation's frequency, in step
//! with the reversals.  The motion from the start keeps its share of it while it never stops; where
//! it stops, each stop takes a little, ever more slowly, down to the last member that need not stop.

use super::cycle_map::CycleMap;
use super::cycle_map::unit;
use super::matrix::Matrix;
use super::newton::Workspace;
use crate::errors::NoOrbit;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// So many roundings a half cycle leaves between a member of a continuum and itself.
const ROUNDINGS: f64 = 256.0;
/// The end of a continuum is bisected so often,
const BISECTIONS: u32 = 60;
/// and looked for up to so many doublings of the motion's own share.
const DOUBLINGS: u32 = 20;
/// The half-period map is inverted so far beside its multiplier 1.
const SHIFT: f64 = 1e-8;

/// The cycle map stands on the symmetric member, and `workspace.state` is the motion in the same section; sets
/// the cycle map to the member that the motion tends to, and returns by how much more than that member's share the last one
/// has.  `monotone` says that μ = 1: with more, a stop does not
/// shrink, because the contact holds until the force has grown, and only a motion that never stops stays.
pub(super) fn member<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    monotone: bool,
) -> Result<S, NoOrbit> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let size = cycle_map.size();
    let contact_state = cycle_map.contact_state;
    let scale = cycle_map.scale();
    // The direction of the family: the eigenvector for 1 of the half-period map, by inverse
    // iteration from the difference of the motion and the symmetric member.
    for (part, state) in cycle_map.modes.iter().zip(pairs_mut(workspace.state)) {
        if let [y, u] = state {
            (*y, *u) = (*y - part.y, *u - part.u);
        }
    }
    for _ in 0..2 {
        // The symmetric member is kept where the direction is not needed: in the cycle_map.
        cycle_map.save(workspace.other);
        unit(workspace.matrix, size);
        cycle_map.half(Some(workspace.matrix))?;
        cycle_map.restore(workspace.other, &contact_state);
        for (other, state) in workspace.other.iter_mut().zip(workspace.state.iter()) {
            *other = *state;
        }
        let shift = one + S::constant(SHIFT.max(ROUNDINGS * S::EPSILON));
        if !Matrix::new(workspace.matrix, size).solve_shifted(shift, workspace.other) {
            return Err(NoOrbit::Unsettled);
        }
        // (shift − D)⁻¹ divides the family's share by shift − 1, and leaves all others as they are.
        let weight = shift - one;
        for (state, other) in workspace.state.iter_mut().zip(workspace.other.iter()) {
            *state = *other * weight;
        }
    }
    // The largest share up to the motion's own with which no stop is needed.
    cycle_map.save(workspace.other);
    let shifted = |cycle_map: &mut CycleMap<'_, '_, S>, share: S| -> Result<bool, NoOrbit> {
        let set = |cycle_map: &mut CycleMap<'_, '_, S>| {
            let states = pairs(workspace.other).zip(pairs(workspace.state));
            for (part, (from, along)) in cycle_map.modes.iter_mut().zip(states) {
                if let ([y, u], [dy, du]) = (from, along) {
                    (part.y, part.u) = (*y + share * *dy, *u + share * *du);
                }
            }
            cycle_map.contact_state = cycle_map
                .setting
                .contact_state(cycle_map.modes, contact_state.t);
        };
        set(cycle_map);
        let pattern = cycle_map.half(None)?.and(cycle_map.half(None)?);
        let states = pairs(workspace.other).zip(pairs(workspace.state));
        let distance =
            cycle_map
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
        set(cycle_map);
        let tolerance = S::constant(ROUNDINGS * S::EPSILON);
        Ok(pattern.stops == 0 && distance <= scale * tolerance)
    };
    if shifted(cycle_map, one)? {
        let (mut inside, mut outside) = (one, one + one);
        for _ in 0..DOUBLINGS {
            if !shifted(cycle_map, outside)? {
                break;
            }
            (inside, outside) = (outside, outside + outside);
        }
        let last = last_inside(inside, outside, |share| shifted(cycle_map, share))?;
        shifted(cycle_map, one)?;
        return Ok(last);
    }
    if !monotone {
        return Err(NoOrbit::Unsettled);
    }
    let inside = last_inside(zero, one, |share| shifted(cycle_map, share))?;
    // A little less: at the very end rounding decides whether it stops.
    let inside = inside * (one - S::constant(ROUNDINGS * S::EPSILON));
    if inside.is_zero() || !shifted(cycle_map, inside)? {
        return Err(NoOrbit::Unsettled);
    }
    Ok(one)
}

/// The last share of an interval for which the motion is steady: it is at the one end, and not at the other.
fn last_inside<S: Float>(
    mut inside: S,
    mut outside: S,
    mut is_steady: impl FnMut(S) -> Result<bool, NoOrbit>,
) -> Result<S, NoOrbit> {
    for _ in 0..BISECTIONS {
        let middle = (inside + outside) * S::constant(0.5);
        if is_steady(middle)? {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Ok(inside)
}
