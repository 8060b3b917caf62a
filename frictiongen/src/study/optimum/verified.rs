//! Checks friction ratios on a fine grid of the band, for scenes with μ > 1.
//!
//! With μ > 1 the motion from rest may reach stick-slip states in narrow ranges of frequency. The first comparison of
//! friction ratios can miss such a range. The amplitudes of the first comparison are therefore lower bounds. The check
//! always takes the friction ratio with the lowest bound. The check first raises this bound to the height of peaks
//! that earlier checks found, and then evaluates the band on the grid. The check ends when no bound is below the
//! lowest amplitude that was checked on the grid.

use super::amplitude::FrictionAmount;
use super::candidates::FrictionCandidate;
use super::look::Closely;
use super::minima::minima;
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned_at, slope, with_slope};
use std::cmp::Ordering;

/// Largest number of friction ratios that one round evaluates on the grid.
const MOST: usize = 24;
/// The search checks a scan point only if its lower bound, divided by the lowest checked amplitude, is below this
/// number. For a minimum between scan points, the search uses the number 1 instead.
const BETTER: f64 = 0.999;
/// Number of rounds in which the search adds friction ratios around the best friction ratio.
const ABOUT: usize = 3;
/// Number of bisections in the search for the smallest friction ratio with an amplitude of 0.
const HALVINGS: u32 = 12;
/// Bound on the work of the bisections for an amplitude of 0, in units of about 10 µs of computing time.
const WORK_OF_TRIVIAL: usize = 100_000;
/// Number of equal pieces into which a round divides the interval on each side of the best friction ratio.
const PARTS: u32 = 4;

/// A friction ratio with a lower bound on its largest amplitude.
struct Bounded {
    at: Scanned,
    /// Number of frequencies that checks on the grid had added before the search computed this lower bound.
    known: usize,
    /// Interval of friction that contains the minimum, if a search found this friction ratio as a minimum. Otherwise
    /// `None`.
    bracket: Option<[f64; 2]>,
}

/// The friction ratios that a search compares, and the lowest amplitude that it has checked on the grid.
struct VerifiedFrictions<'b, 's> {
    band: &'b AmplitudeBand<'s>,
    open: Vec<Bounded>,
    best: Option<Scanned>,
    /// Smallest friction ratio at which a stuck state exists at every frequency of the band.
    locked_from: f64,
    /// The search checks a friction ratio only if its lower bound, divided by the lowest checked amplitude, is below
    /// this number.
    better: f64,
}

impl VerifiedFrictions<'_, '_> {
    fn add(&mut self, at: Scanned, bracket: Option<[f64; 2]>) {
        let known = self.band.learned();
        self.open.push(Bounded { at, known, bracket });
    }

    /// Returns the lowest amplitude that was checked on the grid so far, or infinity if no amplitude was checked.
    fn level(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| best.value)
    }

    /// Returns the index of the friction ratio with the lowest bound, if this bound is below the lowest checked
    /// amplitude.
    fn next(&self) -> Option<usize> {
        let below = self.better * self.level();
        let open = self.open.iter().enumerate();
        let open = open.filter(|(_, of)| !of.at.whole && of.at.complete && of.at.value < below);
        let least = open.min_by(|(_, a), (_, b)| self.order(&a.at, &b.at));
        least.map(|(index, _)| index)
    }

    /// Orders friction ratios by their bounds. A contact that is stuck over the whole band has the same amplitude at
    /// many friction ratios. The first of these is then the one closest to the friction that locks the contact.
    fn order(&self, a: &Scanned, b: &Scanned) -> Ordering {
        let far = |of: &Scanned| (of.beta - self.locked_from).abs();
        let order = a.value.total_cmp(&b.value);
        order.then(far(a).total_cmp(&far(b)))
    }

    /// Checks friction ratios until no bound is below the lowest checked amplitude.
    fn run(&mut self) {
        let mut grids = 0;
        while grids < MOST && !self.band.amplitude.is_spent() {
            let Some(index) = self.next() else {
                break;
            };
            let Some(beta) = self.open.get(index).map(|of| of.at.beta) else {
                break;
            };
            let level = self.level();
            let again = self
                .open
                .get(index)
                .is_some_and(|of| of.known < self.band.learned());
            let at = if again && self.best.is_some() {
                scanned_at(self.band, beta, level)
            } else {
                grids += 1;
                self.evaluated(beta, level)
            };
            if self.band.amplitude.is_spent() && !at.complete {
                break;
            }
            if at.whole && at.value < level {
                self.best = Some(at.clone());
            }
            let known = self.band.learned();
            if let Some(of) = self.open.get_mut(index) {
                of.at = at;
                of.known = known;
            }
        }
    }

    /// Evaluates the whole band on the grid at one friction ratio, until an amplitude exceeds the cutoff. All further
    /// evaluations of the band include the frequencies of the largest peaks.
    fn evaluated(&self, beta: f64, cutoff: f64) -> Scanned {
        let friction = FrictionAmount::Ratio(beta);
        let band = self.band;
        let mut look = band.look(band.open(friction), cutoff, Closely::Whole);
        if look.complete {
            band.add_grid(&mut look, friction, cutoff);
        }
        band.learn_largest(&look);
        let complete = look.complete;
        Scanned {
            whole: complete,
            ..with_slope(beta, look, |peak| slope(band, beta, peak))
        }
    }

    /// Returns the compared friction ratios in ascending order.
    fn scan(&self) -> Vec<Scanned> {
        let mut scan: Vec<Scanned> = self.open.iter().map(|of| of.at.clone()).collect();
        scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
        scan.dedup_by(|a, b| a.beta == b.beta);
        scan
    }

    /// Returns the next lower and the next higher friction ratio among the compared friction ratios. If one of the two
    /// does not exist, returns `beta` in its place.
    fn neighbours(&self, beta: f64) -> [f64; 2] {
        let others = self.open.iter().map(|of| of.at.beta);
        let below = others.clone().filter(|other| *other < beta);
        let above = others.filter(|other| beta < *other);
        [
            below.fold(f64::NEG_INFINITY, f64::max),
            above.fold(f64::INFINITY, f64::min),
        ]
        .map(|other| if other.is_finite() { other } else { beta })
    }

    /// Adds friction ratios around the best friction ratio, up to its neighbours on both sides. Slopes do not predict
    /// the amplitudes between friction ratios, because the amplitude jumps with friction.
    fn add_around(&mut self) {
        let Some(beta) = self.best.as_ref().map(|best| best.beta) else {
            return;
        };
        let level = self.level();
        for end in self.neighbours(beta) {
            for part in 1..PARTS {
                let between = beta + (end - beta) * f64::from(part) / f64::from(PARTS);
                if between != beta && !self.band.amplitude.is_spent() {
                    self.add(scanned_at(self.band, between, level), None);
                }
            }
        }
    }

    /// Adds the minima between the compared friction ratios, in ranges of friction in which the amplitude is smooth.
    fn add_minima(&mut self) {
        let best = self.best.as_ref().map(|best| best.beta);
        for of in minima(self.band, &self.scan(), self.level()) {
            if best != Some(of.at.beta) {
                let at = Scanned {
                    whole: false,
                    ..of.at
                };
                self.add(at, Some(of.bracket));
            }
        }
    }
}

/// Returns the friction ratio with the lowest amplitude on the grid. If the search reaches its bound on work before
/// the first check ends, returns the friction ratio with the lowest lower bound.
pub(super) fn verified(
    band: &AmplitudeBand<'_>,
    scan: &mut Vec<Scanned>,
    locked_from: f64,
) -> Option<FrictionCandidate> {
    let mut checks = VerifiedFrictions {
        band,
        open: Vec::new(),
        best: None,
        locked_from,
        better: BETTER,
    };
    for at in scan.drain(..) {
        checks.add(Scanned { whole: false, ..at }, None);
    }
    checks.run();
    for _ in 0..ABOUT {
        checks.add_around();
        checks.run();
    }
    if 0.0 < checks.level() {
        checks.better = 1.0;
        checks.add_minima();
        checks.run();
    }
    *scan = checks.scan();
    let complete = scan.iter().filter(|at| at.complete && at.value.is_finite());
    let lowest = complete.min_by(|a, b| checks.order(a, b)).cloned();
    let mut at = checks.best.clone().or(lowest)?;
    if at.value == 0.0 {
        band.amplitude.allow(WORK_OF_TRIVIAL);
        at = least_trivial(band, scan, at);
    }
    let found = checks.open.iter().find(|of| of.at.beta == at.beta);
    let bracket = found.and_then(|of| of.bracket);
    let bracket = bracket.unwrap_or_else(|| checks.neighbours(at.beta));
    Some(FrictionCandidate { at, bracket })
}

/// Returns the smallest friction ratio with an amplitude of 0. The amplitude at the friction ratio of `at` is 0.
fn least_trivial(band: &AmplitudeBand<'_>, scan: &[Scanned], at: Scanned) -> Scanned {
    let moves = scan.iter().filter(|other| !(other.value == 0.0));
    let below = moves
        .map(|other| other.beta)
        .filter(|other| *other < at.beta);
    let (mut from, mut to) = (below.fold(0.0, f64::max), at);
    for _ in 0..HALVINGS {
        let here = scanned_at(band, 0.5 * (from + to.beta), 0.0);
        if here.complete && here.value == 0.0 {
            to = here;
        } else {
            from = here.beta;
        }
    }
    to
}

/// Recomputes the amplitude of each scanned friction ratio whose amplitude is at most `level`, and keeps the larger
/// amplitude. The earlier amplitude is only a lower bound. The new evaluation includes the frequencies of the peaks
/// that the checks on the grid found.
pub(super) fn raise(band: &AmplitudeBand<'_>, scan: &mut [Scanned], level: f64) {
    for seen in scan
        .iter_mut()
        .filter(|seen| seen.complete && seen.value <= level)
    {
        let again = scanned_at(band, seen.beta, level);
        if seen.value < again.value {
            *seen = again;
        }
    }
}
