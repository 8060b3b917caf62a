//! Limit cycles: periodic motions of a chain without a periodic load.
//!
//! The search follows a motion and notes the state at each instant at which a contact starts to slide. Two such states
//! that agree enclose a whole number of periods. A motion that sticks forgets most of its past at each stop, so that
//! it reaches its cycle after few periods.

use super::steady::Steady;
use super::{Heap, JointError, MAX_PERIOD, Motion, Series, State, Watch};
use frictiongen_kernel::joints::{Observe, STUCK, Short};

/// Largest relative difference of two states that count as equal.
const CLOSE: f64 = 1e-11;
/// Number of starts of sliding after which the search gives up.
const MOST_STARTS: usize = 4096;
/// Duration of a part of the motion between two tests, in periods of the fastest motion of the chain.
const PART: f64 = 64.0;
/// Number of parts without a start of sliding after which the search gives up.
const QUIET_PARTS: usize = 4096;

/// State at the start of sliding of a contact.
struct Start {
    time: f64,
    /// The contacts that start to slide.
    contacts: Vec<bool>,
    /// Displacements, and velocities divided by the fastest rate of the chain.
    state: Vec<f64>,
}

impl Start {
    /// Returns true if two states agree, and belong to the same contacts.
    fn repeats(&self, other: &Self) -> bool {
        let size = self.state.iter().copied().map(f64::abs).fold(0.0, f64::max);
        let mut pairs = self.state.iter().zip(&other.state);
        self.contacts == other.contacts && pairs.all(|(a, b)| (a - b).abs() <= CLOSE * size)
    }
}

/// Observer of a motion that collects the starts of sliding.
struct Starts {
    rate: f64,
    masses: usize,
    last: Vec<f64>,
    found: Vec<Start>,
}

impl Observe<f64, Heap> for Starts {
    fn stretch(&mut self, series: &Series, end: f64, _: &State) {
        let wall = self.masses;
        self.last.clear();
        for mass in 0..self.masses {
            self.last.push(series.place((mass, wall), end));
        }
        for mass in 0..self.masses {
            let terms = series.velocity_terms(mass);
            let speed = frictiongen_kernel::joints::value(&terms, end);
            self.last.push(speed / self.rate);
        }
    }

    fn event(&mut self, time: f64, before: &Short<i8>, after: &Short<i8>) {
        let pairs = before.iter().zip(after);
        let contacts: Vec<bool> = pairs
            .map(|(before, after)| *before == STUCK && after.abs() == 1)
            .collect();
        if contacts.contains(&true) {
            self.found.push(Start {
                time,
                contacts,
                state: self.last.clone(),
            });
        }
    }
}

impl Starts {
    /// Returns the duration after which the last start repeats, or `None` if it repeats none of the starts before.
    fn period(&self) -> Option<f64> {
        let (last, before) = self.found.split_last()?;
        let mut earlier = before.iter().rev().take(MAX_PERIOD);
        let known = earlier.find(|start| start.repeats(last))?;
        Some(last.time - known.time)
    }
}

/// Returns the limit cycle that a motion without a periodic load reaches, and its period. Returns `None` if the motion
/// comes to rest, slides steadily, or does not repeat.
///
/// # Errors
///
/// [`JointError`] if the motion exceeds a bound of the solver.
pub fn limit_cycle(mut motion: Motion) -> Result<Option<(Steady, f64)>, JointError> {
    let part = PART * motion.model().stretch;
    let mut starts = Starts {
        rate: 1.0 / motion.model().stretch,
        masses: motion.model().masses.len(),
        last: Vec::new(),
        found: Vec::new(),
    };
    let mut quiet = 0;
    while quiet < QUIET_PARTS && starts.found.len() < MOST_STARTS {
        let count = starts.found.len();
        motion.run_with(motion.time() + part, &mut starts)?;
        quiet = if starts.found.len() > count {
            0
        } else {
            quiet + 1
        };
        let Some(period) = starts.period().filter(|_| quiet == 0) else {
            continue;
        };
        let mut watch = Watch::new(motion.model());
        let state = motion.state().clone();
        motion.restart(state.clone());
        motion.run_with(period, &mut watch)?;
        let steady = Steady::of_cycle(state, watch.cycle(period), &motion.model().size);
        return Ok(Some((steady, period)));
    }
    Ok(None)
}
