//! Finds the best common friction together with the best shares of several contacts.

use super::band::{Band, Closely, KeepGoing, Merit};
use super::evaluator::{FrictionAmount, Goal};
use super::problem::OptimumProblem;
use super::{Optimum, OptimumEnd, OptimumError, OptimumRequest, WORK};
use crate::study::joined::JoinedError;
use crate::study::system::System;

/// First step of the search. A step is a factor on a share or on the friction.
const FIRST: f64 = 1.6;
/// Lower bound of the steps. The search ends when the next step is not above this bound.
const LAST: f64 = 1.02;
/// Number of compared distributions (friction and shares) after which the search begins no further pass over all
/// numbers.
const MOST: usize = 400;

/// Interval of the values that a search for the best shares may give to the share of one contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShareRange {
    /// Index of the contact in the scene description.
    pub contact: usize,
    /// Smallest share of the common friction that the contact may have. It is above 0.
    pub from: f64,
    /// Largest share of the common friction that the contact may have.
    pub to: f64,
}

/// Result of a search for the best common friction and the best shares of the contacts.
#[derive(Clone, Debug)]
pub struct SharesOptimum {
    /// The best share of each contact, in the order of the scene description.
    pub shares: Vec<f64>,
    /// The best common friction with these shares.
    pub optimum: Optimum,
    /// The largest amplitude over the band with the best common friction and the shares of the scene description.
    pub before: f64,
}

impl System {
    /// Returns the indices of the contacts whose shares a name selects. `share pads` selects one contact. `share` selects
    /// all contacts but the first, because a common factor on all shares has the effect of the common friction. Returns
    /// `None` for another name, and for a scene with a single contact.
    ///
    /// # Errors
    /// The reason in words, if there is no such contact.
    #[doc(hidden)]
    pub fn shares_named(&self, name: &str) -> Result<Option<Vec<usize>>, String> {
        let mut words = name.split_whitespace();
        if !self.scene().is_joined() || words.next() != Some("share") {
            return Ok(None);
        }
        let contacts = self.scene().named_contacts();
        let names = || contacts.iter().map(|contact| contact.name.as_str());
        let name: Vec<&str> = words.collect();
        if name.is_empty() {
            return Ok(Some((1..contacts.len()).collect()));
        }
        let name = name.join(" ");
        let found = names().position(|contact| contact == name);
        let found = found.ok_or_else(|| {
            let known = names().collect::<Vec<_>>().join(", ");
            format!("there is no contact `{name}`; the contacts are {known}")
        });
        Ok(Some(vec![found?]))
    }

    /// Finds the common friction and the shares with which the largest amplitude of a mass over a band of frequencies is
    /// smallest. The search calls `watch` after each steady state, and ends with the best result so far if `watch`
    /// returns false.
    ///
    /// The search begins at the best common friction with the shares of the scene description. In each round, it
    /// multiplies or divides the friction and then each share by a factor, and keeps every change that reduces the
    /// largest amplitude. If a round has reduced this amplitude, the search also tries all changes of the round a second
    /// time, together. Otherwise it reduces the factor, from 1.6 down to 1.02.
    ///
    /// The result is a local minimum. Another distribution far from the description may be better.
    ///
    /// # Errors
    /// Same errors as [`optimum`](System::optimum). [`JoinedError::Shares`] for an interval that does not begin above 0,
    /// does not end above its start, or is not finite, and for a contact that does not exist.
    #[doc(hidden)]
    pub fn best_shares(
        &self,
        request: &OptimumRequest,
        ranges: &[ShareRange],
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<SharesOptimum, OptimumError> {
        let contacts = self.scene().named_contacts().into_iter();
        let given: Vec<f64> = contacts.map(|contact| contact.law.share).collect();
        for range in ranges {
            let sound = 0.0 < range.from && range.from < range.to && range.to.is_finite();
            if !sound || given.len() <= range.contact {
                return Err(JoinedError::Shares.into());
            }
        }
        let mut problem = OptimumProblem::new(self, request)?.watched_by(watch);
        let goal = Goal::one(problem.objective);
        let before = problem.found(goal.clone(), WORK, None)?;
        let mut descent = Descent {
            band: problem.band(goal.clone()),
            problem: &problem,
            ranges,
            compared: 0,
            best: Distribution {
                shares: given,
                friction: before.least.at.beta,
                merit: before.least.at.merit,
            },
        };
        if watch() {
            descent.run();
        }
        let (best, asked) = (descent.best, descent.band.asked.get());
        problem.joined = problem
            .joined
            .map(|joined| joined.with_shares(&best.shares));
        let stopped = !watch();
        let quiet: KeepGoing<'_> = &|| true;
        if stopped {
            problem = problem.watched_by(quiet);
        }
        let found = problem.found(goal, WORK, None)?;
        let optimum = problem.told(found, true)?;
        Ok(SharesOptimum {
            shares: best.shares,
            optimum: Optimum {
                end: if stopped {
                    OptimumEnd::Stopped
                } else {
                    optimum.end
                },
                evaluations: asked + before.band.asked.get() + optimum.evaluations,
                ..optimum
            },
            before: before.least.at.merit.value,
        })
    }
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
        let goal = Goal::one(self.problem.objective);
        self.band.evaluator = self.problem.evaluator(goal, Some(&tried.shares));
        let friction = FrictionAmount::Ratio(tried.friction);
        let look = self.band.look(friction, cutoff, Closely::Grid);
        match look.complete {
            true => look.merit,
            false => Merit::WORST,
        }
    }
}
