//! Identification of the friction force, alone or together with other unknowns, from a response (thesis 4.5, 6.4.2).

mod answer;
mod data;
mod explained;
mod friction;
pub(super) mod model;
mod observation;
mod request;
mod several;

use super::MeasureError;
use crate::OutOfDomain;
use crate::study::System;
pub use answer::{Estimate, Explained, Identified, Verdict};
pub use observation::{Datum, Observation, Using};
pub use request::{IdentifyRequest, Unknown};

impl System {
    /// Finds the friction force that explains the measurements in any regime, with its 95 % interval.
    ///
    /// If the force is the only unknown, the call scans the sum of squared residuals over the whole range of forces.
    /// The interval contains the forces at which the sum exceeds its minimum by at most the 95 % quantile of χ². This
    /// bound is larger if noise does not explain the residuals. The scan also finds other forces with the same
    /// response. It also detects a response that hardly depends on the force. With more unknowns, damped Gauss–Newton
    /// steps with exact sensitivities follow the scan. The intervals then come from the covariance of the fit.
    ///
    /// The stiffness of an elastic contact can also be an unknown ([`Quantity::ContactStiffness`]). A contact that
    /// never slides determines this stiffness, but not the friction force.
    ///
    /// [`Quantity::ContactStiffness`]: crate::study::sensitivity::Quantity::ContactStiffness
    ///
    /// If the contact slides all the time, the complex amplitude X₁ of one mass's fundamental gives β directly: |X₁ −
    /// V| = 4β|H|/π. V is the amplitude of the mass without friction, and H its amplitude under a unit force in the
    /// contact. The two-amplitude method at resonance (Liang and Feeny, J. Vib. Acoust. 126 (2004) 118) corresponds to
    /// observations at two loads with [`Unknown::Damping`].
    ///
    /// ```
    /// use frictiongen::measure::{Datum, IdentifyRequest, Observation, Verdict};
    /// use frictiongen::study::units::Load;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: System = "struct Plate {
    ///     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// // The response to a base motion of 1.75 mm at 4 Hz with F = 0.5 N.
    /// let load = Load::Base(1.75e-3);
    /// let at = plate.at(plate.frequency_ratio_at_hertz(4.0))?;
    /// let response = at.response(plate.load_scale(load)?.friction_ratio(0.5))?;
    /// let value = response.harmonic(Of::Mass(0), 1).ok_or("no motion")?;
    /// let datum = Datum { mass: 0, harmonic: 1, value, deviation: 1e-3 };
    /// let seen = Observation { hertz: 4.0, load, load_deviation: 1e-6, motions: vec![datum] };
    /// let found = plate.identify(&[seen], &IdentifyRequest::default())?;
    /// assert_eq!(found.verdict, Verdict::Determined);
    /// assert!((found.friction.value - 0.5).abs() < 1e-6 && found.friction.holds(0.5));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`] for no observation, a load that does not fit, and fewer data than unknowns. [`MeasureError`]
    /// also for a motion that no friction explains or that is 1000 times too large, and for a fit that does not
    /// converge.
    pub fn identify(
        &self,
        observations: &[Observation],
        request: &IdentifyRequest,
    ) -> Result<Identified, MeasureError> {
        self.single().map_err(OutOfDomain::from)?;
        let problem = friction::IdentifyProblem::new(self, observations, request)?;
        let alone = problem.friction()?;
        if request.unknowns.is_empty() {
            alone.checked(&problem)?;
            return alone.answer(&problem);
        }
        several::fit(&problem, &alone, &request.unknowns)
    }
}
