//! Follows a motion further that does not soon settle, and finds another stable steady state if it does not settle at
//! all.
//!
//! With μ > 1 a motion may wander for thousands of cycles before it settles, or for ever. A stable steady state may
//! nevertheless exist. Newton's method finds it from some of the states that the motion visits. Only the run-time
//! system uses this search. Emitted code does not contain it.

use super::cycle::Watch;
use super::heap::Heap;
use super::run::Motion;
use super::steady::{ATTEMPTS, Approach, MAX_PERIOD, Place, Search, Steady};
use super::tangent::ShotSpan;
use crate::errors::Halt;

/// Number of visited states that are [`NEARBY`] cycles apart.
const VISITS: usize = 64;
/// Number of cycles between two visited states from which Newton's method starts.
const NEARBY: usize = 4;
/// Number of visited states after the first [`VISITS`], which are [`MAX_PERIOD`] cycles apart. A motion that has reached a
/// subharmonic state repeats within this number of cycles.
const LATE_VISITS: usize = 30;
/// Distance of the motion from a steady state, divided by the size of the displacements, below which the motion may be
/// on its way there.
const NEAR: f64 = 0.01;

/// The stable steady state to which a motion has come closest without settling there.
#[derive(Default)]
struct Closest(Option<(Steady<f64, Heap>, f64)>);

impl Closest {
    fn offer(&mut self, steady: Steady<f64, Heap>, far: f64) {
        let is_closer = self.0.as_ref().is_none_or(|(_, known)| far < *known);
        if steady.is_stable() && is_closer {
            self.0 = Some((steady, far));
        }
    }
}

impl Motion<f64, Heap> {
    /// Searches for the steady state that the motion reaches, as [`settle`](Self::settle) does, or as
    /// [`settle_from`](Self::settle_from) does if `place` is [`Place::Reached`]. If the motion does not settle, the
    /// result is another stable steady state: the one to which the motion has come closest, or the one in which no
    /// contact slides. If the search finds none, the result contains the next [`MAX_PERIOD`] cycles of the motion.
    /// [`Steady::approach`] says which of these it is.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn settle_or_other(
        &self,
        omega: f64,
        place: Place,
        near: Option<&Steady<f64, Heap>>,
    ) -> Result<Steady<f64, Heap>, Halt> {
        let (start, mut motion) = (self.clone(), self.clone());
        let mut search = Search::by_tables(self, omega, 1.0);
        let mut closest = Closest::default();
        let mut others = |steady, far| closest.offer(steady, far);
        if let Some(steady) = search.reach(&mut motion, (ATTEMPTS, place), near, &mut others)? {
            return Ok(steady);
        }
        if let Some(steady) = search.visit(&mut motion, &mut closest)? {
            return Ok(steady);
        }
        let cycles = search.cycles;
        let other = closest.0.map(|(steady, _)| steady);
        let other = other.or_else(|| search.stuck(&start).ok().flatten());
        let approach = Approach::Apart(cycles);
        let steady = match other {
            None => return search.last_cycles(&mut motion, cycles),
            Some(steady) if place == Place::Centred => search.centred(&start, steady)?,
            Some(steady) => steady,
        };
        Ok(Steady { approach, ..steady })
    }
}

impl Search<f64, Heap> {
    /// Follows a motion, and starts Newton's method from the states that it visits. Returns the steady state in which the
    /// motion settles.
    fn visit(
        &mut self,
        motion: &mut Motion<f64, Heap>,
        closest: &mut Closest,
    ) -> Result<Option<Steady<f64, Heap>>, Halt> {
        for visit in 0..VISITS + LATE_VISITS {
            let cycles = if visit < VISITS { NEARBY } else { MAX_PERIOD };
            let back = self.warm(motion, cycles)?;
            let back = back.filter(|period| *period > 1).map(ShotSpan::Cycles);
            let half = self.is_odd(motion.model()).then_some(ShotSpan::Half);
            let spans = [half, Some(ShotSpan::Cycles(1)), back];
            for span in spans.into_iter().flatten() {
                // A step of Newton's method may lead to a state whose motion exceeds a bound.
                let Ok(Some(steady)) = self.newton(motion, span) else {
                    continue;
                };
                if steady.period > 1 && self.repeats_earlier(motion, &steady)? {
                    continue;
                }
                let far = self.away(motion.state(), &steady);
                if far <= NEAR && self.accepts(motion, &steady)? {
                    return Ok(Some(steady));
                }
                closest.offer(steady, far);
            }
        }
        Ok(None)
    }

    /// Returns the next cycles of a motion that does not settle. `cycles` is the number of those before.
    fn last_cycles(
        &mut self,
        motion: &mut Motion<f64, Heap>,
        cycles: usize,
    ) -> Result<Steady<f64, Heap>, Halt> {
        let start = motion.state().clone();
        let mut watch = Watch::new(motion.model());
        self.advance(motion, MAX_PERIOD, &mut watch)?;
        let cycle = watch.cycle(self.length(MAX_PERIOD));
        Ok(Steady {
            period: MAX_PERIOD,
            approach: Approach::Unsettled(cycles),
            ..Steady::of_cycle(start, cycle, &motion.model().size)
        })
    }
}
