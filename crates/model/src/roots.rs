//! Modes of the chain with its contact stuck. A mode is a pair of roots s of 1/κ + Σ c_i/(s² + 2ζ_iσ_i s + λ_i) over
//! the modes i of the sliding chain. Mode i has the resonance σ_i = √λ_i, the damping ratio ζ_i and the contribution
//! c_i to the inverse effective mass of the contact. κ is the stiffness of the contact divided by k₁, and 1/κ is the
//! *compliance* of the contact. The compliance of a rigid contact is 0.
//!
//! Without damping, one root lies between each pair of neighbouring resonances. With an elastic contact, another root
//! lies above the last resonance. With damping, the simultaneous iteration of Aberth and Ehrlich starts from the
//! undamped roots.

use frictiongen_kernel::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;

/// A mode that the contact drives: its resonance σ = √λ, its damping ratio ζ, and its term (c + es)/(s² + 2ζσs + λ) in a
/// response of the contact. For a response to a contact force, c is the contribution of the mode to the inverse
/// effective mass of the contact, and e is 0.
#[derive(Clone, Copy, Debug)]
pub struct DrivenMode {
    pub sigma: Dd,
    pub zeta: Dd,
    /// c, the constant term of the numerator.
    pub inverse_mass: Dd,
    /// e, the coefficient of s in the numerator.
    pub along: Dd,
}

/// One mode of the chain with its contact stuck. A pair of roots describes the mode, the zeros of s² + 2αs + ω².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// ω, the natural frequency of the mode.
    pub omega: Dd,
    /// α/ω, the damping ratio of the mode.
    pub zeta: Dd,
}

/// Returns the modes of the chain with its contact stuck, in ascending order of ω. The resonances of `modes` must be
/// distinct and in ascending order.
pub(crate) fn pairs(modes: &[DrivenMode], compliance: Dd) -> Vec<Pair> {
    let zero = Dd::ZERO;
    let mut undamped: Vec<Dd> = modes
        .windows(2)
        .map(|neighbours| match neighbours {
            [low, high] => between(modes, compliance, low.sigma, Some(high.sigma)),
            _ => zero,
        })
        .collect();
    if !compliance.is_zero()
        && let Some(last) = modes.last()
    {
        undamped.push(between(modes, compliance, last.sigma, None));
    }
    if modes.iter().all(|mode| mode.zeta == zero) {
        let pair = |omega| Pair { omega, zeta: zero };
        return undamped.into_iter().map(pair).collect();
    }
    let mut roots = start(modes, &undamped);
    converge(modes, compliance, &mut roots, 0);
    paired(roots)
}

/// Returns the undamped root ω between two neighbouring resonances, where 1/κ + Σ c_i/(λ_i − ω²) rises from −∞ to ∞.
/// 1/κ is `compliance`. If `high` is `None`, `low` is the last resonance, and the result is the root above `low`. The
/// function multiplies the sum by the denominators of the two neighbouring modes. It applies regula falsi with the
/// Illinois rule to the product.
fn between(modes: &[DrivenMode], compliance: Dd, low: Dd, high: Option<Dd>) -> Dd {
    let value = |omega: Dd| {
        let gap = |sigma: Dd| (sigma - omega) * (sigma + omega);
        // Above the last resonance there is only one neighbouring mode. The factor of the second denominator is then 1.
        let upper = || high.map_or(Dd::ONE, gap);
        let start = if compliance.is_zero() {
            Dd::ZERO
        } else {
            compliance * gap(low) * upper()
        };
        modes.iter().fold(start, |sum, mode| {
            // The product of the two denominators cancels the denominator of a neighbouring mode. This avoids a
            // division by a difference that is nearly 0.
            let weight = if mode.sigma == low {
                upper()
            } else if Some(mode.sigma) == high {
                gap(low)
            } else {
                gap(low) * upper() / gap(mode.sigma)
            };
            sum + mode.inverse_mass * weight
        })
    };
    // Returns an upper bound on the root above the last resonance. At the root, Σ c_i/(ω² − λ_i) = 1/κ, and no
    // denominator is smaller than that of the last resonance.
    let last = || {
        let sum = modes
            .iter()
            .fold(Dd::ZERO, |sum, mode| sum + mode.inverse_mass);
        (low * low + sum / compliance).sqrt() * Dd::from(1.0 + 1e-15)
    };
    let (mut a, mut b) = (low, high.unwrap_or_else(last));
    let (mut at_a, mut at_b) = (value(a), value(b));
    let half = Dd::from(0.5);
    let mut last = None;
    for step in 0..200 {
        let mut c = b - at_b * (b - a) / (at_b - at_a);
        // If the weights of the two modes differ greatly, regula falsi keeps the same bound for many steps. Every
        // eighth step therefore bisects.
        if step % 8 == 7 || !(a < c && c < b) {
            c = (a + b) * half;
        }
        if !(a < c && c < b) {
            break;
        }
        let at_c = value(c);
        if at_c.is_zero() {
            return c;
        }
        let lower = (at_c < Dd::ZERO) == (at_a < Dd::ZERO);
        if lower {
            (a, at_a) = (c, at_c);
        } else {
            (b, at_b) = (c, at_c);
        }
        // Two steps in a row replaced the same bound and kept the other bound. The kept bound gets half its weight
        // (Illinois rule).
        if last == Some(lower) {
            if lower {
                at_b = at_b * half;
            } else {
                at_a = at_a * half;
            }
        }
        last = Some(lower);
        if (b - a).abs() <= b * Dd::from(1e-31) {
            break;
        }
    }
    (a + b) * half
}

/// Returns starting values for the search of the roots: the undamped frequencies, with damping estimated from the mode
/// shapes. A slight asymmetry of the values allows a pair to separate into two real roots.
fn start(modes: &[DrivenMode], undamped: &[Dd]) -> Vec<Complex<Dd>> {
    let mut roots = Vec::new();
    for (index, omega) in undamped.iter().enumerate() {
        let (mut weight, mut damping) = (Dd::ZERO, Dd::ZERO);
        for mode in modes {
            let gap = (mode.sigma - *omega) * (mode.sigma + *omega);
            if gap.is_zero() {
                continue;
            }
            let term = mode.inverse_mass / (gap * gap);
            weight = weight + term;
            damping = damping + term * mode.zeta * mode.sigma;
        }
        let zeta = (damping / weight / *omega).to_f64();
        let uneven = 1.0 + 1e-3 * (index % 7 + 1) as f64;
        let (first, second) = if zeta < 1.0 {
            let (re, im) = (-zeta - 1e-9, (1.0 - zeta * zeta).sqrt());
            (
                Complex::new(re, im),
                Complex::new(re * uneven, -im * uneven),
            )
        } else {
            let root = (zeta * zeta - 1.0).sqrt();
            let slow = 1.0 / (zeta + root);
            (
                Complex::new(-slow, 1e-4 * slow),
                Complex::new(-(zeta + root), -2e-4 * (zeta + root)),
            )
        };
        for root in [first, second] {
            roots.push(Complex::new(
                Dd::from(root.re) * *omega,
                Dd::from(root.im) * *omega,
            ));
        }
    }
    roots
}

/// Finds zeros of the sum `direct` + Σ (c_i + e_i s)/(s² + 2ζ_iσ_i s + λ_i) over the modes, starting from the estimates in
/// `roots`. The first `known` entries of `roots` stay fixed.
pub(crate) fn converge(modes: &[DrivenMode], direct: Dd, roots: &mut [Complex<Dd>], known: usize) {
    fn steps<S: Float>(
        modes: &[DrivenMode],
        direct: Dd,
        roots: &mut [Complex<Dd>],
        known: usize,
        most: (usize, f64),
    ) {
        let modes: Vec<[S; 4]> = modes
            .iter()
            .map(|mode| [mode.sigma, mode.zeta, mode.inverse_mass, mode.along].map(to))
            .collect();
        let direct = to(direct);
        iterate(roots, known, most, |s| slope_over_value(&modes, direct, s));
    }
    steps::<f64>(modes, direct, roots, known, FIRST_STEPS);
    steps::<Dd>(modes, direct, roots, known, LAST_STEPS);
}

/// Largest number of steps in double precision, and the relative correction at which these steps end. The search for
/// roots begins with these steps. The steps in double-double follow (`LAST_STEPS`).
const FIRST_STEPS: (usize, f64) = (100, 1e-14);
/// Largest number of steps in double-double, and the relative correction at which the search for roots ends.
const LAST_STEPS: (usize, f64) = (60, 1e-29);

/// A root counts as real if its imaginary part is at most this fraction of its modulus. Rounding alone can cause an
/// imaginary part of this size.
const REAL: f64 = 1e-13;

/// Converts a double-double to another number type.
pub(crate) fn to<S: Float>(value: Dd) -> S {
    S::constant(value.hi) + S::constant(value.lo)
}

/// Improves the estimates of all roots of a polynomial P simultaneously (Aberth and Ehrlich). Each step is a Newton
/// step for one root, computed from P′/P after division by the factors of the other roots. The first `known` roots stay
/// unchanged.
pub(crate) fn iterate<S: Float>(
    roots: &mut [Complex<Dd>],
    known: usize,
    (steps, tolerance): (usize, f64),
    slope_over_value: impl Fn(Complex<S>) -> Complex<S>,
) {
    let of = |value: S| {
        let high = value.to_f64();
        Dd::from(high) + Dd::from((value - S::constant(high)).to_f64())
    };
    let mut own: Vec<Complex<S>> = roots
        .iter()
        .map(|root| Complex::new(to(root.re), to(root.im)))
        .collect();
    for _ in 0..steps {
        let mut largest = 0.0_f64;
        for index in known..own.len() {
            let Some(&s) = own.get(index) else { continue };
            let mut newton = slope_over_value(s);
            for (other, root) in own.iter().enumerate() {
                let difference = complex::add(s, complex::scale(*root, S::constant(-1.0)));
                if other != index && !(difference.re.is_zero() && difference.im.is_zero()) {
                    let pull = complex::reciprocal(difference, true);
                    newton = Complex::new(newton.re - pull.re, newton.im - pull.im);
                }
            }
            let step = complex::reciprocal(newton, true);
            if !(step.re.is_finite() && step.im.is_finite()) {
                continue;
            }
            let size = complex::modulus(s, true).to_f64();
            largest = largest.max(complex::modulus(step, true).to_f64() / size);
            if let Some(root) = own.get_mut(index) {
                *root = Complex::new(s.re - step.re, s.im - step.im);
            }
        }
        if largest < tolerance {
            break;
        }
    }
    for (root, own) in roots.iter_mut().zip(own) {
        *root = Complex::new(of(own.re), of(own.im));
    }
}

/// Returns P′/P at s, for the polynomial P = (direct + Σ (c_i + e_i s)/d_i) Π d_i with d_i = s² + 2ζ_iσ_i s + σ_i².
fn slope_over_value<S: Float>(modes: &[[S; 4]], direct: S, s: Complex<S>) -> Complex<S> {
    let zero = complex::real(S::constant(0.0));
    let (mut value, mut slope, mut others) = (complex::real(direct), zero, zero);
    let two = S::constant(2.0);
    for [sigma, zeta, inverse_mass, along] in modes {
        let rate = two * *zeta * *sigma;
        let d = complex::add(
            complex::mul(s, Complex::new(s.re + rate, s.im), true),
            complex::real(*sigma * *sigma),
        );
        let inverse = complex::reciprocal(d, true);
        let derivative = Complex::new(s.re * two + rate, s.im * two);
        let ratio = complex::mul(derivative, inverse, true);
        let mut term = complex::scale(inverse, *inverse_mass);
        if !along.is_zero() {
            let own = complex::scale(inverse, *along);
            term = complex::add(term, complex::mul(own, s, true));
            slope = Complex::new(slope.re - own.re, slope.im - own.im);
        }
        value = complex::add(value, term);
        slope = complex::add(slope, complex::mul(term, ratio, true));
        others = complex::add(others, ratio);
    }
    let own = complex::mul(slope, complex::reciprocal(value, true), true);
    Complex::new(others.re - own.re, others.im - own.im)
}

/// Joins two conjugate roots into a pair, and joins real roots into pairs by size. Two real roots whose starting
/// values come from one undamped frequency stay together. A pair of real roots from two different modes would make the
/// modal contributions nearly linearly dependent.
fn paired(started: Vec<Complex<Dd>>) -> Vec<Pair> {
    let is_real = |root: &Complex<Dd>| {
        let size = complex::modulus(*root, true);
        root.im.abs() <= size * Dd::from(REAL)
    };
    let mut pairs = Vec::new();
    let mut roots = Vec::new();
    for two in started.chunks(2) {
        match two {
            [a, b] if is_real(a) && is_real(b) => pairs.push(pair(a.re + b.re, a.re * b.re)),
            _ => roots.extend(two),
        }
    }
    let mut real: Vec<Dd> = Vec::new();
    while let Some(root) = roots.pop() {
        if is_real(&root) {
            real.push(root.re);
            continue;
        }
        let distance = |other: &Complex<Dd>| {
            let difference = Complex::new(other.re - root.re, other.im + root.im);
            complex::modulus(difference, true).to_f64()
        };
        let partner = (0..roots.len()).min_by(|a, b| {
            let of = |i: &usize| roots.get(*i).map_or(f64::INFINITY, distance);
            of(a).total_cmp(&of(b))
        });
        let Some(partner) = partner else { continue };
        let partner = roots.swap_remove(partner);
        let product = root.re * partner.re - root.im * partner.im;
        pairs.push(pair(root.re + partner.re, product));
    }
    real.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
    for two in real.chunks(2) {
        if let [a, b] = two {
            pairs.push(pair(*a + *b, *a * *b));
        }
    }
    pairs.sort_by(|a, b| a.omega.to_f64().total_cmp(&b.omega.to_f64()));
    pairs
}

fn pair(sum: Dd, product: Dd) -> Pair {
    let omega = product.abs().sqrt();
    let zeta = -sum * Dd::from(0.5) / omega;
    Pair {
        omega,
        zeta: if zeta < Dd::ZERO { Dd::ZERO } else { zeta },
    }
}
