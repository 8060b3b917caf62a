//! Computes F(τ) = Σ κc[(1 + g)p + (u/x²)(cos τ − p′)], the sum of the velocity constraint over the modes, and its
//! derivatives in τ. p is the free displacement of a mode after a unit velocity. `ModeStage` explains the factors
//! κc(1 + g) and κcu/x². The code gives τ in half-turns t, with τ = πt.

use crate::series::IntervalSeries;
use crate::stage::{ChainStage, ModeDecay, ModeStage};
use frictiongen_model::interval::Interval;

/// Returns the free displacement p of a mode after a unit velocity, and its slope p′, at an instant.
fn free<const N: usize>(
    mode: &ModeStage<N>,
    t: &IntervalSeries<N>,
) -> (IntervalSeries<N>, IntervalSeries<N>) {
    let own = &mode.oscillator;
    let turns = mode.x * *t;
    match own.kind {
        ModeDecay::Undamped => {
            let (s, c) = turns.sine_cosine();
            (s * mode.slow, c)
        }
        ModeDecay::Under => {
            let decay_factor = turns.times(-(Interval::pi() * own.zeta)).exp();
            let (s, c) = turns.times(own.q).sine_cosine();
            let (s, c) = (decay_factor * s, decay_factor * c);
            let p = (s * mode.slow).times(Interval::ONE / own.q);
            (p, c - s.times(own.zeta_over_q))
        }
        ModeDecay::Critical => {
            let decay_factor = turns.times(-Interval::pi()).exp();
            let p = (decay_factor * *t).times(Interval::pi());
            (p, decay_factor - p * mode.x)
        }
        ModeDecay::Over => {
            let rates = [Interval::ONE / own.fast, own.fast];
            let [slow, fast] = rates.map(|rate| turns.times(-(Interval::pi() * rate)).exp());
            let half = Interval::ONE / (own.q + own.q);
            let p = ((slow - fast) * mode.slow).times(half);
            let [slow_rate, fast_rate] = rates;
            let slope = (fast.times(fast_rate) - slow.times(slow_rate)).times(half);
            (p, slope)
        }
    }
}

/// Returns, for each mode at an instant, its free displacement p after a unit velocity, and the slope p′.
pub(crate) fn motions<const N: usize>(
    stage: &ChainStage<N>,
    t: &IntervalSeries<N>,
) -> Vec<(IntervalSeries<N>, IntervalSeries<N>)> {
    stage.modes.iter().map(|mode| free(mode, t)).collect()
}

/// Returns F, the sum of the velocity constraint over the modes, at an instant. The instant may depend on r.
pub(crate) fn value<const N: usize>(
    stage: &ChainStage<N>,
    motions: &[(IntervalSeries<N>, IntervalSeries<N>)],
    cosine: &IntervalSeries<N>,
) -> IntervalSeries<N> {
    let mut sum = IntervalSeries::fixed(Interval::ZERO);
    for (mode, (p, slope)) in stage.modes.iter().zip(motions) {
        sum = sum + mode.free * *p + mode.forced_slope * (*cosine - *slope);
    }
    sum
}

/// Returns F′, the slope in τ of the sum of the velocity constraint over the modes, at an instant. The instant may
/// depend on r.
pub(crate) fn slope<const N: usize>(
    stage: &ChainStage<N>,
    motions: &[(IntervalSeries<N>, IntervalSeries<N>)],
    sine: &IntervalSeries<N>,
) -> IntervalSeries<N> {
    let mut sum = IntervalSeries::fixed(Interval::ZERO);
    for (mode, (p, slope)) in stage.modes.iter().zip(motions) {
        // The free displacement p of a mode satisfies −p″ = x(2ζp′ + xp), with x = √λ/r.
        let two_zeta = mode.oscillator.zeta.doubled();
        let bent = mode.x * (slope.times(two_zeta) + mode.x * *p);
        sum = sum + mode.free * *slope + mode.forced_slope * (bent - *sine);
    }
    sum
}

/// Returns F′, F″ and F‴ over an interval of r and an interval of τ. F is the sum of the velocity constraint over the
/// modes.
pub(crate) fn derivatives<const N: usize>(
    stage: &ChainStage<N>,
    motions: &[(IntervalSeries<N>, IntervalSeries<N>)],
    (sine, cosine): (Interval, Interval),
) -> [Interval; 3] {
    let mut sums = [Interval::ZERO; 3];
    for (mode, (p, slope)) in stage.modes.iter().zip(motions) {
        let x = mode.x.value();
        let square = x.squared();
        let (p, p1) = (p.value(), slope.value());
        let (p2, p3, p4);
        if mode.oscillator.kind == ModeDecay::Undamped {
            (p2, p3) = (-(square * p), -(square * p1));
            p4 = -(square * p2);
        } else {
            let loss = x * mode.oscillator.zeta.doubled();
            p2 = -(loss * p1 + square * p);
            p3 = -(loss * p2 + square * p1);
            p4 = -(loss * p3 + square * p2);
        }
        let (a, b) = (mode.free.value(), mode.forced_slope.value());
        let [first, second, third] = &mut sums;
        *first = *first + a * p1 + b * (-sine - p2);
        *second = *second + a * p2 + b * (-cosine - p3);
        *third = *third + a * p3 + b * (sine - p4);
    }
    sums
}

/// Returns the second derivative F″ at τ = 0, where F is the sum of the velocity constraint over the modes. At τ = 0
/// the free displacement p of a mode has p′ = 1, p″ = −2ζx and p‴ = x²(4ζ² − 1).
pub(crate) fn bend_at_start<const N: usize>(stage: &ChainStage<N>) -> IntervalSeries<N> {
    let one = IntervalSeries::fixed(Interval::ONE);
    let zero = IntervalSeries::fixed(Interval::ZERO);
    stage.modes.iter().fold(zero, |sum, mode| {
        let two_zeta = mode.oscillator.zeta.doubled();
        let curve = mode.x.times(two_zeta);
        let third = mode.x.squared() - curve.squared();
        sum - mode.free * curve + mode.forced_slope * (third - one)
    })
}
