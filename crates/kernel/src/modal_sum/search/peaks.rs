//! Record of the largest value that a search has found so far, and of its positions.

use super::{EQUAL, Maximiser, MaximumSearch, SAME_MAXIMUM, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

impl<S: Float, D: Decay<S>> MaximumSearch<'_, S, D> {
    /// Records a local maximum if its value is at least the largest value found so far, apart from rounding. `best` is
    /// the value minus its possible rounding error, and serves for this comparison. If `best` is larger, the value
    /// `kept` becomes the largest value.
    pub(super) fn keep(&mut self, best: S, kept: S, place: Maximiser<S>) {
        let share = S::constant(1.0 - EQUAL * S::RESOLUTION);
        if self.peak.value < best {
            if self.peak.value < best * share {
                self.peak.places = [None; 4];
            }
            self.peak.value = kept;
            self.note(place);
        } else if self.peak.value * share <= best {
            self.note(place);
        }
    }

    /// Moves a position that a Newton step has found into the half period. The flag is true if the position was in the
    /// next or the previous half period, in which a motion continues with the opposite sign. The velocity constraint is
    /// defined only within the half period. For the velocity constraint, the function therefore clamps the position to
    /// the half period.
    pub(super) fn moved(&self, tau: S) -> (S, bool) {
        let (zero, end) = (S::constant(0.0), self.problem.end);
        match self.problem.weight {
            Weight::One if tau < zero => (tau + end, true),
            Weight::One if end < tau => (tau - end, true),
            Weight::One | Weight::Sine => (tau.max(zero).min(end), false),
        }
    }

    fn note(&mut self, place: Maximiser<S>) {
        if self.knows(place) {
            return;
        }
        if let Some(free) = self.peak.places.iter_mut().find(|slot| slot.is_none()) {
            *free = Some(place);
        }
    }

    /// Returns true if the search has already recorded the maximum at a position. The end of a half period and the
    /// start of the next half period are the same instant. In the next half period, a motion has the opposite sign.
    fn knows(&self, place: Maximiser<S>) -> bool {
        let near = S::constant(SAME_MAXIMUM);
        self.peak.places.iter().flatten().any(|known| {
            let distance = (known.tau - place.tau).abs();
            if known.negative == place.negative {
                distance < near
            } else {
                self.problem.weight == Weight::One && self.problem.end - distance < near
            }
        })
    }

    /// Returns the modal sum, or sum/sin τ, as a pair of numbers. The first number is the value minus its possible
    /// rounding error, and serves for comparisons. The second number is the value itself.
    pub(super) fn quotient_at(&self, value: S, sine: S, cosine: S, negative: bool) -> (S, S) {
        let value = if negative { -value } else { value };
        match self.problem.weight {
            Weight::One => (value, value),
            Weight::Sine if S::constant(0.0) < sine => {
                let quotient = value / sine - self.signed(S::constant(0.0), negative);
                let doubt = self.noise(cosine) / sine;
                (quotient - doubt, quotient)
            }
            Weight::Sine => (self.problem.floor, self.problem.floor),
        }
    }
}
