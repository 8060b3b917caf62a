//! Prediction of the largest value's position from earlier searches at nearby frequency ratios.

use super::{Maximiser, Peak};
use crate::number::scalar::Float;

/// Positions at which the last searches of a sweep found their largest values.
///
/// A search that gets a `Neighbour` begins at the predicted position. It then proves that nothing larger
/// remains, as every search does. A wrong prediction costs some evaluations, but does not change the result.
///
/// One `Neighbour` serves the motion of one mass of one scene; see
/// [`Motion::largest_near`](crate::response::motion::Motion::largest_near).
#[derive(Clone, Copy, Debug, Default)]
pub struct Neighbour<S> {
    /// Known positions, the latest first.
    known: [Option<Known<S>>; 3],
}

/// A position, and the point of the sweep at which it was found.
#[derive(Clone, Copy, Debug)]
struct Known<S> {
    /// Rate of the fastest mode, which is proportional to 1/r.
    speed: S,
    place: Maximiser<S>,
}

impl<S: Float> Neighbour<S> {
    /// Creates an empty prediction. The first search of a sweep is like any other.
    #[must_use]
    pub fn new() -> Self {
        Self { known: [None; 3] }
    }

    /// Returns the expected position of the largest value. It lies on the parabola through the last three positions, on
    /// the line through the last two, or at the last one.
    pub(super) fn guess(&self, speed: S) -> Option<Maximiser<S>> {
        let [last, second, third] = self.known;
        let last = last?;
        let mut tau = last.place.tau;
        if let Some(second) = second {
            let slope = last.slope_to(&second);
            tau = tau + (speed - last.speed) * slope;
            if let Some(third) = third {
                let curve = (slope - second.slope_to(&third)) / (last.speed - third.speed);
                tau = tau + (speed - last.speed) * (speed - second.speed) * curve;
            }
        }
        Some(Maximiser {
            tau,
            negative: last.place.negative,
        })
    }

    /// Stores the position that a search has found.
    pub(super) fn learn(&mut self, speed: S, peak: &Peak<S>) {
        let [found, ..] = peak.places;
        let [last, second, _] = self.known;
        let Some(place) = found else {
            *self = Self::new();
            return;
        };
        let known = Some(Known { speed, place });
        self.known = match last {
            // The sweep repeats its last point. The new position replaces the old one.
            Some(last) if last.speed == speed => [known, second, None],
            // The position has jumped, so that the older ones no longer predict it.
            Some(last) if last.place.negative != place.negative => [known, None, None],
            _ => [known, last, second],
        };
    }
}

impl<S: Float> Known<S> {
    fn slope_to(&self, other: &Self) -> S {
        (self.place.tau - other.place.tau) / (self.speed - other.speed)
    }
}
