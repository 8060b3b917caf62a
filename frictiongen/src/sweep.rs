//! Sweeps over the frequency ratio r and the friction ratio β, for emitted and run-time systems. The functions run on
//! one thread, do not allocate, and write their results into the caller's slices.
//!
//! ```
//! use frictiongen::sweep::{self, LimitsPoint};
//! use frictiongen::{Of, Regime, friction_system};
//!
//! friction_system! {
//!     struct Block {
//!         masses: { block: 1.0 },
//!         springs: { base - block: 1.0 },
//!         contact: block - wall,
//!         excitation: block,
//!     }
//! }
//!
//! # fn main() -> Result<(), sweep::SweepError> {
//! let ratios = [0.8, 1.0, 2.0];
//! let mut limits = [LimitsPoint::default(); 3];
//! sweep::limits(&Block, &ratios, &mut limits)?;
//! assert!(limits[1].continuous > 0.78 && limits[1].sliding == 1.0);
//!
//! let mut map = [Regime::Stuck; 6];
//! sweep::regimes(&Block, &ratios, &[0.3, 1.2], &mut map)?;
//! assert_eq!(map[..2], [Regime::Continuous, Regime::Stuck]); // at r = 0.8
//!
//! let mut amplitudes = [None; 6];
//! sweep::amplitudes(&Block, Of::Contact, &ratios, &[0.3, 1.2], &mut amplitudes)?;
//! assert!(amplitudes[0].is_some_and(|amplitude| amplitude > 2.0) && amplitudes[1].is_none());
//! # Ok(())
//! # }
//! ```

use crate::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, OutOfDomain, Regime};
use core::fmt;
use frictiongen_kernel::contact::regime;

/// The limits β_lim and β*_lim at one frequency ratio.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LimitsPoint<S> {
    /// Frequency ratio r of this point.
    pub r: S,
    /// The exact limit of continuous motion β_lim.
    pub continuous: S,
    /// The limit of sliding β*_lim.
    pub sliding: S,
}

/// The reason why a sweep ends early.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SweepError {
    /// A frequency ratio r or friction ratio β is outside the domain. The function has already written the results for
    /// all earlier values.
    OutOfDomain(OutOfDomain),
    /// The length of the slice for the results differs from the number of points.
    Length {
        /// Number of points in the sweep. Each point has one result.
        points: usize,
        /// Length of the slice that the caller passed for the results.
        room: usize,
    },
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(f),
            Self::Length { points, room } => {
                write!(
                    f,
                    "the sweep has {points} points, but there is room for {room} results"
                )
            }
        }
    }
}

impl core::error::Error for SweepError {}

impl From<OutOfDomain> for SweepError {
    fn from(error: OutOfDomain) -> Self {
        Self::OutOfDomain(error)
    }
}

fn check_length(points: usize, room: usize) -> Result<(), SweepError> {
    if points == room {
        Ok(())
    } else {
        Err(SweepError::Length { points, room })
    }
}

/// Computes the limits β_lim and β*_lim at every frequency ratio, and writes them to the slice of results.
///
/// # Errors
/// [`SweepError`] if a frequency ratio is outside the domain, or if the slices have different lengths.
pub fn limits<F: FrictionSystem>(
    system: &F,
    ratios: &[F::Scalar],
    out: &mut [LimitsPoint<F::Scalar>],
) -> Result<(), SweepError> {
    check_length(ratios.len(), out.len())?;
    for (r, out) in ratios.iter().zip(out) {
        let limits = system.at(*r)?.limits();
        *out = LimitsPoint {
            r: *r,
            continuous: limits.continuous,
            sliding: limits.sliding,
        };
    }
    Ok(())
}

/// Computes the regime at every pair of frequency ratio r and friction ratio β, and writes it to the slice of results.
/// The results for the first r and all β come first. The call computes the limits once for each r.
///
/// # Errors
/// [`SweepError`] if an r or β is outside the domain, or if the slice does not have one entry for each pair.
pub fn regimes<F: FrictionSystem>(
    system: &F,
    ratios: &[F::Scalar],
    betas: &[F::Scalar],
    out: &mut [Regime],
) -> Result<(), SweepError> {
    check_length(ratios.len().saturating_mul(betas.len()), out.len())?;
    for (r, row) in ratios.iter().zip(out.chunks_mut(betas.len().max(1))) {
        let limits = system.at(*r)?.limits();
        for (beta, out) in betas.iter().zip(row) {
            *out = limits.regime(*beta)?;
        }
    }
    Ok(())
}

/// Computes the exact amplitude at every pair of frequency ratio r and friction ratio β, and writes it to the slice of
/// results. The results for the first r and all β come first. An entry is `None` if the regime is not continuous, on an
/// unbounded resonance, and for a motion that the scene does not provide.
///
/// # Errors
/// [`SweepError`] if an r or β is outside the domain, or if the slice does not have one entry for each pair.
pub fn amplitudes<F>(
    system: &F,
    of: Of,
    ratios: &[F::Scalar],
    betas: &[F::Scalar],
    out: &mut [Option<F::Scalar>],
) -> Result<(), SweepError>
where
    F: FrictionSystem,
    for<'a> F::At<'a>: MotionAt,
{
    check_length(ratios.len().saturating_mul(betas.len()), out.len())?;
    for (r, row) in ratios.iter().zip(out.chunks_mut(betas.len().max(1))) {
        let at = system.at(*r)?;
        for (beta, out) in betas.iter().zip(row) {
            let beta = regime::check_beta(*beta)?;
            let motion = at.motion(beta).ok();
            *out = motion.and_then(|motion| motion.ask(of, |steady| steady.amplitude()));
        }
    }
    Ok(())
}
