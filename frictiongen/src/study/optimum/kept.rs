//! The best friction among those that keep other quantities within bounds.
//!
//! Each bound leaves ranges of friction. A grid of friction, which contains the best friction of every quantity, shows
//! the ranges, and bisection finds their ends. The objective is then searched within each range.

use super::amplitude::FrictionAmount;
use super::look::Closely;
use super::objective::{Objective, short};
use super::peaks::AmplitudeBand;
use super::problem::{OptimumProblem, WORK_OF_A_REPORT};
use super::request::OptimumError;
use super::scan::{Scanned, scanned_at};
use super::search::{Least, SearchEnd, least_between};

/// Number of bisections for an end of a range of friction.
const HALVINGS: usize = 30;
/// Work for the ranges of a bound, as a multiple of the work of one search.
const FOR_RANGES: usize = 4;
/// Number of golden sections towards the friction at which the bounds are exceeded least.
const SECTIONS: usize = 40;
/// Larger of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Relative excess of a bound that counts as rounding.
const ROUNDING: f64 = 1e-10;
/// Number of friction ratios that a search adds to the scan of a range.
const INSIDE: u32 = 12;

/// The best friction within the bounds, with the largest value of each bounded quantity.
pub(super) struct Kept {
    pub least: Least,
    pub values: Vec<f64>,
}

/// A bounded quantity over the band, with its largest allowed value.
struct Bound<'s> {
    band: AmplitudeBand<'s>,
    most: f64,
    least: Least,
}

impl Bound<'_> {
    /// Returns the largest value over the band, over the largest allowed value. Values above `cutoff` are lower bounds.
    fn ratio(&self, friction: f64, cutoff: f64) -> f64 {
        let cutoff = cutoff * self.most;
        // The search for the bounded quantity's own optimum knows lower bounds on many values.
        let mut known = self.least.scan.iter();
        let known = known.find(|seen| seen.beta == friction && cutoff < seen.value);
        if let Some(known) = known {
            return known.value / self.most;
        }
        let first = scanned_at(&self.band, friction, cutoff);
        if !first.complete {
            return first.value.max(cutoff * (1.0 + 2.0 * ROUNDING)) / self.most;
        }
        // The first evaluation follows motions at some frequencies only.
        let open = self.band.open(FrictionAmount::Ratio(friction));
        let whole = self.band.look(open, cutoff, Closely::Whole);
        let top = whole.peaks.first();
        if let Some(missed) = top.filter(|top| first.value * (1.0 + ROUNDING) < top.value) {
            self.band.learn(missed.r);
        }
        top.map_or(first.value, |top| top.value.max(first.value)) / self.most
    }
}

/// Returns the best friction within the bounds of a problem.
pub(super) fn least(
    problem: &OptimumProblem<'_>,
    band: &AmplitudeBand<'_>,
    work: usize,
) -> Result<Kept, OptimumError> {
    let work = work / (problem.keep.len() + 2);
    let bound = |(objective, most): &(Objective, f64)| {
        let band = AmplitudeBand::new(problem.system, *objective, problem.ends);
        let least = OptimumProblem::least(&band, work)?;
        band.amplitude.allow(work.saturating_mul(FOR_RANGES));
        Ok::<_, OptimumError>(Bound {
            band,
            most: *most,
            least,
        })
    };
    let bounds: Vec<Bound<'_>> = problem.keep.iter().map(bound).collect::<Result<_, _>>()?;
    let free = OptimumProblem::least(band, work)?;
    if keeps(&bounds, free.at.beta) {
        return Ok(told(&bounds, free));
    }
    let mut grid: Vec<f64> = std::iter::once(&free)
        .chain(bounds.iter().map(|bound| &bound.least))
        .flat_map(|least| {
            least
                .scan
                .iter()
                .map(|seen| seen.beta)
                .chain([least.at.beta])
        })
        .collect();
    grid.sort_by(f64::total_cmp);
    grid.dedup();
    let mut ranges = ranges(&bounds, &grid);
    if ranges.is_empty() {
        let (friction, ratio) = nearest(&bounds, &grid);
        if 1.0 + ROUNDING < ratio {
            return Err(OptimumError::Bounds(contradiction(
                problem, &bounds, friction,
            )));
        }
        ranges.push([friction; 2]);
    }
    let found = ranges.into_iter().filter_map(|range| {
        let [from, to] = range;
        let more = (1..INSIDE).map(|part| from + (to - from) * f64::from(part) / f64::from(INSIDE));
        let seen = free.scan.iter().map(|seen| seen.beta).chain(more);
        least_between(band, work, range, seen)
    });
    let best = found.min_by(|a, b| a.at.value.total_cmp(&b.at.value));
    let best = best.ok_or(OptimumError::TooLong)?;
    Ok(told(&bounds, best))
}

/// Returns true if a friction keeps all bounds.
fn keeps(bounds: &[Bound<'_>], friction: f64) -> bool {
    bounds
        .iter()
        .all(|bound| bound.ratio(friction, 1.0 + ROUNDING) <= 1.0 + ROUNDING)
}

/// Adds the largest values of the bounded quantities at the best friction.
fn told(bounds: &[Bound<'_>], mut least: Least) -> Kept {
    if bounds.iter().any(|bound| bound.band.amplitude.is_spent()) {
        least.end = SearchEnd::Spent;
    }
    let largest = |bound: &Bound<'_>| {
        bound.band.amplitude.allow(WORK_OF_A_REPORT);
        let peaks = bound.band.peaks(FrictionAmount::Ratio(least.at.beta));
        peaks.first().map_or(f64::NAN, |peak| peak.value)
    };
    Kept {
        values: bounds.iter().map(largest).collect(),
        least,
    }
}

/// Returns the ranges of friction that keep the bounds, each between frictions of the grid that do not.
fn ranges(bounds: &[Bound<'_>], grid: &[f64]) -> Vec<[f64; 2]> {
    let kept: Vec<bool> = grid
        .iter()
        .map(|friction| keeps(bounds, *friction))
        .collect();
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    let mut open = None;
    let mut last: Option<(f64, bool)> = None;
    for (friction, kept) in grid.iter().copied().zip(kept) {
        match (last, kept) {
            (None, true) => open = Some(friction),
            (Some((before, false)), true) => open = Some(end(bounds, friction, before)),
            (Some((before, true)), false) => {
                let from = open.take();
                ranges.extend(from.map(|from| [from, end(bounds, before, friction)]));
            }
            _ => {}
        }
        last = Some((friction, kept));
    }
    ranges.extend(open.zip(last).map(|(from, (last, _))| [from, last]));
    ranges
}

/// Returns the last friction that keeps the bounds, between one that does and one that does not.
fn end(bounds: &[Bound<'_>], mut kept: f64, mut lost: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (kept + lost);
        if keeps(bounds, middle) {
            kept = middle;
        } else {
            lost = middle;
        }
    }
    kept
}

/// Returns the friction at which the bounds are exceeded least, with the largest value over its bound.
fn nearest(bounds: &[Bound<'_>], grid: &[f64]) -> (f64, f64) {
    let worst = |friction: f64| {
        let ratios = bounds
            .iter()
            .map(|bound| bound.ratio(friction, f64::INFINITY));
        ratios.fold(0.0, f64::max)
    };
    let ratios: Vec<f64> = grid.iter().map(|friction| worst(*friction)).collect();
    let best = (0..ratios.len()).min_by(|a, b| {
        let ratio = |index: &usize| ratios.get(*index).copied().unwrap_or(f64::INFINITY);
        ratio(a).total_cmp(&ratio(b))
    });
    let best = best.unwrap_or(0);
    let at = |index: usize| grid.get(index).copied();
    let own = at(best).unwrap_or(0.0);
    let mut low = best.checked_sub(1).and_then(at).unwrap_or(own);
    let mut high = at(best + 1).unwrap_or(own);
    let (mut friction, mut ratio) = (own, ratios.get(best).copied().unwrap_or(f64::INFINITY));
    for _ in 0..SECTIONS {
        let (a, b) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
        let (at_a, at_b) = (worst(a), worst(b));
        for (place, value) in [(a, at_a), (b, at_b)] {
            if value < ratio {
                (friction, ratio) = (place, value);
            }
        }
        if at_a < at_b {
            high = b;
        } else {
            low = a;
        }
        if ratio <= 1.0 || high - low <= 1e-9 * high {
            break;
        }
    }
    (friction, ratio)
}

/// Describes bounds that no friction keeps, with the smallest values that can be reached.
fn contradiction(problem: &OptimumProblem<'_>, bounds: &[Bound<'_>], friction: f64) -> String {
    let system = problem.system;
    let scale = problem.load.and_then(|load| system.load_scale(load).ok());
    let force = |friction: f64| match scale {
        Some(scale) => format!("{} N of friction", short(scale.friction(friction))),
        None => format!("a friction ratio of {}", short(friction)),
    };
    let quantity = |bound: &Bound<'_>, value: f64| {
        let objective = bound.band.amplitude.objective;
        let name = objective.name(system);
        (name, objective.written(system, scale, value))
    };
    for bound in bounds {
        let Scanned { value, beta, .. } = bound.least.at;
        if bound.most * (1.0 + ROUNDING) < value {
            let (name, least) = quantity(bound, value);
            let (_, most) = quantity(bound, bound.most);
            let at = force(beta);
            return format!(
                "no friction keeps `{name}` within {most}: its smallest largest value over the band is {least}, with {at}; give a bound of at least that"
            );
        }
    }
    let list = |value: &dyn Fn(&Bound<'_>) -> f64| {
        let all = bounds.iter().map(|bound| {
            let (name, value) = quantity(bound, value(bound));
            format!("`{name}` {value}")
        });
        all.collect::<Vec<_>>().join(" and ")
    };
    let alone = list(&|bound| bound.least.at.value);
    let together = list(&|bound| bound.ratio(friction, f64::INFINITY) * bound.most);
    format!(
        "the bounds contradict each other: the smallest values, each with its own friction, are {alone}; together they come nearest with {}: {together}",
        force(friction)
    )
}
