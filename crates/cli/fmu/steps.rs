//! The steps of an instance, and the events in them.

use crate::inputs::between;
use crate::instance::{Phase, Refusal, State};
use crate::scene::{self, DT, INPUTS};

/// Result of the steps in one call of fmi3DoStep.
struct Taken {
    events: u64,
    /// Instant of the last event in these steps, s.
    event_time: Option<f64>,
    /// Inputs at the end of the last step.
    last: [f64; INPUTS],
    /// True if the steps end before the communication step.
    early: bool,
}

impl State {
    /// Returns the time of the last communication point, s.
    pub fn time(&self) -> f64 {
        let steps = self.stepper.as_ref().map_or(0, |stepper| stepper.steps());
        self.start + steps as f64 * DT
    }

    /// Advances by whole steps.  With `early_return`, the call ends after the first step with an event.  Returns true if
    /// it has ended before the end of the communication step.  A refusal changes nothing.
    pub fn advance(&mut self, now: f64, length: f64, early_return: bool) -> Result<bool, Refusal> {
        self.demand(Phase::Step, "fmi3DoStep")?;
        let time = self.time();
        if !((now - time).abs() < 0.5 * DT) {
            return Err(Refusal::error(format!(
                "the communication point is {now} s, but the FMU is at {time} s; restore a state for another time"
            )));
        }
        let count = (length / DT).round();
        if !(1.0 <= count && count < 1e12 && (length - count * DT).abs() <= 1e-3 * DT) {
            return Err(Refusal::error(format!(
                "the communication step is {length} s; give a multiple of the step {DT} s of the description"
            )));
        }
        if self.stop + 0.5 * DT < time + count * DT {
            return Err(Refusal::error(format!(
                "a step of {length} s from {time} s passes the stop time {} s",
                self.stop
            )));
        }
        let before = (count > 1.0).then(|| self.stepper.clone());
        match self.steps(count as u64, early_return) {
            Ok(taken) => {
                (self.events, self.last) = (taken.events, taken.last);
                if let Some(event_time) = taken.event_time {
                    self.event_time = event_time;
                }
                Ok(taken.early)
            }
            Err(text) => {
                if let Some(before) = before {
                    self.stepper = before;
                }
                Err(Refusal::discard(format!(
                    "{text}; the inputs are {}",
                    self.told(0..INPUTS)
                )))
            }
        }
    }

    /// Takes steps.  Returns their events, or the reason why a step failed.
    fn steps(&mut self, count: u64, early_return: bool) -> Result<Taken, String> {
        let (last, inputs, start) = (self.last, self.inputs(), self.start);
        let stepper = self.stepper.as_mut().ok_or("the FMU has no stepper")?;
        let mut taken = Taken {
            events: 0,
            event_time: None,
            last: inputs,
            early: false,
        };
        for index in 1..=count {
            let sample = between(&last, &inputs, index, count);
            let begun = start + stepper.steps() as f64 * DT;
            let stepped = stepper
                .advance(scene::input(&sample))
                .map_err(|error| error.to_string())?;
            taken.events += u64::from(stepped.events);
            if let Some(since) = stepper.last_event() {
                taken.event_time = Some(begun + f64::from(since));
            }
            if early_return && 0 < stepped.events && index < count {
                (taken.last, taken.early) = (sample, true);
                break;
            }
        }
        Ok(taken)
    }
}
