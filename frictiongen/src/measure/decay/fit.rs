//! Fits a model of a decaying vibration to all samples between the first and the last extreme.

use super::swings::Swings;
use crate::measure::MeasureError;
use crate::measure::least_squares::{Linearised, minimise};
use crate::measure::statistics::student;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Step of the finite difference for a derivative with respect to a parameter, divided by the scale of the parameter.
const DIFFERENCE: f64 = 1e-6;
/// Index of the parameter “number of samples in a half cycle” in [`DecayShape`].
const HALF: usize = 3;
/// Index of the parameter “logarithmic decrement of a half cycle” in [`DecayShape`].
const DECREMENT: usize = 4;
/// Index of the parameter F/k in [`DecayShape`]: friction force F divided by stiffness k.
const LENGTH: usize = 5;

/// Parameters of a decaying vibration. The first three are the instant of the first extreme (in samples), the
/// displacement at this extreme (m), and the middle between the two points about which the mass oscillates (m). The
/// other three are the duration of a half cycle (in samples), the logarithmic decrement of a half cycle due to viscous
/// damping, and F/k (m).
type DecayShape = [f64; 6];

/// Computes the displacement at each sample from the first extreme to the last, for the parameters `shape`.
fn wave(shape: &[f64], from: usize, count: usize) -> Option<Vec<f64>> {
    let &[start, first, middle, half, decrement, length] = shape else {
        return None;
    };
    let decay = (-decrement).exp();
    let (mut swing, mut extreme) = (0.0, first);
    let centre = |extreme: f64| middle + length * (extreme - middle).signum();
    let values = (0..count).map(|index| {
        let since = ((from + index) as f64 - start) / half;
        while swing + 1.0 <= since {
            let about = centre(extreme);
            extreme = about - (extreme - about) * decay;
            swing += 1.0;
        }
        let about = centre(extreme);
        let part = since - swing;
        let (sin, cos) = (PI * part).sin_cos();
        about + (extreme - about) * (-decrement * part).exp() * (cos + decrement / PI * sin)
    });
    Some(values.collect())
}

/// A recorded decay, a first guess of its parameters, and the parameters to fit.
pub(super) struct DecayFit<'s> {
    /// Index of the sample at the first extreme of the free vibration.
    from: usize,
    /// Samples of the free vibration from its first extreme to its last.
    window: &'s [f64],
    start: DecayShape,
    /// Natural scale of each parameter of the fit.
    scales: DecayShape,
    /// Indices of the parameters that the fit may change, in [`DecayShape`].
    free: Vec<usize>,
}

/// Fitted parameters of a free vibration, each with its value and the half width of its 95 % interval.
pub(super) struct DecayParameters {
    /// Number of samples in half a cycle of the free vibration, and the half width of its interval.
    pub(super) half: (f64, f64),
    /// Logarithmic decrement of the free vibration in half a cycle due to viscous damping, and the half width of its
    /// interval.
    pub(super) decrement: (f64, f64),
    /// Friction force F divided by the stiffness k, in m, and the half width of its interval.
    pub(super) length: (f64, f64),
    /// Standard deviation of the fit's residuals, in m.
    pub(super) deviation: f64,
}

impl<'s> DecayFit<'s> {
    /// Computes a first guess of the parameters from the extremes. `damping` is ζ if it is known.
    pub(super) fn new(
        samples: &'s [f64],
        swings: &Swings,
        damping: Option<f64>,
    ) -> Result<Self, MeasureError> {
        let [first, last] = swings.ends;
        let half = (last.0 - first.0) as f64 / (swings.turns.len() - 1) as f64;
        let known = damping.map(|ratio| PI * ratio / (1.0 - ratio * ratio).sqrt());
        let second = swings.turns.get(1).map_or(first.1, |second| second.1);
        let middle = first.1 + 0.5 * (second - first.1);
        let size = swings.largest;
        Ok(Self {
            from: first.0,
            window: samples.get(first.0..=last.0).ok_or(MeasureError::NoFit)?,
            start: [
                first.0 as f64,
                first.1,
                middle,
                half,
                known.unwrap_or(0.0),
                swings.linear_decrement,
            ],
            scales: [half, size, size, half, 1.0, size],
            free: (0..6)
                .filter(|index| known.is_none() || *index != DECREMENT)
                .collect(),
        })
    }

    /// Fits the parameters of a free vibration to the samples.
    pub(super) fn solved(&self) -> Result<DecayParameters, MeasureError> {
        let bounds: Vec<(f64, f64)> = self.free.iter().map(|part| self.bounds(*part)).collect();
        let free: Vec<f64> = self
            .free
            .iter()
            .filter_map(|part| self.start.get(*part).copied())
            .collect();
        let fit = minimise(
            &free,
            &bounds,
            |free| self.residuals(free),
            |free| self.linearised(free),
        );
        let fit = fit.filter(|fit| fit.settled).ok_or(MeasureError::NoFit)?;
        let freedom = self.window.len().saturating_sub(fit.rank).max(1);
        let deviation = (fit.squares / freedom as f64).sqrt();
        let quantile = student(freedom);
        let shape = self.shape(&fit.parameters).ok_or(MeasureError::NoFit)?;
        let estimate = |part: usize| {
            let value = shape.get(part).copied().unwrap_or(f64::NAN);
            let place = self.free.iter().position(|free| *free == part);
            let variance = place.map_or(0.0, |at| fit.own_variance(at));
            (value, quantile * deviation * variance.sqrt())
        };
        Ok(DecayParameters {
            half: estimate(HALF),
            decrement: estimate(DECREMENT),
            length: estimate(LENGTH),
            deviation,
        })
    }

    /// Returns the lower and the upper bound of a parameter in the fit.
    fn bounds(&self, part: usize) -> (f64, f64) {
        let [_, _, _, half, _, size] = self.scales;
        match part {
            HALF => (0.5 * half, 2.0 * half),
            DECREMENT => (-1.0, 10.0),
            LENGTH => (-size, size),
            _ => (f64::MIN, f64::MAX),
        }
    }

    /// Returns all parameters of the decay. `free` gives the fitted parameters. A parameter that is not fitted keeps
    /// the value of the first guess.
    fn shape(&self, free: &[f64]) -> Option<DecayShape> {
        let mut shape = self.start;
        for (part, value) in self.free.iter().zip(free) {
            *shape.get_mut(*part)? = *value;
        }
        Some(shape)
    }

    /// Returns the residuals of the fit: the computed minus the recorded displacement at each sample.
    fn residuals(&self, free: &[f64]) -> Option<DVector<f64>> {
        let count = self.window.len();
        let values = wave(&self.shape(free)?, self.from, count)?;
        let pairs = values.iter().zip(self.window);
        Some(DVector::from_iterator(count, pairs.map(|(a, b)| a - b)))
    }

    /// Returns the residuals and their derivatives with respect to the fitted parameters, by central differences.
    fn linearised(&self, free: &[f64]) -> Option<Linearised> {
        let residuals = self.residuals(free)?;
        let mut jacobian = DMatrix::zeros(self.window.len(), free.len());
        for (index, part) in self.free.iter().enumerate().take(free.len()) {
            let step = DIFFERENCE * self.scales.get(*part).copied().unwrap_or(1.0);
            let moved = |by: f64| {
                let mut moved = free.to_vec();
                *moved.get_mut(index)? += by;
                self.residuals(&moved)
            };
            jacobian.set_column(index, &((moved(step)? - moved(-step)?) / (2.0 * step)));
        }
        Some(Linearised {
            residuals,
            jacobian,
        })
    }
}
