//! Helpers of the unit tests for modal sums and their searches. A wave is the term of one mode in a modal sum. The
//! helpers compute derivatives of a wave by formulas that are independent of the tested code. They also create random
//! waves.
//!
//! A wave is a sum of sinusoids and a free vibration p, whose derivatives satisfy p⁽ⁿ⁺²⁾ = −2ζx p⁽ⁿ⁺¹⁾ − x² p⁽ⁿ⁾. ζ is
//! the damping ratio of the mode, and x its natural frequency divided by the excitation frequency.

use crate::modal_sum::wave::{Sum, Wave};
use crate::oscillator::decay::Damped;
use crate::oscillator::mode::Kind;
use crate::response::coefficients::ModalCoefficients;
use crate::response::motion::motion_wave;
use core::f64::consts::PI;

pub use fuzzing::Random as Lcg;

pub type TestWave = Wave<f64, Damped<f64>>;

/// Number of derivatives of a wave that the tests compute. A search uses no higher derivative in its Taylor series.
pub const ORDERS: usize = 18;

/// Modal damping ratios ζ for the tests, with every kind of damping. At some ζ the closed form of the response changes.
/// The list has a value below and a value above each such ζ.
pub const ZETAS: [f64; 12] = [
    0.0, 1e-6, 0.01, 0.1, 0.3, 0.49, 0.6, 0.9, 1.0, 1.2, 3.0, 20.0,
];

pub fn damped(zeta: f64) -> Damped<f64> {
    let kind = match zeta {
        0.0 => Kind::Undamped,
        zeta if zeta < 0.5 => Kind::Light,
        zeta if zeta < 1.0 => Kind::Heavy,
        1.0 => Kind::Critical,
        _ => Kind::Over,
    };
    Damped::new(kind, zeta, ((1.0 - zeta) * (1.0 + zeta)).abs().sqrt())
}

pub fn at_rest(x: f64, zeta: f64) -> TestWave {
    Wave::at_rest(x, damped(zeta))
}

/// Returns the derivatives p⁽ⁿ⁾ of a free vibration p at the time τ, for n = 0, 1, …, `last`. p starts with
/// displacement 0 and velocity 1.
fn free(x: f64, zeta: f64, tau: f64, last: usize) -> [f64; ORDERS] {
    let mut out = [0.0; ORDERS];
    let q2 = 1.0 - zeta * zeta;
    let q = q2.abs().sqrt();
    (out[0], out[1]) = if zeta == 1.0 {
        let decay_factor = (-x * tau).exp();
        (tau * decay_factor, (1.0 - x * tau) * decay_factor)
    } else if q2 > 0.0 {
        let decay_factor = (-zeta * x * tau).exp();
        let (s, c) = (q * x * tau).sin_cos();
        (
            decay_factor * s / (q * x),
            decay_factor * (c - zeta / q * s),
        )
    } else {
        // The product of the two decay rates is x². The code computes the slow rate as x² divided by the fast rate. A
        // difference of nearly equal numbers would lose digits.
        let (slow, fast) = (x / (zeta + q), x * (zeta + q));
        let (a, b) = ((-slow * tau).exp(), (-fast * tau).exp());
        // For τ → 0 the two exponentials `a` and `b` nearly cancel. `exp_m1` keeps the digits of their difference.
        let p = -a * (-(fast - slow) * tau).exp_m1() / (fast - slow);
        (p, b - slow * p)
    };
    for n in 2..=last {
        out[n] = -2.0 * zeta * x * out[n - 1] - x * x * out[n - 2];
    }
    out
}

/// Returns the derivatives of cos τ and sin τ with respect to τ, of the order `order`.
fn turning(tau: f64, order: usize) -> (f64, f64) {
    let (s, c) = tau.sin_cos();
    [(c, s), (-s, c), (-c, -s), (s, -c)][order % 4]
}

/// Returns the coefficients a and b of the response y = 1/x² + a·d + b·p of a mode. The load is a unit force that
/// changes its sign every half period.
///
/// The coefficients follow from y(π) = −y(0) and y′(π) = −y′(0), with d = p′ + 2ζx p and d′ = −x²p. p is the free
/// vibration from displacement 0 with velocity 1.
fn mass_controlled_parts(x: f64, zeta: f64) -> (f64, f64) {
    let end = free(x, zeta, PI, 1);
    let (p, slope) = (end[0], end[1]);
    let d = slope + 2.0 * zeta * x * p;
    // At τ = π, the two conditions on y and y′ are (1 + d)a + p·b = −2/x² and −x²p·a + (1 + p′)b = 0.
    let determinant = (1.0 + d) * (1.0 + slope) + x * x * p * p;
    let a = -2.0 / (x * x) * (1.0 + slope) / determinant;
    (a, -2.0 * p / determinant)
}

/// Returns the derivative of a wave (one mode's term in a modal sum) at the time τ. `order` is the order of the
/// derivative.
pub fn derivative(wave: &TestWave, tau: f64, order: usize) -> f64 {
    use crate::oscillator::decay::Decay;
    let (x, zeta) = (wave.x, wave.decay.zeta());
    let p = free(x, zeta, tau, order + 1);
    let (c, s) = turning(tau, order);
    let d = |order: usize| match order {
        0 => p[1] + 2.0 * zeta * x * p[0],
        _ => -x * x * p[order - 1],
    };
    let rise = if wave.mass_controlled {
        let (a, b) = mass_controlled_parts(x, zeta);
        let constant = if order == 0 { 1.0 / (x * x) } else { 0.0 };
        constant + a * d(order) + b * p[order]
    } else if order == 0 {
        (1.0 - d(0)) / (x * x)
    } else {
        p[order - 1]
    };
    wave.free * p[order]
        + wave.forced_slope * (c - p[order + 1])
        + wave.forced * (s - p[order])
        + wave.rise * rise
}

/// Returns the derivative of a modal sum at the time τ. `order` is the order of the derivative.
pub fn sum_derivative(sum: &Sum<'_, f64, Damped<f64>>, tau: f64, order: usize) -> f64 {
    let (c, s) = turning(tau, order);
    let waves = sum.waves.iter().map(|wave| derivative(wave, tau, order));
    sum.cosine * c + sum.sine * s + waves.sum::<f64>()
}

/// Returns four or five test waves, each with a name. A wave is the term of one mode in a modal sum.
///
/// In each of the first four waves, one coefficient is 1 and the others are 0. For a mode that resonates far below the
/// excitation frequency, a fifth wave contains the whole response.
pub fn parts(x: f64, zeta: f64) -> Vec<(&'static str, TestWave)> {
    let at_rest = at_rest(x, zeta);
    let mut parts = vec![
        (
            "free",
            Wave {
                free: 1.0,
                ..at_rest
            },
        ),
        (
            "forced_slope",
            Wave {
                forced_slope: 1.0,
                ..at_rest
            },
        ),
        (
            "forced",
            Wave {
                forced: 1.0,
                ..at_rest
            },
        ),
        (
            "rise",
            Wave {
                rise: 1.0,
                ..at_rest
            },
        ),
    ];
    if x * (2.0 * zeta).max(1.0) < 0.5 {
        let inert = Wave {
            rise: 1.0,
            mass_controlled: true,
            ..at_rest
        };
        parts.push(("mass-controlled", inert));
    }
    parts
}

/// Returns random waves in ascending order of natural frequency. A wave is the term of one mode in a modal sum. If
/// `undamped` is true, no mode is damped. Otherwise each mode has its own damping ratio. If `rise` is false, a wave
/// has only the terms that occur in the velocity constraint.
pub fn random_waves(
    random: &mut Lcg,
    (low, high): (f64, f64),
    undamped: bool,
    rise: bool,
) -> Vec<TestWave> {
    let count = 1 + random.below(6);
    let mut waves: Vec<TestWave> = (0..count)
        .map(|_| {
            let x = random.log_uniform(low, high);
            let zeta = if undamped {
                0.0
            } else {
                [0.0, random.log_uniform(1e-4, 0.5), 0.7, 1.0, 4.0][random.below(5)]
            };
            // The factors x and x² make each term of a fast mode of order 1, so that all terms have similar sizes.
            let mut wave = at_rest(x, zeta);
            wave.forced = random.signed();
            wave.forced_slope = random.signed();
            if rise {
                wave.free = x * random.signed();
                wave.rise = x * x * random.signed();
            }
            wave
        })
        .collect();
    waves.sort_by(|a, b| a.x.total_cmp(&b.x));
    waves
}

/// Returns a random motion that resembles the motion of a chain. The motion repeats with the opposite sign after half a
/// period. The result consists of one wave for each mode, and of the coefficients of cos τ and sin τ in the motion.
///
/// The response of a mode is a combination of the functions in `Basis`, plus a term in cos τ and a term in sin τ. The
/// wave of the mode contains only the combination. The function sums the cos τ and sin τ terms of all modes in the two
/// coefficients. A mass-controlled mode, which resonates far below the excitation frequency, has no such terms.
pub fn random_motion(
    random: &mut Lcg,
    (low, high): (f64, f64),
    undamped: bool,
    most: usize,
) -> (Vec<TestWave>, f64, f64) {
    let (mut cosine, mut sine) = (random.signed(), random.signed());
    let mut waves: Vec<TestWave> = (0..1 + random.below(most))
        .map(|_| {
            let x = random.log_uniform(low, high);
            let damping = [
                random.log_uniform(1e-4, 0.5),
                random.log_uniform(1e-3, 0.1),
                0.7,
                4.0,
            ];
            let zeta = if undamped {
                0.0
            } else {
                damping[random.below(4)]
            };
            let weight = random.signed() * x * x;
            if x * (2.0 * zeta).max(1.0) < 0.5 {
                return Wave {
                    rise: weight,
                    mass_controlled: true,
                    ..at_rest(x, zeta)
                };
            }
            // With g = −a x² − 1, the response 1/x² + a·d + b·p equals (1 − d)/x² + g(cos τ − d)/x² − b(sin τ − p) − g
            // cos τ/x² + b sin τ.
            let (a, b) = mass_controlled_parts(x, zeta);
            let fall = -a - 1.0 / (x * x);
            cosine -= weight * fall;
            sine += weight * b;
            let coefficients = ModalCoefficients {
                rise: weight,
                fall: weight * fall,
                forced: -(weight * b),
                harmonic: 0.0,
            };
            motion_wave(x, damped(zeta), coefficients)
        })
        .collect();
    waves.sort_by(|a, b| a.x.total_cmp(&b.x));
    (waves, cosine, sine)
}

/// Returns a random velocity constraint: the waves of the modes, the coefficient of sin τ in their sum, and the limit
/// of the constraint for τ → 0.
///
/// A wave is the term of one mode. The sum of the waves vanishes at τ = 0 and at τ = π. Without damping, the sum of
/// the waves plus the limit times sin τ is odd about τ = π/2.
pub fn random_constraint(
    random: &mut Lcg,
    (low, high): (f64, f64),
    undamped: bool,
    most: usize,
) -> (Vec<TestWave>, f64, f64) {
    let (mut sine, mut start) = (0.0, 0.0);
    let mut waves: Vec<TestWave> = (0..1 + random.below(most))
        .map(|_| {
            let x = random.log_uniform(low, high);
            let damping = [
                random.log_uniform(1e-4, 0.5),
                random.log_uniform(1e-3, 0.1),
                0.7,
                4.0,
            ];
            let zeta = if undamped {
                0.0
            } else {
                damping[random.below(4)]
            };
            let inverse_mass = random.unit();
            // The velocity of the mode is y′ = −a x²p + b p′, with the free displacement p.
            let (a, b) = mass_controlled_parts(x, zeta);
            let (forced, forced_slope) = (inverse_mass * a * x * x, -(inverse_mass * b));
            sine -= 2.0 * zeta * x * forced_slope;
            start += 2.0 * zeta * x * forced_slope - forced;
            Wave {
                forced,
                forced_slope,
                ..at_rest(x, zeta)
            }
        })
        .collect();
    waves.sort_by(|a, b| a.x.total_cmp(&b.x));
    (waves, sine, start)
}
