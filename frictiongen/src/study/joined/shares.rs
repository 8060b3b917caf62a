//! Finds the best common friction together with the best shares of the contacts.

use super::error::JoinedError;
use super::optimum::{Early, FrictionSearch, JoinedOptimum};
use super::scene::Joined;
use frictiongen_model::scene::Scene;

/// First step of the search. A step is a factor on a share or on the friction.
const FIRST: f64 = 1.6;
/// Lower bound of the steps. The search ends when the next step is not above this bound. A step is a factor on a share
/// or on the friction.
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
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedDistribution {
    /// The best share of each contact, in the order of the scene description.
    pub shares: Vec<f64>,
    /// The best common friction with these shares.
    pub optimum: JoinedOptimum,
    /// The best common friction with the shares of the scene description.
    pub before: JoinedOptimum,
}

impl<'a> Joined<'a> {
    /// Returns this scene with other shares of the common friction. A contact without a number in `shares` keeps its
    /// share.
    #[must_use]
    pub fn with_shares(&self, shares: &[f64]) -> Self {
        let mut joined = self.clone();
        joined.set_shares(shares);
        joined
    }

    /// Finds the common friction and the shares with which the largest amplitude of a mass over a band of frequency
    /// ratios is smallest. The search calls `watch` before each steady state, and stops if `watch` returns false.
    ///
    /// The search begins at the best common friction with the shares of the scene description. In each round, it
    /// multiplies or divides the friction and then each share by a factor, and keeps every change that reduces the
    /// largest amplitude. If a round has reduced this amplitude, the search also tries all changes of the round a second
    /// time, together. Otherwise it reduces the factor, from 1.6 down to 1.02.
    ///
    /// The result is a local minimum. Another distribution far from the description may be better.
    ///
    /// # Errors
    /// Same errors as [`optimum_watched`](Self::optimum_watched). [`JoinedError::Shares`] for an interval that does
    /// not begin above 0, does not end above its start, or is not finite. [`JoinedError::Shares`] also for a contact
    /// that does not exist.
    pub fn best_shares(
        &self,
        mass: &str,
        band: (f64, f64),
        ranges: &[ShareRange],
        watch: &dyn Fn() -> bool,
    ) -> Result<JoinedDistribution, JoinedError> {
        let given: Vec<f64> = shares(self.scene());
        for range in ranges {
            let sound = 0.0 < range.from && range.from < range.to && range.to.is_finite();
            if !sound || given.len() <= range.contact {
                return Err(JoinedError::Shares);
            }
        }
        let before = self.optimum_watched(mass, band, watch)?;
        let mut descent = Descent {
            search: FrictionSearch::new(self, mass, band, watch)?,
            ranges,
            compared: 0,
            best: Distribution {
                shares: given,
                friction: before.friction,
                peak: (before.amplitude, before.r),
            },
        };
        let followed = match before.is_complete {
            true => descent.run(),
            false => Err(Early::Stopped),
        };
        let is_complete = match followed {
            Ok(()) => true,
            Err(Early::Stopped) => false,
            Err(Early::Failed(error)) => return Err(error),
        };
        let (best, search) = (descent.best, descent.search);
        let told = search.told(best.friction, best.peak, is_complete);
        Ok(JoinedDistribution {
            shares: best.shares,
            optimum: JoinedOptimum {
                evaluations: before.evaluations + told.evaluations,
                frictions: before.frictions + told.frictions,
                ..told
            },
            before,
        })
    }
}

/// Returns each contact's share of the common friction in the scene description.
fn shares(scene: &Scene) -> Vec<f64> {
    let contacts = scene.named_contacts().into_iter();
    contacts.map(|contact| contact.law.share).collect()
}

/// A common friction and the shares of all contacts.
#[derive(Clone, Debug)]
struct Distribution {
    shares: Vec<f64>,
    friction: f64,
    /// Largest amplitude of the mass over the band, and the frequency ratio at which it occurs.
    peak: (f64, f64),
}

/// A search that multiplies one number after the other by a factor: first the friction, then each share.
struct Descent<'j, 'a> {
    search: FrictionSearch<'j, 'a>,
    ranges: &'j [ShareRange],
    compared: usize,
    best: Distribution,
}

impl Descent<'_, '_> {
    fn run(&mut self) -> Result<(), Early> {
        let mut start = self.best.clone();
        for range in self.ranges {
            if let Some(share) = start.shares.get_mut(range.contact) {
                *share = share.clamp(range.from, range.to);
            }
        }
        start.peak = self.peak(&start, f64::INFINITY)?;
        // The shares of the scene description may be outside the permitted intervals. The search therefore begins at
        // `start`.
        self.best = start;
        self.descend(FIRST)
    }

    /// Multiplies or divides one number after the other by a factor. If no change gives a smaller peak, reduces the
    /// factor.
    fn descend(&mut self, mut factor: f64) -> Result<(), Early> {
        while LAST < factor && self.compared < MOST {
            let before = self.best.clone();
            for number in 0..=self.ranges.len() {
                if !self.better(number, factor)? {
                    self.better(number, 1.0 / factor)?;
                }
            }
            if self.best.peak.0 < before.peak.0 {
                self.leap(&before)?;
            } else {
                factor = factor.sqrt();
            }
        }
        Ok(())
    }

    /// Tries the best distribution with one number multiplied by a factor. The number is the friction or a share.
    /// Returns true if the changed distribution is better.
    fn better(&mut self, number: usize, factor: f64) -> Result<bool, Early> {
        let mut tried = self.best.clone();
        match number
            .checked_sub(1)
            .and_then(|index| self.ranges.get(index))
        {
            None => tried.friction *= factor,
            Some(range) => {
                let Some(share) = tried.shares.get_mut(range.contact) else {
                    return Ok(false);
                };
                let moved = (*share * factor).clamp(range.from, range.to);
                if moved == *share {
                    return Ok(false);
                }
                *share = moved;
            }
        }
        self.keep(tried)
    }

    /// Repeats the change from `before` to the best distribution, because this change has reduced the peak. The call
    /// multiplies the friction and each share by their ratio to the value in `before`. It keeps the result if the peak
    /// is smaller.
    fn leap(&mut self, before: &Distribution) -> Result<(), Early> {
        let mut tried = self.best.clone();
        tried.friction *= tried.friction / before.friction;
        for range in self.ranges {
            let earlier = before.shares.get(range.contact).copied();
            if let (Some(share), Some(earlier)) = (tried.shares.get_mut(range.contact), earlier) {
                *share = (*share * *share / earlier).clamp(range.from, range.to);
            }
        }
        self.keep(tried).map(|_| ())
    }

    /// Stores the distribution `tried` if it is better than the best distribution so far. Returns true if it is better.
    fn keep(&mut self, mut tried: Distribution) -> Result<bool, Early> {
        tried.peak = self.peak(&tried, self.best.peak.0)?;
        let better = tried.peak.0 < self.best.peak.0;
        if better {
            self.best = tried;
        }
        Ok(better)
    }

    /// Returns the largest amplitude of the mass over the band with a distribution, and the frequency ratio at which
    /// it occurs. Ends early with the first amplitude above `cutoff`.
    fn peak(&mut self, tried: &Distribution, cutoff: f64) -> Result<(f64, f64), Early> {
        self.compared += 1;
        self.search.set_shares(&tried.shares);
        self.search.largest(tried.friction, cutoff)
    }
}
