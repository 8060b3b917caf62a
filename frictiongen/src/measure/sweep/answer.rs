//! Result of the fit of a scene's parameters to a sweep.

use crate::measure::identify::Estimate;
use crate::measure::statistics::is_chance;
use crate::study::System;

/// Parameters of a scene found in a sweep without friction: reference frequency, mass and stiffness ratios, and
/// damping.
#[derive(Clone, Debug)]
pub struct SweepFit {
    /// Reference frequency √(k₁/m₁)/2π, in Hz. The frequency ratio r is the frequency divided by the reference
    /// frequency. With one storey the reference frequency is the natural frequency (4.1).
    pub reference: Estimate,
    /// Mass ratios γ_i = m_i/m₁, from the second mass on.
    pub masses: Vec<Estimate>,
    /// Stiffness ratios κ_e = k_e/k₁, from the second spring on.
    pub springs: Vec<Estimate>,
    /// The damping ratio ζ of all modes, or `None` if the request does not include damping.
    pub damping: Option<Estimate>,
    /// Natural frequencies of the fitted scene, in Hz.
    pub natural: Vec<Estimate>,
    /// Sum of the squared residuals, each over its variance, divided by the degrees of freedom. `None` if the measured
    /// points have no deviations.
    pub misfit: Option<f64>,
    /// Degrees of freedom: number of measured points minus the number of parameters that the points determine.
    pub freedom: usize,
    /// Root mean square of the relative residuals of the amplitudes.
    pub scatter: f64,
    /// Condition number of the fit. If it is large, the measured points hardly separate the effects of the parameters.
    pub condition: f64,
    /// Measured minus computed amplitude of each point, in the order of the points.
    pub residuals: Vec<f64>,
    /// The scene with the fitted parameters. The fit does not change the first mass.
    pub system: System,
}

impl SweepFit {
    /// Returns true if the given deviations of the measured points explain the residuals. Without deviations or degrees
    /// of freedom the result is true, because nothing contradicts the fit.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        is_chance(self.misfit, self.freedom)
    }
}
