//! The limit of continuous motion of several contacts.

use super::at::JoinedAt;
use super::error::JoinedError;
use crate::Regime;

/// Number of frictions, evenly spaced up to the limit of sliding, among which the search finds the first at which a
/// contact sticks.
const PLACES: u32 = 16;
/// Number of halvings below the first of these frictions. The limit counts as 0 below this part of the limit of sliding.
const HALVINGS: u32 = 40;
/// Largest relative difference between the ends of the interval in which the limit is.
const CLOSE: f64 = 1e-10;

impl JoinedAt<'_> {
    /// Returns the limit of continuous motion: the largest common friction below which all contacts slide all the time in
    /// the steady state of [`orbit`](Self::orbit). It is 0 if a contact is elastic, because such a contact sticks after each
    /// reversal.
    ///
    /// The search computes steady states at 16 frictions up to the limit of sliding and then bisects. It misses stops that
    /// occur only between two of these frictions.
    ///
    /// # Errors
    /// [`JoinedError::Resonance`] on an undamped resonance of the stuck chain, where the limit of sliding is infinite.
    /// Otherwise the errors of [`orbit`](Self::orbit). A motion that does not settle is no error; it counts as one with
    /// stops.
    pub fn continuous_limit(&self) -> Result<f64, JoinedError> {
        let most = self.stuck()?.limit();
        let contacts = self.chain(1.0)?.contacts;
        let is_elastic = contacts.iter().any(|contact| contact.stiffness.is_some());
        if is_elastic || most.is_nan() || most <= 0.0 {
            return Ok(0.0);
        }
        let (mut low, mut high) = (0.0, most);
        for place in 1..PLACES {
            let friction = most * f64::from(place) / f64::from(PLACES);
            if !self.slides_at(friction)? {
                high = friction;
                break;
            }
            low = friction;
        }
        for _ in 0..HALVINGS {
            if low > 0.0 {
                break;
            }
            if self.slides_at(0.5 * high)? {
                low = 0.5 * high;
            } else {
                high *= 0.5;
            }
        }
        if low <= 0.0 {
            return Ok(0.0);
        }
        while high - low > CLOSE * high {
            let middle = 0.5 * (low + high);
            if self.slides_at(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }

    /// Returns true if all contacts slide all the time in the steady state.
    fn slides_at(&self, friction: f64) -> Result<bool, JoinedError> {
        match self.orbit(friction) {
            Ok(orbit) => Ok(orbit.regime() == Regime::Continuous),
            Err(JoinedError::Engine(_)) => Ok(false),
            Err(error) => Err(error),
        }
    }
}
