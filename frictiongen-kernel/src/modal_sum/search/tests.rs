//! Steps, summits and whole searches against dense scans of sums written down anew.

use super::walk::safe_step;
use super::*;
use crate::modal_sum::wave::Wave;
use crate::oscillator::decay::Damped;
use crate::oscillator::decay::Instant;
use crate::testing::{Lcg, TestWave, random_constraint, random_motion, rest, sum_derivative};
use core::f64::consts::{FRAC_PI_2, PI};

mod grids;
mod ties;
mod whole;

type TestSearch<'a> = Search<'a, f64, Damped<f64>>;
type TestSum<'a> = Sum<'a, f64, Damped<f64>>;

/// A question without a tolerance: over the half period, or over half of it for a sum that is odd about it.
pub fn asked(weight: Weight, both_signs: bool, start: f64) -> Problem<f64> {
    let odd = weight == Weight::Sine && both_signs;
    Problem {
        weight,
        both_signs,
        end: if odd { FRAC_PI_2 } else { PI },
        floor: 0.0,
        start,
        tolerance: 0.0,
    }
}

/// A search that has found this much.
pub fn search<'a>(sum: TestSum<'a>, question: Problem<f64>, known: f64) -> TestSearch<'a> {
    let mut search = Search::new(sum, question);
    search.peak.value = known;
    search
}

/// The largest value by a walk alone, after a climb from a place.
pub fn walked_from(sum: TestSum<'_>, question: Problem<f64>, guess: f64) -> Peak<f64> {
    let mut search = search(sum, question, question.floor);
    let (local, _) = search.local(guess);
    search.climb(guess, local, local.value < 0.0);
    search.by_walk();
    search.peak
}

/// ±sum − level·weight at any time, by other formulas.
pub fn excess(search: &TestSearch<'_>, negative: bool, tau: f64) -> f64 {
    let value = sum_derivative(&search.sum, tau, 0);
    let value = if negative { -value } else { value };
    match search.question.weight {
        Weight::One => value - search.peak.value,
        Weight::Sine => value - search.signed(search.peak.value, negative) * tau.sin(),
    }
}

/// How large the sum's terms are, of which the angle of a fast wave leaves some twelve digits.
pub fn size(search: &TestSearch<'_>) -> f64 {
    let wave = |w: &TestWave| {
        w.free.abs() / w.x + w.swing.abs() + w.swing_slope.abs() + w.rise.abs() / (w.x * w.x)
    };
    search.peak.value.abs()
        + search.question.start
        + search.sum.cosine.abs()
        + search.sum.sine.abs()
        + search.sum.waves.iter().map(wave).sum::<f64>()
}

/// Where the excess is first above rounding, in steps of a hundredth of `step`, as a share of it.
fn crossing(search: &TestSearch<'_>, negative: bool, tau: f64, step: f64, shares: u32) -> f64 {
    let bar = 1e-11 * size(search);
    (1..=100 * shares)
        .map(|k| f64::from(k) / 100.0)
        .take_while(|share| tau + share * step <= search.question.end)
        .find(|share| excess(search, negative, tau + share * step) > bar)
        .unwrap_or(f64::INFINITY)
}

/// A sum to search, and its question: the constraint's quotient or a mass's motion.
struct Drawn {
    waves: Vec<TestWave>,
    cosine: f64,
    sine: f64,
    question: Problem<f64>,
}

impl Drawn {
    fn new(random: &mut Lcg, range: (f64, f64), undamped: bool, over_sine: bool) -> Self {
        if over_sine {
            let (waves, sine, start) = random_constraint(random, range, undamped, 16);
            let question = asked(Weight::Sine, undamped, start);
            return Self {
                waves,
                cosine: 0.0,
                sine,
                question,
            };
        }
        let (waves, cosine, sine) = random_motion(random, range, undamped, 16);
        let question = asked(Weight::One, true, 0.0);
        Self {
            waves,
            cosine,
            sine,
            question,
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

/// What a walk's safe step is made of: of the whole sum, and of the sum with its tail reduced.
#[test]
fn nothing_is_above_the_level_within_a_safe_step() {
    let mut random = Lcg(41);
    let (mut compared, mut slower) = (0, 0);
    let (mut nearest, mut nearest_falling) = (f64::INFINITY, f64::INFINITY);
    for case in 0..6000 {
        let sine = case % 2 == 0;
        let undamped = case % 3 == 0;
        let drawn = Drawn::new(&mut random, (0.05, 100.0), undamped, sine);
        let (sum, question) = (drawn.sum(), drawn.question);
        let negative = question.both_signs && case % 4 < 2;
        let tau = question.end * (0.02 + 0.97 * random.unit());
        // The level is where the sum is, or somewhat above.
        let mut search = search(sum, question, 0.0);
        let gap = if case % 5 < 2 {
            0.0
        } else {
            random.log_uniform(1e-9, 1.0)
        };
        let weight = if sine { tau.sin() } else { 1.0 };
        search.peak.value = excess(&search, negative, tau) / weight + gap;
        if !(search.peak.value > 0.0) {
            search.peak.value = gap;
        }
        search.choose_tail();
        let (local, slow) = search.local(tau);
        let local = search.excess(&local, negative, search.level());
        let step = safe_step(&local);
        let without_third = safe_step(&Local {
            third_bound: 0.0,
            ..local
        });
        let near = crossing(&search, negative, tau, step, 3);
        assert!(
            near > 1.0,
            "case {case}, τ {tau}: above the level at {near} of {step}"
        );
        nearest = nearest.min(near);
        if without_third < step {
            nearest_falling = nearest_falling.min(near);
        }
        compared += 1;
        if let (Some(slow), Some(tail)) = (slow, search.tail) {
            let mut slow = search.excess(&slow, negative, search.level());
            slow.value += tail.amplitude;
            if slow.value < 0.0 {
                slower += 1;
                let step = safe_step(&slow);
                let near = crossing(&search, negative, tau, step, 1);
                assert!(
                    near > 1.0,
                    "case {case}, τ {tau}: above the level at {near} of {step}, by the tail"
                );
            }
        }
    }
    println!(
        "{compared} steps, {slower} by a tail; the nearest crossing at {nearest}, of a falling sum at {nearest_falling}"
    );
    assert_eq!(compared, 6000);
    assert!(slower > 50 && nearest < 1.05);
}

/// Just behind an inflection where the third derivative is all its bound allows, the sum falls by little and
/// rises again: slope 0, curvature −c, third derivative b.  It falls for 2c/b and is back after 3c/b.
fn inflection(x: f64, past: f64) -> ([TestWave; 1], f64, f64) {
    let tau = (PI - past) / x;
    let waves = [Wave {
        free: 1.0,
        ..rest(x, 0.0)
    }];
    // p′ = −cos(past), which a sinusoid of the excitation balances.
    (waves, past.cos() / tau.cos(), tau)
}

#[test]
fn a_falling_sum_is_left_before_it_rises_again() {
    let mut compared = 0;
    for x in [20.0, 100.0, 1000.0] {
        for past in [1e-3, 1e-2, 0.1] {
            let (waves, sine, tau) = inflection(x, past);
            let sum = Sum {
                waves: &waves,
                cosine: 0.0,
                sine,
            };
            let mut search = search(sum, asked(Weight::One, false, 0.0), 0.0);
            let (local, _) = search.local(tau);
            search.peak.value = local.value;
            let mut local = search.excess(&local, false, search.level());
            // Rounding of the balance would decide which way it starts.
            local.slope = 0.0;
            let step = safe_step(&local);
            // What is sought is of the order of c³/b².
            let above =
                |share: f64| excess(&search, false, tau + share * step) > 1e-3 * past.powi(3) / x;
            let first = (1..400)
                .map(|k| f64::from(k) / 100.0)
                .find(|share| above(*share))
                .unwrap();
            println!("x {x}, past {past}: crossing at {first} of the step");
            assert!(first > 1.0 && first < 1.8, "x {x}, past {past}: {first}");
            compared += 1;
        }
    }
    assert_eq!(compared, 9);
}

/// The same place as a summit ahead: the sum is concave as far as half of what the third derivative allows.
#[test]
fn a_settled_summit_is_left_before_the_sum_rises_again() {
    let mut settled = 0;
    for x in [20.0, 100.0, 1000.0] {
        for past in [1e-3, 1e-2, 0.1] {
            let (waves, sine, top) = inflection(x, past);
            let sum = Sum {
                waves: &waves,
                cosine: 0.0,
                sine,
            };
            let mut search = search(sum, asked(Weight::One, false, 0.0), 0.0);
            // The summit's own value, and a thousandth of what the sum falls behind it.
            let low = 1e-3 * past.powi(3) / x;
            search.peak.value = sum_derivative(&sum, top, 0) + low;
            let tau = top - 0.1 * past / x;
            let (local, _) = search.local(tau);
            let local = search.excess(&local, false, search.level());
            let summit = -local.slope / local.curvature;
            let step = safe_step(&local);
            let next = search.over_summit(tau, summit, step, (false, local.third_bound), &[false]);
            assert!(
                search.peak.places[0].is_none(),
                "x {x}, past {past}: climbed"
            );
            let reach = next - top;
            let first = (1..1000)
                .map(|k| f64::from(k) / 100.0)
                .find(|share| excess(&search, false, top + share * reach) > low)
                .unwrap();
            println!("x {x}, past {past}: crossing at {first} of what is settled");
            assert!(first > 1.0, "x {x}, past {past}: {first}");
            // Six times the radius, of which the approach to the summit takes a little.
            settled += u32::from(first < 8.0);
        }
    }
    assert_eq!(settled, 9);
}

/// From a random place before a summit, with the level at about its height.
#[test]
fn nothing_is_above_the_level_over_a_summit() {
    let mut random = Lcg(43);
    let (mut compared, mut elsewhere, mut climbed, mut settled) = (0, 0, 0, 0);
    for case in 0..20_000 {
        let sine = case % 2 == 0;
        let undamped = case % 3 == 0;
        let drawn = Drawn::new(&mut random, (0.5, 40.0), undamped, sine);
        let (sum, question) = (drawn.sum(), drawn.question);
        let tau = question.end * (0.05 + 0.9 * random.unit());
        let mut search = search(sum, question, 0.0);
        let (local, _) = search.local(tau);
        let at_zero = search.excess(&local, false, 0.0);
        let summit = -at_zero.slope / at_zero.curvature;
        if !(0.0 < at_zero.slope && at_zero.curvature < 0.0) || tau + summit > question.end {
            elsewhere += 1;
            continue;
        }
        let weight = |tau: f64| if sine { tau.sin() } else { 1.0 };
        let top = excess(&search, false, tau + summit) / weight(tau + summit);
        search.peak.value =
            (top.max(0.0) + random.log_uniform(1e-9, 0.3)).max(at_zero.value / weight(tau));
        let level = search.excess(&local, false, search.level());
        let (summit, step) = (-level.slope / level.curvature, safe_step(&level));
        if !(0.0 < level.slope && level.curvature < 0.0 && step < summit + summit) {
            elsewhere += 1;
            continue;
        }
        let signs: &[bool] = if question.both_signs {
            &[false, true]
        } else {
            &[false]
        };
        let opposite = signs.len() == 2 && search.excess(&local, true, search.level()).value > 0.0;
        if opposite {
            elsewhere += 1;
            continue;
        }
        let step = signs.iter().fold(step, |step, &negative| {
            step.min(safe_step(&search.excess(&local, negative, search.level())))
        });
        let next = search.over_summit(tau, summit, step, (false, level.third_bound), signs);
        if next == tau {
            climbed += 1;
            continue;
        }
        compared += 1;
        settled += u32::from(next > tau + 1.001 * step.max(tau * f64::EPSILON));
        for &negative in signs {
            let near = crossing(&search, negative, tau, next - tau, 1);
            assert!(
                near > 1.0,
                "case {case}, τ {tau}, negative {negative}: above at {near}"
            );
        }
    }
    println!(
        "{compared} summits, {settled} settled, {climbed} climbed, {elsewhere} places before none"
    );
    assert_eq!(compared + climbed + elsewhere, 20_000);
    assert!(compared > 1500 && settled > 50);
}
