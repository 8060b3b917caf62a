//! Estimates the work of computing a response. A search counts work instead of time, so that a bound on its work stops
//! the search at the same point on every machine.
//!
//! One unit of work is about 10 µs. The constants are rounded means over random frames of one to six masses.

use super::response::SystemResponse;
use super::system::System;
use crate::study::scene::Damping;
use crate::{Error, NoOrbit};

/// Work of a motion from rest that did not settle, in units of about 10 µs. The code multiplies this number by (number
/// of masses + 2).
const UNSETTLED: usize = 400;
/// Work of a response for which the motion from rest did not settle and the search found another steady state, in
/// units of about 10 µs.
const ANOTHER: usize = 1000;
/// Number of vibrations of the fastest mode in one cycle of the excitation that doubles the work. Such a cycle costs
/// twice the work of a cycle in which all modes are slow.
const VIBRATIONS: f64 = 10.0;
/// Work of a settled motion of a damped chain, for each mass, in units of about 10 µs.
const DAMPED: usize = 8;
/// Work of a settled motion of an undamped chain, in units of about 10 µs. The code multiplies this number by the
/// square of the number of masses.
const UNDAMPED: usize = 6;

/// Returns the work of the response `found` at the frequency ratio r, in units of about 10 µs.
pub(in crate::study) fn work(
    system: &System,
    r: f64,
    found: Result<&SystemResponse<'_>, Error>,
) -> usize {
    let scene = system.scene();
    let masses = scene.masses.len();
    let fastest = system.resonances().last().copied().unwrap_or(0.0);
    let vibrations = fastest / (VIBRATIONS * r);
    // The conversion from `f64` to an integer limits a number that is too large, and converts NaN to 0.
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
        // With μ = 1, only the closed form can exist. The code then computes no motion in time.
        Ok(SystemResponse::Continuous(_)) if scene.stiction <= 1.0 => 1,
        Ok(SystemResponse::Continuous(_) | SystemResponse::StickSlip(_)) => followed,
        Ok(SystemResponse::Stuck(_)) => followed.div_ceil(4),
        Err(Error::NoOrbit(NoOrbit::Unbounded)) => 1,
        Err(Error::NoOrbit(_)) => spent,
        Err(_) => 1,
    }
}
