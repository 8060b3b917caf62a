//! Finds starting points for the fit of a scene to a sweep, and runs the fits.

use super::model::{AmplitudeScale, Sweep};
use crate::measure::MeasureError;
use crate::measure::least_squares::{FitResult, minimise};

/// Smallest and largest factor by which the starting points of a fit multiply the scene's own frequencies.
const FACTORS: [f64; 2] = [0.5, 2.0];
/// Number of intervals, of equal width on a logarithmic scale, into which the code divides the range [`FACTORS`] for
/// the starting points.
const TRIED: u32 = 40;
/// Factors by which the starting points of a fit multiply the scene's own mass and stiffness ratios. `TWO` is for
/// scenes with two storeys, and `THREE` for scenes with three.
const TWO: [f64; 7] = [0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 3.3];
const THREE: [f64; 3] = [0.7, 1.0, 1.4];
/// Number of starting points from which the code runs a fit. The code takes the points with the smallest sums of
/// squared residuals.
const STARTS: usize = 6;
/// If the misfit of a fit from the scene's own parameters is below this number, the code accepts this fit. The misfit
/// is the sum of squared residuals, divided by the degrees of freedom.
const GOOD: f64 = 2.0;
/// Factors that give further starting points near the best fit. Each of these points has one parameter of the best fit
/// multiplied by one of the factors. The code repeats the fits from these points as long as a round reduces the sum of
/// squares to less than the fraction [`BETTER`] of its last value. It makes at most [`ROUNDS`] rounds.
const HOPS: [f64; 4] = [0.97, 0.99, 1.01, 1.03];
const ROUNDS: usize = 4;
const BETTER: f64 = 0.999;
/// A further fit ends early if its parameters come closer to the best fit so far than this relative distance. Such a
/// fit would only find the best fit a second time.
const BACK: f64 = 1e-5;

impl Sweep<'_> {
    /// Returns the starting points of a fit, beginning with the best.
    fn starts(&self) -> Vec<Vec<f64>> {
        let own = self.start();
        let ratios = own.len() - 1 - usize::from(self.damping);
        let each: &[f64] = match ratios {
            0..=2 => &TWO,
            3..=4 => &THREE,
            _ => &[1.0],
        };
        let mut tried = vec![own];
        for place in 1..=ratios {
            let others = tried.iter().flat_map(|start| {
                each.iter().map(move |ratio| {
                    let mut start = start.clone();
                    if let Some(value) = start.get_mut(place) {
                        *value *= ratio;
                    }
                    start
                })
            });
            tried = others.collect();
        }
        let [low, high] = FACTORS;
        let share = |i: u32| f64::from(i) / f64::from(TRIED);
        let factors: Vec<f64> = (0..=TRIED)
            .map(|i| low * (high / low).powf(share(i)))
            .collect();
        let mut judged = Vec::new();
        for ratios in tried {
            // The code uses one modal analysis for all factors on the frequencies, because such a factor only scales r.
            let Some(system) = self.at(&ratios) else {
                continue;
            };
            for factor in &factors {
                let Some(values) = self.values(&system, *factor) else {
                    continue;
                };
                let mut start = ratios.clone();
                if let Some(first) = start.first_mut() {
                    *first = *factor;
                }
                judged.push((
                    self.compared(&values, AmplitudeScale::Log).norm_squared(),
                    start,
                ));
            }
        }
        judged.sort_by(|a, b| a.0.total_cmp(&b.0));
        judged
            .into_iter()
            .take(STARTS)
            .map(|(_, start)| start)
            .collect()
    }

    pub(super) fn fit(&self) -> Result<FitResult, MeasureError> {
        let bounds = |start: &[f64]| -> Vec<(f64, f64)> {
            let last = start.len() - 1;
            let bound = |(index, value): (usize, &f64)| {
                if self.damping && index == last {
                    (0.0, 1.0)
                } else {
                    (0.1 * value, 10.0 * value)
                }
            };
            start.iter().enumerate().map(bound).collect()
        };
        let run = |start: &[f64], form: AmplitudeScale| {
            minimise(
                start,
                &bounds(start),
                |at| self.residuals(at, form),
                |at| self.linearise(at, form),
            )
        };
        // The amplitudes have poles at the resonances. Near a pole, the slope of the sum of squared differences does
        // not lead to the minimum. A first fit therefore compares the logarithms of the amplitudes.
        let from = |start: &[f64]| {
            let rough = run(start, AmplitudeScale::Log)?;
            run(&rough.parameters, AmplitudeScale::Plain).filter(|fit| fit.settled)
        };
        let own = from(&self.start());
        let freedom = self.points.len() - self.start().len();
        let weighed = self.points.iter().all(|point| point.deviation.is_some());
        let good = |fit: &FitResult| weighed && 0 < freedom && fit.squares < GOOD * freedom as f64;
        if own.as_ref().is_some_and(good) {
            return own.ok_or(MeasureError::NoFit);
        }
        let starts = self.starts();
        let fits = starts.iter().filter_map(|start| from(start)).chain(own);
        let best = fits
            .min_by(|a, b| a.squares.total_cmp(&b.squares))
            .ok_or(MeasureError::NoFit)?;
        // Amplitudes have no sign. If a resonance lies on the wrong side of a measured point, the sum of squares
        // therefore has a false minimum next to the right minimum.
        let mut best = best;
        for _ in 0..ROUNDS {
            let places = 0..best.parameters.len();
            let hops = places.flat_map(|place| HOPS.map(|hop| (place, hop)));
            let known = &best.parameters;
            let found = hops.filter_map(|(place, hop)| {
                let mut start = known.clone();
                *start.get_mut(place)? *= hop;
                let linearise = |at: &[f64]| {
                    let pairs = at.iter().zip(known);
                    let back = pairs.fold(0.0_f64, |most, (new, old)| {
                        most.max((new - old).abs() / old.abs().max(BACK))
                    });
                    // Most fits from these starting points lead back to the best fit. A fit that leads back ends as
                    // soon as it has reached the best fit.
                    (BACK < back).then(|| self.linearise(at, AmplitudeScale::Plain))?
                };
                let residuals = |at: &[f64]| self.residuals(at, AmplitudeScale::Plain);
                minimise(&start, &bounds(&start), residuals, linearise).filter(|fit| fit.settled)
            });
            let found = found.min_by(|a, b| a.squares.total_cmp(&b.squares));
            match found.filter(|fit| fit.squares < BETTER * best.squares) {
                Some(fit) => best = fit,
                None => break,
            }
        }
        Ok(best)
    }
}
