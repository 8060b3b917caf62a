//! From event to event, none missed: each step goes as far as what the third derivative can do keeps
//! the function positive.  The steps shrink onto the zero from the left and are its root finder too.

use super::local::{Local, ROUNDINGS, Series};
use super::step;
use crate::number::scalar::Float;

/// No segment is walked with more steps than this; one that needs more goes on as another segment.
pub const MAX_STEPS: u32 = 4000;
/// What has just failed to leave must pass the level by so many times what rounding can do.
const WEDGED: f64 = 16.0;
/// Behind a graze the walk goes on so many roundings of its instant later at least.
const PAST: f64 = 4.0;

/// A function that a walk follows.
pub(crate) trait Walked<S> {
    /// No walk along it has more steps than this.
    const MOST: u32 = MAX_STEPS;
    /// The function after τ.
    fn local(&self, tau: S) -> Local<S>;
    /// The function shortly after the start, from its value and slope there, which are known better than it gives them.
    fn series(&self, value: S, slope: S) -> Series<S>;
    /// What rounding can do to a value.
    fn noise(&self) -> S;
    /// How far it is asked for.
    fn reach(&self) -> S;
}

/// How a walk ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Walk<S> {
    /// A zero, and whether it is the second function's.
    Zero(S, bool),
    /// None until here.
    Until(S),
    /// The function does not leave zero upwards.
    NoStart,
}

/// Where the function stands at the start.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Start<S> {
    /// Wherever the sum says.
    Anywhere,
    /// On zero, with this slope, exactly.
    Zero(S),
    /// Where it has just failed to leave: it must pass the level by more than rounding.
    Wedged,
}

/// The first zero of a positive sum; `steps` counts on.
pub(crate) fn first_zero<S: Float, F: Walked<S>>(
    sum: &F,
    start: Start<S>,
    steps: &mut u32,
) -> Walk<S> {
    let zero = S::constant(0.0);
    let mut tau = zero;
    let mut local = sum.local(tau);
    let mut series: Option<Series<S>> = None;
    if let Start::Zero(slope) = start {
        let terms = sum.series(zero, slope);
        local = terms.at(zero, local.bound);
        if !(zero < slope || zero < terms.term(2)) {
            return Walk::NoStart;
        }
        series = Some(terms);
    }
    let mut exact = series.is_some();
    for _ in 0..F::MOST {
        *steps = steps.saturating_add(1);
        let noise = if exact { zero } else { sum.noise() };
        let h = match judged(&local, noise, tau, exact) {
            Verdict::Zero(shift) => return Walk::Zero(within(sum, tau + shift), false),
            Verdict::Past(step) => step,
            Verdict::Above => step::safe(
                local.value.max(zero),
                local.slope,
                local.curve,
                local.bound,
                sum.reach() - tau,
            ),
        };
        let next = tau + h;
        if !(tau < next) {
            return Walk::Zero(tau, false);
        }
        tau = next;
        if !(tau < sum.reach()) {
            return Walk::Until(sum.reach());
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
    Walk::Until(tau)
}

/// The first instant from `from` on at which |sum| reaches `level`; the flag says whether it is −level.
/// `steps` counts on.
pub(crate) fn first_reach<S: Float, F: Walked<S>>(
    sum: &F,
    level: S,
    from: S,
    start: Start<S>,
    steps: &mut u32,
) -> Walk<S> {
    let zero = S::constant(0.0);
    let noise = sum.noise() + level * S::constant(ROUNDINGS * S::EPSILON);
    let level = match start {
        Start::Wedged => level + noise * S::constant(WEDGED),
        _ => level,
    };
    let mut tau = from;
    for _ in 0..F::MOST {
        *steps = steps.saturating_add(1);
        let local = sum.local(tau);
        let mut next = sum.reach();
        for negative in [false, true] {
            let gap = gap(&local, level, negative);
            let most = sum.reach() - tau;
            let h = match judged(&gap, noise, tau, false) {
                Verdict::Zero(shift) => return Walk::Zero(within(sum, tau + shift), negative),
                Verdict::Past(step) => step.min(most),
                Verdict::Above => {
                    step::safe(gap.value.max(zero), gap.slope, gap.curve, gap.bound, most)
                }
            };
            if !(tau < tau + h) {
                return Walk::Zero(tau, negative);
            }
            next = next.min(tau + h);
        }
        tau = next;
        if !(tau < sum.reach()) {
            return Walk::Until(sum.reach());
        }
    }
    Walk::Until(tau)
}

/// A function that is flat to rounding meets zero where rounding says, not beyond what is asked for.
fn within<S: Float>(sum: &impl Walked<S>, tau: S) -> S {
    tau.max(S::constant(0.0)).min(sum.reach())
}

/// level ∓ the function.
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

enum Verdict<S> {
    /// Positive.
    Above,
    /// On a zero, so far from here.
    Zero(S),
    /// It touches zero without crossing: this far beyond, it is as far above again.
    Past(S),
}

fn judged<S: Float>(local: &Local<S>, noise: S, tau: S, exact: bool) -> Verdict<S> {
    let zero = S::constant(0.0);
    let Local {
        value,
        slope,
        curve,
        ..
    } = *local;
    if noise < value || !(slope < zero) || (exact && tau.is_zero()) {
        return Verdict::Above;
    }
    if zero < curve {
        let bottom = -(slope / curve);
        let least = value + slope * bottom * S::constant(0.5);
        if -noise < least {
            return Verdict::Past(bottom + bottom + tau * S::constant(PAST * S::EPSILON));
        }
    }
    let mut shift = -(value / slope);
    if !((shift * curve).abs() <= slope.abs()) {
        // The slope is all but zero, and its tangent may lead far beyond: the curve says where the zero is.
        let two = S::constant(2.0);
        let root = (slope * slope - two * value * curve).sqrt();
        shift = two * value / (root - slope);
    }
    Verdict::Zero(if shift.is_finite() { shift } else { zero })
}
