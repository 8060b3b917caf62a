//! Residuals of an identification: measured minus computed motions, transformed so that they are uncorrelated and have
//! the standard deviation 1.

use super::observation::{Datum, Observation, Using};
use crate::Complex;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Largest standard deviation, in rad, of a phase that the fit uses. The fit ignores a phase with a larger deviation.
const VAGUE: f64 = 0.3;

/// The quantities of one observation that the fit compares, with the covariance of their errors.
pub(super) struct Weighed<'o> {
    seen: &'o Observation,
    using: Using,
    /// Indices of the motions that the fit compares.
    kept: Vec<usize>,
    /// Lower Cholesky factor of the covariance matrix of the measured values.
    factor: DMatrix<f64>,
}

fn inner(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.re + a.im * b.im
}

/// Returns the complex number i·x.
fn turned(x: Complex<f64>) -> Complex<f64> {
    Complex::new(-x.im, x.re)
}

/// Returns the change of the compared quantities that a small change of a complex motion causes. `using` selects the
/// compared quantities: amplitude, phase, or both amplitude and phase.
fn seen_change(using: Using, value: Complex<f64>, change: Complex<f64>) -> Vec<f64> {
    let size = value.norm().max(f64::MIN_POSITIVE);
    match using {
        Using::Complex => vec![change.re, change.im],
        Using::Amplitude => vec![inner(value, change) / size],
        Using::Phase | Using::PhaseAlone => vec![inner(turned(value), change) / (size * size)],
    }
}

impl<'o> Weighed<'o> {
    /// Computes the covariance of the compared quantities from the errors of each channel and of the load. The error
    /// of the load is common to all motions. For base motion, x/Y is a measured displacement divided by the amplitude
    /// of the base. A relative error ε of the load's amplitude changes x/Y by −x/Y·ε. Because β = F/(k₁Y), it also
    /// changes the computed motion by −β·dx/dβ·ε. `friction` contains the derivative β·dx/dβ, which equals F·dx/dF.
    pub(super) fn new(
        seen: &'o Observation,
        using: Using,
        friction: Option<&[Complex<f64>]>,
    ) -> Option<Self> {
        let amplitude = seen.load.amplitude();
        let relative = seen.load_deviation / amplitude;
        let certain =
            |datum: &Datum| !using.is_phase() || datum.deviation < VAGUE * datum.value.norm();
        let kept: Vec<usize> = (0..seen.motions.len())
            .filter(|place| seen.motions.get(*place).is_some_and(certain))
            .collect();
        let (mut own, mut of_size, mut of_phase) = (Vec::new(), Vec::new(), Vec::new());
        for place in &kept {
            let datum = seen.motions.get(*place)?;
            let value = datum.value;
            let zero = Complex::new(0.0, 0.0);
            let by_friction = friction
                .and_then(|all| all.get(*place))
                .copied()
                .unwrap_or(zero);
            let unit = if using.is_phase() {
                datum.deviation / value.norm()
            } else {
                datum.deviation
            };
            let size = seen_change(using, value, (by_friction - value) * relative);
            own.extend(std::iter::repeat_n(unit * unit, size.len()));
            of_size.extend(size);
            let order = f64::from(datum.harmonic);
            of_phase.extend(seen_change(
                using,
                value,
                turned(value) * (-order * relative),
            ));
        }
        let (of_size, of_phase) = (DVector::from_vec(of_size), DVector::from_vec(of_phase));
        let covariance = DMatrix::from_diagonal(&DVector::from_vec(own))
            + &of_size * of_size.transpose()
            + &of_phase * of_phase.transpose();
        Some(Self {
            seen,
            using,
            kept,
            factor: covariance.cholesky()?.l(),
        })
    }

    /// Returns the number of compared values.
    pub(super) fn len(&self) -> usize {
        self.factor.nrows()
    }

    /// Returns the residuals for the computed motions of a scene.
    pub(super) fn residuals(&self, model: &[Complex<f64>]) -> Option<DVector<f64>> {
        let mut all = Vec::with_capacity(self.len());
        for place in &self.kept {
            let (seen, model) = (self.seen.motions.get(*place)?.value, *model.get(*place)?);
            match self.using {
                Using::Complex => all.extend([seen.re - model.re, seen.im - model.im]),
                Using::Amplitude => all.push(seen.norm() - model.norm()),
                Using::Phase | Using::PhaseAlone => {
                    let turn = seen * model.conj();
                    // A computed motion of zero amplitude has no phase. The code therefore uses the largest possible
                    // phase error, π rad.
                    let still = model.norm() < f64::MIN_POSITIVE.sqrt();
                    all.push(if still { PI } else { turn.im.atan2(turn.re) });
                }
            }
        }
        self.factor.solve_lower_triangular(&DVector::from_vec(all))
    }

    /// Converts the derivatives `slopes` of the computed motions to the derivatives of the residuals.
    pub(super) fn slopes(
        &self,
        model: &[Complex<f64>],
        slopes: &[Complex<f64>],
    ) -> Option<DVector<f64>> {
        let mut all = Vec::with_capacity(self.len());
        for place in &self.kept {
            let change = seen_change(self.using, *model.get(*place)?, *slopes.get(*place)?);
            all.extend(change.into_iter().map(|value| -value));
        }
        self.factor.solve_lower_triangular(&DVector::from_vec(all))
    }
}
