//! Result of the fit of a sweep.

use crate::measure::identify::Estimate;
use crate::measure::statistics::is_chance;
use crate::study::System;

/// Frequencies, ratios and damping found in a sweep without friction.
#[derive(Clone, Debug)]
pub struct SweepFit {
    /// Reference frequency √(k₁/m₁)/2π, Hz, so that r is the frequency over this value. With one storey it is the
    /// natural frequency (4.1).
    pub reference: Estimate,
    /// Mass ratios γ_i = m_i/m₁, from the second mass on.
    pub masses: Vec<Estimate>,
    /// Stiffness ratios κ_e = k_e/k₁, from the second spring on.
    pub springs: Vec<Estimate>,
    /// One damping ratio ζ for all modes, if it was asked for.
    pub damping: Option<Estimate>,
    /// The natural frequencies, Hz.
    pub natural: Vec<Estimate>,
    /// Sum of squares over the degrees of freedom, if deviations were given.
    pub misfit: Option<f64>,
    /// Degrees of freedom: number of points less the number of parameters that they determine.
    pub freedom: usize,
    /// Root mean square of the relative residuals.
    pub scatter: f64,
    /// Condition number of the fit.
    pub condition: f64,
    /// Measured less computed amplitude, in the order of the points.
    pub residuals: Vec<f64>,
    /// The scene with the values that were found. Its first mass keeps its value.
    pub system: System,
}

impl SweepFit {
    /// Returns whether the given deviations explain the residuals. Without deviations or degrees of freedom the
    /// residuals cannot be judged, and the result is true.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        is_chance(self.misfit, self.freedom)
    }
}
