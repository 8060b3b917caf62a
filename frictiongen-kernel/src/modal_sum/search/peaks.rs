//! The largest value so far, and the places where it is taken.

use super::{EQUAL, Maximiser, SAME_MAXIMUM, Search, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// Keeps a maximum, if there is none larger: what it is compared by, what it is, and where.
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

    /// A climber's next place, and whether it is in a half period of the other sign: the motion
    /// goes on there, while the velocity constraint has no meaning beyond its ends.
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

    /// Whether this maximum is known: the end of one half period is the beginning of the next, of the
    /// other sign.
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

    /// The sum over its weight: as far as it is sure, by which places are compared, and as it is.
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
