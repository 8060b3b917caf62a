//! Finds the friction with the smallest largest amplitude by a map over frequency and friction, refined near the best
//! friction. The map uses none of the optimiser's code except the response itself.

use super::frames::Frame;
use frictiongen::{Error, NoOrbit, NotContinuous, Of};

/// Number of steps of an even grid over the band of frequencies.
const EVEN: usize = 90;
/// Relative distances from each resonance at which the map has additional frequencies.
const BESIDE: [f64; 13] = [
    -0.04, -0.02, -0.008, -0.003, -0.001, -0.0003, 0.0, 0.0003, 0.001, 0.003, 0.008, 0.02, 0.04,
];
/// Number of friction ratios in the first round.
const FRICTIONS: usize = 28;
/// Number of friction ratios in each later round, which is near the best friction of the previous round.
const FINER: usize = 8;
/// Number of later rounds.
const ROUNDS: usize = 3;
/// Number of frequencies that a refinement adds on each side of a local maximum.
const CELLS: usize = 5;
/// Number of refinements of a local maximum.
const CUTS: usize = 4;
/// Relative distance of neighbouring frequencies of the fine grid.
const FINE: f64 = 0.0025;

/// Returns the amplitude divided by P/k₁, or by Y for base motion. It is infinite on a resonance that nothing bounds,
/// and 0 if there is no result.
pub fn amplitude(frame: &Frame, r: f64, beta: f64) -> f64 {
    let at = frame.system.at(r).expect("in the domain");
    match at.response(beta) {
        Ok(response) => {
            let swing = response.swing(Of::Mass(frame.mass));
            swing.map_or(f64::NAN, |swing| swing.amplitude)
        }
        Err(
            Error::NotContinuous(NotContinuous::Unbounded)
            | Error::NoOrbit(NoOrbit::Unbounded)
            | Error::StuckResonance(_),
        ) => f64::INFINITY,
        Err(_) => 0.0,
    }
}

/// Returns the frequency ratios of the map.
pub fn frequencies(frame: &Frame) -> Vec<f64> {
    let [from, to] = frame.band;
    let even = (0..=EVEN).map(|i| from + (to - from) * i as f64 / EVEN as f64);
    let resonances = frame.system.resonances().iter();
    let beside = resonances.flat_map(|resonance| BESIDE.map(|share| resonance * (1.0 + share)));
    let mut all: Vec<f64> = even.chain(beside).collect();
    all.retain(|r| from <= *r && *r <= to);
    all.sort_by(f64::total_cmp);
    all
}

/// Returns the frequency ratios of the map, together with a grid of relative spacing 0.25 %.
///
/// If motions do not settle, their amplitudes scatter from one frequency to the next. The largest amplitude at the
/// frequencies of the map alone is then far too small. In one undamped frame of six masses it is 2.9 instead of 7.8.
pub fn fine_frequencies(frame: &Frame) -> Vec<f64> {
    let [from, to] = frame.band;
    let steps = ((to / from).ln() / FINE).ceil();
    let grid = (0..=steps as u32).map(|i| from * (to / from).powf(f64::from(i) / steps));
    let mut all: Vec<f64> = frequencies(frame).into_iter().chain(grid).collect();
    all.retain(|r| from <= *r && *r <= to);
    all.sort_by(f64::total_cmp);
    all
}

/// Returns the largest amplitude at a friction ratio by samples. The function refines every interval of frequencies
/// that may contain the largest amplitude. It stops as soon as an amplitude exceeds `enough`.
pub fn largest(frame: &Frame, places: &[f64], beta: f64, enough: f64) -> f64 {
    let mut values = vec![0.0; places.len()];
    let mut most = 0.0_f64;
    // The search samples every ninth frequency first, so that it finds an excessive amplitude early.
    for offset in 0..9 {
        for place in (offset..places.len()).step_by(9) {
            values[place] = amplitude(frame, places[place], beta);
            most = most.max(values[place]);
            if enough < most {
                return most;
            }
        }
    }
    let mut best = most;
    for place in 0..places.len() {
        let (before, after) = (place.saturating_sub(1), (place + 1).min(places.len() - 1));
        let top = values[before] <= values[place] && values[after] <= values[place];
        if !top || values[place] < 0.85 * most {
            continue;
        }
        let (mut a, mut b) = (places[before], places[after]);
        for _ in 0..CUTS {
            let cells = 2 * CELLS;
            let finer: Vec<f64> = (0..=cells)
                .map(|cell| a + (b - a) * cell as f64 / cells as f64)
                .collect();
            let found = finer.iter().map(|r| amplitude(frame, *r, beta));
            let (at, value) = found
                .enumerate()
                .max_by(|(_, x), (_, y)| x.total_cmp(y))
                .expect("places");
            best = best.max(value);
            if enough < best {
                return best;
            }
            (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(cells)]);
        }
    }
    best
}

/// Returns the friction ratio with the smallest largest amplitude over the band, and that amplitude.
pub fn least(frame: &Frame) -> (f64, f64) {
    let places = frequencies(frame);
    let limit = |r: &f64| frame.system.at(*r).expect("in the domain").sliding_limit();
    let mut limits: Vec<f64> = places.iter().map(limit).collect();
    limits.retain(|limit| limit.is_finite());
    limits.sort_by(f64::total_cmp);
    let middle = limits[limits.len() / 2];
    let [low, high] = [
        0.02 * middle,
        (1.2 * limits[limits.len() - 1]).min(60.0 * middle),
    ];
    let (mut best, mut least) = (0.0, largest(frame, &places, 0.0, f64::INFINITY));
    let mut tried = vec![0.0];
    // The friction ratios closest to the middle of the range are evaluated first.
    let mut wanted: Vec<f64> = (0..=FRICTIONS)
        .map(|i| low * (high / low).powf(i as f64 / FRICTIONS as f64))
        .collect();
    wanted.sort_by(|a, b| (a / middle).ln().abs().total_cmp(&(b / middle).ln().abs()));
    for _ in 0..=ROUNDS {
        for beta in &wanted {
            let value = largest(frame, &places, *beta, least);
            if value < least {
                (best, least) = (*beta, value);
            }
        }
        tried.extend(&wanted);
        tried.sort_by(f64::total_cmp);
        let own = tried.iter().position(|beta| *beta == best).expect("tried");
        let (a, b) = (
            tried[own.saturating_sub(1)],
            tried[(own + 1).min(tried.len() - 1)],
        );
        wanted = (1..=FINER)
            .map(|i| a + (b - a) * i as f64 / (FINER + 1) as f64)
            .collect();
    }
    (best, least)
}
