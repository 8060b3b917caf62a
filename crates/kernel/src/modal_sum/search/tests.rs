//! Tests grids, summits and whole searches. A *summit* is a position from which one Newton step leads to a local
//! maximum. The tests compare each result with values of the sum at many instants. The formulas of these values are
//! independent of the search.

use super::*;
use crate::modal_sum::wave::Wave;
use crate::oscillator::decay::Damped;
use crate::oscillator::decay::Instant;
use crate::testing::{Lcg, TestWave, at_rest, random_constraint, random_motion, sum_derivative};
use core::f64::consts::{FRAC_PI_2, PI};

mod grids;
mod ties;
mod whole;

type TestSearch<'a> = MaximumSearch<'a, f64, Damped<f64>>;
type TestSum<'a> = Sum<'a, f64, Damped<f64>>;

/// Returns a search problem for the half period, with tolerance 0. For a sum that is odd about π/2, the search covers
/// only the first half of the half period.
pub fn asked(weight: Weight, both_signs: bool, start: f64) -> SearchSettings<f64> {
    let odd = weight == Weight::Sine && both_signs;
    SearchSettings {
        weight,
        both_signs,
        end: if odd { FRAC_PI_2 } else { PI },
        floor: 0.0,
        start,
        tolerance: 0.0,
    }
}

/// Returns a search that has already found the largest value `known`.
pub fn search<'a>(sum: TestSum<'a>, problem: SearchSettings<f64>, known: f64) -> TestSearch<'a> {
    let mut search = MaximumSearch::new(sum, problem);
    search.peak.value = known;
    search
}

/// Returns the excess ±sum − level·weight at a phase τ, where the weight is 1 or sin τ. The formula of the sum is
/// independent of the search.
pub fn excess(search: &TestSearch<'_>, negative: bool, tau: f64) -> f64 {
    let value = sum_derivative(&search.sum, tau, 0);
    let value = if negative { -value } else { value };
    match search.problem.weight {
        Weight::One => value - search.peak.value,
        Weight::Sine => value - search.signed(search.peak.value, negative) * tau.sin(),
    }
}

/// Returns the sum of the sizes of the modal terms. A term is accurate to about twelve digits of this sum, because the
/// phase of a fast mode is rounded.
pub fn size(search: &TestSearch<'_>) -> f64 {
    let wave = |w: &TestWave| {
        w.free.abs() / w.x + w.forced.abs() + w.forced_slope.abs() + w.rise.abs() / (w.x * w.x)
    };
    search.peak.value.abs()
        + search.problem.start
        + search.sum.cosine.abs()
        + search.sum.sine.abs()
        + search.sum.waves.iter().map(wave).sum::<f64>()
}

/// A random modal sum and its search problem, for the velocity constraint or for the motion of a mass.
struct Drawn {
    waves: Vec<TestWave>,
    cosine: f64,
    sine: f64,
    problem: SearchSettings<f64>,
}

impl Drawn {
    fn new(random: &mut Lcg, range: (f64, f64), undamped: bool, over_sine: bool) -> Self {
        if over_sine {
            let (waves, sine, start) = random_constraint(random, range, undamped, 16);
            let problem = asked(Weight::Sine, undamped, start);
            return Self {
                waves,
                cosine: 0.0,
                sine,
                problem,
            };
        }
        let (waves, cosine, sine) = random_motion(random, range, undamped, 16);
        let problem = asked(Weight::One, true, 0.0);
        Self {
            waves,
            cosine,
            sine,
            problem,
        }
    }

    fn sum(&self) -> TestSum<'_> {
        let Self {
            waves,
            cosine,
            sine,
            ..
        } = self;
        Sum {
            waves,
            cosine: *cosine,
            sine: *sine,
        }
    }
}
