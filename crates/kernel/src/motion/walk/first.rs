//! Searches for the first zero of a function in steps that skip no zero. This search is called a *walk*. A bound on the
//! third derivative limits each step to a length over which the function is certainly positive. Close to the zero the
//! steps become shorter, and the walk converges to the zero.

use super::step;
use crate::motion::series::{Local, LocalSeries, ROUNDINGS, Walked};
use crate::number::scalar::Float;

/// Factor on the rounding error of a force, for a contact that has just failed to start sliding. This contact breaks
/// away only if its force exceeds the break-away level by more than the factor times the rounding error.
const WEDGED: f64 = 16.0;
/// Smallest distance, in rounding units, at which a search continues after a point where the function touches zero
/// without a change of sign.
const PAST: f64 = 4.0;

/// Result of a *walk*, a search for a zero in steps that skip no zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WalkResult<S> {
    /// The function has a zero at this instant. The flag is true if the function reaches −level, and false if it
    /// reaches +level.
    Zero(S, bool),
    /// The function has no zero up to the given instant.
    Until(S),
    /// The function starts at zero and does not become positive.
    NoStart,
}

/// Value of the function at the start of a walk (search for a zero).
#[derive(Clone, Copy, Debug)]
pub(crate) enum WalkStart<S> {
    /// The value is unknown. The walk evaluates the function at its start.
    Anywhere,
    /// The function is exactly zero at the present instant. The field is the slope of the function at this instant.
    Zero(S),
    /// The contact has just failed to start sliding. The force must now exceed its level by more than its rounding
    /// error.
    Wedged,
}

/// Finds the first zero of a function that is positive at the start. Adds the number of steps to `steps`.
pub(crate) fn first_zero<S: Float, F: Walked<S>>(
    sum: &F,
    start: WalkStart<S>,
    steps: &mut u32,
) -> WalkResult<S> {
    let zero = S::constant(0.0);
    let mut tau = zero;
    let mut local = sum.local(tau);
    let mut series: Option<LocalSeries<S>> = None;
    if let WalkStart::Zero(slope) = start {
        let terms = sum.series(zero, slope);
        local = terms.at(zero, local.bound);
        if !(zero < slope || zero < terms.term(2)) {
            return WalkResult::NoStart;
        }
        series = Some(terms);
    }
    let mut exact = series.is_some();
    for _ in 0..sum.most() {
        *steps = steps.saturating_add(1);
        let noise = if exact { zero } else { sum.noise() };
        let h = match verdict(&local, noise, tau, exact) {
            RootVerdict::Zero(shift) => return WalkResult::Zero(within(sum, tau + shift), false),
            RootVerdict::Past(step) => step,
            RootVerdict::Above => step::safe(
                local.value.max(zero),
                local.slope,
                local.curve,
                local.bound,
                sum.reach() - tau,
            ),
        };
        let next = tau + h;
        if !(tau < next) {
            return WalkResult::Zero(tau, false);
        }
        tau = next;
        if !(tau < sum.reach()) {
            return WalkResult::Until(sum.reach());
        }
        match &series {
            Some(series) if tau <= series.reach => {
                exact = true;
                local = series.at(tau, local.bound);
            }
            _ => {
                exact = false;
                local = sum.local(tau);
            }
        }
    }
    WalkResult::Until(tau)
}

/// Finds the first instant at or after `from` at which |`sum`| reaches `level`. The flag in the result is true if the
/// sum reaches −`level`. Adds the number of steps to `steps`.
pub(crate) fn first_reach<S: Float, F: Walked<S>>(
    sum: &F,
    level: S,
    from: S,
    start: WalkStart<S>,
    steps: &mut u32,
) -> WalkResult<S> {
    let zero = S::constant(0.0);
    let noise = sum.noise() + level * S::constant(ROUNDINGS * S::EPSILON);
    let level = match start {
        WalkStart::Wedged => level + noise * S::constant(WEDGED),
        _ => level,
    };
    let mut tau = from;
    for _ in 0..sum.most() {
        *steps = steps.saturating_add(1);
        let local = sum.local(tau);
        let mut next = sum.reach();
        for negative in [false, true] {
            let gap = gap(&local, level, negative);
            let most = sum.reach() - tau;
            let h = match verdict(&gap, noise, tau, false) {
                RootVerdict::Zero(shift) => {
                    return WalkResult::Zero(within(sum, tau + shift), negative);
                }
                RootVerdict::Past(step) => step.min(most),
                RootVerdict::Above => {
                    step::safe(gap.value.max(zero), gap.slope, gap.curve, gap.bound, most)
                }
            };
            if !(tau < tau + h) {
                return WalkResult::Zero(tau, negative);
            }
            next = next.min(tau + h);
        }
        tau = next;
        if !(tau < sum.reach()) {
            return WalkResult::Until(sum.reach());
        }
    }
    WalkResult::Until(tau)
}

/// Clamps an instant to the searched interval. For a flat function, rounding may place the zero after the end of the
/// interval.
fn within<S: Float>(sum: &impl Walked<S>, tau: S) -> S {
    tau.max(S::constant(0.0)).min(sum.reach())
}

/// Returns the function level − f, where `local` contains the value and the derivatives of f. If `negative` is true,
/// returns level + f instead.
fn gap<S: Float>(local: &Local<S>, level: S, negative: bool) -> Local<S> {
    if negative {
        Local {
            value: level + local.value,
            ..*local
        }
    } else {
        Local {
            value: level - local.value,
            slope: -local.slope,
            curve: -local.curve,
            bound: local.bound,
        }
    }
}

enum RootVerdict<S> {
    /// The function is positive at the present instant.
    Above,
    /// The function has a zero at this distance from the present instant.
    Zero(S),
    /// The function touches zero without crossing it. At this distance the function has its present value a second
    /// time.
    Past(S),
}

fn verdict<S: Float>(local: &Local<S>, noise: S, tau: S, exact: bool) -> RootVerdict<S> {
    let zero = S::constant(0.0);
    let Local {
        value,
        slope,
        curve,
        ..
    } = *local;
    if noise < value || !(slope < zero) || (exact && tau.is_zero()) {
        return RootVerdict::Above;
    }
    if zero < curve {
        let bottom = -(slope / curve);
        let least = value + slope * bottom * S::constant(0.5);
        if -noise < least {
            return RootVerdict::Past(bottom + bottom + tau * S::constant(PAST * S::EPSILON));
        }
    }
    let mut shift = -(value / slope);
    if !((shift * curve).abs() <= slope.abs()) {
        // The slope is almost zero, and the zero of the tangent may be far too late. The code therefore takes the zero
        // of the parabola with the same value, slope and curvature.
        let two = S::constant(2.0);
        let root = (slope * slope - two * value * curve).sqrt();
        shift = two * value / (root - slope);
    }
    RootVerdict::Zero(if shift.is_finite() { shift } else { zero })
}
