//! Finds the largest amplitude over a band of frequencies at one friction.
//!
//! The search evaluates the amplitude on a grid of frequencies, which is closer near the resonances of the chain with
//! every set of stuck contacts. It refines each local maximum that may be the largest. Later searches at other frictions
//! begin with the frequencies of the largest amplitudes.

use super::evaluator::{Answer, Evaluator, FrictionAmount, Goal, OneContact};
use super::objective::Objective;
use crate::study::golden;
use crate::study::system::System;
use crate::{Of, Regime};
use std::cell::{Cell, RefCell};

/// Number of intervals of the geometric grid over the band.
const GRID: usize = 72;
/// Largest odd fraction of a resonance near which a stick-slip motion may have a maximum.
const FRACTIONS: [f64; 4] = [3.0, 5.0, 7.0, 9.0];
/// Smallest relative distance between two frequencies that the grid takes beside resonances.
const APART: f64 = 1e-3;
/// Relative distance of the frequencies of the finer grid.
const FINE: f64 = 0.0025;
/// Largest number of frequencies of the finer grid.
const MOST_FINE: f64 = 2000.0;
/// Largest excess of the friction over β*_lim, relative to β*_lim, at which the finer grid divides its intervals.
const NEAR_STUCK: f64 = 0.02;
/// Number of parts into which the finer grid divides such an interval.
const PARTS: u32 = 40;
/// Largest number of frequencies from such intervals.
const MOST_PARTS: usize = 1200;
/// Number of rounds in which the search evaluates the finer grid.
const SPREAD: usize = 8;
/// The search refines a maximum if its amplitude, divided by the largest amplitude, is at least this.
const WORTH: f64 = 0.75;
/// The search refines a maximum precisely if its amplitude, divided by the largest amplitude, is at least this.
const WORTH_FINELY: f64 = 0.95;
/// Largest number of local maxima that the search refines.
const MOST_TOPS: usize = 10;
/// Relative tolerance in r of a maximum, as long as the largest maximum is not known.
const ROUGHLY: f64 = 1e-3;
/// Relative tolerance in r of a maximum, if the search only compares frictions.
const NEARLY: f64 = 1e-5;
/// Relative tolerance in r of a maximum.
pub(super) const FINELY: f64 = 1e-9;
/// A search that follows known maxima omits those whose amplitude, divided by the largest, is below this.
const NEAR_TOP: f64 = 0.7;
/// Smallest amplitude that counts as infinite. On an undamped resonance of the chain with its contacts stuck, only
/// rounding bounds the amplitude.
const POLE: f64 = 1e9;
/// The search omits a frequency of the grid whose largest expected amplitude, divided by the largest amplitude so far, is
/// below `WORTH`. The expected amplitude is the latest known one, times this factor, times (β/β′)³ or (β′/β)³, where β′
/// is the friction of the latest known amplitude.
const GROWTH: f64 = 1.5;
/// The finer grid omits frequencies between two frequencies of the grid whose amplitudes, divided by the largest
/// amplitude, are below this.
const LOW: f64 = 0.4;
/// First step in r, divided by r, of the search for a maximum whose frequency at a similar friction is known.
const STEP: f64 = 2e-3;
/// Largest number of frequencies that the grid takes from maxima.
const MOST_LEARNED: usize = 60;
/// Relative difference between amplitudes that rounding may cause.
const ROUNDING: f64 = 1e-13;

/// A function that a search calls after each evaluation. It returns false to stop the search.
pub(in crate::study) type KeepGoing<'s> = &'s (dyn Fn() -> bool + Sync);

/// The quality of a friction. Smaller is better. First counts the excess over the bounds, then the amplitude.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Merit {
    /// The largest quotient of a quantity and its bound, minus 1; 0 if the bounds hold.
    pub excess: f64,
    /// The largest amplitude over the band.
    pub value: f64,
}

impl Merit {
    /// The merit that is worse than every other merit.
    pub const WORST: Self = Self {
        excess: f64::INFINITY,
        value: f64::INFINITY,
    };

    fn new(value: f64, bound: f64) -> Self {
        let excess = (bound - 1.0).max(0.0);
        Self { excess, value }
    }

    /// Returns a merit that is worse by a factor.
    pub fn times(self, factor: f64) -> Self {
        match self.excess {
            0.0 => Self {
                value: self.value * factor,
                ..self
            },
            excess => Self {
                excess: excess * factor,
                value: f64::INFINITY,
            },
        }
    }

    /// Returns true if a friction with this answer at one frequency is certainly worse than this merit.
    fn excludes(&self, answer: &Answer) -> bool {
        let excess = (answer.bound - 1.0).max(0.0);
        self.excess < excess || (self.excess == 0.0 && self.value < answer.value)
    }
}

/// A frequency ratio with its answer.
type Point = (f64, Answer);

/// A local maximum of the amplitude over frequency.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct BandPeak {
    pub r: f64,
    pub value: f64,
    pub regime: Regime,
    /// True if the frequency is a bound of the band.
    pub edge: bool,
}

/// The amplitudes over the band at one friction.
#[derive(Clone, Debug)]
pub(super) struct Look {
    pub beta: f64,
    pub merit: Merit,
    /// The largest quotient of a quantity and its bound.
    pub bound: f64,
    /// The local maxima, the highest first.
    pub peaks: Vec<BandPeak>,
    /// False if the search ended because an amplitude exceeded the cutoff. The merit is then a lower bound.
    pub complete: bool,
    /// Frequency ratios at which the motion does not settle.
    pub unsettled: Vec<f64>,
}

impl Look {
    fn new(beta: f64) -> Self {
        Self {
            beta,
            merit: Merit::new(0.0, 0.0),
            bound: 0.0,
            peaks: Vec::new(),
            complete: false,
            unsettled: Vec::new(),
        }
    }
}

/// How closely the search looks at the band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closely {
    /// Only the grid and its maxima.
    Grid,
    /// In addition a finer grid, with steps of 0.25 %, or smaller steps where the contacts can just stick.
    Whole,
}

/// A frequency of the grid, with the latest friction and quotient there.
#[derive(Clone, Copy, Debug)]
struct Place {
    r: f64,
    beta: f64,
    value: f64,
}

impl Place {
    fn new(r: f64) -> Self {
        Self {
            r,
            beta: f64::NAN,
            value: f64::INFINITY,
        }
    }

    /// Returns the largest amplitude to expect at another friction.
    fn promise(&self, beta: f64) -> f64 {
        let ratio = beta / self.beta;
        let growth = GROWTH * ratio.max(1.0 / ratio).powi(3);
        if growth.is_finite() {
            self.value * growth
        } else {
            f64::INFINITY
        }
    }
}

/// A band of frequencies, with the frequencies at which the search evaluates the amplitude.
pub(in crate::study) struct Band<'s> {
    pub(super) evaluator: Box<dyn Evaluator + 's>,
    pub(super) ends: [f64; 2],
    /// Frequencies of the grid in ascending order.
    grid: RefCell<Vec<Place>>,
    learned: Cell<usize>,
    /// Number of evaluations of the amplitude so far.
    pub(super) asked: Cell<usize>,
    /// Number of evaluations without a result.
    pub(super) silent: Cell<usize>,
    work: Cell<usize>,
    most: Cell<usize>,
    /// True if all evaluations follow the motion from rest, even where the closed form of a sliding contact exists.
    pub(super) follows: Cell<bool>,
    pub(super) watch: Cell<Option<KeepGoing<'s>>>,
    pub(super) stopped: Cell<bool>,
}

impl<'s> Band<'s> {
    pub(super) fn new(evaluator: Box<dyn Evaluator + 's>, ends: [f64; 2]) -> Self {
        let grid = grid(&*evaluator, ends);
        Self {
            evaluator,
            ends,
            grid: RefCell::new(grid.into_iter().map(Place::new).collect()),
            learned: Cell::new(0),
            asked: Cell::new(0),
            silent: Cell::new(0),
            work: Cell::new(0),
            most: Cell::new(usize::MAX),
            follows: Cell::new(false),
            watch: Cell::new(None),
            stopped: Cell::new(false),
        }
    }

    /// Returns the local maxima of a displacement over a band of frequencies, in descending order, at the friction ratio
    /// β.
    pub(in crate::study) fn peaks_of(
        system: &'s System,
        of: Of,
        ends: [f64; 2],
        beta: f64,
    ) -> Vec<BandPeak> {
        let goal = Goal::one(Objective::displacement(of));
        let band = Self::new(Box::new(OneContact::new(system, goal)), ends);
        band.check(beta, Merit::WORST, usize::MAX).peaks
    }

    /// Returns the grid's frequency ratios.
    pub(super) fn frequencies(&self) -> Vec<f64> {
        self.grid.borrow().iter().map(|place| place.r).collect()
    }

    /// Sets the bound on the work of all evaluations to the work done so far plus `work`. Returns the earlier bound.
    pub(super) fn allow(&self, work: usize) -> usize {
        self.most.replace(self.work.get().saturating_add(work))
    }

    /// Evaluates the whole band at one friction within an own bound on work, and follows all motions from rest.
    pub(super) fn check(&self, beta: f64, cutoff: Merit, work: usize) -> Look {
        let before = (self.allow(work), self.follows.replace(true));
        let look = self.look(FrictionAmount::Ratio(beta), cutoff, Closely::Whole);
        self.most.set(before.0);
        self.follows.set(before.1);
        look
    }

    /// Returns true if the evaluations have reached their bound on work, or if the caller has stopped the search.
    pub(super) fn is_spent(&self) -> bool {
        self.most.get() <= self.work.get() || self.stopped.get()
    }

    pub(super) fn at(&self, r: f64, friction: FrictionAmount) -> Answer {
        let mut answer = self.evaluator.answer(r, friction, self.follows.get());
        if POLE < answer.value {
            answer.value = f64::INFINITY;
        }
        self.asked.set(self.asked.get() + 1);
        self.work.set(self.work.get().saturating_add(answer.work));
        if answer.value.is_nan() {
            self.silent.set(self.silent.get() + 1);
        }
        if let Some(watch) = self.watch.get()
            && !watch()
        {
            self.stopped.set(true);
        }
        answer
    }

    /// Evaluates the band at one friction. The call ends early if the friction is certainly worse than `cutoff`.
    pub(super) fn look(&self, friction: FrictionAmount, cutoff: Merit, closely: Closely) -> Look {
        let mut look = Look::new(match friction {
            FrictionAmount::Ratio(beta) => beta,
            FrictionAmount::Locked => f64::INFINITY,
        });
        let mut points: Vec<Point> = Vec::new();
        let mut most = 0.0_f64;
        for place in self.order() {
            if closely == Closely::Grid && place.promise(look.beta) < WORTH * most {
                continue;
            }
            let answer = self.noted(place.r, friction, (&mut look, &mut points));
            most = most.max(answer.value).max(answer.bound);
            if self.is_spent() || cutoff.excludes(&answer) {
                return self.ended(look, &points);
            }
        }
        if closely == Closely::Whole {
            for r in self.finer(&mut points, LOW * most, look.beta) {
                let answer = self.noted(r, friction, (&mut look, &mut points));
                if self.is_spent() || cutoff.excludes(&answer) {
                    self.learn(r);
                    return self.ended(look, &points);
                }
            }
        }
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found = Vec::new();
        let quantities: [fn(&Answer) -> f64; 2] = [|answer| answer.value, |answer| answer.bound];
        for of in quantities {
            match self.refined(&points, friction, (of, cutoff, closely)) {
                Ok(more) => found.extend(more),
                Err(more) => {
                    points.extend(more);
                    return self.ended(look, &points);
                }
            }
        }
        look.complete = true;
        points.extend(found);
        self.ended(look, &points)
    }

    /// Completes the result with the answers at some frequencies.
    fn ended(&self, mut look: Look, points: &[Point]) -> Look {
        let most = |of: fn(&Answer) -> f64| {
            let values = points.iter().map(|(_, answer)| of(answer));
            values.fold(0.0, f64::max)
        };
        look.bound = most(|answer| answer.bound);
        look.merit = Merit::new(most(|answer| answer.value), look.bound);
        let mut points = points.to_vec();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        for index in tops(&points, |answer| answer.value) {
            if let Some((r, answer)) = points.get(index) {
                look.peaks.push(self.peak(*r, answer));
            }
        }
        look.peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
        if look.complete {
            for peak in look.peaks.iter().take(3) {
                if WORTH_FINELY * look.merit.value <= peak.value {
                    self.learn(peak.r);
                }
            }
        }
        look
    }

    /// Refines the local maxima of a quantity that may be the largest: first all roughly, then the highest precisely.
    /// Returns the refined points, as an error if one of them is beyond the cutoff.
    fn refined(
        &self,
        points: &[Point],
        friction: FrictionAmount,
        (of, cutoff, closely): (fn(&Answer) -> f64, Merit, Closely),
    ) -> Result<Vec<Point>, Vec<Point>> {
        let most = points
            .iter()
            .map(|(_, answer)| of(answer))
            .fold(0.0, f64::max);
        if most == 0.0 || most.is_infinite() {
            return Ok(Vec::new());
        }
        let mut worth: Vec<([f64; 2], (f64, Answer))> = Vec::new();
        for index in tops(points, of) {
            let Some((r, answer)) = points.get(index).copied() else {
                continue;
            };
            let side = |side: Option<usize>| side.and_then(|side| points.get(side)).copied();
            let sides = [side(index.checked_sub(1)), side(Some(index + 1))];
            let level = sides.iter().flatten();
            let flat = level
                .clone()
                .all(|(_, side)| of(&answer) - of(side) <= ROUNDING * most);
            if WORTH * most <= of(&answer) && !flat {
                let ends = sides.map(|side| side.map_or(r, |(r, _)| r));
                worth.push((ends, (r, answer)));
            }
        }
        worth.sort_by(|a, b| of(&b.1.1).total_cmp(&of(&a.1.1)));
        worth.truncate(MOST_TOPS);
        let mut most = most;
        let mut found = Vec::new();
        for (ends, top) in &mut worth {
            *top = self.climbed(*ends, *top, friction, (of, ROUGHLY));
            found.push(*top);
            if self.is_spent() || cutoff.excludes(&top.1) {
                self.learn(top.0);
                return Err(found);
            }
            most = most.max(of(&top.1));
            let [a, b] = *ends;
            let near = 3.0 * ROUGHLY * top.0;
            *ends = [a.max(top.0 - near), b.min(top.0 + near)];
        }
        // A maximum may be a corner. A rough search would then put a quantity above its bound.
        let near = match closely {
            Closely::Grid if !self.evaluator.has_bounds() => NEARLY,
            Closely::Grid | Closely::Whole => FINELY,
        };
        for (ends, top) in worth {
            if WORTH_FINELY * most <= of(&top.1) {
                let top = self.climbed(ends, top, friction, (of, near));
                found.push(top);
                if self.is_spent() || cutoff.excludes(&top.1) {
                    self.learn(top.0);
                    return Err(found);
                }
            }
        }
        Ok(found)
    }

    /// Returns the maximum of a quantity between two frequency ratios, from a known point between them.
    fn climbed(
        &self,
        ends: [f64; 2],
        (start, known): (f64, Answer),
        friction: FrictionAmount,
        (of, near): (fn(&Answer) -> f64, f64),
    ) -> (f64, Answer) {
        let mut best = (start, known);
        let value = |r: f64| {
            let answer = self.at(r, friction);
            let value = of(&answer);
            if of(&best.1) < value {
                best = (r, answer);
            }
            if value.is_nan() {
                f64::NEG_INFINITY
            } else {
                value
            }
        };
        if of(&known).is_finite() && ends[0] < ends[1] {
            golden::largest(value, ends, (start, of(&known)), near);
        }
        best
    }

    /// Evaluates a frequency, and adds the answer to the points of an evaluation of the band.
    fn noted(
        &self,
        r: f64,
        friction: FrictionAmount,
        (look, points): (&mut Look, &mut Vec<Point>),
    ) -> Answer {
        let answer = self.at(r, friction);
        let mut grid = self.grid.borrow_mut();
        let index = grid.partition_point(|place| place.r < r);
        if let Some(place) = grid.get_mut(index).filter(|place| place.r == r) {
            place.value = answer.value.max(answer.bound);
            place.beta = look.beta;
        }
        if !answer.is_settled && answer.value.is_finite() {
            look.unsettled.push(r);
        }
        if !answer.value.is_nan() {
            points.push((r, answer));
        }
        answer
    }

    /// Returns the frequencies of the finer grid, without those between two points that are both below `low`.
    fn finer(&self, points: &mut [Point], low: f64, beta: f64) -> Vec<f64> {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [from, to] = self.ends;
        let steps = ((to / from).ln() / FINE).ceil().clamp(200.0, MOST_FINE);
        let fine = (1..steps as u32).map(|place| from * (to / from).powf(f64::from(place) / steps));
        let is_worth = |r: &f64| {
            let index = points.partition_point(|(other, _)| other < r);
            let sides = [index.checked_sub(1), Some(index)];
            let mut sides = sides.iter().filter_map(|side| points.get((*side)?));
            sides.any(|(_, side)| low <= side.value.max(side.bound))
        };
        let fine: Vec<f64> = fine.filter(is_worth).collect();
        // If the bound on work ends the evaluation early, its frequencies are spread over the band.
        let spread = |all: &[f64], rounds: usize| -> Vec<f64> {
            let rounds = (0..rounds).flat_map(|round| all.iter().skip(round).step_by(rounds));
            rounds.copied().collect()
        };
        let hidden = spread(&self.nearly_sliding(&fine, beta), PARTS as usize);
        let mut all = spread(&fine, SPREAD);
        all.extend(hidden.into_iter().take(MOST_PARTS));
        all
    }

    /// Returns frequencies between those of the finer grid at which all contacts can just stick. With μ > 1 a motion
    /// from rest may slide there for ever. Such motions lie in many ranges that are much narrower than the finer grid.
    fn nearly_sliding(&self, fine: &[f64], beta: f64) -> Vec<f64> {
        if self.evaluator.locks() {
            return Vec::new();
        }
        let limits: Vec<(f64, f64)> = fine
            .iter()
            .map(|r| (*r, self.evaluator.sliding_limit(*r)))
            .collect();
        let sticks = |limit: f64| limit <= beta && beta <= (1.0 + NEAR_STUCK) * limit;
        let mut found = Vec::new();
        for pair in limits.windows(2) {
            let [(a, from), (b, to)] = *pair else {
                continue;
            };
            let crosses = from.min(to) <= beta && beta <= (1.0 + NEAR_STUCK) * from.max(to);
            // An interval between low amplitudes is not part of the finer grid.
            if !crosses || (1.0 + 2.0 * FINE) * a < b {
                continue;
            }
            let part = |part: u32| a + (b - a) * f64::from(part) / f64::from(PARTS);
            let parts = (1..PARTS).map(part);
            found.extend(parts.filter(|r| sticks(self.evaluator.sliding_limit(*r))));
        }
        found
    }

    /// Returns the highest of the maxima next to the given frequency ratios. It is infinite if there is no motion at one
    /// of them.
    pub(super) fn highest_near(&self, beta: f64, seeds: &[f64]) -> f64 {
        let friction = FrictionAmount::Ratio(beta);
        let starts = seeds.iter().map(|seed| (*seed, self.at(*seed, friction)));
        let starts: Vec<Point> = starts.collect();
        if starts.iter().any(|(_, answer)| answer.value.is_nan()) {
            return f64::INFINITY;
        }
        let peaks = worth(starts).into_iter();
        let peaks = peaks.map(|start| self.followed(friction, start, NEARLY).value);
        peaks.fold(0.0, f64::max)
    }

    /// Returns the local maxima of the amplitude that lie nearest to the given frequency ratios, with a relative
    /// tolerance of these.
    pub(super) fn near(&self, beta: f64, seeds: &[f64], tolerance: f64) -> Vec<BandPeak> {
        let friction = FrictionAmount::Ratio(beta);
        let peaks = seeds.iter().map(|seed| {
            let start = (*seed, self.at(*seed, friction));
            self.followed(friction, start, tolerance)
        });
        peaks.collect()
    }

    /// Evaluates only the maxima next to the given frequency ratios. The call ends early if the friction is certainly
    /// worse than `cutoff`.
    pub(super) fn tracked(&self, beta: f64, seeds: &[f64], cutoff: Merit) -> Look {
        let friction = FrictionAmount::Ratio(beta);
        let mut look = Look::new(beta);
        let mut starts: Vec<Point> = Vec::new();
        for seed in seeds {
            let answer = self.at(*seed, friction);
            if self.is_spent() || cutoff.excludes(&answer) {
                look.merit.value = answer.value;
                look.peaks.push(self.peak(*seed, &answer));
                return look;
            }
            starts.push((*seed, answer));
        }
        for start in worth(starts) {
            let peak = self.followed(friction, start, NEARLY);
            look.merit.value = look.merit.value.max(peak.value);
            look.peaks.push(peak);
            if self.is_spent() || cutoff.value < peak.value {
                return look;
            }
        }
        look.peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
        look.complete = true;
        look
    }

    fn followed(
        &self,
        friction: FrictionAmount,
        mut middle: (f64, Answer),
        tolerance: f64,
    ) -> BandPeak {
        let [from, to] = self.ends;
        let inside = |r: f64| r.clamp(from, to);
        let mut width = STEP * middle.0;
        let mut ends = [middle.0; 2];
        // The loop moves towards larger amplitudes until the amplitude is lower on both sides.
        for _ in 0..24 {
            ends = [inside(middle.0 - width), inside(middle.0 + width)];
            let sides = ends.map(|r| (r, self.at(r, friction)));
            let [left, right] = sides;
            let next = if left.1.value > right.1.value {
                left
            } else {
                right
            };
            let rises = middle.1.value < next.1.value;
            if !rises {
                if self.is_edge(middle.0) {
                    return self.peak(middle.0, &middle.1);
                }
                break;
            }
            let edge = self.is_edge(next.0);
            ends = [inside(next.0 - width), inside(next.0 + width)];
            middle = next;
            if edge {
                break;
            }
            width *= 1.6;
        }
        let of: fn(&Answer) -> f64 = |answer| answer.value;
        let (r, answer) = self.climbed(ends, middle, friction, (of, tolerance));
        self.peak(r, &answer)
    }

    fn peak(&self, r: f64, answer: &Answer) -> BandPeak {
        BandPeak {
            r,
            value: answer.value,
            regime: answer.regime,
            edge: self.is_edge(r),
        }
    }

    fn is_edge(&self, r: f64) -> bool {
        let near = |end: &f64| (r - end).abs() <= 4.0 * FINELY * end;
        self.ends.iter().any(near)
    }

    /// Returns the grid in descending order of the latest amplitudes.
    fn order(&self) -> Vec<Place> {
        let mut all = self.grid.borrow().clone();
        all.sort_by(|a, b| b.value.total_cmp(&a.value));
        all
    }

    /// Adds the frequency of a maximum to the grid.
    fn learn(&self, r: f64) {
        let mut grid = self.grid.borrow_mut();
        let place = grid.partition_point(|place| place.r < r);
        let near = |index: Option<usize>| {
            let known = index.and_then(|index| grid.get(index));
            known.is_some_and(|place| (place.r - r).abs() <= 0.1 * APART * r)
        };
        let known = near(Some(place)) || near(place.checked_sub(1));
        if !known && self.learned.get() < MOST_LEARNED {
            grid.insert(place, Place::new(r));
            self.learned.set(self.learned.get() + 1);
        }
    }
}

/// Returns the points near which the highest maximum may be.
fn worth(mut points: Vec<Point>) -> Vec<Point> {
    let most = points
        .iter()
        .map(|(_, answer)| answer.value)
        .fold(0.0, f64::max);
    points.retain(|(_, answer)| NEAR_TOP * most <= answer.value);
    points
}

/// Returns the indices of the local maxima of a quantity. One point represents neighbouring points of equal height.
fn tops(points: &[Point], of: impl Fn(&Answer) -> f64) -> Vec<usize> {
    let value = |place: Option<usize>| {
        let point = place.and_then(|place| points.get(place));
        point.map_or(f64::NEG_INFINITY, |(_, answer)| of(answer))
    };
    let is_top = |index: &usize| {
        let own = value(Some(*index));
        value(index.checked_sub(1)) < own && value(Some(index + 1)) <= own
    };
    (0..points.len()).filter(is_top).collect()
}

/// Returns the frequencies of a band at which the search evaluates the amplitude for every friction.
fn grid(evaluator: &dyn Evaluator, [from, to]: [f64; 2]) -> Vec<f64> {
    let step = |place: usize| (to / from).powf(place as f64 / GRID as f64);
    let mut even: Vec<f64> = (1..GRID).map(|place| from * step(place)).collect();
    even.extend([from, to]);
    let (mut exact, mut beside) = (Vec::new(), Vec::new());
    for [resonance, zeta] in evaluator.resonances() {
        exact.push(resonance);
        if zeta.is_nan() {
            continue;
        }
        let width = zeta.clamp(1e-3, 0.1);
        let sides = [-12.0, -4.0, -1.0, 1.0, 4.0, 12.0].map(|share| 1.0 + share * width);
        beside.extend(sides.map(|share| resonance * share));
        // Exactly on a fraction, an undamped chain has a continuum of steady states.
        beside.extend(FRACTIONS.map(|order| resonance / order * 1.0043));
    }
    // The resonances come first, then the grid, so that neither gives way to a frequency beside a resonance.
    let mut all: Vec<f64> = Vec::new();
    let lists = [(even, 0.0), (exact, 1e-6), (beside, APART)];
    for (list, apart) in lists {
        for r in list {
            let near = |known: &f64| (known - r).abs() <= apart * r;
            if from <= r && r <= to && !all.iter().any(near) {
                all.push(r);
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

#[cfg(test)]
#[allow(clippy::expect_used, reason = "a test may fail")]
mod tests {
    use super::{Band, Closely, FrictionAmount, Goal, Merit, Objective, OneContact};
    use crate::Of;
    use crate::study::System;

    fn band<'s>(system: &'s System, ends: [f64; 2]) -> Band<'s> {
        let goal = Goal::one(Objective::displacement(Of::Mass(0)));
        Band::new(Box::new(OneContact::new(system, goal)), ends)
    }

    /// Checks that the search counts evaluations without a result. In this chain neither the contact nor damping acts
    /// on the second mode. A steady state with stops therefore does not exist.
    #[test]
    fn what_has_no_answer_is_counted() {
        let text = "struct Chain { masses: { a: 1, b: 1, c: 1 }, contact: b - wall, excitation: a,
            springs: { base - a: 1, a - b: 1, b - c: 1, c - wall: 1 } }";
        let system: System = text.parse().expect("a scene");
        let limits = system.at(0.5).expect("r").limits();
        let band = band(&system, [0.4, 0.6]);
        let slides = FrictionAmount::Ratio(0.5 * limits.continuous);
        assert!(band.at(0.5, slides).value.is_finite());
        assert_eq!((band.asked.get(), band.silent.get()), (1, 0));
        let stops = FrictionAmount::Ratio(0.5 * (limits.continuous + limits.sliding));
        for asked in [1, 2] {
            assert!(band.at(0.5, stops).value.is_nan());
            assert_eq!((band.asked.get(), band.silent.get()), (1 + asked, asked));
        }
    }

    /// Checks the peak of a damped mass without friction, 1/(2ζ√(1 − ζ²)) at r = √(1 − 2ζ²), and that an amplitude above
    /// the cutoff ends the evaluation.
    #[test]
    fn the_peak_of_one_mass() {
        let zeta = 0.02_f64;
        let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
            excitation: block, damping: modal(0.02) }";
        let system: System = text.parse().expect("a scene");
        let band = band(&system, [0.3, 3.0]);
        let free = FrictionAmount::Ratio(0.0);
        let look = band.look(free, Merit::WORST, Closely::Whole);
        let expected = 0.5 / (zeta * (1.0 - zeta * zeta).sqrt());
        assert!(
            (look.merit.value / expected - 1.0).abs() < 1e-13,
            "{look:?}"
        );
        let r = look.peaks.first().expect("a peak").r;
        assert!((r - (1.0 - 2.0 * zeta * zeta).sqrt()).abs() < 1e-8, "{r}");
        let cutoff = Merit {
            value: 0.5 * expected,
            ..look.merit
        };
        let before = band.asked.get();
        assert!(!band.look(free, cutoff, Closely::Whole).complete);
        assert_eq!(band.asked.get(), before + 1);
    }
}
