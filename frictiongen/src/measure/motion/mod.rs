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

/// Fraction of the motion that may remain unexplained before the fit starts from other friction forces too.
const POOR: f64 = 0.1;
/// Factors on the first guess of the friction force for further starting points of the fit.
const FACTORS: [f64; 2] = [0.5, 2.0];
/// Largest number of further fits from starting points with the first guess of the parameters that are at a bound. A
/// fit counts if it reduces the sum of squares below the fraction [`BETTER`].
const ROUNDS: usize = 4;
const BETTER: f64 = 0.999;

/// Numbers of a scene that explain the whole motion in a recording, with their 95 % intervals.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct MotionFit {
    /// Kinetic friction force F in N, or `None` if it was recorded.
    pub friction: Option<Estimate>,
    /// The fitted numbers of the description, in the order of the request.
    pub numbers: Vec<(Tunable, Estimate)>,
    /// Root mean square of the residuals. Each residual is divided by the root mean square of its channel.
    pub scatter: f64,
    /// Degrees of freedom: number of measured values minus the number of parameters that they determine.
    pub freedom: usize,
    /// Condition number of the fit. A large number means that the recording hardly separates the numbers.
    pub condition: f64,
    /// Number of runs over the whole recording without derivatives.
    pub runs: usize,
    /// Number of runs over the whole recording with an exact derivative.
    pub derivatives: usize,
    /// Number of derivatives by finite differences, because the motion grazes an event.
    pub differences: usize,
    /// The scene with the fitted numbers.
    pub system: System,
}

impl System {
    /// Fits the friction force and numbers of the description to the whole motion in a recording, by least squares.
    ///
    /// The recording has the channels of [`Inputs`](super::Inputs) and displacements or velocities of masses, which the
    /// fit compares with the motion of the stepper from rest. Displacements are relative to the first sample.
    /// `friction` is the first guess of the friction force in N. It must be `None` if the recording has the channel
    /// `friction`. The first guess of each number in `vary` is its value in the scene.
    ///
    /// The derivatives are exact, through all stops, break-aways and reversals. If the motion grazes an event, the fit
    /// uses a difference instead, and counts it in [`MotionFit::differences`].
    ///
    /// # Errors
    /// [`MeasureError`] for the errors of [`Inputs::of`](super::Inputs::of), for a recording without the motion of a
    /// mass, for fewer values than unknowns, and for a fit that does not converge.
    #[doc(hidden)]
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
    let mut fit = best.ok_or(MeasureError::NoFit)?;
    // At a bound the motion may not depend on a parameter at all, as on μ = 1 if the contact then reverses without a
    // stop. The fit cannot leave such a bound by itself.
    for _ in 0..ROUNDS {
        let mut from = fit.parameters.clone();
        let places = from.iter_mut().zip(&bounds).zip(&start);
        let mut at_bound = false;
        for ((value, (low, high)), start) in places {
            if *value == *low || *value == *high {
                (*value, at_bound) = (*start, true);
            }
        }
        let found = at_bound.then(|| run(&from)).flatten();
        match found.filter(|found| found.squares < BETTER * fit.squares) {
            Some(found) => fit = found,
            None => break,
        }
    }
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
