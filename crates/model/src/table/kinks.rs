//! Kinks of β_lim. The velocity constraint is the function of the phase τ whose maximum over the half period
//! determines β_lim. β_lim has a kink where this maximum jumps to another τ.

use super::exact::Exact;

/// Step of the search for kinks of β_lim, in units of √λ/r: the natural frequency of the fastest mode divided by the
/// excitation frequency.
const STEP: f64 = 0.005;
/// Phase difference in τ, in rad, above which two maxima of the velocity constraint count as different maxima.
const JUMP: f64 = 0.1;
/// Smallest number of steps in the search for kinks of β_lim in the range of r.
const FEWEST: usize = 64;
/// Largest number of steps in the search for kinks of β_lim in the range of r.
const MOST: usize = 20_000;

/// Returns the frequency ratios within a range at which β_lim has a kink, in ascending order. Bisection finds each
/// frequency ratio to the last digit of its `f64`.
pub(super) fn kinks(exact: &mut Exact<'_>, (low, high): (f64, f64)) -> Vec<f64> {
    let fastest = exact
        .modal
        .resonances
        .iter()
        .fold(0.0, |most: f64, r| most.max(r.to_f64()));
    let (first, last) = (1.0 / high, 1.0 / low);
    let steps = ((fastest * (last - first) / STEP).ceil() as usize).clamp(FEWEST, MOST);
    let mut kinks = Vec::new();
    let mut before = low;
    for step in 1..=steps {
        let share = step as f64 / steps as f64;
        let r = if step < steps {
            1.0 / (last + (first - last) * share)
        } else {
            high
        };
        between(exact, before, r, &mut kinks);
        before = r;
    }
    kinks
}

/// Returns true if `a` and `b` are the instants τ of two different maxima of the velocity constraint, not of one
/// maximum that has shifted.
fn differ(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() > JUMP,
        (None, None) => false,
        _ => true,
    }
}

/// Finds the kink of β_lim between two frequency ratios by bisection, and appends it to `kinks`. Does nothing if there
/// is no kink.
pub(super) fn between(exact: &mut Exact<'_>, mut low: f64, mut high: f64, kinks: &mut Vec<f64>) {
    loop {
        let (Some(at_low), Some(at_high)) = (exact.at(low), exact.at(high)) else {
            return;
        };
        if !differ(at_low.tau, at_high.tau) {
            return;
        }
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            kinks.push(high);
            return;
        }
        let Some(at_middle) = exact.at(middle) else {
            return;
        };
        let distance = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs(),
            (None, None) => 0.0,
            _ => f64::INFINITY,
        };
        if distance(at_middle.tau, at_low.tau) < distance(at_middle.tau, at_high.tau) {
            low = middle;
        } else {
            high = middle;
        }
    }
}
