//! Newton's method on the map of half a period or a whole one, and the map's multipliers.

use super::flow::{Flow, Pattern, unit};
use super::matrix::Matrix;
use crate::errors::NoOrbit;
use crate::number::complex::{self, Complex};
use crate::number::pairs::pairs_mut;
use crate::number::scalar::Float;
use crate::simulation::{Contact, Stance};

const NEWTON_STEPS: u32 = 12;

/// States of this size that differ by no more than this are the same.
pub(super) fn same<S: Float>(scale: S) -> S {
    scale * S::constant(1e-9_f64.max(1024.0 * S::EPSILON))
}

/// Working space: the matrix, two states, and the multipliers.
pub(super) struct Room<'m, S> {
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

/// Newton's method from where the flow stands; none if it does not converge.  The flow then stands
/// on the fixed point.
pub(super) fn newton<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    map: Map,
) -> Result<Option<Pattern>, NoOrbit> {
    let symmetric = map.symmetric;
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let size = flow.size();
    let start = flow.stance;
    let mut last = S::constant(f64::MAX);
    let mut stance = start;
    for _ in 0..NEWTON_STEPS {
        flow.save(room.other);
        unit(room.matrix, size);
        let Ok((image, pattern)) = mapped(flow, room.matrix, map) else {
            return Ok(None);
        };
        if (image == Contact::Stuck) != (stance.contact == Contact::Stuck) {
            // The section itself has changed hands; the image is as good a start.
            stance.contact = image;
            stance.t = start.t;
            flow.save(room.other);
            negate(room.other, symmetric);
            flow.restore(room.other, &stance);
            continue;
        }
        // δ = (1 − A)⁻¹(F(x) − x), in the place of F(x).
        let scale = flow.scale().max(S::constant(1e-290));
        let sign = if symmetric { -one } else { one };
        for (part, state) in flow.modes.iter_mut().zip(pairs_mut(room.other)) {
            if let [y, u] = state {
                let difference = [sign * part.y - *y, sign * part.u - *u];
                (part.y, part.u) = (*y, *u);
                [*y, *u] = difference;
            }
        }
        if symmetric {
            for entry in room.matrix.iter_mut() {
                *entry = -*entry;
            }
        }
        if !Matrix::new(room.matrix, size).solve_shifted(one, room.other) {
            return Ok(None);
        }
        let mut step = zero;
        for (part, state) in flow.modes.iter_mut().zip(pairs_mut(room.other)) {
            if let [y, u] = state {
                step = step.max(y.abs()).max(u.abs());
                (*y, *u) = (part.y + *y, part.u + *u);
            }
        }
        if !step.is_finite() {
            return Ok(None);
        }
        stance.t = start.t;
        flow.restore(room.other, &stance);
        let small = step <= scale * S::constant(1e-11_f64.max(256.0 * S::EPSILON));
        // Below rounding, or as far down as rounding lets it come.
        if step <= scale * S::constant(4.0 * S::EPSILON)
            || (small && last * S::constant(0.25) < step)
            || step <= scale * S::constant(1e-9) && step <= last * last / scale
        {
            return Ok(Some(pattern));
        }
        last = step;
    }
    Ok(None)
}

/// The map with its deviations; how the contact stands then.
fn mapped<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    columns: &mut [S],
    map: Map,
) -> Result<(Contact, Pattern), NoOrbit> {
    let mut pattern = Pattern::default();
    for _ in 0..map.halves() {
        pattern = pattern.and(flow.half(Some(columns))?);
    }
    let contact = flow.stance.contact;
    let contact = if map.symmetric {
        contact.reversed()
    } else {
        contact
    };
    Ok((contact, pattern))
}

fn negate<S: Float>(state: &mut [S], really: bool) {
    if really {
        for value in state {
            *value = -*value;
        }
    }
}

/// The multipliers of the period, for which the flow stands on a fixed point and stays there; the
/// largest modulus of those of the map.
pub(super) fn multipliers<S: Float>(
    flow: &mut Flow<'_, '_, S>,
    room: &mut Room<'_, S>,
    map: Map,
) -> Result<S, NoOrbit> {
    let size = flow.size();
    let start: Stance<S> = flow.stance;
    flow.save(room.other);
    unit(room.matrix, size);
    mapped(flow, room.matrix, map)?;
    flow.restore(room.other, &start);
    Matrix::new(room.matrix, size).eigenvalues(room.multipliers);
    let mut largest = S::constant(0.0);
    for multiplier in room.multipliers.iter_mut() {
        largest = largest.max(complex::modulus(*multiplier, true));
        if map.symmetric {
            *multiplier = complex::mul(*multiplier, *multiplier, true);
        }
    }
    Ok(largest)
}
