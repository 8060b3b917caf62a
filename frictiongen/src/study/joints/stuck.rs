//! Response of a chain while no contact slides. The chain is then linear, and the response has a closed form.

use super::{Chain, JointError};
use nalgebra::Complex;

/// Response of a chain while no contact slides, under loads of one frequency.
#[derive(Clone, Debug)]
pub struct StuckResponse {
    /// Amplitude |X| of the displacement of each mass.
    pub amplitudes: Vec<f64>,
    /// Complex amplitude X of each mass: x = Re X exp(iωt).
    pub displacements: Vec<Complex<f64>>,
    /// Amplitude of the force in each contact.
    pub forces: Vec<f64>,
    /// Smallest common factor on all friction forces at which no contact slides, and the index of the contact that
    /// slides first below this factor. `None` if no contact has a friction force.
    pub limit: Option<(f64, usize)>,
}

/// Returns the response while no contact slides. The response leaves out constant loads. The function assumes that no
/// earlier motion has left a constant force in an elastic contact.
///
/// # Errors
///
/// [`JointError`] for an invalid chain. [`JointError::Number`] also if no load is harmonic, if the loads have several
/// frequencies, or if the frequency is an undamped resonance of the chain with its contacts stuck.
pub fn stuck_response(chain: &Chain) -> Result<StuckResponse, JointError> {
    let model = chain.model()?;
    let response = model.stuck(frequency(chain)?);
    let response = response.ok_or(JointError::Number("the frequency"))?;
    let displacements = response.displacements;
    Ok(StuckResponse {
        amplitudes: displacements.iter().map(|x| x.norm()).collect(),
        displacements: displacements.into_vec(),
        forces: response.forces.into_vec(),
        limit: response.limit,
    })
}

/// Returns the angular frequency that all harmonic loads and the base motion have in common.
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
