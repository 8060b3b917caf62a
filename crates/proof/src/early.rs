//! The velocity constraint F/sin τ near the start of the half period. At the start F and sin τ are both zero, so this
//! module uses the Taylor series of F/τ in τ.

use crate::force;
use crate::series::IntervalSeries;
use crate::stage::ChainStage;
use frictiongen_model::interval::Interval;

/// Number of terms of the Taylor series of F/τ in τ, where F/sin τ is the velocity constraint. [`rest`] bounds the
/// remainder. With fewer terms the proof would stay correct, but would fail for more of r.
const TERMS: usize = 13;
/// Derivatives of cos τ at τ = 0, which repeat after four.
const OF_COSINE: [f64; 4] = [1.0, 0.0, -1.0, 0.0];
/// Largest |τ|, in rad, for which the bound on the remainder of the series of sin τ/τ is valid. The proof uses the
/// series only for instants near the start of the half period, which are earlier than this |τ|.
const FARTHEST: f64 = 1.3;
/// Bound on the remainder of the power series of sin τ/τ, and of its slope, for |τ| up to [`FARTHEST`]. The terms
/// after the first [`PAIRS`] add up to less than 20·1.3¹⁹/21! < 6·10⁻¹⁷.
const SINC_REST: f64 = 1e-16;
/// Number of powers of τ² in the power series of sin τ/τ. The next term is below one rounding unit for |τ| up to
/// [`FARTHEST`].
const PAIRS: usize = 10;
/// Factor on an upper bound. It covers up to four roundings, each at most 2⁻⁵³ ≈ 1.1·10⁻¹⁶.
const UP: f64 = 1.0 + 1e-15;
/// Factor on an upper bound. It covers up to ninety roundings, including those of π and of other factors.
const FAR_UP: f64 = 1.0 + 1e-14;

/// Returns sin τ/τ and its slope in τ, by power series with the remainder [`SINC_REST`]. Returns intervals of all
/// numbers if |τ| may exceed [`FARTHEST`].
pub(crate) fn sinc<const N: usize>(
    tau: &IntervalSeries<N>,
) -> (IntervalSeries<N>, IntervalSeries<N>) {
    if !(tau.value().size() <= FARTHEST) {
        return (
            IntervalSeries::fixed(Interval::ALL),
            IntervalSeries::fixed(Interval::ALL),
        );
    }
    let square = tau.squared();
    let zero = IntervalSeries::fixed(Interval::ZERO);
    let (mut value, mut slope) = (zero, zero);
    // The sums run from the highest power to the lowest. The coefficient of τ^{2j} is (−1)^j/(2j + 1)!. The
    // coefficient of τ^{2j−1} in the slope is 2j times as large.
    for j in (0..PAIRS).rev() {
        let mut weight = Interval::ONE;
        for factor in 2..=(2 * j + 1) {
            weight = weight / Interval::point(factor as f64);
        }
        let weight = if j % 2 == 0 { weight } else { -weight };
        value = value * square + IntervalSeries::fixed(weight);
        if j > 0 {
            slope =
                slope * square + IntervalSeries::fixed(weight * Interval::point(2.0 * j as f64));
        }
    }
    let rest = IntervalSeries::fixed(Interval::within(SINC_REST));
    (value + rest, slope * *tau + rest)
}

/// Returns F/τ and its slope in τ from a Taylor series in τ, without the remainder that [`rest`] bounds. F/sin τ is
/// the velocity constraint.
pub(crate) fn over_tau<const N: usize>(
    stage: &ChainStage<N>,
    tau: &IntervalSeries<N>,
) -> (IntervalSeries<N>, IntervalSeries<N>) {
    let zero = IntervalSeries::fixed(Interval::ZERO);
    // p is the free displacement of a mode after a unit velocity. At τ = 0 its nth derivative is k_n xⁿ⁻¹, with
    // k_n + 2ζk_{n−1} + k_{n−2} = 0. Because x = σ/r with σ = √λ, all modes have the same power of r. The code adds up
    // the products of κc(1 + g) with k_nσⁿ⁻¹ and of κcu/x² with k_{n+1}σⁿ over the modes. `ModeStage` explains these
    // two factors.
    let mut sums = [(zero, zero); TERMS + 1];
    for mode in &stage.modes {
        let own = mode.oscillator;
        let two_zeta = own.zeta.doubled();
        let (mut constant, mut next, mut power) =
            (Interval::ZERO, Interval::ONE, Interval::ONE / own.sigma);
        for (free, forced) in &mut sums {
            free.add_times(&mode.free, constant * power);
            power = power * own.sigma;
            forced.add_times(&mode.forced_slope, next * power);
            (constant, next) = (next, -(two_zeta * next + constant));
        }
    }
    let (mut power, mut factorial) = (IntervalSeries::fixed(Interval::ONE), 1.0);
    let mut coefficients = Vec::with_capacity(TERMS);
    for (n, (free, forced)) in sums.iter().enumerate().skip(1) {
        let cosine = OF_COSINE.get(n % 4).copied().unwrap_or(0.0);
        let derivative = (*free - *forced * stage.inverse) * power
            + stage.quadrature.times(Interval::point(cosine));
        factorial *= n as f64;
        coefficients.push(derivative.times(Interval::ONE / Interval::point(factorial)));
        power = power * stage.inverse;
    }
    let (mut value, mut slope) = (zero, zero);
    for (power, coefficient) in coefficients.iter().enumerate().rev() {
        value = value * *tau + *coefficient;
        if power > 0 {
            slope = slope * *tau + coefficient.times(Interval::point(power as f64));
        }
    }
    (value, slope)
}

/// Returns bounds on the remainders of [`over_tau`], of F/τ and of its slope, for all τ from 0 to πt.
pub(crate) fn rest<const N: usize>(stage: &ChainStage<N>, t: f64) -> [Interval; 2] {
    let stage = stage.truncated::<1>();
    let all = Interval::new(0.0, t);
    let motions = force::motions(&stage, &IntervalSeries::fixed(all));
    let mut most = 0.0;
    for (mode, (p, slope)) in stage.modes.iter().zip(&motions) {
        let x = mode.x.value();
        let loss = x * mode.oscillator.zeta.doubled();
        let (mut p, mut next) = (p.value(), slope.value());
        for _ in 0..=TERMS {
            let following = -(loss * next) - x.squared() * p;
            (p, next) = (next, following);
        }
        // With T for `TERMS`, `p` and `next` are now p⁽ᵀ⁺¹⁾ and p⁽ᵀ⁺²⁾. The magnitude of a derivative of the cosine is
        // at most 1.
        let of_forced_slope = mode.forced_slope.value() * (Interval::within(1.0) - next);
        most += (mode.free.value() * p + of_forced_slope).size() * UP;
    }
    let tau = std::f64::consts::PI * t * FAR_UP;
    let mut tail = most;
    for n in 1..=(TERMS - 1) {
        tail *= tau / n as f64 * UP;
    }
    // With T for `TERMS`, `tail` is sup|F⁽ᵀ⁺¹⁾| τᵀ⁻¹/(T − 1)!.
    let terms = TERMS as f64;
    let of_slope = tail / (terms + 1.0) * FAR_UP;
    let of_value = tail * tau / (terms * (terms + 1.0)) * FAR_UP;
    [Interval::within(of_value), Interval::within(of_slope)]
}
