//! A run in time from rest or from a given state, with a sample at every requested instant.

use super::{
    History, HistoryError, HistoryEvent, HistoryRequest, MOST_EVENTS, MOST_SAMPLES, check,
};
use crate::Of;
use crate::study::{System, simulation::SystemSimulation};
use frictiongen_kernel::simulation::Event;
use std::f64::consts::TAU;

/// Largest difference of phase τ, in rad, at which the code treats an instant and a sample as simultaneous. The
/// difference is a few rounding errors of a phase.
const NEAR: f64 = 16.0 * f64::EPSILON;

impl System {
    /// Returns the sampled motion over time from rest or from a given state, with every event.
    ///
    /// ```
    /// use frictiongen::kernel::simulation::Event;
    /// use frictiongen::study::history::HistoryRequest;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let request = HistoryRequest { skip: 100, ..HistoryRequest::new(&[Of::Mass(0)]) };
    /// let history = block.history(0.3, 0.4, &request)?;
    /// assert_eq!(history.len(), 10 * 200 + 1);
    /// // The contact stops twice a cycle.
    /// let stops = history.events.iter().filter(|event| event.event == Event::Stop);
    /// assert_eq!(stops.count(), 20);
    /// // The phase portrait shows displacement over velocity.
    /// let track = &history.tracks[0];
    /// let portrait: Vec<(f64, f64)> =
    ///     track.displacement.iter().copied().zip(track.velocity.iter().copied()).collect();
    /// assert_eq!(portrait.len(), history.len());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`HistoryError`] for an invalid request, and for a frequency ratio r, a friction ratio β or a state outside the
    /// domain.
    pub fn history(
        &self,
        r: f64,
        beta: f64,
        request: &HistoryRequest,
    ) -> Result<History, HistoryError> {
        check(self, &request.of, request.cycles, request.samples)?;
        if MOST_SAMPLES < request.skip {
            return Err(HistoryError::TooManySkipped);
        }
        let from = request.from.as_ref();
        let from = from.map(|(x, v)| (x.as_slice(), v.as_slice()));
        let run = match (request.amplitude, from) {
            (None, None) => self.simulation(r, beta)?,
            (None, Some(state)) => self.simulation_from(r, beta, state)?,
            (Some(amplitude), None) => self.simulation_under(r, beta, amplitude)?,
            (Some(amplitude), Some(state)) => {
                self.simulation_under_from(r, beta, amplitude, state)?
            }
        };
        let mut history = History::new(request.skip, request.cycles, request.samples, &request.of);
        let mut follower = Follower {
            run,
            of: &request.of,
        };
        for cycle in 0..request.skip {
            follower.pass(cycle, 1.0, |_, _| Ok(()))?;
        }
        follower.sample(&mut history);
        let samples = u64::from(request.samples);
        for index in 0..samples * u64::from(request.cycles) {
            let (cycle, end) = (index / samples, index % samples + 1);
            let to = end as f64 / samples as f64;
            let events = &mut history.events;
            follower.pass(request.skip + cycle, to, |follower, event| {
                if MOST_EVENTS <= events.len() {
                    return Err(HistoryError::TooManyEvents);
                }
                events.push(follower.event(event));
                Ok(())
            })?;
            follower.sample(&mut history);
        }
        Ok(history)
    }
}

/// A run in time, with the list of motions that the history contains.
struct Follower<'a, 'o> {
    run: SystemSimulation<'a>,
    of: &'o [Of],
}

impl Follower<'_, '_> {
    /// Advances the run to an instant, event by event. The instant is the fraction `part` of the cycle with the number
    /// `cycle`. Fails if the run has too many events.
    fn pass(
        &mut self,
        cycle: u64,
        part: f64,
        mut note: impl FnMut(&Self, Event) -> Result<(), HistoryError>,
    ) -> Result<(), HistoryError> {
        for _ in 0..MOST_EVENTS {
            // The code computes the length of each step from the run's own time. Rounding errors of the steps therefore
            // do not accumulate.
            let whole = cycle as f64 - self.run.cycles() as f64;
            let left = whole * TAU + (TAU * part - self.run.phase());
            if !(NEAR < left) {
                return Ok(());
            }
            let segment = self.run.advance(left)?;
            if let Some(event) = segment.event {
                note(self, event)?;
            }
        }
        Err(HistoryError::TooManyEvents)
    }

    /// Returns displacement and velocity of a motion. The caller must have checked that the scene has this motion.
    fn motion(&self, of: Of) -> (f64, f64) {
        self.run.motion_of(of).unwrap_or_default()
    }

    fn sample(&self, history: &mut History) {
        let motions = self.of.iter().map(|of| self.motion(*of));
        history.push(motions, (self.run.contact(), self.run.friction()));
    }

    fn event(&self, event: Event) -> HistoryEvent {
        HistoryEvent {
            tau: TAU * (self.run.cycles() as f64) + self.run.phase(),
            event,
            contact: self.run.contact(),
            displacements: self.of.iter().map(|of| self.motion(*of).0).collect(),
        }
    }
}
