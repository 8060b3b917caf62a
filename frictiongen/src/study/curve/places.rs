//! Selects the first frequency ratios of a curve, called *places*. The code cuts the curve at some places, and later
//! adds points between the places.

use super::answer::PieceEnd;
use super::request::CurveRequest;
use crate::study::golden::reached;
use crate::study::system::System;
use crate::{Of, Regime};

/// Number of intervals in the first grid of frequency ratios.
const INTERVALS: usize = 160;
/// Largest number of odd sub-harmonics of one resonance that become points of a curve. The odd sub-harmonics are the
/// resonance divided by 3, 5, 7, ….
const MOST_SUBHARMONICS: usize = 25;
/// Relative distance from a pole of the response to the nearest points of the curve.
const NEAR_POLE: f64 = 1e-5;
/// Relative distance from a resonance at which the code evaluates the amplitude. A comparison with the amplitude at
/// ten times this distance detects a pole, towards which the amplitude grows without bound.
const POLE: f64 = 1e-9;
/// Number of golden-section steps in a search for another regime between three neighbouring frequency ratios. Each step
/// reduces the interval to 0.62 of its length.
const STEPS: usize = 60;

/// A frequency ratio that becomes a point of the curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurvePlace {
    pub r: f64,
    /// The reason why the curve is cut between this frequency ratio and the next. `None` without a cut.
    pub cut: Option<PieceEnd>,
    /// True if the curve may leave out this point. The point is then a sub-harmonic of a resonance and not next to a
    /// cut. A sweep leaves out all such points. Any other curve computes these points last, as far as its bound on
    /// work permits.
    pub spare: bool,
}

impl CurvePlace {
    pub(super) fn at(r: f64) -> Self {
        Self {
            r,
            cut: None,
            spare: false,
        }
    }

    fn cut(r: f64, cut: PieceEnd) -> Self {
        Self {
            cut: Some(cut),
            ..Self::at(r)
        }
    }
}

/// Returns the first frequency ratios of a curve in ascending order: both bounds of the range, resonances, their
/// sub-harmonics, a grid, and both sides of every cut.
pub(super) fn places(system: &System, request: &CurveRequest, beta: f64) -> Vec<CurvePlace> {
    let search = PlaceSearch {
        system,
        request,
        beta,
    };
    let (mut poles, mut subharmonics) = (Vec::new(), Vec::new());
    let mut grid = grid(request);
    for resonance in search.resonances() {
        if search.is_pole(resonance, &request.of) {
            poles.push(resonance);
        } else {
            grid.push(resonance);
        }
        let orders = (1..=MOST_SUBHARMONICS).map(|i| (2 * i + 1) as f64);
        subharmonics.extend(orders.map(|order| resonance / order));
    }
    grid.extend(&subharmonics);
    let sides = |pole: &f64| [pole * (1.0 - NEAR_POLE), pole * (1.0 + NEAR_POLE)];
    // The grid must have no point within the distance `NEAR_POLE` of a pole. The two points on both sides of the pole
    // are then its nearest points.
    let beside = |r: &f64| poles.iter().any(|pole| (r / pole - 1.0).abs() <= NEAR_POLE);
    grid.retain(|r| request.from <= *r && *r <= request.to && !beside(r));
    let sides = poles.iter().flat_map(sides);
    grid.extend(sides.filter(|r| request.from <= *r && *r <= request.to));
    grid.sort_by(f64::total_cmp);
    grid.dedup();
    let is_pole = |left: f64, right: f64| poles.iter().any(|pole| left < *pole && *pole < right);
    let mut places = search.cut(&grid, is_pole);
    subharmonics.sort_by(f64::total_cmp);
    let mut beside_cut = true;
    for place in &mut places {
        let subharmonic = subharmonics.binary_search_by(|r| r.total_cmp(&place.r));
        place.spare = !beside_cut && place.cut.is_none() && subharmonic.is_ok();
        beside_cut = place.cut.is_some();
    }
    places
}

/// Returns a grid of evenly spaced frequency ratios with both bounds of the range, and geometrically spaced ones at low
/// r.
fn grid(request: &CurveRequest) -> Vec<f64> {
    let width = request.to - request.from;
    let wanted = request.widest.map_or(0.0, |widest| (width / widest).ceil());
    // The bound 1e7 is for callers of the library. The command already refuses a grid that is too fine for the memory.
    let count = wanted.max(INTERVALS as f64).min(1e7) as usize;
    let inner = (1..count).map(|i| request.from + width * i as f64 / count as f64);
    let mut grid: Vec<f64> = inner.collect();
    grid.extend([request.from, request.to]);
    // At low r the sub-harmonics of the resonances are closer together. The additional points at low r therefore have
    // a spacing proportional to r.
    let mut low = request.from * 1.05;
    while low < request.to * 0.1 && grid.len() < count + 200 {
        grid.push(low);
        low *= 1.05;
    }
    grid
}

struct PlaceSearch<'a> {
    system: &'a System,
    request: &'a CurveRequest,
    beta: f64,
}

impl PlaceSearch<'_> {
    /// Returns the resonances of the chain without friction and with its contact stuck, as frequency ratios.
    fn resonances(&self) -> Vec<f64> {
        let held = self.system.dynamics().held;
        let free = self.system.resonances().iter().copied();
        free.chain(held.iter().map(|mode| mode.frequency)).collect()
    }

    /// Returns true if the amplitude of a motion in the list `of` grows without bound towards the given resonance.
    fn is_pole(&self, resonance: f64, of: &[Of]) -> bool {
        let largest = |distance: f64| -> Option<f64> {
            let r = resonance * (1.0 - distance);
            let response = self
                .system
                .at(r)
                .ok()?
                .response(self.request.beta_at(self.beta, r))
                .ok()?;
            let sizes = of
                .iter()
                .filter_map(|of| Some(response.swing(*of)?.amplitude));
            Some(sizes.fold(0.0, f64::max))
        };
        match (largest(10.0 * POLE), largest(POLE)) {
            // Towards a pole, the amplitude grows tenfold from the farther point to the nearer point.
            (Some(far), Some(near)) => 5.0 * far < near,
            _ => false,
        }
    }

    /// Returns ln(β/β_lim) and ln(β/β*_lim) at the frequency ratio r. If the first number is negative, the contact can
    /// slide all the time. If the second number is not negative, a stuck state exists.
    fn margins(&self, r: f64) -> (f64, f64) {
        match self.system.at(r) {
            Ok(at) => {
                let limits = at.limits();
                let over = |limit: f64| (self.request.beta_at(self.beta, r) / limit).ln();
                (over(limits.continuous), over(limits.sliding))
            }
            Err(_) => (f64::NAN, f64::NAN),
        }
    }

    fn regime(&self, r: f64) -> Option<Regime> {
        let limits = self.system.at(r).ok()?.limits();
        limits.regime(self.request.beta_at(self.beta, r)).ok()
    }

    /// Adds both sides of every regime boundary to the grid. Marks the cuts of the curve at regime boundaries and at
    /// poles.
    fn cut(&self, grid: &[f64], is_pole: impl Fn(f64, f64) -> bool) -> Vec<CurvePlace> {
        let mut all = grid.to_vec();
        all.extend(self.hidden(grid));
        all.sort_by(f64::total_cmp);
        all.dedup();
        let regimes: Vec<_> = all.iter().map(|r| self.regime(*r)).collect();
        let mut places = Vec::new();
        for (pair, regimes) in all.windows(2).zip(regimes.windows(2)) {
            let (&[left, right], [first, second]) = (pair, regimes) else {
                continue;
            };
            if is_pole(left, right) {
                places.push(CurvePlace::cut(left, PieceEnd::Pole));
            } else {
                self.change(left, right, [*first, *second], &mut places);
            }
        }
        places.extend(all.last().copied().map(CurvePlace::at));
        places
    }

    /// Adds the first of two frequency ratios to the curve, and both sides of every regime boundary between the two.
    fn change(
        &self,
        left: f64,
        right: f64,
        [first, second]: [Option<Regime>; 2],
        places: &mut Vec<CurvePlace>,
    ) {
        if first == second {
            places.push(CurvePlace::at(left));
            return;
        }
        let (low, high) = self.boundary(left, right, first);
        if left < low {
            places.push(CurvePlace::at(left));
        }
        places.push(CurvePlace::cut(low, PieceEnd::Boundary));
        if high < right {
            // Stick-slip may lie between the continuous and the stuck regime. The search therefore continues at
            // frequencies above this boundary.
            self.change(high, right, [self.regime(high), second], places);
        }
    }

    /// Returns the two neighbouring floating-point numbers between which the regime at `low` ends.
    fn boundary(&self, mut low: f64, mut high: f64, regime: Option<Regime>) -> (f64, f64) {
        loop {
            let middle = 0.5 * (low + high);
            if !(low < middle && middle < high) {
                return (low, high);
            }
            if self.regime(middle) == regime {
                low = middle;
            } else {
                high = middle;
            }
        }
    }

    /// Returns frequency ratios between grid points at which the contact has another regime than at the grid points.
    /// The search starts from three neighbouring grid points with the same regime.
    fn hidden(&self, grid: &[f64]) -> Vec<f64> {
        let margins: Vec<_> = grid.iter().map(|r| self.margins(*r)).collect();
        let mut found = Vec::new();
        for (places, margins) in grid.windows(3).zip(margins.windows(3)) {
            let (&[left, _, right], &[a, b, c]) = (places, margins) else {
                continue;
            };
            for (read, sign) in [
                (continuous as MarginOf, 1.0),
                (continuous, -1.0),
                (sliding, 1.0),
                (sliding, -1.0),
            ] {
                let [a, b, c] = [a, b, c].map(|margins| sign * read(margins));
                // All three margins are on one side of the limit, and the middle margin is nearest to the limit.
                // Between the outer points, β may therefore cross the limit.
                if a < 0.0 && b < 0.0 && c < 0.0 && a <= b && c <= b {
                    let value = |r: f64| sign * read(self.margins(r));
                    found.extend(reached([left, right], STEPS, value, |value| 0.0 <= value));
                }
            }
        }
        found
    }
}

/// A function that selects one of the two margins ln(β/β_lim) and ln(β/β*_lim).
type MarginOf = fn((f64, f64)) -> f64;

fn continuous(margins: (f64, f64)) -> f64 {
    margins.0
}

fn sliding(margins: (f64, f64)) -> f64 {
    margins.1
}
