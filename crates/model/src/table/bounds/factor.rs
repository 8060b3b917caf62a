//! Bounds the relative error of an emitted factor in a cell of r. Each factor belongs to a zero of an emitted product.
//! The error of the factor is relative to the factor with the exact zero.

use super::super::request::is_single;
use super::super::zeros::Zero;
use super::ball::Ball;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::Factor;

/// Factor on a sum of small relative errors. It covers the products of these errors.
pub(super) const UP: f64 = 1.03;
/// A sum of relative errors counts as small up to this value. [`UP`] covers the products of errors of this size.
const SMALL: f64 = 0.02;
/// Smallest normal number in single precision, up to rounding.
const NORMAL_SINGLE: f64 = 1.2e-38;
/// Smallest normal number in double precision, up to rounding.
const NORMAL: f64 = 2.3e-308;

/// Factor that turns a positive expression of a few operations in double precision into an upper bound. It covers
/// rounding errors and neglected terms with a wide margin.
const MORE: f64 = 1.01;
/// Factor that turns a positive expression of a few operations in double precision into a lower bound. It has the same
/// margin as [`MORE`].
const LESS: f64 = 0.99;
/// Bound on the relative error of a zero's position: a hundred rounding units of double precision. The actual error
/// is only a few units.
const PLACE: f64 = 1e-14;
/// Bound on the relative error of a difference of squares or of positions: millions of rounding units. The actual
/// error is only a few units.
const DIFFERENCE: f64 = 1e-9;
/// Bound on the relative change of a factor if its zero z moves by d, as a multiple of d/D. D is the distance of ir
/// from z. A factor is a product of at most four differences: ir − z, −ir − z, and the same with the conjugate of z.
/// To first order each difference contributes d/D, so the bound is four. The additional 0.1 covers the second order.
const MOVED: f64 = 4.1;
/// A number slightly smaller than ½, for two lower bounds. `at` is the number of the scalar type nearest to a zero y.
/// First, every other number of the type is at least half a spacing away from y. Second, the modulus of r − `at`
/// exceeds half of `at` if this difference is not exact.
const WITHIN_HALF: f64 = 0.45;
/// Bound on |B|/(B² + 4x²y²) in units of 1/(xy), slightly enlarged, for a zero x + iy with B = (r − y)(r + y) + x².
/// From B² + 4x²y² ≥ 4xy|B| it follows that the quotient is at most ¼/(xy).
const QUARTER: f64 = 0.26;
/// Bound on 2x²|B|/(B² + 4x²y²) in units of x/y, slightly enlarged, for a zero x + iy with B = (r − y)(r + y) + x².
/// From B² + 4x²y² ≥ 4xy|B| it follows that the quotient is at most ½x/y.
const HALF: f64 = 0.51;
/// Bound on (|r² − y²| + x²)/|B| for B ≥ x²/2, for a zero x + iy with B = (r − y)(r + y) + x².
const TIMES: f64 = 3.0;

/// An interval of r. The bounds of the whole range are numbers of the emitted scalar type. Other ends need not be.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundedInterval {
    pub low: f64,
    pub high: f64,
}

/// The exact zero of a factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownZero {
    pub zero: Zero,
    /// Bound on the absolute error of the zero's position.
    pub off: f64,
    /// Distance from the zero to the nearest number of the scalar type that the proof covers.
    pub nearest: f64,
}

/// Returns half a unit in the last place of 1, and the smallest normal number, of the scalar type.
pub(in crate::table) fn unit<S: Float>() -> (f64, f64) {
    let smallest = if is_single::<S>() {
        NORMAL_SINGLE
    } else {
        NORMAL
    };
    (0.5 * S::EPSILON, smallest)
}

/// Bounds on the relative error and on the modulus of a factor in a cell of r.
#[derive(Clone, Copy, Debug)]
pub(super) struct FactorBounds {
    /// Largest relative error of the computed factor.
    pub error: f64,
    /// Lower bound on the modulus of the factor.
    pub least: f64,
    /// Upper bound on the modulus of the factor.
    pub most: f64,
}

/// Returns three numbers for y > 0. The first is the number of the scalar type that is nearest to y. The second is the
/// distance of this number from y. The third is a lower bound on the distance of all other numbers of the type from y.
pub(super) fn beside<S: Float>(y: Dd) -> (f64, f64, f64) {
    let near = S::constant(y.to_f64()).to_f64();
    let apart = Ball::exact(y - Dd::from(near)).least();
    (near, apart, WITHIN_HALF * unit::<S>().0 * y.to_f64())
}

/// Returns an upper bound on the difference of two double-double numbers.
fn apart(a: Dd, b: Dd) -> f64 {
    (Ball::exact(a) - Ball::exact(b)).most()
}

impl KnownZero {
    /// Returns a lower bound on |r − y| for all r of a cell, where iy is the zero.
    pub fn distance(&self, cell: RoundedInterval) -> f64 {
        let y = self.zero.y.to_f64();
        let outside = (cell.low - y).max(y - cell.high) * (1.0 - DIFFERENCE);
        // At an end of the cell, r may be as near to y as any other number of the scalar type.
        self.nearest.max(outside - PLACE * y)
    }

    /// Returns a lower bound on |ir − z| for all r of a cell, where z is the zero.
    pub fn away(&self, cell: RoundedInterval) -> f64 {
        let x = self.zero.x.abs().to_f64() * (1.0 - PLACE);
        let along = if self.zero.y.is_zero() {
            cell.low
        } else {
            self.distance(cell)
        };
        x.max(along)
    }

    /// Returns the bounds on the emitted factor in a cell of r.
    pub fn bounds<S: Float>(
        &self,
        factor: &Factor<S>,
        cell: RoundedInterval,
    ) -> Option<FactorBounds> {
        let (unit, _) = unit::<S>();
        let wide = |value: S| Dd::from(value.to_f64());
        let (x, y) = (self.zero.x.abs(), self.zero.y);
        let square = x * x;
        let moved = MOVED * self.off / self.away(cell);
        let (size, place) = (x.to_f64(), y.to_f64());
        let bounds = match *factor {
            Factor::Real { off } => {
                if !y.is_zero() {
                    return None;
                }
                let least = (cell.low * cell.low + size * size) * LESS;
                let off = apart(wide(off), square) / least;
                FactorBounds {
                    error: 2.0 * unit + off + moved,
                    least,
                    most: (cell.high * cell.high + size * size) * MORE,
                }
            }
            Factor::Zero { at, rest } => {
                if !x.is_zero() || y.is_zero() {
                    return None;
                }
                let (own, offset) = self.along(wide(at), wide(rest), unit, cell);
                let distance = self.distance(cell);
                let beyond = (cell.low + place).min(2.0 * place) * LESS;
                let far = (cell.high - place).abs().max((cell.low - place).abs());
                FactorBounds {
                    error: own + offset / distance + moved,
                    least: distance * beyond,
                    most: far * (cell.high + place) * MORE,
                }
            }
            Factor::Pair {
                at,
                rest,
                off,
                least,
            } => {
                if y.is_zero() {
                    return None;
                }
                let (own, offset) = self.along(wide(at), wide(rest), unit, cell);
                let own_least = Dd::from(4.0) * square * y * y;
                let off = apart(wide(off), square);
                self.pair(
                    own,
                    (offset, off, apart(wide(least), own_least)),
                    unit,
                    cell,
                )
                .map(|bounds| FactorBounds {
                    error: bounds.error + moved,
                    ..bounds
                })?
            }
        };
        (bounds.error < SMALL).then_some(FactorBounds {
            error: bounds.error * UP,
            ..bounds
        })
    }

    /// Returns the relative rounding error of ((r − at) − rest)(r + at) in a cell of r, and the error of the position
    /// at + rest of this factor's zero.
    fn along(&self, at: Dd, rest: Dd, unit: f64, cell: RoundedInterval) -> (f64, f64) {
        let y = self.zero.y;
        let place = at.to_f64();
        let offset = apart(at + rest, y) + self.off;
        let from_at = apart(at, y);
        // r − at is exact if r and `at` differ by at most a factor of two.
        let exact = 0.5 * place <= cell.low && cell.high <= 2.0 * place;
        let first = if exact {
            0.0
        } else {
            // If r − `at` is not exact, its modulus exceeds half of `at`.
            unit * (1.0 + from_at / (WITHIN_HALF * place - from_at).max(0.0))
        };
        let sum = unit + from_at / (cell.low + y.to_f64()) * MORE;
        // The relative error contains the roundings of the two differences, of the sum r + `at` and of the product.
        (first + unit + sum + unit, offset)
    }

    /// Returns the bounds on the factor B² + 4x²y² in a cell of r, with B = (r − y)(r + y) + x² for a zero x + iy.
    /// `own` is the relative rounding error of (r − y)(r + y). `offset`, `off` and `least` are the absolute errors of
    /// y, x² and 4x²y² as the table stores them.
    fn pair(
        &self,
        own: f64,
        (offset, off, least): (f64, f64, f64),
        unit: f64,
        cell: RoundedInterval,
    ) -> Option<FactorBounds> {
        let (x, y) = (self.zero.x.abs().to_f64(), self.zero.y.to_f64());
        let distance = self.distance(cell);
        // B = (r − y)(r + y) + x² rises with r. Its bounds are therefore its values at the two ends of the cell.
        let low = (cell.low - y) * (cell.low + y) + x * x;
        let high = (cell.high - y) * (cell.high + y) + x * x;
        let scale = cell.high * cell.high + y * y + x * x;
        let mut smallest = low.max(-high).max(0.0) - DIFFERENCE * scale;
        if x == 0.0 {
            smallest = smallest.max(distance * (cell.low + y) * LESS);
        }
        let smallest = smallest.max(0.0);
        let floor = 4.0 * x * x * y * y;
        let whole = (smallest * smallest).max(floor) * LESS;
        if !(whole > 0.0) {
            return None;
        }
        // `steep` bounds |B|/(B² + 4x²y²), by the smaller of two upper bounds.
        let steep = if smallest > 0.0 {
            1.0 / smallest
        } else {
            f64::INFINITY
        };
        let steep = steep.min(if x > 0.0 {
            QUARTER / (x * y)
        } else {
            f64::INFINITY
        });
        // With B = (r − y)(r + y) + x², (|r² − y²| + x²)|B| is at most `times` (B² + 4x²y²). For x² < 2y² this follows
        // from |r² − y²| ≤ |B| + x². Otherwise it follows from B ≥ x²/2.
        let times = (1.0 + HALF * x / y).min(TIMES);
        let shifted = offset * (cell.high + y) + off;
        let of_square = 2.0 * (own * times + unit + shifted * steep);
        // The inequality (a + b + c)² ≤ 3(a² + b² + c²) separates the three errors `own`·`times`, `unit` and
        // `shifted`·`steep`.
        let second = 3.0 * (TIMES * TIMES * own * own + unit * unit + shifted * shifted / whole);
        Some(FactorBounds {
            error: of_square + second + unit + least / whole + unit,
            least: whole,
            most: (low * low).max(high * high) * MORE + floor * MORE,
        })
    }
}
