//! Newton's method on the map of half a period or a whole one, and the map's multipliers.

use super::cycle_map::{CycleMap, Pattern, unit};
use super::matrix::Matrix;
use crate::errors::NoOrbit;
use crate::number::complex::{self, Complex};
use crate::number::pairs::pairs_mut;
use crate::number::scalar::Float;
use crate::simulation::{Contact, ContactState};

const NEWTON_STEPS: u32 = 12;

/// What two ways to the same state or instant may differ by,
const AGREEMENT: f64 = 1e-9;
/// and in `f32`, in roundings: the events of a cycle add theirs.
const AGREEING_ROUNDINGS: f64 = 1024.0;
/// A step of Newton's method is small from here on,
const SMALL_STEP: f64 = 1e-11;
/// and in `f32` from so many roundings on,
const SMALL_ROUNDINGS: f64 = 256.0;
/// and no step can be below so many.
const LEAST_ROUNDINGS: f64 = 4.0;
/// Below a small step rounding holds the method up where a step is more than this ratio of the one before.
const STALLED: f64 = 0.25;
/// From here on, relative to the state, a step that is no more than the square of the one before is the last.
const QUADRATIC: f64 = 1e-9;
/// A state has at least this size, so that a division by it is finite.
const SMALLEST_SCALE: f64 = 1e-290;

/// How far apart, relative to their size, two are that rounding alone parts.
pub(super) fn agreement<S: Float>() -> S {
    S::constant(AGREEMENT.max(AGREEING_ROUNDINGS * S::EPSILON))
}

/// States of this size that differ by no more than this are the same.
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

/// What takes a state on by half a period, or a whole one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    /// In cycles of the excitation.
    pub period: u32,
    /// Half a period, times −1.
    pub symmetric: bool,
}

impl Map {
    /// Of a symmetric state that repeats after one cycle.
    pub const HALF_CYCLE: Self = Self {
        period: 1,
        symmetric: true,
    };

    /// How many half cycles it is.
    pub fn halves(self) -> u32 {
        if self.symmetric {
            self.period
        } else {
            2 * self.period
        }
    }
}

/// Newton's method from where the cycle map stands; none if it does not converge.  The cycle map then stands
/// on the fixed point.
pub(super) fn newton<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    map: Map,
) -> Result<Option<Pattern>, NoOrbit> {
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
            // The section itself has changed hands; the image is as good a start.
            contact_state.contact = image;
            contact_state.t = start.t;
            cycle_map.save(workspace.other);
            if symmetric {
                negate(workspace.other);
            }
            cycle_map.restore(workspace.other, &contact_state);
            continue;
        }
        // δ = (1 − A)⁻¹(F(x) − x), in the place of F(x).
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
        if !Matrix::new(workspace.matrix, size).solve_shifted(one, workspace.other) {
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
        // A contact that hardly slides has a motion far smaller than P/k₁, whose rounding moves it.
        let small = step <= small.max(S::constant(LEAST_ROUNDINGS * S::EPSILON));
        // Below rounding, or as far down as rounding lets it come.
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

/// The map with its deviations; how the contact stands then.
pub(super) fn mapped<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    columns: &mut [S],
    map: Map,
) -> Result<(Contact, Pattern), NoOrbit> {
    let mut pattern = Pattern::default();
    for _ in 0..map.halves() {
        pattern = pattern.and(cycle_map.half(Some(columns))?);
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

/// The multipliers of the period, for which the cycle map stands on a fixed point and stays there; the
/// largest modulus of those of the map.
pub(super) fn multipliers<S: Float>(
    cycle_map: &mut CycleMap<'_, '_, S>,
    workspace: &mut Workspace<'_, S>,
    map: Map,
) -> Result<S, NoOrbit> {
    let size = cycle_map.size();
    let start: ContactState<S> = cycle_map.contact_state;
    cycle_map.save(workspace.other);
    unit(workspace.matrix, size);
    mapped(cycle_map, workspace.matrix, map)?;
    cycle_map.restore(workspace.other, &start);
    Matrix::new(workspace.matrix, size).eigenvalues(workspace.multipliers);
    let mut largest = S::constant(0.0);
    for multiplier in workspace.multipliers.iter_mut() {
        largest = largest.max(complex::modulus(*multiplier, true));
        if map.symmetric {
            *multiplier = complex::mul(*multiplier, *multiplier, true);
        }
    }
    Ok(largest)
}
