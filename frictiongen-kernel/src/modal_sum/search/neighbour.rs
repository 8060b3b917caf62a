//! What a search learns from searches at frequency ratios beside its own: where to look first.

use super::{Maximiser, Peak};
use crate::number::scalar::Float;

/// Where the last searches of a sweep found their largest values.
///
/// A search that is given one begins at the place that the last ones lead to; it then proves that nothing larger remains,
/// as every search does.  A wrong place costs some evaluations, and no answer.
///
/// One serves the motion of one mass of one scene; see
/// [`Motion::largest_near`](crate::response::motion::Motion::largest_near).
#[derive(Clone, Copy, Debug, Default)]
pub struct Neighbour<S> {
    /// The latest first.
    known: [Option<Known<S>>; 3],
}

/// A place, and where in the sweep it was.
#[derive(Clone, Copy, Debug)]
struct Known<S> {
    /// The fastest mode's speed, which goes with 1/r.
    speed: S,
    place: Maximiser<S>,
}

impl<S: Float> Neighbour<S> {
    /// Knows nothing: the first search of a sweep is as any other.
    #[must_use]
    pub fn new() -> Self {
        Self { known: [None; 3] }
    }

    /// Where the largest value is expected: on the parabola through the last places, the line, or at the last one.
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

    /// Takes up what a search has found.
    pub(super) fn learn(&mut self, speed: S, peak: &Peak<S>) {
        let [found, ..] = peak.places;
        let [last, second, _] = self.known;
        let Some(place) = found else {
            *self = Self::new();
            return;
        };
        let known = Some(Known { speed, place });
        self.known = match last {
            // The same place of the sweep once more.
            Some(last) if last.speed == speed => [known, second, None],
            // A jump: what was known leads elsewhere.
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
