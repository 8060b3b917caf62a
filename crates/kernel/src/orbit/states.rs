//! Searches for the steady states of a scene at one friction ratio β.

use super::scene::{KnownState, Print, ProvidesOrbit};
use super::start::Start;
use crate::errors::{NoOrbit, OutOfDomain};
use crate::motion::{ContactChain, Law};
use crate::number::scalar::{Float, Scalar};
use crate::response::{At, Scene};
use core::fmt;

/// Largest number of initial states in a search for steady states.
const STARTS: usize = 9;
/// Friction ratios, divided by β_lim, at which the closed form gives an initial state. The search uses them if its own
/// β is at least β_lim, because no closed form exists at this β.
const FORMER: [f64; 2] = [0.98, 0.5];
/// Factors by which the code multiplies β. Motions at the resulting neighbouring friction ratios give some initial
/// states of the search.
const NEIGHBOURS: [f64; 4] = [0.97, 1.03, 0.8, 1.25];

/// Iterator over the steady states that a search finds at one friction ratio, which [`At::states`] returns. The
/// iterator searches for a state when the caller requests the next item. [`reason`](Self::reason) explains an empty
/// list.
pub struct States<T: Scene> {
    at: At<T>,
    beta: T::Scalar,
    starts: [Option<Start<'static, T::Scalar>>; STARTS],
    seen: [Option<Print<T::Scalar>>; STARTS],
    next: usize,
    /// Reason why motion from rest reaches no steady state, once the search has found it.
    reason: Option<NoOrbit>,
}

impl<T: Scene> fmt::Debug for States<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("States")
            .field("next", &self.next)
            .finish_non_exhaustive()
    }
}

impl<T: ProvidesOrbit> States<T> {
    pub(super) fn new(at: At<T>, beta: T::Scalar) -> Result<Self, OutOfDomain> {
        let mut starts = [None; STARTS];
        let mut places = starts.iter_mut();
        let mut add = |start: Option<Start<'static, T::Scalar>>| {
            if let (Some(place), Some(_)) = (places.next(), start) {
                *place = start;
            }
        };
        add(Some(Start::Rest));
        let zero = T::Scalar::constant(0.0);
        // With μ = 1 the distance between two motions never grows, so that all initial states lead to the same steady
        // state.
        let law = at.scene().numbers().chain.law(beta);
        if law.is_contraction() || beta.is_zero() {
            return Ok(Self::from_starts(at, beta, starts));
        }
        add((!(beta < at.sliding_limit())).then_some(Start::Stuck));
        let limit = at.continuous_limit();
        let closed =
            |beta: T::Scalar| (zero < beta && beta.is_finite()).then_some(Start::ClosedForm(beta));
        if beta < limit {
            add(closed(beta));
        } else {
            for share in FORMER {
                add(closed(limit * T::Scalar::constant(share)));
            }
        }
        for share in NEIGHBOURS {
            add(Some(Start::Neighbour(beta * T::Scalar::constant(share))));
        }
        Ok(Self::from_starts(at, beta, starts))
    }

    /// Returns the reason why motion from rest reaches no steady state. If the iterator returns no state at all, this
    /// is also the reason why the list is empty. Returns `None` if motion from rest reaches a steady state, and before
    /// the caller requests the first item.
    #[must_use]
    pub fn reason(&self) -> Option<NoOrbit> {
        self.reason
    }

    /// Leaves out the motion from rest, if the caller has already followed this motion.
    #[must_use]
    pub fn without_rest(self) -> Self {
        Self {
            next: self.next.max(1),
            ..self
        }
    }

    fn from_starts(
        at: At<T>,
        beta: T::Scalar,
        starts: [Option<Start<'static, T::Scalar>>; STARTS],
    ) -> Self {
        let seen = [None; STARTS];
        Self {
            at,
            beta,
            starts,
            seen,
            next: 0,
            reason: None,
        }
    }
}

impl<T: ProvidesOrbit> Iterator for States<T>
where
    <T::Orbit as core::ops::Deref>::Target: KnownState<Scalar = T::Scalar>,
{
    type Item = T::Orbit;

    fn next(&mut self) -> Option<T::Orbit> {
        loop {
            let start = *self.starts.get(self.next)?;
            self.next += 1;
            let Some(start) = start else { continue };
            let orbit = match T::settled(&self.at, self.beta, start, false) {
                Ok(orbit) => orbit,
                Err(reason) => {
                    if start == Start::Rest {
                        self.reason = Some(reason);
                    }
                    continue;
                }
            };
            let print = orbit.print();
            if self.seen.iter().flatten().any(|seen| seen.is_alike(&print)) {
                continue;
            }
            if let Some(place) = self.seen.get_mut(self.next - 1) {
                *place = Some(print);
            }
            return Some(orbit);
        }
    }
}
