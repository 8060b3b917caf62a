//! The work of an answer, counted rather than measured, so that what a bound on it leaves out is the same on every machine.

use super::response::SystemResponse;
use crate::{Error, NoOrbit};

/// A motion that was followed to a steady state, for each pair of modes.  The unit is an answer of the closed form.
const FOLLOWED: usize = 5;
/// One that did not settle, or has no answer.
const UNSETTLED: usize = 1000;

/// The work of a response in a chain of so many masses.
pub(in crate::study) fn work(masses: usize, found: Result<&SystemResponse<'_>, Error>) -> usize {
    match found {
        Ok(response) if !response.is_settled() => UNSETTLED,
        Ok(SystemResponse::StickSlip(_)) => FOLLOWED * masses * masses,
        Ok(_) => 1,
        Err(Error::NoOrbit(NoOrbit::Unbounded)) => 1,
        Err(Error::NoOrbit(_)) => UNSETTLED,
        Err(_) => 1,
    }
}
