//! Fits the friction force together with other unknowns.

use super::answer::{Estimate, Identified, Verdict};
use super::data::Weighed;
use super::friction::{Alone, IdentifyProblem, verdict};
use super::model::{self, Along, Direction};
use super::request::Unknown;
use crate::Complex;
use crate::measure::MeasureError;
use crate::measure::least_squares::{FitResult, Linearised, minimise};
use crate::measure::statistics::{NORMAL, excess, is_chance};
use crate::study::{System, sensitivity::Quantity};
use nalgebra::{DMatrix, DVector};
use std::cell::Cell;

/// Step of a finite difference, divided by the value of the unknown. The fit uses finite differences if no exact
/// derivative exists.
const DIFFERENCE: f64 = 1e-6;
/// Starting value of the damping ratio ζ in the fit if the scene has no damping.
const SOME_DAMPING: f64 = 0.01;
/// Number of friction forces that serve as starting points of the fit. They come from the search for the friction force
/// alone.
const STARTS: usize = 3;

/// Returns the lower and the upper bound of an unknown in the fit.
fn bounds(unknown: Unknown, start: f64) -> (f64, f64) {
    match unknown {
        Unknown::Stiction | Unknown::Quantity(Quantity::Stiction) => (1.0, 10.0),
        Unknown::Damping | Unknown::Quantity(Quantity::DampingRatio(_)) => (0.0, 1.0),
        Unknown::Quantity(Quantity::MassDamping | Quantity::StiffnessDamping) => (0.0, f64::MAX),
        // The stiffness of a contact is often known only within a factor of ten.
        Unknown::Quantity(Quantity::ContactStiffness) => (0.02 * start, 50.0 * start),
        _ => (0.2 * start, 5.0 * start),
    }
}

fn is_contact_stiffness(unknown: Unknown) -> bool {
    matches!(unknown, Unknown::Quantity(Quantity::ContactStiffness))
}

/// Returns the variables that change with an unknown of the fit. The derivative of a result with respect to the unknown
/// is the sum of its derivatives with respect to these variables.
fn directions(unknown: Unknown, masses: usize) -> Vec<Direction> {
    match unknown {
        Unknown::Stiction => vec![Direction::Quantity(Quantity::Stiction)],
        Unknown::Frequencies => vec![Direction::Frequencies],
        Unknown::Damping => (0..masses)
            .map(|mode| Direction::Quantity(Quantity::DampingRatio(mode)))
            .collect(),
        Unknown::Quantity(quantity) => vec![Direction::Quantity(quantity)],
    }
}

struct SeveralFit<'p, 'a> {
    problem: &'p IdentifyProblem<'a>,
    unknowns: &'p [Unknown],
    weighed: Vec<Weighed<'a>>,
    /// Number of derivatives that the fit has computed by finite differences so far.
    differences: Cell<usize>,
}

impl SeveralFit<'_, '_> {
    fn system(&self, parameters: &[f64]) -> Option<System> {
        model::changed(self.problem.system, self.unknowns, parameters.get(1..)?)
    }

    fn residuals(&self, parameters: &[f64]) -> Option<DVector<f64>> {
        let system = self.system(parameters)?;
        let friction = *parameters.first()?;
        let mut all = Vec::new();
        for (seen, weights) in self.problem.observations.iter().zip(&self.weighed) {
            let answer = model::answer(&system, seen, friction)?;
            all.extend(weights.residuals(&answer.values)?.iter());
        }
        Some(DVector::from_vec(all))
    }

    fn linearise(&self, parameters: &[f64]) -> Option<Linearised> {
        let residuals = self.residuals(parameters)?;
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for index in 0..parameters.len() {
            let column = self
                .exact(parameters, index)
                .or_else(|| self.difference(parameters, index))?;
            jacobian.set_column(index, &column);
        }
        Some(Linearised {
            residuals,
            jacobian,
        })
    }

    /// Returns the derivatives of the residuals with respect to one unknown of the fit, by dual numbers.
    fn exact(&self, parameters: &[f64], index: usize) -> Option<DVector<f64>> {
        let system = self.system(parameters)?;
        let friction = *parameters.first()?;
        let masses = system.scene().masses.len();
        let directions = match index.checked_sub(1) {
            None => vec![Direction::Friction],
            Some(place) => directions(*self.unknowns.get(place)?, masses),
        };
        // The unknown `Frequencies` is the total factor on the natural frequencies, which the changed scene already
        // contains. `Along` differentiates with respect to a further factor, whose value is 1. By the chain rule, the
        // code divides the derivative by the total factor.
        let factor = match index
            .checked_sub(1)
            .and_then(|place| self.unknowns.get(place))
        {
            Some(Unknown::Frequencies) => 1.0 / parameters.get(index)?,
            _ => 1.0,
        };
        let along: Vec<Along<'_>> = directions
            .into_iter()
            .map(|direction| Along::new(&system, direction))
            .collect::<Option<_>>()?;
        let mut all = Vec::new();
        for (seen, weights) in self.problem.observations.iter().zip(&self.weighed) {
            let answer = model::answer(&system, seen, friction)?;
            let mut sum = vec![Complex::new(0.0, 0.0); answer.values.len()];
            for along in &along {
                for (sum, slope) in sum.iter_mut().zip(along.slopes(seen, friction)?) {
                    *sum += slope * factor;
                }
            }
            all.extend(weights.slopes(&answer.values, &sum)?.iter());
        }
        Some(DVector::from_vec(all))
    }

    /// Returns the derivatives of the residuals with respect to one unknown of the fit, by finite differences. Dual
    /// numbers give no derivative if a stop or reversal of the contact is about to appear or vanish.
    fn difference(&self, parameters: &[f64], index: usize) -> Option<DVector<f64>> {
        let value = *parameters.get(index)?;
        let step = DIFFERENCE * value.abs().max(DIFFERENCE);
        let moved = |by: f64| {
            let mut moved = parameters.to_vec();
            *moved.get_mut(index)? += by;
            self.residuals(&moved)
        };
        self.differences.set(self.differences.get() + 1);
        // The step increases the value, because the value may be at its lower bound.
        Some((moved(step)? - moved(0.0)?) / step)
    }
}

/// Fits the friction force and the other unknowns together.
pub(super) fn fit(
    problem: &IdentifyProblem<'_>,
    alone: &Alone,
    unknowns: &[Unknown],
) -> Result<Identified, MeasureError> {
    let start = |unknown: &Unknown| {
        let value = model::value(problem.system, *unknown)?;
        let damping = matches!(
            unknown,
            Unknown::Damping | Unknown::Quantity(Quantity::DampingRatio(_))
        );
        Some(if damping && value == 0.0 {
            SOME_DAMPING
        } else {
            value
        })
    };
    let start: Vec<f64> =
        unknowns
            .iter()
            .map(start)
            .collect::<Option<_>>()
            .ok_or(MeasureError::Asked(
                "the scene lacks one of the requested unknowns",
            ))?;
    let mut levels = alone.levels.clone();
    levels.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (low, high) = problem.range;
    // Forces at one third and two thirds of the range are additional starting points, because the unknowns may be far
    // from the values in the scene description.
    let others = [1.0, 2.0].map(|part| low + (high - low) * part / 3.0);
    let forces = levels
        .iter()
        .take(STARTS)
        .map(|level| level.0.value)
        .chain(others);
    let limits: Vec<(f64, f64)> = std::iter::once((low, 5.0 * high))
        .chain(
            unknowns
                .iter()
                .zip(&start)
                .map(|(unknown, start)| bounds(*unknown, *start)),
        )
        .collect();
    // If the first guess of a contact's stiffness is far off, steps along the slope do not lead to the right stiffness.
    // The fit therefore starts from several stiffnesses.
    let factors: &[f64] = match unknowns.iter().copied().any(is_contact_stiffness) {
        true => &[1.0, 0.2, 5.0],
        false => &[1.0],
    };
    let mut best: Option<FitResult> = None;
    let mut several = SeveralFit {
        problem,
        unknowns,
        weighed: problem.weighed(problem.system, None)?,
        differences: Cell::new(0),
    };
    let data: usize = several.weighed.iter().map(Weighed::len).sum();
    if data < 1 + unknowns.len() {
        return Err(MeasureError::TooFewData {
            data,
            unknowns: 1 + unknowns.len(),
        });
    }
    let run = |several: &SeveralFit<'_, '_>, start: &[f64]| {
        minimise(
            start,
            &limits,
            |at| several.residuals(at),
            |at| several.linearise(at),
        )
        .filter(|fit| fit.settled)
    };
    for (force, factor) in forces.flat_map(|force| factors.iter().map(move |one| (force, *one))) {
        let mut from = vec![force.max(1e-3 * high)];
        let values = unknowns.iter().zip(&start);
        from.extend(
            values.map(|(unknown, value)| match is_contact_stiffness(*unknown) {
                true => factor * value,
                false => *value,
            }),
        );
        if let Some(found) = run(&several, &from)
            && best
                .as_ref()
                .is_none_or(|best| found.squares < best.squares)
        {
            best = Some(found);
        }
    }
    let first = best.ok_or(MeasureError::NoFit)?;
    // The second pass computes the effect of the load's error at the values that the first pass has fitted.
    let system = several
        .system(&first.parameters)
        .ok_or(MeasureError::NoFit)?;
    let friction = first.parameters.first().copied();
    several.weighed = problem.weighed(&system, friction)?;
    let fit = run(&several, &first.parameters).ok_or(MeasureError::NoFit)?;
    answer(&several, fit, data)
}

fn answer(
    several: &SeveralFit<'_, '_>,
    fit: FitResult,
    data: usize,
) -> Result<Identified, MeasureError> {
    let (problem, unknowns) = (several.problem, several.unknowns);
    let freedom = data - fit.rank;
    let misfit = (freedom > 0).then(|| fit.squares / freedom as f64);
    let scale = excess(misfit, freedom).sqrt();
    let system = several.system(&fit.parameters).ok_or(MeasureError::NoFit)?;
    let estimate = |index: usize| {
        let value = fit.parameters.get(index).copied().unwrap_or(f64::NAN);
        let reach = NORMAL * scale * fit.own_variance(index).sqrt();
        Estimate {
            value,
            from: (value - reach).max(0.0),
            to: value + reach,
        }
    };
    let friction = estimate(0);
    let explained = problem.explained(&system, friction.value)?;
    let changed = IdentifyProblem {
        system: &system,
        ..*problem
    };
    changed.explains(friction.value)?;
    let told = verdict(&friction, 1, &explained);
    let unknowns = unknowns.iter().enumerate();
    let unknowns = unknowns.map(|(index, unknown)| (*unknown, estimate(index + 1)));
    Ok(Identified {
        levels: vec![friction],
        verdict: if is_chance(misfit, freedom) {
            told
        } else {
            Verdict::NotExplained
        },
        friction,
        unknowns: unknowns.collect(),
        misfit,
        freedom,
        condition: fit.condition,
        differences: several.differences.get(),
        explained,
        system,
    })
}
