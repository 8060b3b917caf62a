//! The chain while no contact slides: a linear chain, in closed form. The kernel has the formulas.

use super::{Chain, JointError};
use nalgebra::Complex;

/// The response while no contact slides, under loads of one frequency.
#[derive(Clone, Debug)]
pub struct StuckResponse {
    /// Amplitude of each mass.
    pub amplitudes: Vec<f64>,
    /// Complex amplitude X of each mass: x = Re X exp(iωt).
    pub displacements: Vec<Complex<f64>>,
    /// Amplitude of the force of each contact.
    pub forces: Vec<f64>,
    /// The factor by which all levels must be multiplied so that the contact that goes first just holds, and this
    /// contact. `None` if no contact has a level.
    pub limit: Option<(f64, usize)>,
}

/// Returns the response while no contact slides. A constant part of the loads does not count. An elastic contact has no
/// force from the past.
///
/// # Errors
///
/// [`JointError::Number`] if the loads have several frequencies, or if the frequency is a resonance.
pub fn stuck_response(chain: &Chain) -> Result<StuckResponse, JointError> {
    let model = chain.model()?;
    let response = model.stuck(frequency(chain)?);
    let response = response.ok_or(JointError::Number("the frequency"))?;
    let displacements = response.displacements;
    Ok(StuckResponse {
        amplitudes: displacements.iter().map(|x| x.norm()).collect(),
        displacements,
        forces: response.forces,
        limit: response.limit,
    })
}

/// Returns the one frequency of all loads.
fn frequency(chain: &Chain) -> Result<f64, JointError> {
    let waves = chain
        .loads
        .iter()
        .map(|(_, wave)| wave)
        .chain([&chain.base]);
    let mut found = waves
        .filter(|wave| wave.amplitude != 0.0)
        .map(|wave| wave.omega);
    let omega = found.next().ok_or(JointError::Number("the load"))?;
    if omega > 0.0 && found.all(|other| other == omega) {
        Ok(omega)
    } else {
        Err(JointError::Number("the frequency of the loads"))
    }
}
