//! Proves that the emitted products over zeros and poles equal β*_lim and |V| within an error bound. V and H are the
//! responses of the contact to the load and to a contact force.
//!
//! [`roots`] proves in double-double that V and H equal products over the computed zeros. [`factor`] bounds the
//! errors of the emitted numbers and of their evaluation. The proof uses no samples. It takes a few hundred
//! operations for each mode, at any accuracy.

mod ball;
mod factor;
mod roots;

#[cfg(test)]
mod tests;

use super::evidence::{Evidence, Proof, ProofWork};
use super::exact::Exact;
use super::product::Product;
use super::request::Request;
use super::worst::Worst;
use super::zeros::{ContactMode, Zero, Zeros};
use crate::scene::Side;
use ball::Ball;
pub(super) use factor::unit;
use factor::{KnownZero, RoundedInterval, UP, beside};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::Factor;
use roots::{Factored, PartialFractions};

/// Largest fraction of the accuracy that the uncertainty of a zero may take, at the number of the scalar type nearest
/// to the zero. If the uncertainty is larger, the proof leaves that number out. A larger fraction leaves out fewer
/// numbers, but leaves less of the accuracy for other errors.
const UNCERTAIN: f64 = 0.1;
/// Largest relative error of a product that the proof accepts. Up to this error, the factor `UP` covers the neglected
/// terms.
const SMALL: f64 = 0.1;
/// Largest intermediate result that the proof accepts, as a multiple of the reciprocal of the smallest normal number.
/// The bound is a twentieth of the largest number of the scalar type, so that the next operation does not overflow.
const LARGEST: f64 = 0.2;
/// Bound on the rounding error of a pole, in rounding units of double-double. A pole follows from the constants of
/// its mode.
const POLE_ROUNDINGS: f64 = 64.0;
/// Relative amount by which the code enlarges the computed bounds. It covers the rounding of the bounds themselves,
/// with thousands of rounding units of double precision.
const OUTWARD: f64 = 1e-12;

/// The exact function (β*_lim or |V|) that an emitted product represents, as gain·Π numerator/Π denominator over
/// computed zeros and poles. At a computed zero the sum over the modes may have a small remainder. `weights` and
/// `tail` bound the relative error that these remainders cause.
struct Meant {
    gain: Ball,
    numerator: Vec<KnownZero>,
    denominator: Vec<KnownZero>,
    /// Zeros with their weights. A weight, divided by the distance of r from its zero, is a relative error of the
    /// function.
    weights: Vec<(KnownZero, f64)>,
    tail: f64,
}

/// V and H of the contact, its responses to the load and to a contact force, as products over zeros and poles with
/// error bounds.
pub(super) struct Receptances {
    damped: bool,
    zeros: Zeros,
    stiction: Dd,
    excitation: Factored,
    receptance: Factored,
}

impl Receptances {
    /// Builds the products for V and H. Returns `None` if the zeros cannot be verified.
    pub fn of(exact: &Exact<'_>, zeros: Option<&Zeros>, highest: f64) -> Option<Self> {
        let zeros = zeros?.clone();
        let modal = exact.modal;
        let contact_modes = exact.contact_modes();
        let driven: Vec<(&ContactMode, [Dd; 2])> = contact_modes
            .iter()
            .filter(|mode| !(mode.residue.is_zero() && mode.along.is_zero()))
            .map(|mode| (mode, [mode.residue, mode.along]))
            .collect();
        let all: Vec<(&ContactMode, [Dd; 2])> = contact_modes
            .iter()
            .map(|mode| (mode, [mode.driven.inverse_mass, Dd::ZERO]))
            .collect();
        let direct = if modal.on_moving_base { -1.0 } else { 0.0 };
        let joined =
            |own: &[Zero]| -> Vec<Zero> { own.iter().chain(&zeros.common).copied().collect() };
        let excitation = PartialFractions::of(direct, &driven, zeros.damped)
            .factored(&joined(&zeros.excitation), highest)?;
        let receptance = PartialFractions::of(0.0, &all, zeros.damped)
            .factored(&joined(&zeros.receptance), highest)?;
        Some(Self {
            damped: zeros.damped,
            stiction: modal.stiction,
            excitation,
            receptance,
            zeros,
        })
    }

    /// Proves that an emitted product is β*_lim, with a bound on its relative error.
    pub fn sliding<S: Float>(&self, product: &Product<S>, request: &Request) -> Proof {
        let gain =
            self.excitation.gain * (Ball::exact(self.stiction) * self.receptance.gain).inverse();
        let both = self.excitation.zeros.iter().chain(&self.receptance.zeros);
        let meant = Meant {
            gain: if gain.at < Dd::ZERO { -gain } else { gain },
            numerator: known(&[
                (&self.zeros.excitation, false),
                (&self.zeros.unloaded, true),
            ]),
            denominator: known(&[(&self.zeros.receptance, false)]),
            weights: both.map(|(zero, weight)| (plain(*zero), *weight)).collect(),
            tail: self.excitation.tail + self.receptance.tail,
        };
        let most = request.accuracy;
        let allowed = match request.side {
            Side::Near => (-most, most),
            Side::Safe => (0.0, most),
        };
        self.proof(product, meant, request, allowed)
    }

    /// Proves that an emitted product is |V|, with a bound on its relative error. V is the response of the contact to
    /// the load. For an undamped chain the product is V with its sign.
    pub fn excitation<S: Float>(&self, product: &Product<S>, request: &Request) -> Proof {
        let own = self.excitation.zeros.iter();
        let mut gain = self.excitation.gain;
        // With v = −r², a zero iy contributes the factor y² + v. The emitted factor (r − y)(r + y) has the opposite
        // sign.
        let plain_factor = |factor: &&Factor<S>| !matches!(factor, Factor::Pair { .. });
        let turned = product.numerator.iter().chain(&product.denominator);
        if !self.damped && turned.filter(plain_factor).count() % 2 == 1 {
            gain = -gain;
        }
        if self.damped && gain.at < Dd::ZERO {
            gain = -gain;
        }
        let meant = Meant {
            gain,
            numerator: known(&[(&self.zeros.excitation, false), (&self.zeros.common, false)]),
            denominator: known(&[(&self.zeros.loaded, true)]),
            weights: own.map(|(zero, weight)| (plain(*zero), *weight)).collect(),
            tail: self.excitation.tail,
        };
        self.proof(
            product,
            meant,
            request,
            (-request.accuracy, request.accuracy),
        )
    }

    fn proof<S: Float>(
        &self,
        product: &Product<S>,
        mut meant: Meant,
        request: &Request,
        allowed: (f64, f64),
    ) -> Proof {
        let ends = (S::constant(request.r.0), S::constant(request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let mut open = Vec::new();
        let lists = [&mut meant.numerator, &mut meant.denominator];
        for known in lists.into_iter().flatten() {
            let weights = meant
                .weights
                .iter()
                .filter(|(of, _)| of.zero.is_near(&known.zero));
            let weight = weights.map(|(_, weight)| *weight).fold(0.0, f64::max);
            if let Some(place) = known.place::<S>(weight, request.accuracy)
                && low <= place
                && place <= high
            {
                open.push((place, place));
            }
        }
        for (known, weight) in &mut meant.weights {
            known.place::<S>(*weight, request.accuracy);
        }
        let mut bound = Worst {
            error: 0.0,
            at: low,
        };
        let mut is_any = false;
        for cell in cells(&meant, low, high) {
            match self.cell(product, &meant, cell) {
                Some((least, most)) if allowed.0 <= least && most <= allowed.1 => {
                    is_any = true;
                    let error = most.max(-least);
                    if error > bound.error {
                        let at = 0.5 * (cell.low + cell.high);
                        bound = Worst { error, at };
                    }
                }
                _ => open.push((cell.low, cell.high)),
            }
        }
        open.sort_by(|a, b| a.0.total_cmp(&b.0));
        open.dedup();
        let evidence = match (is_any, open.is_empty()) {
            (false, _) => Evidence::Checked,
            (true, true) => Evidence::Proven,
            (true, false) => Evidence::Partly,
        };
        Proof {
            evidence,
            bound,
            open,
            work: ProofWork(0),
        }
    }

    /// Returns bounds on the relative error of the product in a cell of r, or `None` if no bound is known.
    fn cell<S: Float>(
        &self,
        product: &Product<S>,
        meant: &Meant,
        cell: RoundedInterval,
    ) -> Option<(f64, f64)> {
        let (unit, smallest) = unit::<S>();
        let (mut error, mut quotients) = (0.0, [(1.0, 1.0); 2]);
        let lists = [
            (&product.numerator, &meant.numerator),
            (&product.denominator, &meant.denominator),
        ];
        // If a number is smaller than `least`, its rounding error may exceed the relative bound. If a number is larger
        // than `most`, the next operation may overflow.
        let (least, most) = (smallest / unit, LARGEST / smallest);
        let regular = |(low, high): (f64, f64)| least <= low && high <= most;
        for ((factors, known), size) in lists.into_iter().zip(&mut quotients) {
            if factors.len() != known.len() {
                return None;
            }
            for (factor, known) in factors.iter().zip(known) {
                let bounds = known.bounds::<S>(factor, cell)?;
                error += bounds.error + unit;
                *size = (size.0 * bounds.least, size.1 * bounds.most);
                if !regular(*size) {
                    return None;
                }
            }
        }
        let [above, below] = quotients;
        if !regular((above.0 / below.1, above.1 / below.0)) {
            return None;
        }
        error += unit;
        let plain = meant.numerator.is_empty() && meant.denominator.is_empty();
        if product.squared {
            error = 0.5 * error * (1.0 + error) + unit;
        } else if self.damped && !plain {
            return None;
        }
        // The multiplication by the gain adds one rounding.
        error += unit;
        // At the computed zeros the sum over the modes has small remainders. `tail` and `weights` bound the errors that
        // these remainders cause.
        error += meant.tail;
        for (known, weight) in &meant.weights {
            let zero = &known.zero;
            let away = if self.damped {
                known.away(cell)
            } else if zero.is_on_axis() && !zero.y.is_zero() {
                known.distance(cell) * cell.low
            } else {
                let size = zero.x.abs().to_f64();
                let beside = size
                    * if zero.y.is_zero() {
                        size
                    } else {
                        zero.y.to_f64()
                    };
                beside.max(if zero.is_on_axis() {
                    cell.low * cell.low
                } else {
                    0.0
                }) * 0.99
            };
            error += weight / away;
        }
        if !(error < SMALL) {
            return None;
        }
        let error = error * (1.0 + 2.0 * error) * UP;
        // The code bounds the error of the gain separately. With `side: safe` the emitted gain deliberately differs
        // from the exact gain.
        let gain =
            Ball::exact(Dd::from(product.gain.to_f64())) * meant.gain.inverse() - Ball::number(1.0);
        let gain = (gain.at.to_f64() - gain.off, gain.at.to_f64() + gain.off);
        let outward = |end: f64| end.abs() * OUTWARD;
        let (low, high) = (
            gain.0 - error * (1.0 + gain.0.abs()),
            gain.1 + error * (1.0 + gain.1.abs()),
        );
        let bounds = (low - outward(low), high + outward(high));
        (bounds.0.is_finite() && bounds.1.is_finite()).then_some(bounds)
    }
}

/// Returns a computed zero with the position error 0. A remainder of the sum over the modes at the zero has its own
/// error bound.
fn plain(zero: Zero) -> KnownZero {
    KnownZero {
        zero,
        off: 0.0,
        nearest: 0.0,
    }
}

/// Returns zeros and poles with bounds on their position errors. The bound is 0 for computed zeros, as in [`plain`],
/// and for undamped poles. The error of a damped pole follows from the constants of its mode.
fn known(lists: &[(&[Zero], bool)]) -> Vec<KnownZero> {
    let lists = lists.iter();
    lists
        .flat_map(|(zeros, is_pole)| zeros.iter().map(move |zero| (zero, *is_pole)))
        .map(|(zero, is_pole)| {
            // An undamped pole is known exactly. A damped pole follows from the constants by a few double-double
            // operations.
            let size = zero.x.abs().to_f64() + zero.y.to_f64();
            let off = if is_pole && !zero.is_on_axis() {
                POLE_ROUNDINGS * size * f64::EPSILON * f64::EPSILON
            } else {
                0.0
            };
            KnownZero {
                off,
                ..plain(*zero)
            }
        })
        .collect()
}

impl KnownZero {
    /// Sets the distance from the zero to the nearest number of the scalar type. If this number is too close to a zero
    /// on the imaginary axis, no error bound exists at the number. The method then returns the number, and the proof
    /// leaves it out.
    fn place<S: Float>(&mut self, weight: f64, accuracy: f64) -> Option<f64> {
        if !self.zero.is_on_axis() || self.zero.y.is_zero() {
            return None;
        }
        let (near, apart, others) = beside::<S>(self.zero.y);
        let y = self.zero.y.to_f64();
        // The uncertainty has two sources: the last digits of the zero, and the two emitted terms of its position.
        let uncertain = weight.max(weight / y) + self.off + y * f64::EPSILON * f64::EPSILON;
        if uncertain <= UNCERTAIN * accuracy * apart {
            self.nearest = apart.min(others);
            None
        } else {
            self.nearest = others;
            Some(near)
        }
    }
}

/// Divides the range of r into cells. Two cells meet halfway between neighbours among the zeros, the poles and the
/// bounds of the range.
fn cells(meant: &Meant, low: f64, high: f64) -> Vec<RoundedInterval> {
    let all = meant.numerator.iter().chain(&meant.denominator);
    let mut places: Vec<f64> = all
        .map(|known| known.zero.y.to_f64())
        .filter(|place| low < *place && *place < high)
        .collect();
    places.push(low);
    places.push(high);
    places.sort_by(f64::total_cmp);
    let mut ends = vec![low];
    for pair in places.windows(2) {
        if let [a, b] = pair
            && a < b
        {
            ends.push(0.5 * (a + b));
        }
    }
    ends.push(high);
    ends.windows(2)
        .filter_map(|pair| match pair {
            [low, high] if low < high => Some(RoundedInterval {
                low: *low,
                high: *high,
            }),
            _ => None,
        })
        .collect()
}
