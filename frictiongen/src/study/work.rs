//! Counts the work that a response costs. The code does not measure time, so that a bound on work stops a search at the
//! same point on every machine.
//!
//! One unit of work is about 10 µs. The constants are rounded means over random frames of one to six masses.

use super::response::SystemResponse;
use super::system::System;
use crate::study::scene::Damping;
use crate::{Error, NoOrbit};

/// Work of a motion from rest that did not settle, for its last cycles. The code multiplies this number by the number
/// of masses plus two.
const UNSETTLED: usize = 400;
/// Additional work of a response if motion from rest did not settle and the search found another steady state.
const ANOTHER: usize = 1000;
/// If the fastest mode vibrates this number of times in a cycle of the excitation, the work of the cycle is twice that
/// of a cycle with a slow mode.
const VIBRATIONS: f64 = 10.0;
/// Work of a motion that settled, for each mass of a damped chain.
const DAMPED: usize = 8;
/// Work of a motion that settled, for each pair of modes of an undamped chain.
const UNDAMPED: usize = 6;

/// Returns the amount of work that the response `found` cost at the frequency ratio r.
pub(in crate::study) fn work(
    system: &System,
    r: f64,
    found: Result<&SystemResponse<'_>, Error>,
) -> usize {
    let scene = system.scene();
    let masses = scene.masses.len();
    let fastest = system.resonances().last().copied().unwrap_or(0.0);
    let vibrations = fastest / (VIBRATIONS * r);
    // The conversion to an integer saturates. NaN becomes 0.
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
        // With μ = 1 no state other than the closed form can exist, so that the code computes no motion in time.
        Ok(SystemResponse::Continuous(_)) if scene.stiction <= 1.0 => 1,
        Ok(SystemResponse::Continuous(_) | SystemResponse::StickSlip(_)) => followed,
        Ok(SystemResponse::Stuck(_)) => followed.div_ceil(4),
        Err(Error::NoOrbit(NoOrbit::Unbounded)) => 1,
        Err(Error::NoOrbit(_)) => spent,
        Err(_) => 1,
    }
}
