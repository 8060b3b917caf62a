//! Selects one member of a continuum of steady motions. In a chain without damping, a continuum of this kind exists at
//! the frequency ratios r = 1/(2n), with n = 1, 2, ….
//!
//! Two members of the continuum differ by a free vibration. The frequency of this vibration is an even multiple of the
//! excitation frequency, and the vibration is in phase with the reversals. A motion that never stops keeps the
//! amplitude of this vibration. Each stop of the contact reduces the amplitude, by less than the previous stop did. A
//! motion with stops therefore tends to the member with the largest amplitude among the members without stops.

use super::cycle_map::CycleMap;
use super::cycle_map::unit;
use super::newton::Workspace;
use crate::errors::NoOrbit;
use crate::motion::ContactChain;
use crate::number::matrix::SquareMatrix;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// Rounding error of a member of the continuum after half a cycle, in rounding units of the state.
const ROUNDINGS: f64 = 256.0;
/// Number of bisections in the search for the end of a continuum of steady states.
const BISECTIONS: u32 = 60;
/// Largest number of times that a search for the end of a continuum doubles the amplitude of the free vibration.
const DOUBLINGS: u32 = 20;
/// Difference between 1 and the shift of the inverse iteration. This iteration finds the eigenvector of the half-period
/// map that belongs to the multiplier 1.
const SHIFT: f64 = 1e-8;

/// Sets the cycle map to one member of a continuum of steady motions. This member is the motion to which the given
/// motion converges.
///
/// Before the call, the cycle map is at the symmetric member, and `workspace.state` is the state of the motion at the
/// same phase. The *share* of a member is the amplitude of its free vibration. The *last member* has the largest share
/// of all members without a stop. The function returns the share of the last member, divided by the share of the
/// selected member.
///
/// `monotone` is true if the stiction μ is 1. Stops then become shorter from cycle to cycle, so that a motion with
/// stops converges to the last member. With μ > 1 stops do not become shorter, because the contact sticks until its
/// force has grown to μF. A motion with stops then converges to no member, and the function returns an error.
pub(super) fn member<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    monotone: bool,
) -> Result<S, NoOrbit> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    if 0 < cycle_map.remembered() {
        // An elastic contact sticks after every reversal, so that it dissipates every free vibration.
        return Err(NoOrbit::Unsettled);
    }
    let size = cycle_map.size();
    let contact_state = cycle_map.contact_state;
    let scale = cycle_map.scale();
    // The members differ by the eigenvector of the half-period map that belongs to the multiplier 1. Inverse iteration
    // finds this eigenvector. The iteration starts from the difference between the motion and the symmetric member.
    for (part, state) in cycle_map.modes.iter().zip(pairs_mut(workspace.state)) {
        if let [y, u] = state {
            (*y, *u) = (*y - part.y, *u - part.u);
        }
    }
    for _ in 0..2 {
        // `other` stores the symmetric member until the cycle map has advanced. After that, the code solves the linear
        // system in `other`.
        cycle_map.save(workspace.other);
        unit(workspace.matrix, size);
        cycle_map.advance_half(Some(workspace.matrix))?;
        cycle_map.restore(workspace.other, &contact_state);
        for (other, state) in workspace.other.iter_mut().zip(workspace.state.iter()) {
            *other = *state;
        }
        let shift = one + S::constant(SHIFT.max(ROUNDINGS * S::EPSILON));
        if !SquareMatrix::new(workspace.matrix, size).solve_shifted(shift, workspace.other) {
            return Err(NoOrbit::Unsettled);
        }
        // D is the derivative of the map. The matrix (shift − D)⁻¹ divides the eigenvector's component by shift − 1,
        // and hardly changes the other components. The factor `weight` undoes this division.
        let weight = shift - one;
        for (state, other) in workspace.state.iter_mut().zip(workspace.other.iter()) {
            *state = *other * weight;
        }
    }
    // A bisection finds the largest share without a stop. The share of the motion itself is the upper bound.
    cycle_map.save(workspace.other);
    let shifted = |cycle_map: &mut CycleMap<'_, '_, S, K>, share: S| -> Result<bool, NoOrbit> {
        let set = |cycle_map: &mut CycleMap<'_, '_, S, K>| {
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
        let pattern = cycle_map
            .advance_half(None)?
            .and(cycle_map.advance_half(None)?);
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
    // The code reduces the share a little, because rounding decides whether the contact stops at the end of the
    // continuum.
    let inside = inside * (one - S::constant(ROUNDINGS * S::EPSILON));
    if inside.is_zero() || !shifted(cycle_map, inside)? {
        return Err(NoOrbit::Unsettled);
    }
    Ok(one)
}

/// Finds by bisection the largest amplitude of a free vibration with which the motion is still steady. In a continuum
/// of steady states, the states differ by this free vibration. The motion is steady with the amplitude `inside`, and
/// not steady with the amplitude `outside`.
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
