//! Newton's method on the half-period map or the period map, and the Floquet multipliers of that map.

use super::cycle_map::{CycleMap, EventPattern, unit};
use super::types::MAX_SEGMENTS;
use crate::errors::NoOrbit;
use crate::motion::{Contact, ContactChain, ContactState};
use crate::number::complex::{self, Complex};
use crate::number::matrix::SquareMatrix;
use crate::number::scalar::Float;

const NEWTON_STEPS: u32 = 12;

/// Largest relative difference at which two computations of the same state or instant are treated as equal.
const AGREEMENT: f64 = 1e-9;
/// Smallest tolerance for the comparison of two computations, in rounding units. The tolerance is large because the
/// rounding errors of all events of a cycle add up. It exceeds `AGREEMENT` only in `f32`.
const AGREEING_ROUNDINGS: f64 = 1024.0;
/// Largest size at which a Newton step counts as small, divided by the size of the state.
const SMALL_STEP: f64 = 1e-11;
/// Smallest limit for a small Newton step, in rounding units. This limit exceeds `SMALL_STEP` only in `f32`.
const SMALL_ROUNDINGS: f64 = 256.0;
/// Size of a Newton step that is only rounding error, in rounding units of the state.
const LEAST_ROUNDINGS: f64 = 4.0;
/// Largest ratio of a small Newton step to the previous step at which Newton's method continues. A step that shrinks
/// less is only rounding error.
const STALLED: f64 = 0.25;
/// Largest Newton step at which the method can end by quadratic convergence, divided by the size of the state. The step
/// must also be no larger than the square of the previous step.
const QUADRATIC: f64 = 1e-9;
/// Lower bound for the size of a state, so that a division by the size stays finite.
const SMALLEST_SCALE: f64 = 1e-290;

/// Returns the largest relative difference of two numbers that the code attributes to rounding alone.
pub(super) fn agreement<S: Float>() -> S {
    S::constant(AGREEMENT.max(AGREEING_ROUNDINGS * S::EPSILON))
}

/// Returns the largest difference of two states of size `scale` that the code attributes to rounding alone.
pub(super) fn same<S: Float>(scale: S) -> S {
    scale * agreement::<S>()
}

/// Memory for Newton's method: the matrix, two states, and the Floquet multipliers.
pub(super) struct Workspace<'m, S> {
    pub matrix: &'m mut [S],
    pub state: &'m mut [S],
    pub other: &'m mut [S],
    pub multipliers: &'m mut [Complex<S>],
}

impl<'m, S: Float> Workspace<'m, S> {
    /// Divides the memory of an orbit ([`numbers`](super::numbers)) into two parts: the states of its segments, and the
    /// working memory of Newton's method. `size` is the number of scalars in a state.
    pub fn divided(
        numbers: &'m mut [S],
        multipliers: &'m mut [Complex<S>],
        (modes, size): (usize, usize),
    ) -> (&'m mut [S], Self) {
        let states = numbers.len().min(MAX_SEGMENTS * 2 * modes);
        let (states, rest) = numbers.split_at_mut(states);
        let (matrix, rest) = rest.split_at_mut(rest.len().min(size * size));
        let (state, other) = rest.split_at_mut(rest.len() / 2);
        let workspace = Self {
            matrix,
            state,
            other,
            multipliers,
        };
        (states, workspace)
    }
}

/// Map that advances a state by half a period or by a whole period.
#[derive(Clone, Copy, Debug)]
pub(super) struct PeriodMap {
    /// Period of the motion, in cycles of the excitation.
    pub period: u32,
    /// True if the map advances a state by half a period and then changes the sign of the state.
    pub symmetric: bool,
}

impl PeriodMap {
    /// Half-period map of a symmetric motion that repeats after one cycle.
    pub const HALF_CYCLE: Self = Self {
        period: 1,
        symmetric: true,
    };

    /// Returns the number of half cycles by which the map advances a state.
    pub fn halves(self) -> u32 {
        if self.symmetric {
            self.period
        } else {
            2 * self.period
        }
    }
}

/// Applies Newton's method to the map, starting at the state of the cycle map. Afterwards the cycle map contains the
/// fixed point. Returns the events during one application of the map. Returns `None` if the method does not converge.
pub(super) fn newton<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    map: PeriodMap,
) -> Result<Option<EventPattern>, NoOrbit> {
    let symmetric = map.symmetric;
    let one = S::constant(1.0);
    let size = cycle_map.size();
    let start = cycle_map.contact_state;
    let mut last = S::constant(f64::MAX);
    let mut contact_state = start;
    for _ in 0..NEWTON_STEPS {
        cycle_map.save(workspace.other);
        unit(workspace.matrix, size);
        let Ok((image, pattern)) = mapped(cycle_map, workspace.matrix, map) else {
            return Ok(None);
        };
        if (image == Contact::Stuck) != (contact_state.contact == Contact::Stuck) {
            // The map has changed the contact from sticking to sliding, or from sliding to sticking. The method
            // restarts with the contact state that the contact has after the map.
            contact_state.contact = image;
            contact_state.t = start.t;
            cycle_map.save(workspace.other);
            if symmetric {
                negate(workspace.other);
            }
            cycle_map.restore(workspace.other, &contact_state);
            continue;
        }
        // `other` receives δ = (1 − A)⁻¹(F(x) − x), where F is the map and A is its derivative.
        let scale = cycle_map.scale().max(S::constant(SMALLEST_SCALE));
        let sign = if symmetric { -one } else { one };
        let start_force = cycle_map.subtract(workspace.other, sign);
        if symmetric {
            negate(workspace.matrix);
        }
        if !SquareMatrix::new(workspace.matrix, size).solve_shifted(one, workspace.other) {
            return Ok(None);
        }
        let step = cycle_map.add(workspace.other, start_force);
        if !step.is_finite() {
            return Ok(None);
        }
        contact_state.t = start.t;
        cycle_map.restore(workspace.other, &contact_state);
        let small = S::constant(SMALL_STEP.max(SMALL_ROUNDINGS * S::EPSILON)) * scale;
        // A contact that hardly slides moves by far less than P/k₁. Its rounding error is still that of a motion of
        // size P/k₁.
        let small = step <= small.max(S::constant(LEAST_ROUNDINGS * S::EPSILON));
        // The method ends in three cases: the step is smaller than rounding, rounding prevents smaller steps, or the
        // convergence is quadratic.
        if step <= scale * S::constant(LEAST_ROUNDINGS * S::EPSILON)
            || (small && last * S::constant(STALLED) < step)
            || step <= scale * S::constant(QUADRATIC) && step <= last * last / scale
        {
            return Ok(Some(pattern));
        }
        last = step;
    }
    Ok(None)
}

/// Applies the map to the state of the cycle map, and its linearisation to the deviations in `columns`. Returns the
/// state of the contact after the map, and the events during the map.
pub(super) fn mapped<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    columns: &mut [S],
    map: PeriodMap,
) -> Result<(Contact, EventPattern), NoOrbit> {
    let mut pattern = EventPattern::default();
    for _ in 0..map.halves() {
        pattern = pattern.and(cycle_map.advance_half(Some(columns))?);
    }
    let contact = cycle_map.contact_state.contact;
    let contact = if map.symmetric {
        contact.reversed()
    } else {
        contact
    };
    Ok((contact, pattern))
}

pub(super) fn negate<S: Float>(numbers: &mut [S]) {
    for number in numbers {
        *number = -*number;
    }
}

/// Computes the Floquet multipliers of the period. The state in the cycle map must be a fixed point, and is the same
/// after the call. Returns the largest absolute value of the map's multipliers.
pub(super) fn multipliers<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    map: PeriodMap,
) -> Result<S, NoOrbit> {
    let size = cycle_map.size();
    let start: ContactState<S> = cycle_map.contact_state;
    cycle_map.save(workspace.other);
    unit(workspace.matrix, size);
    mapped(cycle_map, workspace.matrix, map)?;
    cycle_map.restore(workspace.other, &start);
    SquareMatrix::new(workspace.matrix, size).eigenvalues(workspace.multipliers);
    let mut largest = S::constant(0.0);
    for multiplier in workspace.multipliers.iter_mut() {
        largest = largest.max(complex::modulus(*multiplier, true));
        if map.symmetric {
            *multiplier = complex::mul(*multiplier, *multiplier, true);
        }
    }
    Ok(largest)
}
