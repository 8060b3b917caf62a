//! Least squares by the damped Gauss–Newton steps of Levenberg and Marquardt. The caller computes the Jacobian.
//!
//! The crate `levenberg-marquardt` offers the same method for nalgebra 0.34. It would add a second version of nalgebra
//! (16 crates in all), because this crate uses nalgebra 0.35. The crate argmin would add 21 crates. This module needs
//! only nalgebra 0.35, which is already a dependency.

use nalgebra::{DMatrix, DVector};

/// Largest number of steps of a fit, including rejected steps.
const MOST_STEPS: usize = 200;
/// The fit ends if the last step changes each parameter by at most this fraction of its value. The fit also ends if
/// the last step changes all residuals together by at most this fraction of a standard deviation.
const SMALL: f64 = 1e-10;
/// Factor by which the damping of the Gauss–Newton steps grows after a rejected step, and by which it shrinks after an
/// accepted step (Marquardt's choice).
const GROWTH: f64 = 10.0;
/// Smallest singular value at which the data determine a direction in parameter space, divided by the largest singular
/// value.
const RANK: f64 = 1e-12;
/// The data determine a quantity only if its gradient is orthogonal to every undetermined direction in parameter
/// space. The gradient counts as orthogonal if the |cosine| of the angle is at most this number.
const APART: f64 = 1e-6;

/// Residuals of a fit, and their derivatives with respect to the parameters. The Jacobian has one column for each
/// parameter.
pub(super) struct Linearised {
    pub(super) residuals: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
}

/// Result of a fit: parameters, sum of squares, and the directions that the data determine.
#[derive(Debug)]
pub(super) struct FitResult {
    pub(super) parameters: Vec<f64>,
    /// True if the steps of the fit have converged.
    pub(super) settled: bool,
    /// The sum of squares of the residuals at the fitted parameters.
    pub(super) squares: f64,
    /// Number of independent directions in parameter space that the data determine. It equals the number of parameters
    /// if the data determine all parameters.
    pub(super) rank: usize,
    /// Condition number of the fit: the largest singular value of the Jacobian, divided by the smallest singular value
    /// of a determined direction. The columns of this Jacobian are derivatives with respect to the scaled parameters.
    pub(super) condition: f64,
    /// The scale of each parameter. The fit divides changes of a parameter by its scale.
    sizes: Vec<f64>,
    /// Directions of relative parameter changes, each with its singular value. The singular value is 0 if the data do
    /// not determine the direction.
    directions: Vec<(DVector<f64>, f64)>,
}

impl FitResult {
    /// Returns the variance of a quantity, if the residuals have the standard deviation 1. `gradient` contains the
    /// derivatives of the quantity with respect to the parameters. The variance is infinite if the data do not
    /// determine the quantity.
    pub(super) fn variance(&self, gradient: &DVector<f64>) -> f64 {
        if self.directions.is_empty() {
            return f64::INFINITY;
        }
        let relative = DVector::from_iterator(
            gradient.len(),
            gradient
                .iter()
                .zip(&self.sizes)
                .map(|(slope, size)| slope * size),
        );
        let terms = self.directions.iter().map(|(direction, value)| {
            let along = direction.dot(&relative);
            if 0.0 < *value {
                (along / value).powi(2)
            } else if along.abs() <= APART * relative.norm() {
                0.0
            } else {
                f64::INFINITY
            }
        });
        terms.sum()
    }

    /// Returns the variance of the parameter with this index, if the residuals have standard deviation 1.
    pub(super) fn own_variance(&self, index: usize) -> f64 {
        let count = self.parameters.len();
        self.variance(&DVector::from_fn(count, |row, _| {
            if row == index { 1.0 } else { 0.0 }
        }))
    }
}

/// Returns the scale of each parameter, by which the fit divides changes of the parameter. The scale is the larger of
/// two numbers. The first is the absolute value of the parameter. The second is the change that shifts the residuals by
/// one standard deviation. For a parameter that tends to zero, the second number is larger.
fn sizes(parameters: &[f64], jacobian: &DMatrix<f64>) -> Vec<f64> {
    let columns = jacobian.column_iter();
    let sizes = parameters.iter().zip(columns).map(|(value, column)| {
        let seen = column.norm().recip();
        let size = if seen.is_finite() {
            value.abs().max(seen)
        } else {
            value.abs()
        };
        if size == 0.0 { 1.0 } else { size }
    });
    sizes.collect()
}

/// Minimises the sum of squared residuals over the parameters, from a starting point.
///
/// `residuals` returns the residuals at given parameters, or `None` if they are undefined. `linearise` returns the
/// residuals with their derivatives. The parameters stay within `bounds`. Returns `None` if the residuals are undefined
/// at the starting point.
pub(super) fn minimise(
    start: &[f64],
    bounds: &[(f64, f64)],
    residuals: impl Fn(&[f64]) -> Option<DVector<f64>>,
    linearise: impl Fn(&[f64]) -> Option<Linearised>,
) -> Option<FitResult> {
    let mut at = start.to_vec();
    let mut lines = linearise(&at)?;
    let mut squares = lines.residuals.norm_squared();
    let mut damping = 1e-3;
    let mut ended = false;
    for _ in 0..MOST_STEPS {
        let normal = lines.jacobian.tr_mul(&lines.jacobian);
        let slope = lines.jacobian.tr_mul(&lines.residuals);
        let mut damped = normal.clone();
        for index in 0..damped.nrows() {
            if let Some(value) = damped.get_mut((index, index)) {
                // Without this damping, a parameter that no residual depends on would make the equations singular. The
                // damping keeps the parameter constant.
                *value += damping * value.max(f64::MIN_POSITIVE);
            }
        }
        let Some(step) = damped.cholesky().map(|factors| factors.solve(&slope)) else {
            damping *= GROWTH;
            if damping > 1e12 {
                break;
            }
            continue;
        };
        let moved = at.iter().zip(step.iter()).zip(bounds);
        let moved: Vec<f64> = moved
            .map(|((value, step), (low, high))| (value - step).clamp(*low, *high))
            .collect();
        let small = moved
            .iter()
            .zip(&at)
            .all(|(new, old)| (new - old).abs() <= SMALL * old.abs().max(SMALL));
        // If a parameter tends to 0, the steps never become small compared with the parameter. In this case the change
        // of the residuals decides.
        let small = small || (&lines.jacobian * &step).norm() <= SMALL;
        let new = residuals(&moved).map(|values| values.norm_squared());
        if let Some(new) = new.filter(|new| *new <= squares) {
            at = moved;
            squares = new;
            damping = (damping / GROWTH).max(1e-15);
            lines = linearise(&at)?;
            if small {
                ended = true;
                break;
            }
        } else {
            if small {
                ended = true;
                break;
            }
            damping *= GROWTH;
            if damping > 1e15 {
                ended = true;
                break;
            }
        }
    }
    let mut fit = judged(at, squares, &lines.jacobian);
    fit.settled = ended;
    Some(fit)
}

/// Returns the result of a fit. A singular value decomposition gives the directions that the data determine.
fn judged(parameters: Vec<f64>, squares: f64, jacobian: &DMatrix<f64>) -> FitResult {
    let mut scaled = jacobian.clone();
    let sizes = sizes(&parameters, jacobian);
    for (index, size) in sizes.iter().enumerate() {
        scaled.column_mut(index).scale_mut(*size);
    }
    let (rows, columns) = scaled.shape();
    let decomposed = scaled.svd(false, true);
    let values = &decomposed.singular_values;
    let largest = values.max();
    let determined = |value: f64| 0.0 < largest && RANK * largest < value;
    let kept = || values.iter().copied().filter(|value| determined(*value));
    let directions = decomposed.v_t.as_ref().filter(|_| columns <= rows);
    let directions = directions.map(|v_t| {
        let rows = v_t.row_iter().zip(values.iter());
        let direction = rows.map(|(row, value)| {
            let value = if determined(*value) { *value } else { 0.0 };
            (row.transpose(), value)
        });
        direction.collect()
    });
    FitResult {
        parameters,
        sizes,
        settled: false,
        squares,
        rank: kept().count(),
        condition: kept()
            .map(|value| largest / value)
            .max_by(f64::total_cmp)
            .unwrap_or(f64::INFINITY),
        directions: directions.unwrap_or_default(),
    }
}
