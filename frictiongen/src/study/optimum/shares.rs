//! Finds the best common friction together with the best shares of several contacts.

use super::band::{Band, Closely, Merit};
use super::evaluator::FrictionAmount;
use super::problem::OptimumProblem;
use super::request::{OptimumOptions, Tuning};
use super::{Optimum, OptimumEnd, OptimumError, OptimumRequest, Tunable, TunedNumber};
use crate::study::joined::JoinedParameter;
use crate::study::system::System;

/// First step of the search. A step is a factor on a share or on the friction.
const FIRST: f64 = 1.6;
/// Lower bound of the steps. The search ends when the next step is not above this bound.
const LAST: f64 = 1.02;
/// Number of compared distributions (friction and shares) after which the search begins no further pass over all
/// numbers.
const MOST: usize = 400;

/// Interval of the share of one contact.
struct ShareRange {
    contact: usize,
    from: f64,
    to: f64,
}

/// Returns the intervals of the shares that a request varies.
fn ranges(system: &System, vary: &[Tuning]) -> Result<Vec<ShareRange>, OptimumError> {
    let mut ranges: Vec<ShareRange> = Vec::new();
    for tuning in vary {
        let contact = tuning.of.share().ok_or(OptimumError::Several)?;
        if ranges.iter().any(|range| range.contact == contact) {
            return Err(OptimumError::Several);
        }
        tuning.check(system)?;
        ranges.push(ShareRange {
            contact,
            from: tuning.from,
            to: tuning.to,
        });
    }
    Ok(ranges)
}

/// Finds the common friction and the shares of contacts with which the largest amplitude over a band is smallest.
///
/// The search begins at the best common friction with the shares of the scene description. In each round, it multiplies
/// or divides the friction and then each share by a factor, and keeps every change that reduces the largest amplitude.
/// If a round has reduced this amplitude, the search also tries all changes of the round a second time, together.
/// Otherwise it reduces the factor, from 1.6 down to 1.02.
///
/// The result is a local minimum. Another distribution far from the description may be better.
pub(super) fn best(
    system: &System,
    request: &OptimumRequest,
    options: &OptimumOptions<'_>,
) -> Result<Optimum, OptimumError> {
    let ranges = ranges(system, options.vary)?;
    let goes_on = || options.watch.is_none_or(|watch| watch());
    let problem = OptimumProblem::new(system, request, options)?.watched_by(options.watch);
    let contacts = system.scene().named_contacts().into_iter();
    let (start, before) = match problem.found(problem.work, None) {
        // Other shares may satisfy the bounds.
        Err(OptimumError::Unreachable { .. }) => (problem.free()?, None),
        found => found.map(|found| {
            let before = found.least.at.merit.value;
            (found, Some(before))
        })?,
    };
    let mut descent = Descent {
        band: problem.band(problem.goal(usize::MAX)),
        problem: &problem,
        ranges: &ranges,
        compared: 0,
        best: Distribution {
            shares: contacts.map(|contact| contact.law.share).collect(),
            friction: start.least.at.beta,
            merit: start.least.at.merit,
        },
    };
    if goes_on() {
        descent.run();
    }
    let (best, asked) = (descent.best, descent.band.asked.get());
    let stopped = !goes_on();
    let mut problem = problem.with_shares(&best.shares);
    if stopped {
        problem = problem.watched_by(None);
    }
    let mut optimum = problem.solved()?;
    if stopped {
        optimum.end = OptimumEnd::Stopped;
    }
    optimum.evaluations += asked + start.band.asked.get();
    optimum.before = before;
    let share = |(contact, share): (usize, &f64)| {
        let range = ranges.iter().find(|range| range.contact == contact);
        TunedNumber {
            of: Tunable::Joined(JoinedParameter::Share(contact)),
            value: *share,
            at_end: range.is_some_and(|range| [range.from, range.to].contains(share)),
        }
    };
    optimum.tuned = best.shares.iter().enumerate().map(share).collect();
    Ok(optimum)
}

/// A common friction and the shares of all contacts.
#[derive(Clone, Debug)]
struct Distribution {
    shares: Vec<f64>,
    friction: f64,
    merit: Merit,
}

/// A search that multiplies one number after the other by a factor: first the friction, then each share.
struct Descent<'p, 's> {
    problem: &'p OptimumProblem<'s>,
    band: Band<'s>,
    ranges: &'p [ShareRange],
    compared: usize,
    best: Distribution,
}

impl Descent<'_, '_> {
    fn run(&mut self) {
        let mut start = self.best.clone();
        for range in self.ranges {
            if let Some(share) = start.shares.get_mut(range.contact) {
                *share = share.clamp(range.from, range.to);
            }
        }
        start.merit = self.merit(&start, Merit::WORST);
        // The shares of the scene description may be outside the permitted intervals. The search therefore begins at
        // `start`.
        self.best = start;
        self.descend(FIRST);
    }

    /// Multiplies or divides one number after the other by a factor. If no change gives a smaller peak, reduces the
    /// factor.
    fn descend(&mut self, mut factor: f64) {
        while LAST < factor && self.compared < MOST && !self.band.is_spent() {
            let before = self.best.clone();
            for number in 0..=self.ranges.len() {
                if !self.better(number, factor) {
                    self.better(number, 1.0 / factor);
                }
            }
            if self.best.merit < before.merit {
                self.leap(&before);
            } else {
                factor = factor.sqrt();
            }
        }
    }

    /// Tries the best distribution with one number multiplied by a factor. The number is the friction or a share.
    /// Returns true if the changed distribution is better.
    fn better(&mut self, number: usize, factor: f64) -> bool {
        let mut tried = self.best.clone();
        match number
            .checked_sub(1)
            .and_then(|index| self.ranges.get(index))
        {
            None => tried.friction *= factor,
            Some(range) => {
                let Some(share) = tried.shares.get_mut(range.contact) else {
                    return false;
                };
                let moved = (*share * factor).clamp(range.from, range.to);
                if moved == *share {
                    return false;
                }
                *share = moved;
            }
        }
        self.keep(tried)
    }

    /// Repeats the change from `before` to the best distribution, because this change has reduced the peak. The call
    /// multiplies the friction and each share by their ratio to the value in `before`. It keeps the result if the peak
    /// is smaller.
    fn leap(&mut self, before: &Distribution) {
        let mut tried = self.best.clone();
        tried.friction *= tried.friction / before.friction;
        for range in self.ranges {
            let earlier = before.shares.get(range.contact).copied();
            if let (Some(share), Some(earlier)) = (tried.shares.get_mut(range.contact), earlier) {
                *share = (*share * *share / earlier).clamp(range.from, range.to);
            }
        }
        self.keep(tried);
    }

    /// Stores the distribution `tried` if it is better than the best distribution so far. Returns true if it is better.
    fn keep(&mut self, mut tried: Distribution) -> bool {
        tried.merit = self.merit(&tried, self.best.merit);
        let better = tried.merit < self.best.merit;
        if better {
            self.best = tried;
        }
        better
    }

    /// Returns the merit of a distribution, or a lower bound of it beyond `cutoff`.
    fn merit(&mut self, tried: &Distribution, cutoff: Merit) -> Merit {
        self.compared += 1;
        let goal = self.problem.goal(usize::MAX);
        self.band.evaluator = self.problem.evaluator(goal, Some(&tried.shares));
        let friction = FrictionAmount::Ratio(tried.friction);
        let look = self.band.look(friction, cutoff, Closely::Grid);
        match look.complete {
            true => look.merit,
            false => Merit::WORST,
        }
    }
}
