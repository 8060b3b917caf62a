//! Finds the largest amplitude over a band by samples only, and its minimum over friction by golden section search.

use crate::tuned_optimum::case::Case;
use frictiongen::study::System;

/// A scene with one value of its varied number, with numbers in N, m and rad/s.
pub struct Tried<'c> {
    case: &'c Case,
    system: System,
    mass: f64,
    stiffness: f64,
    pub count: usize,
}

impl<'c> Tried<'c> {
    pub fn new(case: &'c Case, value: f64) -> Self {
        let [mass, stiffness] = case.first.map(|known| known.unwrap_or(value));
        Self {
            case,
            system: case.system(value),
            mass,
            stiffness,
            count: 0,
        }
    }

    fn amplitude(&mut self, omega: f64, force: f64) -> f64 {
        self.count += 1;
        let of = self.system.motion_named(self.case.of).expect("a motion");
        let r = omega * (self.mass / self.stiffness).sqrt();
        let (load, length) = if self.case.base {
            (self.stiffness * self.case.load, self.case.load)
        } else {
            (self.case.load, self.case.load / self.stiffness)
        };
        let response = self.system.at(r).expect("r").response(force / load);
        response.map_or(f64::INFINITY, |response| {
            length * response.swing(of).expect("a motion").amplitude
        })
    }

    /// Returns the largest amplitude over the band, in m, by samples only. `force` is the friction force in N.
    pub fn largest(&mut self, force: f64) -> f64 {
        const GRID: usize = 240;
        let [from, to] = self.case.band;
        let grid = |a: f64, b: f64, cells: usize| -> Vec<f64> {
            (0..=cells)
                .map(|place| a + (b - a) * place as f64 / cells as f64)
                .collect()
        };
        let places = grid(from, to, GRID);
        let values: Vec<f64> = places
            .iter()
            .map(|omega| self.amplitude(*omega, force))
            .collect();
        let most = values.iter().copied().fold(0.0, f64::max);
        let mut best = most;
        for place in 0..=GRID {
            let (before, after) = (place.saturating_sub(1), (place + 1).min(GRID));
            let top = values[before] <= values[place] && values[after] <= values[place];
            if !top || values[place] < 0.97 * most {
                continue;
            }
            let (mut a, mut b) = (places[before], places[after]);
            while b - a > 1e-7 * b {
                let finer = grid(a, b, 10);
                let found = finer.iter().map(|omega| self.amplitude(*omega, force));
                let (at, value) = found
                    .enumerate()
                    .max_by(|(_, x), (_, y)| x.total_cmp(y))
                    .expect("places");
                best = best.max(value);
                (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(10)]);
            }
        }
        best
    }

    /// Returns the friction force with the smallest value of `largest`, and that value. The function searches near
    /// the force `about`, by a grid and then by golden section search.
    pub fn least(&mut self, about: f64) -> (f64, f64) {
        let window = if 0.0 < about {
            [0.8 * about, 1.25 * about]
        } else {
            [0.0, 0.05]
        };
        golden(window, 12, 1e-9, |force| self.largest(force))
    }
}

/// Returns the minimum of a function: the best point of a grid, refined by golden section search.
pub fn golden(
    [from, to]: [f64; 2],
    cells: u32,
    near: f64,
    mut f: impl FnMut(f64) -> f64,
) -> (f64, f64) {
    let cell = (to - from) / f64::from(cells);
    let (mut x, mut least) = (from, f64::INFINITY);
    for place in 0..=cells {
        let at = from + cell * f64::from(place);
        let value = f(at);
        if value < least {
            (x, least) = (at, value);
        }
    }
    let (mut a, mut b) = ((x - cell).max(from), (x + cell).min(to));
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let at = |share: f64, a: f64, b: f64| a + share * (b - a);
    let (mut c, mut d) = (at(1.0 - share, a, b), at(share, a, b));
    let (mut fc, mut fd) = (f(c), f(d));
    while b - a > near * to {
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = at(1.0 - share, a, b);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = at(share, a, b);
            fd = f(d);
        }
    }
    [(x, least), (c, fc), (d, fd)]
        .into_iter()
        .min_by(|(_, a), (_, b)| a.total_cmp(b))
        .expect("three")
}
