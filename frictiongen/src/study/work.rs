//! The work of an answer, counted rather than measured, so that what a bound on it leaves out is the same on every machine.

use super::response::SystemResponse;
use super::system::System;
use crate::{Error, NoOrbit};

/// A motion that was followed to a steady state, for each pair of modes.  The unit is an answer of the closed form.
const FOLLOWED: usize = 5;
/// One that did not settle, or has no answer.
const UNSETTLED: usize = 1000;

/// The work of a response.
pub(in crate::study) fn work(system: &System, found: Result<&SystemResponse<'_>, Error>) -> usize {
    let scene = system.scene();
    let masses = scene.masses.len();
    let followed = FOLLOWED * masses * masses;
    match found {
        Ok(response) if !response.is_settled() || !response.is_from_rest() => UNSETTLED,
        // With μ = 1 no other state can exist beside the closed form, and nothing is followed.
        Ok(SystemResponse::Continuous(_)) if scene.stiction <= 1.0 => 1,
        Ok(SystemResponse::Continuous(_) | SystemResponse::StickSlip(_)) => followed,
        Ok(SystemResponse::Stuck(_)) => followed.div_ceil(4),
        Err(Error::NoOrbit(NoOrbit::Unbounded)) => 1,
        Err(Error::NoOrbit(_)) => UNSETTLED,
        Err(_) => 1,
    }
}
