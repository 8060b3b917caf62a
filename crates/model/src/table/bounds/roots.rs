//! Proves that a sum over modes equals a product over given zeros, up to a bounded relative error.
//!
//! The sum is direct + Σρ_i/d_i, with residues ρ_i and denominators d_i. Its numerator N = (direct + Σρ_i/d_i)·Πd_i is
//! a polynomial in v, which is s = ir, or s² for an undamped chain. P = Π(v − z_j) is the product over the given
//! zeros. In partial fractions, N/P = q(v) + Σ_j N(z_j)/P′(z_j)/(v − z_j). The remainders N(z_j) are small if the
//! zeros are right up to their last digits. Except for rounding errors, q is a constant. The proof does not assume
//! that the given zeros are right. Wrong zeros give large N(z_j), and therefore a large error bound.

use super::super::zeros::{ContactMode, Zero};
use super::OUTWARD;
use super::ball::{Ball, Disc, UP as OF_ONE};
use frictiongen_kernel::number::dd::Dd;

/// Factor on a bound, slightly above 1. It covers the rounding errors in the computation of the bound, with thousands
/// of rounding units of double precision.
const UP: f64 = 1.0 + OUTWARD;

/// A term of a sum over the modes: the numerator of a mode, residue + along·v, divided by its denominator, v² + rate·v +
/// square or v + square.
struct Term {
    rate: Ball,
    square: Ball,
    residue: Ball,
    along: Option<Ball>,
}

/// A sum over the modes: direct + Σ(ρ + ev)/d, with the residues ρ, the coefficients e of v, and the denominators d.
pub(super) struct PartialFractions {
    damped: bool,
    direct: Dd,
    terms: Vec<Term>,
}

/// A sum, written as a product over its zeros with error bounds.
pub(super) struct Factored {
    /// The gain, the constant in N = gain·Π(v − z_j)·(1 + δ). N is the numerator of the sum, and z_j are the given
    /// zeros.
    pub gain: Ball,
    /// Bound on |δ| in N = gain·Π(v − z_j)·(1 + δ), without the contributions of the zeros z_j (`zeros`). N is the
    /// numerator of the sum and v its variable.
    pub tail: f64,
    /// The zeros, each with a weight. The weight, divided by the distance of v from the zero, bounds the contribution
    /// of the zero to |δ|.
    pub zeros: Vec<(Zero, f64)>,
}

impl PartialFractions {
    pub fn of(direct: f64, contact_modes: &[(&ContactMode, [Dd; 2])], damped: bool) -> Self {
        let terms = contact_modes.iter().map(|(mode, [residue, along])| {
            let (sigma, zeta) = (
                Ball::exact(mode.driven.sigma),
                Ball::exact(mode.driven.zeta),
            );
            Term {
                rate: Ball::number(2.0) * zeta * sigma,
                square: sigma * sigma,
                residue: Ball::exact(*residue),
                along: (!along.is_zero()).then(|| Ball::exact(*along)),
            }
        });
        Self {
            damped,
            direct: Dd::from(direct),
            terms: terms.collect(),
        }
    }

    /// Returns the degree of the sum's numerator N, a polynomial in v. Returns `None` if its leading terms cancel.
    fn degree(&self) -> Option<usize> {
        let full = self.terms.len() * if self.damped { 2 } else { 1 };
        if self.direct.is_zero() {
            let rises = self.terms.iter().any(|term| term.along.is_some());
            full.checked_sub(if self.damped && !rises { 2 } else { 1 })
        } else {
            Some(full)
        }
    }

    /// Returns the numerator N of the sum over the modes at v.
    fn numerator(&self, v: Disc) -> Disc {
        let mut sum = Disc::real(Ball::exact(self.direct));
        let mut all = Disc::real(Ball::number(1.0));
        for term in &self.terms {
            let denominator = if self.damped {
                v * (v + Disc::real(term.rate)) + Disc::real(term.square)
            } else {
                v + Disc::real(term.square)
            };
            let mut load = Disc::real(term.residue);
            if let Some(along) = term.along {
                load = load + v * Disc::real(along);
            }
            sum = sum + load * denominator.inverse();
            all = all * denominator;
        }
        sum * all
    }

    /// Returns the sum over the modes as a product over the given zeros, with error bounds. Returns `None` if no
    /// bounds can be proven. `highest` is the largest frequency ratio r at which the bounds hold.
    pub fn factored(&self, zeros: &[Zero], highest: f64) -> Option<Factored> {
        let roots: Vec<Vec<Disc>> = zeros.iter().map(|zero| self.roots(zero)).collect();
        let all: Vec<Disc> = roots.iter().flatten().copied().collect();
        let excess = self.degree()?.checked_sub(all.len())?;
        let mut weights = Vec::with_capacity(all.len());
        for (place, root) in all.iter().enumerate() {
            let others = all.iter().enumerate().filter(|(other, _)| *other != place);
            let one = Disc::real(Ball::number(1.0));
            let slope = others.fold(one, |product, (_, other)| product * (*root - *other));
            weights.push(self.numerator(*root).most() / slope.least());
        }
        // The code evaluates q on a circle that encloses all zeros, poles and frequencies. The mean of these values
        // is the constant term of q.
        let sizes = self.terms.iter().map(|term| {
            let (rate, square) = (term.rate.most(), term.square.most());
            if self.damped {
                rate + square.sqrt()
            } else {
                square
            }
        });
        let sizes = sizes.chain(all.iter().map(Disc::most));
        let own = if self.damped {
            highest
        } else {
            highest * highest
        };
        let radius = 2.0 * sizes.fold(own, f64::max);
        let circle = circle(excess + 1);
        let mut values = Vec::with_capacity(circle.len());
        let mut beside = 0.0_f64;
        for point in &circle {
            let v = *point * Disc::real(Ball::number(radius));
            let mut value = self.numerator(v);
            let mut off = 0.0;
            for (root, weight) in all.iter().zip(&weights) {
                let distance = v - *root;
                value = value * distance.inverse();
                off += weight / distance.least() * OF_ONE;
            }
            beside = beside.max(off);
            values.push(value);
        }
        let share = Disc::real(Ball::number(1.0 / circle.len() as f64));
        let zero = Disc::real(Ball::number(0.0));
        let mean = values.iter().fold(zero, |sum, value| sum + *value) * share;
        let apart = values.iter().map(|value| (*value - mean).most());
        let apart = apart.fold(0.0, f64::max) + 2.0 * beside;
        // The numerator N and the product P over the zeros have real coefficients. The constant of their quotient q is
        // therefore real too.
        let mut gain = mean.re;
        gain.off += beside;
        let least = gain.least();
        // The kth coefficient of q, multiplied by the kth power of the radius, is at most the deviation of q from its
        // mean on the circle.
        let tail = excess as f64 * apart / least * UP;
        let mut weights = weights.into_iter();
        let zeros = zeros.iter().zip(&roots).map(|(zero, roots)| {
            let own: f64 = weights.by_ref().take(roots.len()).sum();
            (*zero, own / least * UP)
        });
        let zeros: Vec<(Zero, f64)> = zeros.collect();
        let known = tail.is_finite() && zeros.iter().all(|(_, weight)| weight.is_finite());
        (least > 0.0 && known).then_some(Factored { gain, tail, zeros })
    }

    /// Returns the roots in the variable v (s or s²) that a stored zero represents, which are one root or a conjugate
    /// pair.
    fn roots(&self, zero: &Zero) -> Vec<Disc> {
        let (x, y) = (Ball::exact(zero.x), Ball::exact(zero.y));
        let root = if self.damped {
            Disc::new(x, y)
        } else {
            Disc::new(x * x - y * y, Ball::number(2.0) * x * y)
        };
        let is_real = zero.y.is_zero() || (!self.damped && zero.x.is_zero());
        if is_real {
            vec![Disc::real(root.re)]
        } else {
            vec![root, root.conjugate()]
        }
    }
}

/// Returns evenly spaced points of the unit circle. Their number is the smallest power of two that is at least `count`.
fn circle(count: usize) -> Vec<Disc> {
    let one = Disc::real(Ball::number(1.0));
    let half = Ball::number(0.5);
    let mut points = vec![one];
    // Each step halves the angle: cos² = (1 + cos)/2.
    let mut cosine = Ball::number(1.0);
    while points.len() < count {
        let step = if points.len() == 1 {
            Disc::real(Ball::number(-1.0))
        } else if points.len() == 2 {
            Disc::new(Ball::number(0.0), Ball::number(1.0))
        } else {
            let sine = ((Ball::number(1.0) - cosine) * half).sqrt();
            Disc::new(((Ball::number(1.0) + cosine) * half).sqrt(), sine)
        };
        cosine = step.re;
        let between: Vec<Disc> = points.iter().map(|point| *point * step).collect();
        points = points
            .into_iter()
            .zip(between)
            .flat_map(|(own, next)| [own, next])
            .collect();
    }
    points
}
