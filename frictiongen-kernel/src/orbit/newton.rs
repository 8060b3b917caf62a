//! Newton's method on the half-period map or the period map, and the Floquet multipliers of that map.

use super::cycle_map::{CycleMap, EventPattern, unit};
use super::types::MAX_SEGMENTS;
use crate::errors::NoOrbit;
use crate::motion::{Contact, ContactChain, ContactState};
use crate::number::complex::{self, Complex};
use crate::number::matrix::SquareMatrix;
use crate::number::scalar::Float;

const NEWTON_STEPS: u32 = 12;

/// Two computations of the same state or instant count as equal if their relative difference is below this value.
const AGREEMENT: f64 = 1e-9;
/// Smallest tolerance at which two computations count as equal, in rounding units. The tolerance is large because the
/// rounding errors of all events of a cycle add up. It exceeds `AGREEMENT` only in `f32`.
const AGREEING_ROUNDINGS: f64 = 1024.0;
/// A Newton step counts as small if it is below this fraction of the state.
const SMALL_STEP: f64 = 1e-11;
/// Smallest bound below which a Newton step counts as small, in rounding units. This bound exceeds `SMALL_STEP` only in
/// `f32`.
const SMALL_ROUNDINGS: f64 = 256.0;
/// Shortest meaningful Newton step, in rounding units of the state.
const LEAST_ROUNDINGS: f64 = 4.0;
/// The method ends if a small Newton step is more than this fraction of the previous step. A step that shrinks no
/// faster is only rounding error.
const STALLED: f64 = 0.25;
/// The method also ends by quadratic convergence, if a Newton step is below this fraction of the state and no larger
/// than the square of the previous step.
const QUADRATIC: f64 = 1e-9;
/// Lower bound on the size of a state, so that a division by that size stays finite.
const SMALLEST_SCALE: f64 = 1e-290;

/// Returns the relative difference below which two numbers differ by rounding only.
pub(super) fn agreement<S: Float>() -> S {
    S::constant(AGREEMENT.max(AGREEING_ROUNDINGS * S::EPSILON))
}

/// Returns the largest difference of two states of size `scale` that differ by rounding only.
pub(super) fn same<S: Float>(scale: S) -> S {
    scale * agreement::<S>()
}

/// Memory for Newton's method: the matrix, two states, and the multipliers.
pub(super) struct Workspace<'m, S> {
    pub matrix: &'m mut [S],
    pub state: &'m mut [S],
    pub other: &'m mut [S],
    pub multipliers: &'m mut [Complex<S>],
}

impl<'m, S: Float> Workspace<'m, S> {
    /// Divides the memory of an orbit ([`numbers`](super::numbers)) into the states of its segments and the workspace.
    /// `size` is the number of scalars in a state.
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

/// Map of a state over half a period or over a whole period.
#[derive(Clone, Copy, Debug)]
pub(super) struct PeriodMap {
    /// Period in cycles of the excitation.
    pub period: u32,
    /// True if the map covers half a period and changes the sign of the state.
    pub symmetric: bool,
}

impl PeriodMap {
    /// Map of a symmetric state that repeats after one cycle.
    pub const HALF_CYCLE: Self = Self {
        period: 1,
        symmetric: true,
    };

    /// Returns the number of half cycles that the map covers.
    pub fn halves(self) -> u32 {
        if self.symmetric {
            self.period
        } else {
            2 * self.period
        }
    }
}

/// Applies Newton's method from the state of the cycle map. Returns the events during the map, and leaves the cycle map
/// at the fixed point. Returns `None` if the method does not converge.
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
            // At the section the contact state has changed between sticking and sliding. The method starts again with
            // the contact state that the contact has after the map.
            contact_state.contact = image;
            contact_state.t = start.t;
            cycle_map.save(workspace.other);
            if symmetric {
                negate(workspace.other);
            }
            cycle_map.restore(workspace.other, &contact_state);
            continue;
        }
        // `other` receives δ = (1 − A)⁻¹(F(x) − x).
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
        // A contact that hardly slides moves by far less than P/k₁, but its rounding error is that of a motion of size
        // P/k₁.
        let small = step <= small.max(S::constant(LEAST_ROUNDINGS * S::EPSILON));
        // The method ends in three cases: the step is below rounding, rounding prevents smaller steps, or the
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

/// Applies the map to the state and its deviations. Returns the contact's state after the map, and the events.
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

/// Computes the Floquet multipliers of the period, for a cycle map at a fixed point. The cycle map stays at the fixed
/// point. Returns the largest modulus of the map's multipliers.
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
