//! Newton's method on the map of half a period or a whole one, and the map's multipliers.

use super::cycle_map::{CycleMap, EventPattern, unit};
use super::matrix::SquareMatrix;
use super::types::MAX_SEGMENTS;
use crate::errors::NoOrbit;
use crate::motion::{Contact, ContactChain, ContactState};
use crate::number::complex::{self, Complex};
use crate::number::pairs::pairs_mut;
use crate::number::scalar::Float;

const NEWTON_STEPS: u32 = 12;

/// Relative difference below which two computations of a state or an instant agree.
const AGREEMENT: f64 = 1e-9;
/// Least difference, in roundings, that two agreeing computations may have.  It exceeds `AGREEMENT` in `f32` only.  The
/// events of a cycle add their roundings.
const AGREEING_ROUNDINGS: f64 = 1024.0;
/// Relative size below which a step of Newton's method is small.
const SMALL_STEP: f64 = 1e-11;
/// Least size, in roundings, below which a step of Newton's method is small.  It exceeds `SMALL_STEP` in `f32` only.
const SMALL_ROUNDINGS: f64 = 256.0;
/// Shortest step that rounding allows, in roundings.
const LEAST_ROUNDINGS: f64 = 4.0;
/// Ratio of a small step to the step before, above which rounding stalls the method.
const STALLED: f64 = 0.25;
/// Relative size below which a step ends the method if it is no larger than the square of the step before.
const QUADRATIC: f64 = 1e-9;
/// Lower bound on the size of a state, so that a division by that size stays finite.
const SMALLEST_SCALE: f64 = 1e-290;

/// Relative difference of two numbers that only rounding separates.
pub(super) fn agreement<S: Float>() -> S {
    S::constant(AGREEMENT.max(AGREEING_ROUNDINGS * S::EPSILON))
}

/// Largest difference of two equal states of size `scale`.
pub(super) fn same<S: Float>(scale: S) -> S {
    scale * agreement::<S>()
}

/// Working space: the matrix, two states, and the multipliers.
pub(super) struct Workspace<'m, S> {
    pub matrix: &'m mut [S],
    pub state: &'m mut [S],
    pub other: &'m mut [S],
    pub multipliers: &'m mut [Complex<S>],
}

impl<'m, S: Float> Workspace<'m, S> {
    /// Divides the memory of an orbit ([`numbers`](super::numbers)) into the states of its segments and the workspace.
    pub fn divided(
        numbers: &'m mut [S],
        multipliers: &'m mut [Complex<S>],
        (modes, driven): (usize, usize),
    ) -> (&'m mut [S], Self) {
        let states = numbers.len().min(MAX_SEGMENTS * 2 * modes);
        let (states, rest) = numbers.split_at_mut(states);
        let (matrix, rest) = rest.split_at_mut(rest.len().min(4 * driven * driven));
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

/// Map of a state over half a period, or over a whole one.
#[derive(Clone, Copy, Debug)]
pub(super) struct PeriodMap {
    /// Period in cycles of the excitation.
    pub period: u32,
    /// True if the map is half a period times −1.
    pub symmetric: bool,
}

impl PeriodMap {
    /// Map of a symmetric state that repeats after one cycle.
    pub const HALF_CYCLE: Self = Self {
        period: 1,
        symmetric: true,
    };

    /// Number of half cycles in the map.
    pub fn halves(self) -> u32 {
        if self.symmetric {
            self.period
        } else {
            2 * self.period
        }
    }
}

/// Applies Newton's method from the state of the cycle map.  Returns the pattern of the map, with the cycle map at the
/// fixed point, or `None` if the method does not converge.
pub(super) fn newton<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    map: PeriodMap,
) -> Result<Option<EventPattern>, NoOrbit> {
    let symmetric = map.symmetric;
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
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
            // The contact's state in the section has changed.  The image is as good a start.
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
        for (part, state) in cycle_map.modes.iter_mut().zip(pairs_mut(workspace.other)) {
            if let [y, u] = state {
                let difference = [sign * part.y - *y, sign * part.u - *u];
                (part.y, part.u) = (*y, *u);
                [*y, *u] = difference;
            }
        }
        if symmetric {
            negate(workspace.matrix);
        }
        if !SquareMatrix::new(workspace.matrix, size).solve_shifted(one, workspace.other) {
            return Ok(None);
        }
        let mut step = zero;
        for (part, state) in cycle_map.modes.iter_mut().zip(pairs_mut(workspace.other)) {
            if let [y, u] = state {
                step = step.max(y.abs()).max(u.abs());
                (*y, *u) = (part.y + *y, part.u + *u);
            }
        }
        if !step.is_finite() {
            return Ok(None);
        }
        contact_state.t = start.t;
        cycle_map.restore(workspace.other, &contact_state);
        let small = S::constant(SMALL_STEP.max(SMALL_ROUNDINGS * S::EPSILON)) * scale;
        // A contact that hardly slides has a motion far smaller than P/k₁, which is rounded at the size of P/k₁.
        let small = step <= small.max(S::constant(LEAST_ROUNDINGS * S::EPSILON));
        // The step is below rounding, or rounding keeps it from falling further, or the method converges quadratically.
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

/// Applies the map to the state and its deviations.  Returns the contact's state after the map, and the pattern.
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

/// Computes the multipliers of the period, for a cycle map at a fixed point, where it stays.  Returns the largest
/// modulus of the map's multipliers.
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
