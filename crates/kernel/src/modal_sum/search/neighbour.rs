//! Prediction of the position of a maximum from earlier searches at nearby frequency ratios.

use super::{Maximiser, Peak};
use crate::number::scalar::Float;

/// Positions of the largest values that the last searches in a frequency sweep found. From these positions the code
/// predicts the position of the next largest value.
///
/// A search with a `Neighbour` begins at the predicted position. The search then proves that no larger value exists, as
/// a search without a `Neighbour` does. A wrong prediction costs some evaluations, but does not change the result.
///
/// Use a separate `Neighbour` for the motion of each mass of each scene. See
/// [`Motion::largest_near`](crate::response::motion::Motion::largest_near).
#[derive(Clone, Copy, Debug, Default)]
pub struct Neighbour<S> {
    /// Up to three known positions of largest values. The position from the latest search comes first.
    known: [Option<KnownMaximum<S>>; 3],
}

/// Position of a largest value, and the frequency at which a search found it.
#[derive(Clone, Copy, Debug)]
struct KnownMaximum<S> {
    /// Rate x(1 + 2ζ) of the fastest mode. The rate is proportional to 1/r, and therefore identifies the frequency in a
    /// sweep.
    speed: S,
    place: Maximiser<S>,
}

impl<S: Float> Neighbour<S> {
    /// Creates a prediction without known positions. The first search of a sweep then has no predicted position.
    #[must_use]
    pub fn new() -> Self {
        Self { known: [None; 3] }
    }

    /// Extrapolates the position of the largest value to a new frequency. The function uses a parabola through three
    /// known positions, or a line through two. A single position is returned unchanged. Without known positions the
    /// result is `None`.
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

    /// Stores the position that a search has found, as a basis for the next prediction. If the search found no
    /// position, clears all known positions.
    pub(super) fn learn(&mut self, speed: S, peak: &Peak<S>) {
        let [found, ..] = peak.places;
        let [last, second, _] = self.known;
        let Some(place) = found else {
            *self = Self::new();
            return;
        };
        let known = Some(KnownMaximum { speed, place });
        self.known = match last {
            // In this case the sweep repeats its last frequency. The new position then replaces the known position at
            // this frequency.
            Some(last) if last.speed == speed => [known, second, None],
            // In this case the maximum has changed its sign. The older positions then no longer predict the next
            // maximum.
            Some(last) if last.place.negative != place.negative => [known, None, None],
            _ => [known, last, second],
        };
    }
}

impl<S: Float> KnownMaximum<S> {
    fn slope_to(&self, other: &Self) -> S {
        (self.place.tau - other.place.tau) / (self.speed - other.speed)
    }
}
