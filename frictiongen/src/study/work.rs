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

/// Work of a steady state of several contacts that settles at once, for each mass, in units of about 10 µs.
const OF_CONTACTS: usize = 25;
/// Work of a motion of several contacts that does not settle, for each mass, in units of about 10 µs.
const OF_CONTACTS_UNSETTLED: usize = 2500;
/// Number of cycles that doubles the work of a steady state of several contacts. In this number of cycles, a deviation
/// from the steady state falls to 1/e.
const CYCLES: f64 = 4.0;

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

/// Returns the work of a steady state of several contacts, in units of about 10 µs. `multiplier` is the modulus of its
/// largest Floquet multiplier, or `None` for a motion that does not settle.
pub(in crate::study) fn of_contacts(masses: usize, multiplier: Option<f64>) -> usize {
    let Some(multiplier) = multiplier else {
        return OF_CONTACTS_UNSETTLED * masses;
    };
    let cycles = (1.0 / (1.0 - multiplier).max(1e-3)).min(500.0);
    (OF_CONTACTS as f64 * masses as f64 * (1.0 + cycles / CYCLES)) as usize
}
