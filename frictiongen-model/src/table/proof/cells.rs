//! What the cells of a half period have in common: the velocity constraint over a part of the range, as they ask for it.

use super::force;
use super::found::Budget;
use super::stage::{Chain, ORDER, Stage};
use super::witness::{Seen, Witness};
use crate::interval::{Interval, Series};
use std::f64::consts::PI;

/// Steps by which the region about a witness is widened, of the length in which a parabola of its curvature doubles.
const TUBE_STEP: f64 = 0.3;
const TUBE_STEPS: usize = 8;
/// The first step, and all of them, go no farther than these parts of the way to the end of the half period.
const TUBE_FIRST: f64 = 0.2;
const TUBE_MOST: f64 = 0.9;
/// For the roundings of an end of a region.
pub(super) const ROUNDING: f64 = 1e-12;

/// There D must be bent by this share of what it is at the witness, or at a second largest.
pub(super) const BENT: f64 = 0.15;

/// What is known over an interval of r: at its centre, and over all of it.
pub(super) struct Part<'a> {
    pub chain: &'a Chain,
    pub witness: &'a Witness,
    /// The interval less its centre.
    pub away: Interval,
    pub at: &'a Stage<ORDER>,
    pub over: &'a Stage<ORDER>,
    pub seen_at: &'a Seen<ORDER>,
    pub seen_over: &'a Seen<ORDER>,
    /// By which share N exceeds the witness, in √(U² + N²).
    pub share: f64,
}

/// One side of the witness: `share` of the way from an end of the half period to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Flank {
    Before,
    After,
}

/// What is known of a part, with what the cells of its half period ask for.
pub(super) struct Cells<'a> {
    /// The chain at the centre of the part,
    pub thin: Stage<1>,
    /// over the part with its slope in r,
    pub wide: Stage<2>,
    /// and over the part alone.
    pub flat: Stage<1>,
    /// N.
    pub level_at: Series<1>,
    pub level_over: Series<2>,
    pub full_at: Series<ORDER>,
    pub full_over: Series<ORDER>,
    pub path_at: Interval,
    pub path_over: Series<2>,
    pub part: &'a Part<'a>,
}

/// κN: N² + U² is (1 + share)² times that of the witness.
fn level<const N: usize>(seen: &Seen<N>, share: f64) -> Series<N> {
    let share = Interval::point(share);
    let more = share + share + share * share;
    (seen.constraint.squared() + seen.size.times(more)).sqrt()
}

impl<'a> Cells<'a> {
    pub fn of(part: &'a Part<'a>) -> Self {
        let (level_at, level_over) = (
            level(part.seen_at, part.share),
            level(part.seen_over, part.share),
        );
        Self {
            thin: part.at.truncated(),
            wide: part.over.truncated(),
            flat: part.over.truncated(),
            level_at: level_at.truncated(),
            level_over: level_over.truncated(),
            full_at: level_at,
            full_over: level_over,
            path_at: part.seen_at.t.value(),
            path_over: part.seen_over.t.truncated(),
            part,
        }
    }

    /// F over a box, with its slope in r, and F′, F″ and F‴; sine and cosine of τ.
    pub fn boxed(&self, t: Interval) -> (Series<2>, [Interval; 3], (Interval, Interval)) {
        let at = Series::<2>::fixed(t);
        let (sine, cosine) = t.sine_cosine();
        let motions = force::motions(&self.wide, &at);
        let value = force::value(&self.wide, &motions, &Series::fixed(cosine));
        let derivatives = force::derivatives(&self.wide, &motions, (sine, cosine));
        (value, derivatives, (sine, cosine))
    }

    /// F′, F″ and F‴ over a box; sine and cosine of τ.
    pub fn derivatives(&self, t: Interval) -> ([Interval; 3], (Interval, Interval)) {
        let waves = t.sine_cosine();
        let motions = force::motions(&self.flat, &Series::fixed(t));
        (force::derivatives(&self.flat, &motions, waves), waves)
    }

    /// D″ over a box of τ for all r.
    pub fn bend(&self, t: Interval, budget: &mut Budget) -> Interval {
        budget.spend(2 * self.wide.modes.len());
        let level = self.level_over.value();
        let ([_, second, third], (sine, cosine)) = self.derivatives(t);
        let plain = -(level * sine) - second;
        // In the middle, and how it changes from there.
        let middle = Interval::point(t.middle());
        let ([_, second, _], (sine, _)) = self.derivatives(middle);
        let moves = (-(level * cosine) - third) * (t - middle) * Interval::pi();
        plain.both(-(level * sine) - second + moves)
    }

    /// How far before and behind an instant D″ is at least a share of what it is there, and the least that it is.
    pub fn widened(
        &self,
        t: Interval,
        curve: Interval,
        bent: f64,
        budget: &mut Budget,
    ) -> ([f64; 2], f64) {
        let length = TUBE_STEP * (self.level_over.value().high / curve.middle()).sqrt() / PI;
        let (mut least, mut reach) = (curve.low, [0.0_f64; 2]);
        for (place, reach) in reach.iter_mut().enumerate() {
            let room = if place == 0 { t.low } else { 1.0 - t.high };
            let mut step = length.min(TUBE_FIRST * room);
            for _ in 0..TUBE_STEPS {
                let far = *reach + step;
                let all = if place == 0 {
                    Interval::new(t.low - far, t.high - *reach)
                } else {
                    Interval::new(t.low + *reach, t.high + far)
                };
                let bend = self.bend(all, budget).low;
                if far < TUBE_MOST * room && bend > bent * curve.low {
                    least = least.min(bend);
                    *reach = far;
                } else {
                    step *= 0.5;
                }
            }
        }
        (reach, least)
    }

    /// The instant at a share of a side: t over all r, with its slope, and at the centre.
    pub fn instant(&self, side: Flank, share: Interval) -> (Interval, Interval, Interval) {
        let (path, slope) = (self.path_over.value(), self.path_over.term(1));
        match side {
            Flank::Before => (path * share, slope * share, self.path_at * share),
            Flank::After => {
                let rest = |path: Interval| Interval::ONE - (Interval::ONE - path) * share;
                (rest(path), slope * share, rest(self.path_at))
            }
        }
    }
}
