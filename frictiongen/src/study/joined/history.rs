//! Samples of a motion in time of several contacts, or of one period of their steady state.

use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::simulation::{JoinedContactNow, JoinedEvent, JoinedSimulation};
use std::f64::consts::TAU;

/// A motion over time of a scene with several contacts: equally spaced samples, and the events between them.
#[derive(Clone, Debug, Default)]
pub struct JoinedHistory {
    /// Phase τ = ωt of each sample, counted from the first sample.
    pub taus: Vec<f64>,
    /// Displacements and velocities of all masses at each sample.
    pub states: Vec<(Vec<f64>, Vec<f64>)>,
    /// For each sample, the motion and force of every contact.
    pub contacts: Vec<Vec<JoinedContactNow>>,
    /// The events in the order of time. Their phase τ is counted from the first sample.
    pub events: Vec<JoinedEvent>,
}

impl JoinedSimulation<'_> {
    /// Advances by `skip` cycles of the load, and then takes samples over `cycles` cycles. The first sample is at the
    /// start of these cycles, and the last sample is at their end.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance).
    pub fn history(
        &mut self,
        skip: u32,
        cycles: u32,
        samples: u32,
    ) -> Result<JoinedHistory, JoinedError> {
        for _ in 0..skip {
            self.advance(TAU)?;
        }
        let start = self.tau();
        let mut history = JoinedHistory::default();
        let count = u64::from(cycles) * u64::from(samples);
        for sample in 0..=count {
            let tau = TAU * sample as f64 / f64::from(samples);
            let reach = (start + tau - self.tau()).max(0.0);
            let events = self.advance(reach)?.into_iter().map(|event| JoinedEvent {
                tau: event.tau - start,
                ..event
            });
            history.events.extend(events);
            history.taus.push(tau);
            history.states.push(self.state());
            history.contacts.push(self.contacts());
        }
        Ok(history)
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
