//! Finds mass, viscous and Coulomb friction of an axis without a spring by linear regression.
//!
//! The equation M q̈ + F_v q̇ + F_c sgn q̇ + offset = force is linear in the four unknowns M, F_v, F_c and offset. q
//! is the position of the axis. The EMPS benchmark identifies a drive by this equation (Janot, Gautier and Brunot,
//! Data set and reference models of EMPS, 2019).
//!
//! The method differentiates no signal. It multiplies the equation by a bump function and integrates by parts
//! (modulating functions, Shinbrot 1957). The bump function is zero with zero slope at both ends of a window. The
//! derivative of a smoothed position would be too small, and the mass therefore too large by the same factor.

use super::identify::Estimate;
use super::recording::{Channel, Dimension};
use super::statistics::student;
use super::{MeasureError, Recording};
use nalgebra::{DMatrix, DVector};

/// Speed below which the direction of sliding is uncertain, divided by the largest speed.
const SLOW: f64 = 0.02;
/// Smallest number of windows from which the regression determines the four unknowns and their uncertainty.
const FEWEST: usize = 12;

/// Mass, viscous friction, Coulomb friction and constant force of an axis, found by regression.
#[derive(Clone, Debug, PartialEq)]
pub struct Regression {
    /// Mass M of the axis, in kg.
    pub mass: Estimate,
    /// Viscous friction coefficient F_v, in N·s/m.
    pub viscous: Estimate,
    /// Coulomb friction force F_c, in N.
    pub coulomb: Estimate,
    /// Constant force on the axis, in N. It is the offset in the equation of motion.
    pub offset: Estimate,
    /// Root mean square of the force that the equation does not explain, in N.
    pub residual: f64,
    /// Condition number of the regression's matrix, with each column scaled to unit length.
    pub condition: f64,
}

impl Recording {
    /// Finds mass, viscous friction, Coulomb friction and offset of an axis. The channel `axis` is the position of the
    /// axis, and the channel `force` the force on the axis.
    ///
    /// The call divides both channels into windows with a length of `seconds`, which should be short compared with the
    /// motion. It leaves out windows in which the axis reverses or is nearly at rest. The windows do not overlap, so
    /// that their errors are independent.
    ///
    /// # Errors
    /// [`MeasureError`] for a channel that is missing or has the wrong quantity, and for windows of fewer than 5
    /// samples. [`MeasureError`] also for fewer than 12 windows, and for a motion from which the four unknowns cannot
    /// be separated.
    pub fn regression(&self, axis: &str, seconds: f64) -> Result<Regression, MeasureError> {
        let (position, force) = (
            self.channel_of(axis, Dimension::Displacement)?,
            self.channel_of("force", Dimension::Force)?,
        );
        let rate = self.even_rate()?;
        let length = (seconds * rate).round();
        if !(5.0..=1e6).contains(&length) {
            return Err(MeasureError::Asked(
                "a window must have at least 5 samples, and fewer than the recording",
            ));
        }
        let length = length as usize;
        let step = 1.0 / rate;
        let bump = bump(length, step);
        let windows = position
            .samples
            .chunks_exact(length)
            .zip(force.samples.chunks_exact(length));
        let fitted: Vec<Window> = windows
            .map(|(motion, push)| {
                let motion = (motion, position.unit.scale());
                Window::of(motion, (push, force.unit.scale()), &bump)
            })
            .collect();
        let fastest = fitted
            .iter()
            .map(|window| window.slowest)
            .fold(0.0, f64::max);
        let kept: Vec<&Window> = fitted
            .iter()
            .filter(|window| SLOW * fastest < window.slowest)
            .collect();
        if kept.len() < FEWEST {
            return Err(MeasureError::TooShort {
                found: format!(
                    "{} windows in which the axis moves in one direction",
                    kept.len()
                ),
                needed: "12",
            });
        }
        solve(&kept)
    }

    /// Returns the channel called `name`. Returns an error if the channel does not measure the given quantity.
    fn channel_of(&self, name: &str, dimension: Dimension) -> Result<&Channel, MeasureError> {
        let known = || self.channels().iter().map(|channel| channel.name.clone());
        let found = self
            .channel(name)
            .ok_or_else(|| MeasureError::NoSuchPlace {
                channel: name.to_owned(),
                known: known().collect(),
            })?;
        if found.unit.dimension() == dimension {
            Ok(found)
        } else {
            Err(MeasureError::WrongDimension {
                channel: name.to_owned(),
                unit: found.unit.name(),
                needed: dimension.needed(),
            })
        }
    }
}

/// Returns three weights for each sample of a window: φ, φ̇ and φ̈, each multiplied by the time step. φ = (1 − s²)⁵ is
/// the bump function, where s runs from −1 to 1 over the window. φ is so flat at both ends that a sum over the samples
/// is as accurate as an integral.
fn bump(length: usize, step: f64) -> Vec<[f64; 3]> {
    let half = 0.5 * length as f64 * step;
    let places = (0..length).map(|i| (2.0 * i as f64 + 1.0) / length as f64 - 1.0);
    places
        .map(|s| {
            let rest = 1.0 - s * s;
            let slope = -10.0 * s * rest.powi(4);
            let bend = 10.0 * rest.powi(3) * (9.0 * s * s - 1.0);
            [
                rest.powi(5) * step,
                slope * step / half,
                bend * step / (half * half),
            ]
        })
        .collect()
}

/// The equation of motion of the axis, integrated over one window.
struct Window {
    /// The four integrals over the window by which the equation multiplies M, F_v, F_c and the offset.
    columns: [f64; 4],
    force: f64,
    /// Smallest distance between the mean positions of two neighbouring quarters of the window. It is 0 if the axis
    /// reverses its direction within the window.
    slowest: f64,
}

impl Window {
    /// Integrates the equation of motion over the samples of position and force. Each list of samples comes with the
    /// factor that converts it to the SI unit.
    fn of(
        (motion, metres): (&[f64], f64),
        (push, newtons): (&[f64], f64),
        bump: &[[f64; 3]],
    ) -> Self {
        let sum = |samples: &[f64], order: usize| -> f64 {
            let weights = bump.iter().filter_map(|weights| weights.get(order));
            samples
                .iter()
                .zip(weights)
                .map(|(value, weight)| value * weight)
                .sum()
        };
        let whole: f64 = bump.iter().map(|[weight, ..]| weight).sum();
        let length = motion.len();
        // The code subtracts the mean position, because the absolute position has no meaning here and would add
        // rounding errors.
        let mean = motion.iter().sum::<f64>() / length as f64;
        let motion: Vec<f64> = motion.iter().map(|q| (q - mean) * metres).collect();
        let quarters = motion.chunks(length.div_ceil(4));
        let means: Vec<f64> = quarters
            .map(|part| part.iter().sum::<f64>() / part.len() as f64)
            .collect();
        let steps: Vec<f64> = means
            .windows(2)
            .filter_map(|pair| Some(pair.last()? - pair.first()?))
            .collect();
        let least = steps
            .iter()
            .map(|step| step.abs())
            .fold(f64::INFINITY, f64::min);
        let side = steps.first().map_or(0.0, |step| step.signum());
        let one_way = steps.iter().all(|step| step.signum() == side);
        Self {
            columns: [sum(&motion, 2), -sum(&motion, 1), side * whole, whole],
            force: sum(&force_in_newtons(push, newtons), 0),
            slowest: if one_way { least } else { 0.0 },
        }
    }
}

fn force_in_newtons(samples: &[f64], scale: f64) -> Vec<f64> {
    samples.iter().map(|value| value * scale).collect()
}

fn solve(kept: &[&Window]) -> Result<Regression, MeasureError> {
    let rows = kept.len();
    let matrix = DMatrix::from_fn(rows, 4, |row, place| {
        kept.get(row)
            .and_then(|window| window.columns.get(place))
            .copied()
            .unwrap_or(0.0)
    });
    let sizes: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    let scaled = DMatrix::from_fn(rows, 4, |row, place| {
        let size = sizes.get(place).copied().unwrap_or(1.0);
        matrix.get((row, place)).copied().unwrap_or(0.0) / size
    });
    let right = DVector::from_iterator(rows, kept.iter().map(|window| window.force));
    let singular = scaled.clone().svd(true, true);
    let condition = singular.singular_values.max() / singular.singular_values.min();
    if !(condition < 1e8) {
        return Err(MeasureError::Asked(
            "this motion does not separate mass and friction: a motion in both directions, with several speeds and accelerations, is needed",
        ));
    }
    let found = singular
        .solve(&right, 0.0)
        .map_err(|_| MeasureError::NoFit)?;
    let left = &right - &scaled * &found;
    let freedom = rows - 4;
    let whole = kept.first().map_or(1.0, |window| window.columns[3]);
    let variance = left.norm_squared() / freedom as f64;
    let inverse = scaled
        .tr_mul(&scaled)
        .try_inverse()
        .ok_or(MeasureError::NoFit)?;
    let estimate = |place: usize| {
        let size = sizes.get(place).copied().unwrap_or(1.0);
        let value = found.get(place).copied().unwrap_or(f64::NAN) / size;
        let spread = inverse.get((place, place)).copied().unwrap_or(f64::NAN);
        let reach = student(freedom) * (variance * spread).sqrt() / size;
        Estimate {
            value,
            from: value - reach,
            to: value + reach,
        }
    };
    Ok(Regression {
        mass: estimate(0),
        viscous: estimate(1),
        coulomb: estimate(2),
        offset: estimate(3),
        residual: (left.norm_squared() / rows as f64).sqrt() / whole,
        condition,
    })
}
