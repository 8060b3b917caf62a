//! Finds steady states at one frequency and one friction, from several initial states.

use super::at::JoinedAt;
use super::error::JoinedError;
use super::orbit::JoinedOrbit;

/// Factors on the states of the two linear responses (no contact slides, no friction). The product of each state and
/// each factor is an initial state of the search.
const FACTORS: [f64; 3] = [1.0, -1.0, 3.0];
/// Largest difference of the amplitudes at which two steady states are treated as the same, divided by the largest
/// amplitude.
const SAME: f64 = 1e-6;

impl<'a> JoinedAt<'a> {
    /// Returns every steady state that the search finds at one common friction. The initial states are rest, the state
    /// in which no contact slides, the response without friction, and multiples of these two responses.
    ///
    /// The first entry is the steady state from rest, if the motion from rest settles. Initial states from which the
    /// motion does not settle give no entry. The list has at least one entry.
    ///
    /// # Errors
    /// [`JoinedError::OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if no initial
    /// state leads to a steady state: the reason why the motion from rest does not.
    pub fn states(&self, friction: f64) -> Result<Vec<JoinedOrbit<'a>>, JoinedError> {
        let mut found: Vec<JoinedOrbit<'a>> = Vec::new();
        let mut reason = None;
        let mut keep = |orbit: Result<JoinedOrbit<'a>, JoinedError>| {
            match orbit {
                Ok(orbit) if !found.iter().any(|known| same(known, &orbit)) => found.push(orbit),
                Ok(_) => {}
                // The motion from this initial state does not settle. The first initial state is rest.
                Err(JoinedError::Engine(error)) => {
                    reason.get_or_insert(error);
                }
                Err(error) => return Err(error),
            }
            Ok(())
        };
        keep(self.orbit(friction))?;
        let stuck = self.stuck().map(|stuck| stuck.state(self.omega()));
        let linear = self.linear().map(|linear| linear.state(self.omega()));
        for (x, v) in [stuck, linear].into_iter().flatten() {
            for factor in FACTORS {
                let scaled = |values: &[f64]| -> Vec<f64> {
                    values.iter().map(|value| factor * value).collect()
                };
                keep(self.orbit_from(friction, (&scaled(&x), &scaled(&v))))?;
            }
        }
        match reason {
            Some(error) if found.is_empty() => Err(error.into()),
            _ => Ok(found),
        }
    }
}

/// Returns true if two steady states have the same period, the same numbers of stops and the same centred amplitudes.
/// Two states of a continuum of steady states can therefore also count as the same state.
fn same(one: &JoinedOrbit<'_>, other: &JoinedOrbit<'_>) -> bool {
    let (a, b) = (one.centred_amplitudes(), other.centred_amplitudes());
    let size = a
        .iter()
        .chain(&b)
        .copied()
        .fold(f64::MIN_POSITIVE, f64::max);
    let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
    let apart = apart.fold(0.0, f64::max);
    let stops = |orbit: &JoinedOrbit<'_>| -> Vec<usize> {
        orbit.contacts().map(|contact| contact.stops()).collect()
    };
    one.period() == other.period() && stops(one) == stops(other) && apart <= SAME * size
}
