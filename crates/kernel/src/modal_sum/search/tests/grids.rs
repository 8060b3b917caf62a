//! Tests of grids. The tests compare the values at nodes, the bounds on derivatives and the closed cells with the modal
//! sum.

use super::whole::scanned;
use super::*;
use crate::modal_sum::search::Maximiser;
use crate::modal_sum::search::bounds::DerivativeBounds;
use crate::modal_sum::search::grid::{Grid, Stretch};
use crate::testing::{ZETAS, derivative, parts};

fn filled(sum: &TestSum<'_>, stretch: &Stretch<f64>, bounds: &DerivativeBounds<f64>) -> Grid<f64> {
    let mut grid = Grid::blank(stretch, bounds);
    grid.fill(sum);
    grid
}

fn grid_of(sum: &TestSum<'_>, from: f64, to: f64, width: f64) -> Grid<f64> {
    let at = Instant::new(from / PI);
    let bounds = DerivativeBounds::of(sum, &at, to - from);
    filled(sum, &Stretch::new(from, to, width, false), &bounds)
}

/// Compares the values and slopes at every node of a grid with the sum. The difference must not exceed the bound on the
/// rounding error.
#[test]
fn nodes_are_on_the_sum() {
    let mut random = Lcg(59);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for case in 0..600 {
        let drawn = Drawn::new(&mut random, (0.05, 40.0), case % 3 == 0, case % 2 == 0);
        let sum = drawn.sum();
        let from = [0.0, 0.3, 1.7][case % 3];
        let grid = grid_of(&sum, from, drawn.problem.end.max(from + 0.5), 0.02);
        let rounding = grid.bounds.rounding;
        let fastest = sum.waves.iter().map(|wave| wave.x).fold(1.0, f64::max);
        grid.beside(u32::MAX, |_, tau, node| {
            // The reference sum also has a rounding error, because each of its phases xτ has an error of one rounding.
            let own = 1e-15 * size_of(&sum) * (1.0 + fastest * tau);
            let value = (node.value - sum_derivative(&sum, tau, 0)).abs();
            let slope = (node.slope - sum_derivative(&sum, tau, 1)).abs();
            assert!(
                value <= rounding + own,
                "case {case}, τ {tau}: {value:e} of {rounding:e}"
            );
            assert!(
                slope <= (rounding + own) * (1.0 + fastest),
                "case {case}, τ {tau}"
            );
            worst = worst.max(value / (rounding + own));
            compared += 1;
        });
    }
    println!("{compared} nodes, off by at most {worst} of what is allowed");
    assert!(compared > 15_000);
}

/// Checks that the fourth and fifth derivative of a sum stay below their bounds at later times.
#[test]
fn no_derivative_exceeds_its_bound() {
    let mut random = Lcg(61);
    let (mut compared, mut nearest) = (0, 0.0_f64);
    for case in 0..600 {
        let drawn = Drawn::new(&mut random, (0.05, 40.0), case % 3 == 0, case % 2 == 0);
        let sum = drawn.sum();
        let from = [0.0, 0.4, 2.0][case % 3];
        let bounds = DerivativeBounds::of(&sum, &Instant::new(from / PI), PI - from);
        let room = 1.0 + 1e-9;
        for i in 0..=50 {
            let tau = from + (PI - from) * f64::from(i) / 50.0;
            let fourth = sum_derivative(&sum, tau, 4).abs();
            let fifth = sum_derivative(&sum, tau, 5).abs();
            assert!(fourth <= bounds.fourth * room, "case {case}, τ {tau}");
            assert!(fifth <= bounds.fifth * room, "case {case}, τ {tau}");
            nearest = nearest.max(fourth / bounds.fourth);
            compared += 1;
        }
        // The search does not use the second and third derivative of a sum with a mass-controlled mode.
        let asked = sum.waves.iter().all(|wave| !wave.mass_controlled);
        for (order, value) in [(2, bounds.second), (3, bounds.third)] {
            let want = sum_derivative(&sum, from, order);
            let off = (value - want).abs();
            assert!(
                !asked || off <= 1e-9 * (want.abs() + bounds.fourth),
                "case {case}: {off:e}"
            );
        }
    }
    println!("{compared} places, the fourth at most {nearest} of its bound");
    assert!(compared == 600 * 51 && nearest > 0.5);
}

/// Checks the bounds on the derivatives for the term of each mode separately, for every kind of damping. The test also
/// checks that no bound is far too large.
#[test]
fn bounds_hold_for_every_part() {
    let (mut compared, mut least, mut most) = (0, 9.0_f64, 0.0_f64);
    for zeta in ZETAS {
        for x in [
            1e-3, 0.05, 0.3, 0.7, 0.999, 1.0, 1.0001, 1.2, 2.0, 5.0, 30.0, 300.0,
        ] {
            for (name, wave) in parts(x, zeta) {
                let sum = Sum {
                    waves: core::slice::from_ref(&wave),
                    cosine: 0.0,
                    sine: 0.0,
                };
                for from in [0.0, 0.2 / x.max(1.0), 0.5, 2.4] {
                    let bounds = DerivativeBounds::of(&sum, &Instant::new(from / PI), PI - from);
                    let start = DerivativeBounds::of(&sum, &Instant::new(0.0), PI);
                    // The rounding error of a decaying term is one unit of its value at the start.
                    let fourth = bounds.fourth * (1.0 + 1e-9) + f64::EPSILON * start.fourth;
                    let fifth = bounds.fifth * (1.0 + 1e-9) + f64::EPSILON * start.fifth;
                    let near = (0..64).map(|k| from + 0.11 * f64::from(k) / x.max(1.0));
                    let far = (0..=64).map(|k| from + (PI - from) * f64::from(k) / 64.0);
                    let mut share = 0.0_f64;
                    for tau in near.chain(far).filter(|tau| *tau <= PI) {
                        let here = derivative(&wave, tau, 4).abs();
                        assert!(here <= fourth, "{name}, ζ {zeta}, x {x}, τ {tau}: {here}");
                        let next = derivative(&wave, tau, 5).abs();
                        assert!(next <= fifth, "{name}, ζ {zeta}, x {x}, τ {tau}: {next}");
                        share = share.max(here / bounds.fourth);
                        compared += 2;
                    }
                    most = most.max(share);
                    if from == 0.0 && x >= 2.0 && zeta <= 0.1 && !wave.mass_controlled {
                        least = least.min(share);
                    }
                }
            }
        }
    }
    println!("{compared} derivatives; shares of the bound from {least} to {most}");
    assert!(compared > 100_000 && most > 0.99 && least > 0.3);
}

fn size_of(sum: &TestSum<'_>) -> f64 {
    size(&search(*sum, asked(Weight::One, true, 0.0), 0.0))
}

/// Checks that the sum does not exceed an arbitrary level in any closed cell (interval between two grid nodes). In this
/// test the search also refines local maxima.
#[test]
fn nothing_is_above_the_level_in_a_closed_cell() {
    let mut random = Lcg(67);
    let (mut closed, mut open, mut beside) = (0, 0, 0);
    for case in 0..4000 {
        let over_sine = case % 2 == 0;
        let drawn = Drawn::new(&mut random, (0.05, 30.0), case % 3 == 0, over_sine);
        let (sum, problem) = (drawn.sum(), drawn.problem);
        let problem = SearchSettings {
            tolerance: 4.0 * f64::EPSILON,
            // The level is at most twice the largest value, or this floor.
            floor: if over_sine { 0.0 } else { 1e-3 * size_of(&sum) },
            ..problem
        };
        let mut search = search(sum, problem, problem.floor);
        if case % 5 < 3 {
            let most = scanned(&search);
            search.peak.value = (most * random.log_uniform(0.1, 2.0)).max(problem.floor);
        }
        let from = if case % 4 < 2 {
            0.0
        } else {
            0.2 * random.unit()
        };
        let width = random.log_uniform(0.01, 0.5);
        let keeps_forcing = over_sine && case % 3 == 1;
        let stretch = Stretch::new(from, problem.end, width, keeps_forcing);
        let bounds = DerivativeBounds::of(&sum, &Instant::new(from / PI), problem.end - from);
        let bits = search.open_cells(&stretch, &bounds);
        let bar = 1e-11 * size(&search);
        for (negative, bits) in [(false, bits[0]), (true, bits[1])] {
            if negative && !problem.both_signs {
                continue;
            }
            for cell in 0..stretch.cells() {
                if bits & (1 << cell) != 0 {
                    open += 1;
                    continue;
                }
                closed += 1;
                let left = from + cell as f64 * stretch.width;
                for i in 0..=8 {
                    let tau = (left + stretch.width * f64::from(i) / 8.0).min(problem.end);
                    let above = excess(&search, negative, tau);
                    beside += usize::from(above > -1e-3 * size(&search));
                    assert!(above <= bar, "case {case}, cell {cell}, τ {tau}: {above:e}");
                }
            }
        }
    }
    println!("{closed} cells closed, {open} left open, {beside} places near the level");
    assert!(closed > 50_000 && open > 500 && beside > 10_000);
}

/// Checks that a cell stays open if the level is just below the largest value in the cell. The test takes the first
/// cell, the last cell and random cells. The test refines no local maxima.
#[test]
fn a_cell_that_exceeds_the_level_is_open() {
    let mut random = Lcg(71);
    let mut held = [0_usize; 3];
    for case in 0..12_000 {
        let over_sine = case % 4 != 0;
        let drawn = Drawn::new(&mut random, (0.05, 30.0), case % 3 == 0, over_sine);
        let (sum, problem) = (drawn.sum(), drawn.problem);
        let mut search = search(sum, problem, 0.0);
        let width = random.log_uniform(0.02, 1.0);
        let stretch = Stretch::new(0.0, problem.end, width, case % 5 == 0);
        let bounds = DerivativeBounds::of(&sum, &Instant::new(0.0), problem.end);
        let grid = filled(&sum, &stretch, &bounds);
        let cell = [0, stretch.cells() - 1, random.below(stretch.cells())][case % 3];
        // The test takes the largest quotient in the cell, among multiples of a thirty-second of its width.
        let at = |i: usize| (cell as f64 + i as f64 / 32.0) * stretch.width;
        let quotient = |tau: f64| {
            let weight = if over_sine { tau.sin() } else { 1.0 };
            excess(&search, false, tau) / weight
        };
        let most = (1..32).map(|i| quotient(at(i))).fold(f64::MIN, f64::max);
        let gap = random.log_uniform(1e-7, 1e-2) * size(&search);
        search.peak.value = most - gap;
        // The excess over the level must be larger than the rounding errors.
        let above = (1..32)
            .map(|i| excess(&search, false, at(i)))
            .fold(f64::MIN, f64::max);
        // The test skips levels that are not positive. The exception is the last cell of sum/sin τ, in which the sum
        // exceeds only such levels.
        let low = search.peak.value <= 0.0 && (!over_sine || case % 3 != 1);
        if above < 1e-9 * size(&search) || low {
            continue;
        }
        search.peak.places[0] = Some(Maximiser {
            tau: 0.0,
            negative: false,
        });
        let open = search.open_of(&grid, false, u32::MAX);
        assert!(
            open & (1 << cell) != 0,
            "case {case}, cell {cell} of {}: {above:e} above {}",
            stretch.cells(),
            search.peak.value
        );
        held[case % 3] += 1;
    }
    println!("first, last and other cells: {held:?}");
    assert!(held.iter().all(|held| *held > 300));
}

/// Checks the cells that the search closes around a local maximum. In these cells the sum must not exceed this maximum.
#[test]
fn a_summit_closes_nothing_that_is_higher() {
    let mut random = Lcg(73);
    let (mut summits, mut closed) = (0, 0);
    for case in 0..6000 {
        let over_sine = case % 2 == 0;
        let drawn = Drawn::new(&mut random, (0.3, 30.0), case % 3 == 0, over_sine);
        let (sum, problem) = (drawn.sum(), drawn.problem);
        let mut search = search(sum, problem, 0.0);
        let rate = sum.waves.iter().map(|wave| wave.x).fold(1.0, f64::max);
        // The cells are so wide that the fourth derivative determines which cells are closed.
        let width = random.log_uniform(0.3, 6.0) / rate;
        let from = if case % 4 < 2 {
            0.0
        } else {
            0.2 * random.unit()
        };
        let stretch = Stretch::new(from, problem.end, width, false);
        let bounds = DerivativeBounds::of(&sum, &Instant::new(from / PI), problem.end - from);
        let grid = filled(&sum, &stretch, &bounds);
        let place = Maximiser {
            tau: from + (stretch.to - from) * random.unit(),
            negative: false,
        };
        let Some(summit) = search.summit(&place, &grid) else {
            continue;
        };
        summits += 1;
        let (level, negative) = summit.height();
        search.peak.value = level;
        let cells = search.about(&summit, &grid, [u32::MAX; 2])[usize::from(negative)];
        let bar = 1e-11 * size(&search);
        for cell in (0..stretch.cells()).filter(|cell| cells & (1 << cell) != 0) {
            closed += 1;
            for i in 0..=16 {
                let tau = from + (cell as f64 + f64::from(i) / 16.0) * stretch.width;
                let above = excess(&search, negative, tau.min(problem.end));
                assert!(above <= bar, "case {case}, cell {cell}, τ {tau}: {above:e}");
            }
        }
    }
    println!("{summits} summits closed {closed} cells");
    assert!(summits > 900 && closed > 2000);
}

/// Checks a Newton step across the end of the half period. The cells around the local maximum must be closed for the
/// sign that the sum has at the maximum.
#[test]
fn a_summit_across_the_end_closes_cells_of_its_own_sign() {
    let waves = [];
    let phase = 0.02_f64;
    let sum = Sum {
        waves: &waves,
        cosine: phase.cos(),
        sine: phase.sin(),
    };
    let mut search = search(sum, asked(Weight::One, true, 0.0), 0.0);
    let stretch = Stretch::new(0.0, PI, 0.3, false);
    let grid = filled(
        &sum,
        &stretch,
        &DerivativeBounds::of(&sum, &Instant::new(0.0), PI),
    );
    let before_the_end = Maximiser {
        tau: PI,
        negative: true,
    };
    let summit = search.summit(&before_the_end, &grid).expect("a summit");
    let [plus, minus] = search.about(&summit, &grid, [u32::MAX; 2]);
    assert!(plus & 1 != 0 && minus == 0, "{plus:b} {minus:b}");
}
