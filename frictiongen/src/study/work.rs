//! The work of an answer, counted rather than measured, so that what a bound on it leaves out is the same on every machine.
//!
//! The unit is some 10 µs.  The numbers are rounded means over random frames of one to six masses.

use super::response::SystemResponse;
use super::system::System;
use crate::study::Damping;
use crate::{Error, NoOrbit};

/// Work of a motion from rest that was followed to its last cycle without settling, for each mass; two more are added.
const UNSETTLED: usize = 400;
/// Work of a point whose motion from rest did not settle and for which another steady state answers.
const ANOTHER: usize = 1000;
/// A cycle takes twice the work if the fastest mode vibrates this many times in it.
const VIBRATIONS: f64 = 10.0;
/// A motion that settled: for each mass where damping helps, and for each pair of modes where only the contact does.
const DAMPED: usize = 8;
const UNDAMPED: usize = 6;

/// The work of a response at a frequency ratio.
pub(in crate::study) fn work(
    system: &System,
    r: f64,
    found: Result<&SystemResponse<'_>, Error>,
) -> usize {
    let scene = system.scene();
    let masses = scene.masses.len();
    let fastest = system.resonances().last().copied().unwrap_or(0.0);
    let vibrations = fastest / (VIBRATIONS * r);
    // Saturates, and is 0 for NaN.
    let unsettled = |work: usize| (work as f64 * (1.0 + vibrations)) as usize;
    let spent = unsettled(UNSETTLED * (masses + 2));
    let followed = if scene.damping == Damping::None {
        UNDAMPED * masses * masses
    } else {
        DAMPED * masses
    };
    match found {
        Ok(response) if !response.is_settled() => spent,
        Ok(response) if !response.is_from_rest() => unsettled(ANOTHER),
        // With μ = 1 no other state can exist beside the closed form, and nothing is followed.
        Ok(SystemResponse::Continuous(_)) if scene.stiction <= 1.0 => 1,
        Ok(SystemResponse::Continuous(_) | SystemResponse::StickSlip(_)) => followed,
        Ok(SystemResponse::Stuck(_)) => followed.div_ceil(4),
        Err(Error::NoOrbit(NoOrbit::Unbounded)) => 1,
        Err(Error::NoOrbit(_)) => spent,
        Err(_) => 1,
    }
}
