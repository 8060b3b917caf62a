//! What a sweep tells.

use crate::measure::identify::Estimate;
use crate::measure::statistics::is_chance;
use crate::study::System;

/// What a sweep without friction says.
#[derive(Clone, Debug)]
pub struct SweepFit {
    /// √(k₁/m₁)/2π, Hz: r = f over this; for one storey the natural frequency (4.1).
    pub reference: Estimate,
    /// γ_i = m_i/m₁ of the masses from the second on.
    pub masses: Vec<Estimate>,
    /// κ_e = k_e/k₁ of the springs from the second on.
    pub springs: Vec<Estimate>,
    /// ζ, one for all modes, if it was asked for.
    pub damping: Option<Estimate>,
    /// The natural frequencies, Hz.
    pub natural: Vec<Estimate>,
    /// The sum of squares over the degrees of freedom, where deviations were given.
    pub misfit: Option<f64>,
    /// The degrees of freedom: points less the parameters that they determine.
    pub freedom: usize,
    /// The root of the mean square of the relative residuals.
    pub scatter: f64,
    /// The condition of the fit.
    pub condition: f64,
    /// Measured less computed amplitude, in the order of the points.
    pub residuals: Vec<f64>,
    /// The scene with what was found; its first mass as it was.
    pub system: System,
}

impl SweepFit {
    /// Whether the given deviations explain the residuals.  Without deviations or freedom there is nothing to judge by, and this
    /// is true.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        is_chance(self.misfit, self.freedom)
    }
}
