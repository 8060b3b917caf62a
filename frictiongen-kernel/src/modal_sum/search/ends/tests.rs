//! Where the walk of a quotient begins and ends: nothing above the level is left outside.

use super::*;
use crate::modal_sum::search::tests::{asked, excess, search, size};
use crate::modal_sum::wave::{Sum, Wave};
use crate::testing::{Lcg, TestWave, random_constraint, random_waves, rest, sum_derivative};
use core::f64::consts::PI;

/// Whether the excess is above rounding anywhere in a stretch, and where first.
fn above(
    search: &Search<'_, f64, crate::oscillator::decay::Damped<f64>>,
    negative: bool,
    (from, to): (f64, f64),
    points: u32,
) -> Option<f64> {
    let bar = 64.0 * f64::EPSILON * size(search);
    (1..points)
        .map(|k| from + (to - from) * f64::from(k) / f64::from(points))
        .find(|tau| excess(search, negative, *tau) > bar)
}

/// The derivatives by which a start is judged, and the fourth's bound at any later time.
#[test]
fn derivatives_at_the_start() {
    let mut random = Lcg(3);
    let mut most = 0.0_f64;
    for case in 0..600 {
        let waves = random_waves(&mut random, (1e-2, 300.0), case % 3 == 0, false);
        let sum = Sum {
            waves: &waves,
            cosine: 0.0,
            sine: random.signed(),
        };
        let search = search(
            sum,
            asked(Weight::Sine, case % 3 == 0, random.unit()),
            random.unit(),
        );
        let negative = case % 2 == 0;
        let (third, fourth, unit) = search.third_at_start(negative);
        let sign = if negative { -1.0 } else { 1.0 };
        let level = search.signed(search.level(), negative);
        let want = (sign * sum_derivative(&sum, 0.0, 3) + level) * unit;
        let size: f64 = waves
            .iter()
            .map(|w| (w.swing.abs() + w.swing_slope.abs()) * (1.0 + w.rate().powi(3)))
            .sum();
        assert!(
            (third - want).abs() <= 1e-12 * (size + level) * unit,
            "case {case}: {third} {want}"
        );
        for k in 0..=200 {
            let tau = if k <= 100 {
                0.1 * f64::from(k) * unit
            } else {
                PI * f64::from(k - 100) / 100.0
            };
            let there = sign * sum_derivative(&sum, tau.min(PI), 4) - level * tau.sin();
            let share = there.abs() * unit * unit / fourth;
            assert!(share <= 1.0 + 1e-9, "case {case}, τ {tau}: {share}");
            most = most.max(share);
        }
    }
    println!("600 sums; largest share of the fourth derivative's bound {most}");
    assert!(most > 0.9);
}

/// Random sums: nothing above the level before the start or behind the end, by either way.
#[test]
fn nothing_is_above_the_level_outside_the_walk() {
    let mut random = Lcg(17);
    let (mut starts, mut ends, mut whole, mut zeros) = (0, 0, 0, 0);
    let mut nearest = [f64::INFINITY; 3];
    for case in 0..1500 {
        let undamped = case % 3 == 0;
        let (waves, sine, start) = random_constraint(&mut random, (0.1, 100.0), undamped, 6);
        let sum = Sum {
            waves: &waves,
            cosine: 0.0,
            sine,
        };
        let floor = random.log_uniform(1e-3, 3.0);
        let mut search = search(sum, asked(Weight::Sine, undamped, start), floor);
        let signs: &[bool] = if undamped { &[false, true] } else { &[false] };
        let begin = search.start(signs);
        zeros += u32::from(begin == 0.0);
        let found = signs
            .iter()
            .filter_map(|negative| above(&search, *negative, (0.0, begin), 400))
            .next();
        assert_eq!(found, None, "case {case}: the walk starts at {begin}");
        let beyond = signs
            .iter()
            .filter_map(|negative| above(&search, *negative, (0.0, 4.0 * begin), 1600))
            .fold(f64::INFINITY, f64::min);
        if begin > 0.0 {
            nearest[0] = nearest[0].min(beyond / begin);
        }
        starts += 1;
        if undamped {
            continue;
        }
        // At the end the climb from the start, if there was one, has raised the level.
        for (index, end) in [search.last(signs), search.last_by_series(signs)]
            .into_iter()
            .enumerate()
        {
            if end == PI {
                whole += 1;
                continue;
            }
            let found = above(&search, false, (end, PI), 400);
            assert_eq!(
                found, None,
                "case {case}: the walk ends at {end}, way {index}"
            );
            let stretch = PI - end;
            let before = above(&search, false, (PI, (PI - 4.0 * stretch).max(0.0)), 1600)
                .map_or(f64::INFINITY, |tau| (PI - tau) / stretch);
            nearest[1 + index] = nearest[1 + index].min(before);
            ends += 1;
        }
    }
    println!(
        "{starts} starts, {zeros} at 0 itself, {ends} ends, {whole} at π itself; the nearest crossings at {nearest:?} of a stretch"
    );
    assert_eq!(starts, 1500);
    assert_eq!(ends + whole, 2000);
    assert!(zeros < 200 && ends > 1000 && nearest[1] < 1.5 && nearest[2] < 2.0);
}

/// A sum that leaves the level as soon as its derivatives at 0 allow: the third falls, and the fourth is all
/// its bound allows.  A start a fifth later would be too late.
#[test]
fn a_start_is_safe_where_the_derivatives_reach_their_bounds() {
    let mut compared = 0;
    for x in [30.0, 100.0, 1000.0] {
        for fall in [0.01, 0.1, 0.3] {
            // (cos τ − cos xτ) − s(cos τ − cos yτ) without a curvature, of which the fourth derivative is all
            // but −x⁴; and of sin τ − p what gives the third.
            let y = 2.0;
            let s = (x * x - 1.0) / (y * y - 1.0);
            let wave = |x: f64| rest(x, 0.0);
            let waves: [TestWave; 2] = [
                Wave {
                    swing_slope: s,
                    ..wave(y)
                },
                Wave {
                    swing_slope: -1.0,
                    swing: -fall * x,
                    ..wave(x)
                },
            ];
            let sum = Sum {
                waves: &waves,
                cosine: 0.0,
                sine: 0.0,
            };
            let mut search = search(sum, asked(Weight::Sine, true, 0.0), 0.0);
            let begin = search.start(&[false]);
            assert!(search.peak.places[0].is_none());
            assert_eq!(
                above(&search, false, (0.0, begin), 2000),
                None,
                "x {x}, {fall}"
            );
            let crossing = above(&search, false, (0.0, 3.0 * begin), 6000).unwrap() / begin;
            println!("x {x}, fall {fall}: crossing at {crossing} of the start");
            assert!(crossing < 1.4, "x {x}, {fall}: {crossing}");
            compared += 1;
        }
    }
    assert_eq!(compared, 9);
}
