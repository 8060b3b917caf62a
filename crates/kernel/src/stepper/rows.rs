//! Constant tables of an oscillator over a sub-interval of a step. The stepper multiplies the oscillator's state and
//! its drive by these constants.

use super::dot::{add, dot};
use crate::motion::TERMS;
use crate::number::scalar::Float;

/// One row of the constant table that advances a mode over a sub-interval. The row contains the weights of the mode's
/// displacement y, of its scaled velocity u, and of the coefficients of its drive. y′ is Ωu, where Ω is the phase
/// advance of the mode in a sub-interval. The drive is the polynomial that the forces on the mode add to u′.
///
/// The first row of `moments` and the row `turn` are stored as three shears, so that rounded weights create no energy.
/// First y increases by before·u, then u by turn·y + loss·u, then y by after·u. The `state` of the first moment is
/// [before, after], and the `state` of `turn` is [turn, loss]. See docs/decisions/engine.md.
#[derive(Clone, Copy, Debug)]
pub struct Row<S, const D: usize> {
    /// Weights of the displacement y and of the scaled velocity u at the start of the sub-interval.
    pub state: [S; 2],
    /// Weights of the coefficients of the mode's drive.
    pub drive: [S; D],
}

/// One row of the constant table that advances a mode of the chain with its contact stuck. The row contains the
/// weights of the mode's displacement y and scaled velocity u, and of the coefficients of the drives. The drives are
/// the polynomials that the inputs add to y′ and u′. The first row of `moments` and the first row of `turns` are
/// stored as three shears, as in [`Row`].
#[derive(Clone, Copy, Debug)]
pub struct HeldRow<S, const D: usize> {
    /// Weights of the displacement y and of the scaled velocity u at the start of the sub-interval.
    pub state: [S; 2],
    /// Weights of the coefficients of two drives: the drive of the displacement's rate y′, and the drive of the scaled
    /// velocity's rate u′.
    pub drive: [[S; D]; 2],
}

/// Table of a mode over a sub-interval of a step. The displacement y and the scaled velocity u satisfy y′ = Ωu and u′ =
/// −Ω(y + 2ζu) + drive. The unit of time is the sub-interval.
#[derive(Clone, Copy, Debug)]
pub struct ModeStep<S, const D: usize> {
    /// Ω, the phase by which the mode would advance in a sub-interval without damping, in rad.
    pub angle: S,
    /// Modal damping ratio ζ of the mode.
    pub zeta: S,
    /// Rate u′ of the mode's scaled velocity caused by a unit force on the mode. The rate is Ω/σ², where Ω is the field
    /// `angle` and σ is the natural frequency of the mode as a frequency ratio.
    pub per_force: S,
    /// φᵀw, the component of the mode in the contact's displacement.
    pub contact: S,
    /// Weights with which the code computes the increase of the scaled velocity u in the sub-interval.
    pub turn: Row<S, D>,
    /// Weights with which the code computes the moments ∫ sʲ y′ ds in the sub-interval, for j = 0, 1, …. Here s is the
    /// time since the start of the sub-interval. The moment with j = 0 is the increase of the displacement y. The sum
    /// of the moments times the coefficients of a load, divided by `per_force`, is the work of this load.
    pub moments: [Row<S, D>; D],
}

/// Table of a mode of the chain with its contact stuck, over a sub-interval of a step. The displacement y and the
/// scaled velocity u satisfy y′ = Ωu + a and u′ = −Ω(y + 2ζu) + b, where a and b are the two drives. The unit of time
/// is the sub-interval.
#[derive(Clone, Copy, Debug)]
pub struct HeldStep<S, const D: usize> {
    /// Ω, the phase by which the mode would advance in a sub-interval without damping, in rad.
    pub angle: S,
    /// Modal damping ratio ζ of the mode.
    pub zeta: S,
    /// Factor of the mode in the force of the stuck contact. A displacement y of the mode adds −`force`·y to this
    /// force.
    pub force: S,
    /// Coupling of the mode with a moving base to which the contact sticks. Each pair contains the rates of the
    /// displacement y and of the scaled velocity u. The first pair belongs to a unit velocity of the base, the second
    /// pair to a unit acceleration.
    pub from_base: [[S; 2]; 2],
    /// Weights with which the code computes the moments ∫ sʲ y′ ds of the displacement y in the sub-interval, for j =
    /// 0, 1, …. Here s is the time since the start of the sub-interval.
    pub moments: [HeldRow<S, D>; D],
    /// Weights with which the code computes the moments ∫ sʲ u′ ds of the scaled velocity u in the sub-interval, for j
    /// = 0, 1, …. Here s is the time since the start of the sub-interval.
    pub turns: [HeldRow<S, D>; D],
}

/// Returns the next coefficients of the displacement y and the scaled velocity u in the power series of an oscillator,
/// each multiplied by its order. The arguments are Ω and ζ of the oscillator, the present coefficients of y and u, and
/// the present coefficients of the drives of y′ and u′.
#[inline]
pub(super) fn next<S: Float>(
    (angle, zeta): (S, S),
    [y, u]: [S; 2],
    [first, second]: [S; 2],
) -> [S; 2] {
    let rise = angle * u + first;
    let turn = second - angle * (y + (zeta + zeta) * u);
    [rise, turn]
}

/// Computes the moments ∫ sʲ y′ ds for j < D and ∫ sʲ u′ ds for j < E, from 0 to `place`. y is the displacement of an
/// oscillator, and u is its scaled velocity. The pair `[y, u]` contains y and u at s = 0. `drive` returns, for one
/// power of s, the coefficients with which the input acts on y′ and u′. `terms` is the number of terms of the power
/// series.
// The function does not use `map` of arrays. In code that is optimised for size, this `map` would cost more than the
// sums.
#[inline]
pub(super) fn moments<S: Float, const D: usize, const E: usize>(
    of: (S, S),
    [mut y, mut u]: [S; 2],
    drive: impl Fn(usize) -> [S; 2],
    terms: usize,
    place: S,
) -> ([S; D], [S; E]) {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let (mut rises, mut turns, mut weights) = ([zero; D], [zero; E], [zero; D]);
    let (mut order, mut power) = (one, place);
    for index in 0..terms {
        let [rise, turn] = next(of, [y, u], drive(index));
        (y, u) = (rise / order, turn / order);
        weigh(&mut weights, order, power, place);
        add(&mut rises, y, &weights);
        if let Some(weights) = weights.first_chunk() {
            add(&mut turns, u, weights);
        }
        (order, power) = (order + one, power * place);
    }
    (rises, turns)
}

/// Computes the weights with which a term of order n of the power series enters the moments with j < D. The weights are
/// n·p^(n+j)/(n+j), where p is the argument `place`, the end of the motion. `power` is pⁿ.
#[inline(always)]
fn weigh<S: Float, const D: usize>(weights: &mut [S; D], order: S, power: S, place: S) {
    let (one, two, three) = (S::constant(1.0), S::constant(2.0), S::constant(3.0));
    match weights.as_mut_slice() {
        [zeroth] => *zeroth = power,
        [zeroth, first] => {
            *zeroth = power;
            *first = power * place * (order / (order + one));
        }
        [zeroth, first, second, third] => {
            *zeroth = power;
            let mut factor = power * place;
            *first = factor * (order / (order + one));
            factor = factor * place;
            *second = factor * (order / (order + two));
            factor = factor * place;
            *third = factor * (order / (order + three));
        }
        weights => {
            let (mut beyond, mut factor) = (order, power);
            for weight in weights {
                *weight = factor * (order / beyond);
                (beyond, factor) = (beyond + one, factor * place);
            }
        }
    }
}

/// Replaces the weights of the displacement y and the scaled velocity u over a sub-interval by the weights of three
/// shears.
///
/// A product of shears has the determinant 1 for any weights. With these weights the product is a rotation, in
/// coordinates that equal y and u apart from rounding errors. Without damping the product therefore conserves exactly a
/// quadratic form that is nearly the energy. The weight `loss` makes the determinant e^(−2ζΩ), the factor by which
/// damping reduces the energy in a sub-interval. Ω is the undamped phase advance of the mode, in rad.
fn shear<S: Float, const D: usize>((angle, zeta): (S, S), rows: &mut [[HeldRow<S, D>; D]; 2]) {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let [rises, turns] = rows;
    let ([rise, ..], [turn, ..]) = (&mut rises[..], &mut turns[..]) else {
        return;
    };
    let ([of_y, of_u], undamped) = (rise.state, zeta.is_zero());
    let loss = (-(zeta + zeta) * angle).exp_m1();
    let after = of_y / turn.state[0];
    let before = if undamped {
        after
    } else {
        (of_u - after * (one + loss)) / (one + of_y)
    };
    for (rises, turns) in rise.drive.iter_mut().zip(turn.drive) {
        for (rise, turn) in rises.iter_mut().zip(turns) {
            *rise = *rise - after * turn;
        }
    }
    // A constant force on an undamped oscillator acts as an impulse on the scaled velocity u between the first and the
    // last shear. The weight of this force in the row of the displacement y is therefore 0.
    let [_, of_force] = &mut rise.drive;
    if let (true, [constant, ..]) = (undamped, &mut of_force[..]) {
        *constant = zero;
    }
    rise.state = [before, after];
    turn.state[1] = loss;
}

impl<S: Float, const D: usize> ModeStep<S, D> {
    pub(super) fn new(angle: S, zeta: S, per_force: S, contact: S) -> Self {
        let mut step = Self::zero();
        (step.angle, step.zeta, step.per_force, step.contact) = (angle, zeta, per_force, contact);
        let rows = HeldStep::rows((angle, zeta));
        for (to, from) in step.moments.iter_mut().zip(rows[0]) {
            *to = Row {
                state: from.state,
                drive: from.drive[1],
            };
        }
        if let Some(from) = rows[1].first() {
            step.turn = Row {
                state: from.state,
                drive: from.drive[1],
            };
        }
        step
    }

    /// Returns a table entry whose numbers are all 0. The code uses it to initialise arrays.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        let row = Row {
            state: [zero; 2],
            drive: [zero; D],
        };
        Self {
            angle: zero,
            zeta: zero,
            per_force: zero,
            contact: zero,
            turn: row,
            moments: [row; D],
        }
    }
}

impl<S: Float, const D: usize> HeldStep<S, D> {
    pub(super) fn new(angle: S, zeta: S, force: S) -> Self {
        let mut step = Self::zero();
        (step.angle, step.zeta, step.force) = (angle, zeta, force);
        [step.moments, step.turns] = Self::rows((angle, zeta));
        step
    }

    /// Computes the weights of all moments of an oscillator. To find a weight, the code sets one quantity to 1 and all
    /// others to 0. The quantities are the displacement y, the scaled velocity u and the coefficients of the drives.
    /// The weight is the moment of the motion that follows.
    fn rows(of: (S, S)) -> [[HeldRow<S, D>; D]; 2] {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let mut rows = [[HeldRow::zero(); D]; 2];
        for (place, start) in [[one, zero], [zero, one]].into_iter().enumerate() {
            let (rises, turns) = moments::<S, D, D>(of, start, |_| [zero; 2], TERMS, one);
            for (rows, values) in rows.iter_mut().zip([rises, turns]) {
                for (row, value) in rows.iter_mut().zip(values) {
                    if let Some(weight) = row.state.get_mut(place) {
                        *weight = value;
                    }
                }
            }
        }
        for channel in 0..2 {
            for place in 0..D {
                let drive = |order: usize| {
                    let term = if order == place { one } else { zero };
                    if channel == 0 {
                        [term, zero]
                    } else {
                        [zero, term]
                    }
                };
                let (rises, turns) = moments::<S, D, D>(of, [zero; 2], drive, TERMS, one);
                for (rows, values) in rows.iter_mut().zip([rises, turns]) {
                    for (row, value) in rows.iter_mut().zip(values) {
                        let weights = row.drive.get_mut(channel);
                        if let Some(weight) = weights.and_then(|row| row.get_mut(place)) {
                            *weight = value;
                        }
                    }
                }
            }
        }
        shear(of, &mut rows);
        rows
    }

    /// Returns a table entry whose numbers are all 0. The code uses it to initialise arrays.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            angle: zero,
            zeta: zero,
            force: zero,
            from_base: [[zero; 2]; 2],
            moments: [HeldRow::zero(); D],
            turns: [HeldRow::zero(); D],
        }
    }
}

impl<S: Float, const D: usize> HeldRow<S, D> {
    fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            state: [zero; 2],
            drive: [[zero; D]; 2],
        }
    }

    /// Returns the sum of the displacement y, the scaled velocity u and the drive's coefficients, each multiplied by
    /// its weight in this row.
    #[inline]
    pub(super) fn times(&self, [y, u]: [S; 2], drive: &[[S; D]; 2]) -> S {
        let [first, second] = &self.drive;
        let [of_y, of_u] = drive;
        let sum = self.state[0] * y + self.state[1] * u;
        dot(dot(sum, first, of_y), second, of_u)
    }
}

impl<S: Float, const D: usize> Row<S, D> {
    /// Returns the sum of the displacement y, the scaled velocity u and the drive's coefficients, each multiplied by
    /// its weight in this row.
    #[inline]
    pub(super) fn times(&self, [y, u]: [S; 2], drive: &[S; D]) -> S {
        let sum = self.state[0] * y + self.state[1] * u;
        dot(sum, &self.drive, drive)
    }
}
