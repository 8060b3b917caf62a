//! Finds the frequency ratios of a band at which β_lim or β*_lim equals β, and the extreme values of β_lim and β*_lim
//! over the band.

use super::line;
use super::look::PLACE;
use super::peaks::{AmplitudeBand, POLE};

/// Number of bisection steps for a frequency ratio at which β_lim or β*_lim equals β.
const HALVINGS: usize = 36;

impl AmplitudeBand<'_> {
    /// Finds the frequency ratios of the band at which β_lim or β*_lim equals β. For each of these frequency ratios,
    /// returns two numbers: one just below it and one just above it.
    pub(super) fn bounds(&self, beta: f64) -> Vec<f64> {
        let (system, objective) = (self.amplitude.system, &self.amplitude.objective);
        let mut bounds = Vec::new();
        for places in self.places.windows(2) {
            let [low, high] = places else {
                continue;
            };
            for which in [0, 1] {
                let below =
                    |limits: &[f64; 2]| limits.get(which).is_some_and(|limit| *limit < beta);
                if below(&low.limits) == below(&high.limits) {
                    continue;
                }
                let (mut a, mut b) = (low.r, high.r);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (a + b);
                    if below(&objective.limits(system, middle)) == below(&low.limits) {
                        a = middle;
                    } else {
                        b = middle;
                    }
                }
                bounds.extend([a, b]);
            }
        }
        bounds
    }

    /// Returns two friction ratios. The first is the smallest value of β_lim and β*_lim over the band. The second is
    /// the largest β*_lim. From the second friction ratio on, a stuck state exists at every frequency of the band.
    pub(super) fn limits(&self) -> [f64; 2] {
        let (system, objective) = (self.amplitude.system, &self.amplitude.objective);
        let extreme = |sign: f64, of: &dyn Fn(&[f64; 2]) -> f64| {
            let value = |limits: &[f64; 2]| sign * of(limits);
            let mut best = f64::NEG_INFINITY;
            for (index, here) in self.places.iter().enumerate() {
                let own = value(&here.limits);
                let side = |place: Option<usize>| {
                    let place = self.places.get(place?)?;
                    Some((place.r, value(&place.limits)))
                };
                let sides = [side(index.checked_sub(1)), side(Some(index + 1))];
                let lower = |side: &Option<(f64, f64)>| side.is_none_or(|(_, other)| other <= own);
                if !sides.iter().all(lower) {
                    continue;
                }
                best = best.max(own);
                let ends = sides.map(|side| side.map_or(here.r, |(r, _)| r));
                let [a, b] = ends;
                if own.is_finite() && a < b {
                    let f = |r: f64| value(&objective.limits(system, r));
                    best = best.max(line::largest(f, ends, (here.r, own), PLACE).1);
                }
            }
            sign * best
        };
        let bounded = |limit: f64| if POLE < limit { f64::INFINITY } else { limit };
        [
            extreme(-1.0, &|[continuous, sliding]| continuous.min(*sliding)),
            bounded(extreme(1.0, &|[_, sliding]| *sliding)),
        ]
    }

    /// Returns the median of the finite limits of sliding β*_lim over the sampled frequencies, or 1 if the median is
    /// not positive.
    pub(super) fn middle_limit(&self) -> f64 {
        let limits = self.places.iter().map(|place| place.limits[1]);
        let mut limits: Vec<f64> = limits.filter(|limit| limit.is_finite()).collect();
        limits.sort_by(f64::total_cmp);
        let middle = limits.get(limits.len() / 2).copied();
        middle.filter(|middle| 0.0 < *middle).unwrap_or(1.0)
    }
}
