//! Least squares by Levenberg and Marquardt's damped Gauss–Newton steps.
//!
//! The crate `levenberg-marquardt` does the same over nalgebra 0.34, a second nalgebra beside the 0.35 of this crate (16
//! crates in all); argmin brings 21.  This is one file over the nalgebra that is there, with exact Jacobians.

use nalgebra::{DMatrix, DVector};

/// Steps, rejected ones included.
const MOST_STEPS: usize = 200;
/// A step that changes every parameter by less than this part is the last one.
const SMALL: f64 = 1e-10;
/// What damping grows and shrinks by (Marquardt's choice).
const GROWTH: f64 = 10.0;
/// Singular values below this part of the largest tell nothing.
const RANK: f64 = 1e-12;

/// Residuals with their derivatives, one column for each parameter.
pub(super) struct Linearised {
    pub(super) residuals: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
}

/// What a fit found.
#[derive(Debug)]
pub(super) struct Fit {
    pub(super) parameters: Vec<f64>,
    /// Whether the steps came to an end.
    pub(super) settled: bool,
    /// The sum of squares.
    pub(super) squares: f64,
    /// The covariance for residuals of deviation 1; none where the data do not tell some parameter.
    pub(super) covariance: Option<DMatrix<f64>>,
    /// The largest singular value of the Jacobian over the smallest, with each parameter measured by its own size.
    pub(super) condition: f64,
}

/// Minimises the sum of squares from `start`.
///
/// `residuals` gives them at parameters, or none where there is no answer; `linearise` also their derivatives.  A parameter
/// stays within its bounds.  None if nothing can be evaluated at the start.
pub(super) fn minimise(
    start: &[f64],
    bounds: &[(f64, f64)],
    residuals: impl Fn(&[f64]) -> Option<DVector<f64>>,
    linearise: impl Fn(&[f64]) -> Option<Linearised>,
) -> Option<Fit> {
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
                // A parameter that nothing tells keeps its value.
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

/// A fit with its covariance.
fn judged(parameters: Vec<f64>, squares: f64, jacobian: &DMatrix<f64>) -> Fit {
    let mut scaled = jacobian.clone();
    let sizes: Vec<f64> = parameters
        .iter()
        .map(|value| if *value == 0.0 { 1.0 } else { value.abs() })
        .collect();
    for (index, size) in sizes.iter().enumerate() {
        scaled.column_mut(index).scale_mut(*size);
    }
    let decomposed = scaled.svd(false, true);
    let values = &decomposed.singular_values;
    let (largest, smallest) = (values.max(), values.min());
    let told = 0.0 < largest && RANK * largest < smallest && jacobian.ncols() <= jacobian.nrows();
    let covariance = decomposed.v_t.filter(|_| told).map(|v_t| {
        let count = parameters.len();
        DMatrix::from_fn(count, count, |i, j| {
            let terms = values.iter().enumerate().map(|(k, value)| {
                let entry = |at: usize| v_t.get((k, at)).copied().unwrap_or(0.0);
                entry(i) * entry(j) / (value * value)
            });
            let size = |at: usize| sizes.get(at).copied().unwrap_or(1.0);
            terms.sum::<f64>() * size(i) * size(j)
        })
    });
    Fit {
        parameters,
        settled: false,
        squares,
        covariance,
        condition: largest / smallest,
    }
}
