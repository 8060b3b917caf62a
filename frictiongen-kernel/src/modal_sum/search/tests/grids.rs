//! Grids against the sum itself: nodes, bounds, and cells that a grid closes.

use super::whole::scanned;
use super::*;
use crate::modal_sum::search::bounds::Bounds;
use crate::modal_sum::search::grid::{Grid, Stretch};

fn grid_of(sum: &TestSum<'_>, from: f64, to: f64, width: f64) -> Grid<f64> {
    let at = Instant::new(from / PI);
    let bounds = Bounds::of(sum, &at, to - from);
    Grid::of(sum, &Stretch::new(from, to, width), &bounds)
}

/// Value and slope at every node, as far as rounding is said to reach.
#[test]
fn nodes_are_on_the_sum() {
    let mut random = Lcg(59);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for case in 0..600 {
        let drawn = Drawn::new(&mut random, (0.05, 40.0), case % 3 == 0, case % 2 == 0);
        let sum = drawn.sum();
        let from = [0.0, 0.3, 1.7][case % 3];
        let grid = grid_of(&sum, from, drawn.question.end.max(from + 0.5), 0.02);
        let rounding = grid.bounds.rounding;
        let fastest = sum.waves.iter().map(|wave| wave.x).fold(1.0, f64::max);
        for (tau, node) in grid.nodes() {
            // The sum's own angles are known to a rounding of τ.
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
        }
    }
    println!("{compared} nodes, off by at most {worst} of what is allowed");
    assert!(compared > 15_000);
}

/// The fourth and the fifth derivative at any later time.
#[test]
fn no_derivative_exceeds_its_bound() {
    let mut random = Lcg(61);
    let (mut compared, mut nearest) = (0, 0.0_f64);
    for case in 0..600 {
        let drawn = Drawn::new(&mut random, (0.05, 40.0), case % 3 == 0, case % 2 == 0);
        let sum = drawn.sum();
        let from = [0.0, 0.4, 2.0][case % 3];
        let bounds = Bounds::of(&sum, &Instant::new(from / PI), PI - from);
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
        // Of a mass-controlled mode neither is asked.
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

fn size_of(sum: &TestSum<'_>) -> f64 {
    size(&search(*sum, asked(Weight::One, true, 0.0), 0.0))
}

/// At a level of its own choice, with summits looked at: wherever a cell is closed, the sum is below.
#[test]
fn nothing_is_above_the_level_in_a_closed_cell() {
    let mut random = Lcg(67);
    let (mut closed, mut open, mut beside) = (0, 0, 0);
    for case in 0..4000 {
        let over_sine = case % 2 == 0;
        let drawn = Drawn::new(&mut random, (0.05, 30.0), case % 3 == 0, over_sine);
        let (sum, question) = (drawn.sum(), drawn.question);
        let question = Problem {
            tolerance: 4.0 * f64::EPSILON,
            // The level is anything up to twice what the largest value is.
            floor: if over_sine { 0.0 } else { 1e-3 * size_of(&sum) },
            ..question
        };
        let mut search = search(sum, question, question.floor);
        if case % 5 < 3 {
            let most = scanned(&search);
            search.peak.value = (most * random.log_uniform(0.1, 2.0)).max(question.floor);
        }
        let from = if case % 4 < 2 {
            0.0
        } else {
            0.2 * random.unit()
        };
        let width = random.log_uniform(0.01, 0.5);
        let stretch = Stretch::new(from, question.end, width);
        let bounds = Bounds::of(&sum, &Instant::new(from / PI), question.end - from);
        let bits = search.open_cells(&stretch, &bounds);
        let bar = 1e-11 * size(&search);
        for (negative, bits) in [(false, bits[0]), (true, bits[1])] {
            if negative && !question.both_signs {
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
                    let tau = (left + stretch.width * f64::from(i) / 8.0).min(question.end);
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
