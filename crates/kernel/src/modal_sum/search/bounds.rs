//! Upper bounds on the derivatives of a modal sum after a given instant, and the state (displacement and velocity) of
//! each mode at this instant.
//!
//! The code splits the motion of most modes into a free motion and a forced motion. The forced motion is a constant
//! plus sinusoids. The other modes *keep their forcing*. The state of such a mode contains the whole motion, and the
//! later motion follows from this state by the equation of the mode (section 9 of `docs/derivation.md`).

use crate::modal_sum::wave::{Sum, Wave};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Basis, Decay, Instant};

/// Smallest |x − 1| at which the code splits the motion of a mode into a free and a forced motion. x = √λ/r is the
/// natural frequency of the mode divided by the excitation frequency. Closer to the resonance x = 1, the free and the
/// forced motion are large and nearly cancel. Their sum would be mainly rounding error.
const NEAR_EXCITATION: f64 = 0.125;
/// Bound on the rounding error of a mode at a grid node, as a multiple of the rounding unit times the mode's amplitude.
/// `ROUNDINGS` rounding units also bound the errors of sin τ and cos τ at the node.
///
/// The matrix that advances a mode from one node to the next has three roundings. The fourth power of the matrix has
/// twelve roundings, and a grid applies this power seven times: 84 roundings. A bound of 64 suffices, because the
/// errors partly cancel.
const ROUNDINGS: f64 = 64.0;

/// State of one mode at an instant, and the force that acts on the mode from this instant on. The equation of the mode
/// is y″ + 2ζx y′ + x²y = constant + cosine·cos τ + sine·sin τ.
pub(super) struct ModeTrack<S> {
    /// Natural frequency of the mode divided by the excitation frequency, x = √λ/r.
    pub x: S,
    /// Coefficient 2ζx of y′ in the equation of the mode.
    pub loss: S,
    pub value: S,
    pub slope: S,
    constant: S,
    cosine: S,
    sine: S,
}

/// Forced motion of one mode: constant + cosine·cos τ + sine·sin τ. A grid adds the coefficients of all modes.
pub(super) struct Common<S> {
    pub constant: S,
    pub cosine: S,
    pub sine: S,
}

impl<S: Float> ModeTrack<S> {
    /// Splits the motion of a mode at an instant into a free and a forced motion. The first result is the state of the
    /// free motion. The second result contains the coefficients of the forced motion. If `all` or [`keeps_forcing`] is
    /// true, the code does not split the motion. The state then contains the whole motion, and the coefficients are 0.
    #[inline]
    pub fn of<D: Decay<S>>(wave: &Wave<S, D>, at: &Instant<S>, all: bool) -> (Self, Common<S>) {
        let zero = S::constant(0.0);
        let x = wave.x;
        let loss = (wave.decay.zeta() + wave.decay.zeta()) * x;
        let basis = if at.t.is_zero() && !wave.mass_controlled {
            Basis {
                free: zero,
                slope: S::constant(1.0),
                forced: zero,
                forced_slope: zero,
                rise: zero,
            }
        } else {
            wave.basis(at)
        };
        if keeps_forcing(wave, all) {
            let (cosine, sine) = wave.forcing();
            let track = Self {
                x,
                loss,
                value: wave.value(&basis),
                slope: wave.slope(&basis, at),
                constant: wave.rise,
                cosine,
                sine,
            };
            let common = Common {
                constant: zero,
                cosine: zero,
                sine: zero,
            };
            return (track, common);
        }
        // The state of the free motion is a combination of the free displacement p and its derivative p′. The function
        // d = p′ + 2ζx·p contributes to the coefficients of p and of p′.
        let constant = wave.rise / (x * x);
        let of_slope = -(wave.forced_slope + constant);
        let of_free = wave.free - wave.forced - constant * loss;
        let curve = -(x * x * basis.free + loss * basis.slope);
        let track = Self {
            x,
            loss,
            value: of_free * basis.free + of_slope * basis.slope,
            slope: of_free * basis.slope + of_slope * curve,
            constant: zero,
            cosine: zero,
            sine: zero,
        };
        let common = Common {
            constant,
            cosine: wave.forced_slope,
            sine: wave.forced,
        };
        (track, common)
    }
}

/// Returns true if the code does not split the motion of a mode into a free and a forced motion. The code does not
/// split the motion of modes that resonate close to the excitation frequency or far below it. For modes far below, the
/// factor 1/x² of the forced motion would outweigh the whole motion. If `all` is true, the result is true for every
/// mode.
pub(super) fn keeps_forcing<S: Float, D: Decay<S>>(wave: &Wave<S, D>, all: bool) -> bool {
    let slow = wave.x < S::constant(0.5) && !wave.rise.is_zero();
    all || wave.mass_controlled
        || slow
        || (wave.x - S::constant(1.0)).abs() < S::constant(NEAR_EXCITATION)
}

/// Upper bounds on the derivatives of a modal sum after a given instant, with bounds on the sum's size and rounding
/// error.
#[derive(Clone, Copy, Debug)]
pub(super) struct DerivativeBounds<S> {
    /// Second derivative of the sum at the instant. The field `third` is the third derivative. Only a search of sum/sin
    /// τ needs the two derivatives. Both derivatives leave out mass-controlled modes, because a sum that is divided by
    /// sin τ contains no such mode.
    pub second: S,
    pub third: S,
    pub fourth: S,
    pub fifth: S,
    /// Sum of the upper bounds on the terms of all modes.
    pub size: S,
    /// Upper bound on the rounding error of the sum at a node.
    pub rounding: S,
    /// Upper bound on the rounding error of the sum, divided by the time τ since the instant. The bound is valid only
    /// if all modes are at rest at the instant. The code must also split no motion into a free and a forced motion.
    pub drift: S,
}

impl<S: Float> DerivativeBounds<S> {
    /// Computes bounds on a modal sum and its derivatives that are valid from the instant `at` for the duration `time`.
    ///
    /// Let y be the displacement of a mode, and x the natural frequency of the mode divided by the excitation
    /// frequency. The bounds follow from the energy (x y⁽ⁿ⁾)² + (y⁽ⁿ⁺¹⁾)² of the nth derivative of y. Damping decreases
    /// this energy, and only the nth derivative of the force on the mode can increase it.
    pub fn of<D: Decay<S>>(sum: &Sum<'_, S, D>, at: &Instant<S>, time: S) -> Self {
        let (zero, one, two) = (S::constant(0.0), S::constant(1.0), S::constant(2.0));
        let (mut cosine, mut sine) = (sum.cosine, sum.sine);
        let (mut second, mut third, mut fourth, mut fifth) = (zero, zero, zero, zero);
        let (mut rounding, mut drift) = (zero, zero);
        for wave in sum.waves {
            if wave.mass_controlled {
                let [y, y4, y5] = mass_controlled_bounds(wave);
                fourth = fourth + y4;
                fifth = fifth + y5;
                rounding = rounding + y;
                continue;
            }
            let (track, common) = ModeTrack::of(wave, at, false);
            let ModeTrack { x, loss, .. } = track;
            (cosine, sine) = (cosine + common.cosine, sine + common.sine);
            let turning = track.cosine * at.cosine + track.sine * at.sine;
            let turned = track.sine * at.cosine - track.cosine * at.sine;
            let y0 = track.value;
            let y1 = track.slope;
            let y2 = track.constant + turning - loss * y1 - x * x * y0;
            let y3 = turned - loss * y2 - x * x * y1;
            let y4 = -turning - loss * y3 - x * x * y2;
            let push = track.cosine.abs() + track.sine.abs();
            // The code uses √(a² + b²) ≤ max + (√2 − 1) min, where max is the larger and min the smaller of |a| and
            // |b|. This bound needs no square, which might overflow.
            let (a, b) = ((x * y3).abs(), y4.abs());
            let energy = a.max(b) + a.min(b) * S::constant(0.414_213_6) + push * time;
            second = second + y2;
            third = third + y3;
            fourth = fourth + energy;
            fifth = fifth + (x + loss) * energy + push;
            let drive = (push + track.constant.abs()) * time;
            let speed = y1.abs() + x * y0.abs() + drive;
            let size = y0.abs() + speed * (one / x).min(time);
            rounding = rounding + size + common.constant.abs();
            drift = drift + two * wave.forced.abs() + wave.forced_slope.abs() * (one + x + loss);
        }
        let turning = cosine * at.cosine + sine * at.sine;
        let common = cosine.abs() + sine.abs();
        let unit = S::constant(2.0 * ROUNDINGS * S::RESOLUTION);
        Self {
            second: second - turning,
            third: third - (sine * at.cosine - cosine * at.sine),
            fourth: fourth + common,
            fifth: fifth + common,
            size: rounding + common,
            rounding: (rounding + common) * unit,
            drift: (drift + sum.sine.abs()) * unit,
        }
    }
}

/// Returns three upper bounds for the motion of a mass-controlled mode: on |y| + |y′|, on the fourth derivative and on
/// the fifth derivative. The Fourier series of the mode has odd harmonics n with amplitudes of at most 4/(πn(n² − x²)),
/// and x < 1/2.
fn mass_controlled_bounds<S: Float, D: Decay<S>>(wave: &Wave<S, D>) -> [S; 3] {
    let (y0, y1) = (S::constant(1.79), S::constant(2.1));
    let x = wave.x;
    let (square, loss) = (x * x, (wave.decay.zeta() + wave.decay.zeta()) * x);
    let y2 = S::constant(1.0) + loss * y1 + square * y0;
    let y3 = loss * y2 + square * y1;
    let y4 = loss * y3 + square * y2;
    let y5 = loss * y4 + square * y3;
    let rise = wave.rise.abs();
    [rise * (y0 + y1), rise * y4, rise * y5]
}
