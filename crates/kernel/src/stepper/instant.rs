//! Instant of the last event in a step of the stepper.

use super::Store;
use super::law::StepContact;
use super::table::StepTables;
use super::types::Stepper;
use crate::number::scalar::Float;

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns the instant of the last event in the last step: the time since the start of this step, in seconds.
    /// Returns `None` if the step had no event. The events are the stops, break-aways and reversals that
    /// [`Stepped::events`](super::Stepped::events) counts.
    ///
    /// A state that the stepper has saved as an image or through serde does not contain the instant. After a stepper
    /// has restored such a state, the result is `None` until the next event.
    #[must_use]
    pub fn last_event(&self) -> Option<S> {
        self.status.last_event.map(|share| share * self.dt())
    }
}
