//! Climbing to a maximum, and keeping those that are equal.

use super::{APART, EQUAL, Maximiser, Search, Weight};
use crate::modal_sum::wave::Local;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// So often may a step of Newton's method, so near a maximum that values do not tell, fail to be half of the
/// one before: while the curvature still changes once or twice.
const MAX_STALLS: u32 = 3;

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// Newton's method on the quotient's derivative, never downhill.
    pub(super) fn climb(&mut self, tau: S, local: Local<S>, negative: bool) {
        let zero = S::constant(0.0);
        let half = S::constant(0.5);
        let (mut tau, mut local, mut negative) = (tau, local, negative);
        let (mut best, mut kept) = self.quotient(&local, negative);
        let mut trust = S::constant(0.25);
        let narrow = S::constant(1e-3) * self.sum.unit();
        let (mut last, mut stalls) = (S::pi(), 0);
        for _ in 0..60 {
            let (slope, curvature) = self.ascent(&local, negative);
            let newton = if curvature < zero {
                -(slope / curvature)
            } else {
                trust.copysign(slope)
            };
            let step = newton.max(-trust).min(trust);
            let (next, flipped) = self.moved(tau + step);
            // Where the slope is 0 at a minimum, any step rises.
            if next == tau || (slope == zero && !(zero < curvature)) {
                // The same place, but by one more step of how it moves with what it depends on.
                tau = next;
                break;
            }
            let (at_next, _) = self.local(next);
            let (value, whole) = self.quotient(&at_next, negative != flipped);
            // So near a maximum the values no longer tell, while Newton's method still converges.
            let near = curvature < zero && step.abs() < narrow;
            let promise = slope * step + curvature.max(zero) * step * step * half;
            let untold = self.untold(best, value, promise);
            let better = near
                || if untold {
                    self.rises_on(&at_next, negative != flipped, slope)
                } else {
                    best <= value
                };
            // Rounding of the slope goes on for ever.
            let small = step.abs() < S::constant(0.125) * self.sum.unit();
            stalls += u32::from(untold && small && last * half < step.abs());
            if stalls == MAX_STALLS {
                break;
            }
            if !better {
                trust = step.abs() * half;
                continue;
            }
            (tau, local, negative) = (next, at_next, negative != flipped);
            if best < value {
                (best, kept) = (value, whole);
            }
            if near && step.abs() < S::constant(4.0 * S::RESOLUTION) * self.sum.unit() {
                break;
            }
            last = step.abs();
        }
        self.keep(best, kept, Maximiser { tau, negative });
        self.choose_tail();
    }

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
        let (zero, end) = (S::constant(0.0), self.question.end);
        match self.question.weight {
            Weight::One if tau < zero => (tau + end, true),
            Weight::One if end < tau => (tau - end, true),
            Weight::One | Weight::Sine => (tau.max(zero).min(end), false),
        }
    }

    /// Keeps an equal maximum elsewhere, for the phase.
    pub(super) fn note_tie(&mut self, tau: S, local: Local<S>, negative: bool) {
        if self.question.weight == Weight::Sine {
            return;
        }
        let (value, _) = self.quotient(&local, negative);
        let equal = self.peak.value * S::constant(1.0 - EQUAL * S::RESOLUTION);
        if equal < value && !self.knows(Maximiser { tau, negative }) {
            self.climb(tau, local, negative);
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
        let near = S::constant(APART);
        self.peak.places.iter().flatten().any(|known| {
            let apart = (known.tau - place.tau).abs();
            if known.negative == place.negative {
                apart < near
            } else {
                self.question.weight == Weight::One && self.question.end - apart < near
            }
        })
    }

    /// Whether values say nothing about a step of so much promise: the place of a maximum is where the
    /// slope vanishes, and needs more digits than the value has.
    fn untold(&self, best: S, value: S, promise: S) -> bool {
        let rounding =
            (S::constant(EQUAL * S::RESOLUTION) * best).max(S::constant(8.0) * self.rounding);
        self.question.weight == Weight::One && promise <= rounding && best - value <= rounding
    }

    /// Where values do not tell: whether it still rises the same way, or falls less steeply than it rose.
    fn rises_on(&self, local: &Local<S>, negative: bool, slope: S) -> bool {
        let (here, _) = self.ascent(local, negative);
        (S::constant(0.0) < here) == (S::constant(0.0) < slope) || here.abs() <= slope.abs()
    }

    fn quotient(&self, local: &Local<S>, negative: bool) -> (S, S) {
        self.quotient_at(local.value, local.sine, local.cosine, negative)
    }

    /// The sum over its weight: as far as it is sure, by which places are compared, and as it is.
    pub(super) fn quotient_at(&self, value: S, sine: S, cosine: S, negative: bool) -> (S, S) {
        let value = if negative { -value } else { value };
        match self.question.weight {
            Weight::One => (value, value),
            Weight::Sine if S::constant(0.0) < sine => {
                let quotient = value / sine - self.signed(S::constant(0.0), negative);
                let doubt = self.noise(cosine) / sine;
                (quotient - doubt, quotient)
            }
            Weight::Sine => (self.question.floor, self.question.floor),
        }
    }

    /// The quotient's derivative and its own, times a positive factor.
    fn ascent(&self, local: &Local<S>, negative: bool) -> (S, S) {
        let (slope, curvature) = match self.question.weight {
            Weight::One => (local.slope, local.curvature),
            Weight::Sine => {
                let Local { sine, cosine, .. } = *local;
                (
                    local.slope * sine - local.value * cosine,
                    (local.curvature + local.value) * sine,
                )
            }
        };
        if negative {
            (-slope, -curvature)
        } else {
            (slope, curvature)
        }
    }
}
