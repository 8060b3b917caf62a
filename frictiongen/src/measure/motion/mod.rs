//! Fits the friction force and numbers of a scene to the whole motion in a recording, sample by sample.

mod model;
#[cfg(test)]
mod tests;

use super::identify::Estimate;
use super::least_squares::{FitResult, minimise};
use super::statistics::student;
use super::{MeasureError, Recording};
use crate::OutOfDomain;
use crate::study::{System, optimum::Tunable};
use model::MotionProblem;

/// If the root mean square of the residuals, divided by that of the motion, is at least this number, the fit also
/// starts from other friction forces.
const POOR: f64 = 0.1;
/// Further starting points of the fit have the first guess of the friction force multiplied by each of these factors.
const FACTORS: [f64; 2] = [0.5, 2.0];
/// Factors that give further starting points near the best fit. Each of these points has one parameter of the best fit
/// multiplied by one of the factors. The code repeats the fits from these points as long as a round reduces the sum of
/// squares to less than the fraction [`BETTER`] of its last value. It makes at most [`ROUNDS`] rounds.
const HOPS: [f64; 2] = [0.97, 1.03];
const ROUNDS: usize = 4;
const BETTER: f64 = 0.999;
/// A further fit ends early if its parameters come closer to the best fit so far than this relative distance. Such a
/// fit would only find the best fit a second time.
const BACK: f64 = 1e-5;
/// If the root mean square of the residuals, divided by that of the motion, is below this number, the fit is not
/// improved further.
const PERFECT: f64 = 1e-6;

/// Numbers of a scene that explain the whole motion in a recording, with their 95 % intervals.
#[derive(Clone, Debug)]
pub struct MotionFit {
    /// Kinetic friction force F in N, or `None` if it was recorded.
    pub friction: Option<Estimate>,
    /// The fitted numbers of the scene description, in the order of the request.
    pub numbers: Vec<(Tunable, Estimate)>,
    /// Root mean square of the residuals. Each residual is divided by the root mean square of its channel.
    pub scatter: f64,
    /// Degrees of freedom: number of measured values minus the number of parameters that they determine.
    pub freedom: usize,
    /// Condition number of the fit. If it is large, the recording hardly separates the effects of the fitted numbers.
    pub condition: f64,
    /// Number of simulations (runs) of the whole recording without derivatives.
    pub runs: usize,
    /// Number of simulations (runs) of the whole recording with an exact derivative.
    pub derivatives: usize,
    /// Number of derivatives by finite differences. The fit uses them if a stop, break-away or reversal of the contact
    /// is about to appear or vanish.
    pub differences: usize,
    /// The scene with the fitted numbers.
    pub system: System,
}

impl System {
    /// Fits the friction force and numbers of the scene description to the whole motion in a recording, by least
    /// squares.
    ///
    /// The recording contains the channels of [`Inputs`](super::Inputs), and displacements or velocities of masses.
    /// The fit compares these motions with the motion that a stepper computes from rest. Displacements are relative to
    /// the first sample. `friction` is the first guess of the friction force in N. It must be `None` if the recording
    /// has the channel `friction`. The first guess of each number in `vary` is its value in the scene.
    ///
    /// The derivatives are exact, through all stops, break-aways and reversals. If one of these events is about to
    /// appear or vanish, no reliable derivative exists. The fit then uses a finite difference, and counts it in
    /// [`MotionFit::differences`].
    ///
    /// # Errors
    /// [`MeasureError`] for the errors of [`Inputs::of`](super::Inputs::of), for a recording without the motion of a
    /// mass, for fewer values than unknowns, and for a fit that does not converge.
    pub fn fit_motion(
        &self,
        recording: &Recording,
        friction: Option<f64>,
        vary: &[Tunable],
    ) -> Result<MotionFit, MeasureError> {
        self.single().map_err(OutOfDomain::from)?;
        let problem = MotionProblem::new(self, recording, (friction, vary), true)?;
        solve(&problem)
    }
}

/// Fits the parameters of a problem.
fn solve(problem: &MotionProblem<'_>) -> Result<MotionFit, MeasureError> {
    let start = problem.start().ok_or(MeasureError::NoFit)?;
    let data = problem.data();
    if data < start.len() {
        return Err(MeasureError::TooFewData {
            data,
            unknowns: start.len(),
        });
    }
    let bounds = problem.bounds(&start);
    let run = |start: &[f64]| {
        minimise(
            start,
            &bounds,
            |at| problem.residuals(at),
            |at| problem.linearise(at),
        )
        .filter(|fit| fit.settled)
    };
    let scatter = |fit: &FitResult| (fit.squares / data as f64).sqrt();
    let mut best = run(&start);
    let good = best.as_ref().is_some_and(|fit| scatter(fit) < POOR);
    if !good && problem.fits_friction() {
        for factor in FACTORS {
            let mut other = start.clone();
            if let Some(force) = other.first_mut() {
                *force *= factor;
            }
            let fits = [best.take(), run(&other)].into_iter().flatten();
            best = fits.min_by(|a, b| a.squares.total_cmp(&b.squares));
        }
    }
    let best = best.ok_or(MeasureError::NoFit)?;
    let fit = improved(problem, (&start, &bounds), best);
    let system = problem.system_at(&fit.parameters);
    let freedom = data - fit.rank;
    let reduced = (freedom > 0).then(|| fit.squares / freedom as f64);
    let reach = reduced.map_or(f64::INFINITY, |reduced| student(freedom) * reduced.sqrt());
    let estimate = |index: usize| {
        let value = fit.parameters.get(index).copied().unwrap_or(f64::NAN);
        let reach = reach * fit.own_variance(index).sqrt();
        Estimate {
            value,
            from: (value - reach).max(0.0),
            to: value + reach,
        }
    };
    let first = usize::from(problem.fits_friction());
    let numbers = problem.vary.iter().enumerate();
    let count = problem.count();
    Ok(MotionFit {
        friction: problem.fits_friction().then(|| estimate(0)),
        numbers: numbers
            .map(|(index, tunable)| (*tunable, estimate(first + index)))
            .collect(),
        scatter: scatter(&fit),
        freedom,
        condition: fit.condition,
        runs: count.plain,
        derivatives: count.exact,
        differences: count.differences,
        system: system.ok_or(MeasureError::NoFit)?,
    })
}

/// Improves a fit by further fits from nearby starting points. The sum of squares has a bend where a stop, break-away
/// or reversal appears or vanishes. It may have a false minimum at the bend. A parameter at its bound may have no
/// effect on the motion. For example, μ = 1 has no effect if the contact then reverses without a stop.
fn improved(
    problem: &MotionProblem<'_>,
    (start, bounds): (&[f64], &[(f64, f64)]),
    mut best: FitResult,
) -> FitResult {
    let enough = PERFECT * PERFECT * problem.data() as f64;
    for _ in 0..ROUNDS {
        if best.squares < enough {
            break;
        }
        let known = &best.parameters;
        let moved = |place: usize, hop: f64| {
            let mut moved = known.clone();
            let (value, (low, high)) = (moved.get_mut(place)?, bounds.get(place)?);
            *value = match start.get(place) {
                Some(start) if value == low || value == high => *start,
                _ => (*value * hop).clamp(*low, *high),
            };
            Some(moved)
        };
        let linearise = |at: &[f64]| {
            let pairs = at.iter().zip(known);
            let back = pairs.fold(0.0_f64, |most, (new, old)| {
                most.max((new - old).abs() / old.abs().max(BACK))
            });
            (BACK < back).then(|| problem.linearise(at))?
        };
        let hops = (0..known.len()).flat_map(|place| HOPS.map(|hop| (place, hop)));
        let found = hops.filter_map(|(place, hop)| {
            let from = moved(place, hop)?;
            let fit = minimise(&from, bounds, |at| problem.residuals(at), linearise)?;
            fit.settled.then_some(fit)
        });
        let found = found.min_by(|a, b| a.squares.total_cmp(&b.squares));
        match found.filter(|fit| fit.squares < BETTER * best.squares) {
            Some(fit) => best = fit,
            None => break,
        }
    }
    best
}
