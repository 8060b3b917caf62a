//! Fits a scene's frequencies, masses and springs to sweeps without friction (thesis 4.3.1, 6.4.2, appendix A).

mod answer;
mod fit;
mod judged;
mod model;
mod points;

pub use answer::SweepFit;
pub use points::SweepPoint;

use super::MeasureError;
use crate::OutOfDomain;
use crate::study::System;
use crate::study::scene::Excitation;
use model::Sweep;

/// Computes the parameters of two storeys from the frequencies ω₀, ω₁ and ω₂ (6.17 to 6.20). Returns √(k₁/m₁) in
/// rad/s, the mass ratio γ and the stiffness ratio κ.
///
/// ω₀ is the antiresonance of the lower mass. ω₁ and ω₂ are the resonances. The three frequencies determine ω_z0, the
/// antiresonance of the motion relative to the base: ω_z0² = ω₁² + ω₂² − (ω₁ω₂/ω₀)². At ω_z0 the transmissibility
/// (6.15) equals 1.
///
/// ```
/// let [reference, gamma, kappa] = frictiongen::measure::two_storeys(2.0_f64.sqrt(), 1.0, 2.0);
/// // k₁/m₁ = 2, k₂/m₂ = 2, k₂/m₁ = 5 − 2 − 2.
/// assert!((reference * reference - 2.0).abs() < 1e-15);
/// assert!((gamma - 0.5).abs() < 1e-15 && (kappa - 0.5).abs() < 1e-15);
/// ```
#[must_use]
pub fn two_storeys(antiresonance: f64, first: f64, second: f64) -> [f64; 3] {
    let reference = first * second / antiresonance;
    let relative = first * first + second * second - reference * reference;
    let gamma = relative / (antiresonance * antiresonance) - 1.0;
    let ratio = antiresonance / reference;
    [reference, gamma, gamma * ratio * ratio]
}

impl System {
    /// Fits the scene's frequencies, mass ratios and stiffness ratios to the amplitudes of a sweep without friction,
    /// by least squares.
    ///
    /// One storey gives its natural frequency f_n (4.1). Two storeys give r₁/ω, γ and κ, as in (6.15) to (6.20). The
    /// fit of more storeys uses the same method. The description gives the connections and the starting point of the
    /// fit. The fit does not change the first mass. If `damping` is true, the fit also finds one damping ratio ζ for
    /// all modes. Otherwise the scene keeps its own damping.
    ///
    /// ```
    /// use frictiongen::measure::SweepPoint;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: frictiongen::System = "struct Plate {
    ///     masses: { plate: 1.0 }, springs: { base - plate: 300.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// let point = |hertz: f64| SweepPoint {
    ///     hertz,
    ///     mass: 0,
    ///     amplitude: 1.0 / (1.0 - (hertz / 3.086).powi(2)).abs(),
    ///     deviation: Some(1e-3),
    /// };
    /// let found = plate.fit_sweep(&[1.0, 2.0, 2.8, 3.5, 5.0].map(point), false)?;
    /// assert!((found.reference.value - 3.086).abs() < 1e-9 && found.reference.holds(3.086));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`] for fewer points than unknowns, and for a scene that a force excites. [`MeasureError`] also for
    /// a fit that does not converge or that leaves half of the motion unexplained.
    pub fn fit_sweep(
        &self,
        points: &[SweepPoint],
        damping: bool,
    ) -> Result<SweepFit, MeasureError> {
        self.single().map_err(OutOfDomain::from)?;
        let scene = self.scene();
        if scene.excitation != Excitation::Base {
            return Err(MeasureError::Asked(
                "a sweep gives the parameters only of a scene that is driven by its base: with a force the masses themselves would be needed",
            ));
        }
        let sweep = Sweep::new(self, points, damping);
        let unknowns = sweep.start().len();
        if points.len() < unknowns {
            return Err(MeasureError::TooFewData {
                data: points.len(),
                unknowns,
            });
        }
        let fit = sweep.fit()?;
        judged::answer(&sweep, &fit)
    }
}
