//! Samples a motion in time of a scene with several contacts. The motion may be one period of a steady state.

use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::simulation::{JoinedContactNow, JoinedEvent, JoinedSimulation};
use std::f64::consts::TAU;

/// Distance between an event and the two samples of [`JoinedSimulation::path`] next to this event, in rad of the phase
/// τ = ωt. The distance exceeds the rounding error of the event's instant, and is too small to be visible in a plot.
const BESIDE: f64 = 1e-9;

/// Samples of a motion in time of a scene with several contacts, and the events between the samples.
#[derive(Clone, Debug, Default)]
pub struct JoinedHistory {
    /// Phase τ = ωt of each sample, counted from the first sample, or the time in s for a free vibration.
    pub taus: Vec<f64>,
    /// Displacements and velocities of all masses at each sample.
    pub states: Vec<(Vec<f64>, Vec<f64>)>,
    /// State of every contact at each sample: motion, force, slip and dissipated energy.
    pub contacts: Vec<Vec<JoinedContactNow>>,
    /// The events in the order of time. The phase τ of each event is counted from the first sample.
    pub events: Vec<JoinedEvent>,
}

impl JoinedSimulation<'_> {
    /// Samples the motion over `cycles` cycles of the load, with `samples` equal intervals in each cycle. The motion
    /// first advances by `skip` cycles without samples. The first sample is at the start of the sampled cycles, and
    /// the last sample is at their end.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance).
    pub fn history(
        &mut self,
        skip: u32,
        cycles: u32,
        samples: u32,
    ) -> Result<JoinedHistory, JoinedError> {
        self.sampled((skip, cycles, samples), TAU, false)
    }

    /// Samples the motion as [`history`](Self::history) does, with two more samples at each event. One sample is just
    /// before the event, and one is just after it. A plot of force over displacement then shows the corners of the
    /// hysteresis loop.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance).
    pub fn path(
        &mut self,
        skip: u32,
        cycles: u32,
        samples: u32,
    ) -> Result<JoinedHistory, JoinedError> {
        self.sampled((skip, cycles, samples), TAU, true)
    }

    /// Samples a free vibration until a time in s, with `samples` equal intervals. If `at_events` is true, the result has
    /// two more samples at each event, as [`path`](Self::path) has.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance).
    pub fn until(
        &mut self,
        seconds: f64,
        samples: u32,
        at_events: bool,
    ) -> Result<JoinedHistory, JoinedError> {
        self.sampled((0, 1, samples), seconds, at_events)
    }

    fn sampled(
        &mut self,
        (skip, cycles, samples): (u32, u32, u32),
        cycle: f64,
        at_events: bool,
    ) -> Result<JoinedHistory, JoinedError> {
        for _ in 0..skip {
            self.advance(cycle)?;
        }
        let start = self.tau();
        let mut history = JoinedHistory::default();
        let count = u64::from(cycles) * u64::from(samples);
        for sample in 0..=count {
            let tau = cycle * sample as f64 / f64::from(samples);
            let before = at_events.then(|| self.clone());
            let events = self.advance_from(start, tau)?;
            if let Some(mut before) = before {
                for event in &events {
                    for shift in [-BESIDE, BESIDE] {
                        let beside = (event.tau - start + shift).min(tau);
                        before.advance_from(start, beside)?;
                        history.push(beside, &before);
                    }
                }
            }
            let events = events.into_iter().map(|event| JoinedEvent {
                tau: event.tau - start,
                ..event
            });
            history.events.extend(events);
            history.push(tau, self);
        }
        Ok(history)
    }

    /// Advances to the phase `start` + `tau`. If this phase is in the past, the call has no effect.
    fn advance_from(&mut self, start: f64, tau: f64) -> Result<Vec<JoinedEvent>, JoinedError> {
        self.advance((start + tau - self.tau()).max(0.0))
    }
}

impl JoinedHistory {
    /// Adds the present state of a motion to the samples. `tau` is the phase of this sample.
    fn push(&mut self, tau: f64, motion: &JoinedSimulation<'_>) {
        // If two events are at nearly the same instant, a sample before the second event can lie before an earlier
        // sample. The phases must not decrease.
        let last = self.taus.last().copied().unwrap_or(f64::NEG_INFINITY);
        self.taus.push(tau.max(last));
        self.states.push(motion.state());
        self.contacts.push(motion.contacts());
    }
}

impl<'a> JoinedOrbit<'a> {
    /// Starts a motion in time from this steady state, at a maximum of the load.
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the solver does not support the chain.
    pub fn simulation(&self) -> Result<JoinedSimulation<'a>, JoinedError> {
        let (joined, omega, units) = self.setting();
        Ok(JoinedSimulation::new(
            joined.clone(),
            self.motion()?,
            (omega, units),
        ))
    }
}
