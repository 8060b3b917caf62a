//! Implicit Euler method for motions that approach their steady state very slowly. One step of the method can replace
//! many cycles.
//!
//! Very slow motions occur close to a resonance of the masses that the contact does not move. In most cycles of such a
//! motion the events are not those of the steady state, so that Newton's method alone does not converge.
//!
//! The Euler step from the state x to the state x′ is x′ = x + (F(x′) − x′)/σ, where F is the half-cycle map and 1/σ
//! the step length. With μ = 1 the distance between two motions never grows. The equation therefore has exactly one
//! solution x′ for any step length, and x′ is closer to the steady state than x.

use super::cycle_map::{CycleMap, unit};
use super::newton::{PeriodMap, Workspace, mapped, negate};
use crate::errors::NoOrbit;
use crate::motion::{Contact, ContactChain};
use crate::number::matrix::SquareMatrix;
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// Largest number of steps of the implicit Euler method.
const MOST_STEPS: u32 = 64;
/// Largest number of Newton steps within one Euler step.
const NEWTON_STEPS: u32 = 10;
/// Largest size of a Newton step at which the Euler step counts as solved, divided by the change of the state in the
/// Euler step.
const SMALL: f64 = 1e-3;
/// First value of σ, the inverse of the length of an Euler step. The first Euler step is 16 half cycles long.
const FIRST_SHIFT: f64 = 0.0625;
/// Factor by which the code multiplies σ after a successful Euler step. A smaller σ makes the next step longer.
const LONGER: f64 = 0.25;
/// Factor by which the code multiplies σ after a failed Euler step. A larger σ makes the next attempt shorter.
const SHORTER: f64 = 8.0;
/// Largest value of σ, the inverse of the length of an Euler step. With σ = 64 an Euler step is 1/64 of a half cycle
/// long. The method ends if a step fails and the next σ would exceed this value.
const LARGEST_SHIFT: f64 = 64.0;
/// Relative change of the state in half a cycle below which the search continues with Newton's method on the half-cycle
/// map.
const NEAR: f64 = 1e-11;

/// Moves the cycle map towards the symmetric steady state that repeats after one cycle. `last` is working memory for
/// one state.
pub(super) fn relax<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    last: &mut [S],
) -> Result<(), NoOrbit> {
    let start = cycle_map.contact_state;
    let mut shift = S::constant(FIRST_SHIFT);
    cycle_map.save(last);
    for _ in 0..MOST_STEPS {
        if step(cycle_map, workspace, last, shift)? {
            let moved = shift * cycle_map.distance(last);
            cycle_map.save(last);
            if moved <= S::constant(NEAR) * cycle_map.scale() {
                break;
            }
            shift = shift * S::constant(LONGER);
        } else {
            cycle_map.restore(last, &start);
            shift = shift * S::constant(SHORTER);
            if S::constant(LARGEST_SHIFT) < shift {
                break;
            }
        }
    }
    Ok(())
}

/// Makes one Euler step from the state `last`. `shift` is σ, the inverse of the step length. Returns false if Newton's
/// method does not find the state after the step.
fn step<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    last: &[S],
    shift: S,
) -> Result<bool, NoOrbit> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let (size, start) = (cycle_map.size(), cycle_map.contact_state);
    for _ in 0..NEWTON_STEPS {
        cycle_map.save(workspace.other);
        unit(workspace.matrix, size);
        let (image, _) = mapped(cycle_map, workspace.matrix, PeriodMap::HALF_CYCLE)?;
        if (image == Contact::Stuck) != (start.contact == Contact::Stuck) {
            return Ok(false);
        }
        let states = pairs_mut(workspace.other).zip(pairs(last));
        for (part, (state, last)) in cycle_map.modes.iter_mut().zip(states) {
            if let ([y, u], [last_y, last_u]) = (state, last) {
                let missing = [
                    -part.y - *y - shift * (*y - *last_y),
                    -part.u - *u - shift * (*u - *last_u),
                ];
                (part.y, part.u) = (*y, *u);
                [*y, *u] = missing;
            }
        }
        negate(workspace.matrix);
        if !SquareMatrix::new(workspace.matrix, size).solve_shifted(one + shift, workspace.other) {
            return Ok(false);
        }
        let mut change = zero;
        for (part, state) in cycle_map.modes.iter().zip(pairs_mut(workspace.other)) {
            if let [y, u] = state {
                change = change.max(y.abs()).max(u.abs());
                (*y, *u) = (part.y + *y, part.u + *u);
            }
        }
        if !change.is_finite() {
            return Ok(false);
        }
        cycle_map.restore(workspace.other, &start);
        let rounding = S::constant(64.0 * S::EPSILON) * cycle_map.scale();
        if change <= (S::constant(SMALL) * cycle_map.distance(last)).max(rounding) {
            return Ok(true);
        }
    }
    Ok(false)
}
