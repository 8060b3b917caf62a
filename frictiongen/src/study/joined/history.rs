//! Samples of a motion in time, or of one period of a steady state.

use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::simulation::{JoinedContactNow, JoinedEvent, JoinedSimulation};
use std::f64::consts::TAU;

/// Samples at equal distances, and the events between them.
#[derive(Clone, Debug, Default)]
pub struct JoinedHistory {
    /// Phase τ = ωt of each sample, from the first sample on.
    pub taus: Vec<f64>,
    /// Displacements and velocities of all masses, sample by sample.
    pub states: Vec<(Vec<f64>, Vec<f64>)>,
    /// All contacts, sample by sample.
    pub contacts: Vec<Vec<JoinedContactNow>>,
    /// The events, in the order of time. Their phase counts from the first sample.
    pub events: Vec<JoinedEvent>,
}

impl JoinedSimulation<'_> {
    /// Skips whole cycles, and then samples some cycles. The first sample is the present instant after the skipped
    /// cycles, the last one the end of the last cycle.
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
    /// Starts the motion in time in this steady state, at a maximum of the load.
    ///
    /// # Errors
    /// Those of the engine.
    pub fn simulation(&self) -> Result<JoinedSimulation<'a>, JoinedError> {
        let (joined, omega, units) = self.setting();
        Ok(JoinedSimulation::new(
            joined.clone(),
            self.motion()?,
            (omega, units),
        ))
    }
}
