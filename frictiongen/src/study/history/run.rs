//! A run in time from rest or from a given state, with a sample at every requested instant. A free vibration is a run
//! without a load.

use super::{
    FreeRequest, History, HistoryError, HistoryEvent, HistoryRequest, MOST_EVENTS, MOST_SAMPLES,
    check,
};
use crate::study::{System, simulation::SystemSimulation};
use crate::{Given, Of, OutOfDomain};
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
            units: RunUnits::GROUPS,
        };
        for cycle in 0..request.skip {
            follower.pass((cycle, 1.0), |_, _| Ok(()))?;
        }
        let samples = u64::from(request.samples);
        follower.fill(&mut history, |index| {
            let (cycle, end) = (index / samples, index % samples + 1);
            (request.skip + cycle, end as f64 / samples as f64)
        })?;
        Ok(history)
    }

    /// Returns the sampled free vibration of the scene from a given state, with every event. No load acts, and a moving
    /// base is at rest. Times are in s, displacements in m, velocities in m/s and forces in N.
    ///
    /// ```
    /// use frictiongen::study::history::FreeRequest;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    /// }"
    /// .parse()?;
    /// let request = FreeRequest::new(&[Of::Mass(0)], (vec![12.0], vec![6.0]), 25.0);
    /// let history = block.free_vibration(1.0, &request)?;
    /// // Each half cycle changes the centre of the vibration from −F/k to F/k, until the block sticks.
    /// let last = history.tracks[0].displacement.last().ok_or("no sample")?;
    /// assert!((last - (15.0 - 205_f64.sqrt())).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`HistoryError`] for an invalid request, and for a friction or a state that is not finite.
    pub fn free_vibration(
        &self,
        friction: f64,
        request: &FreeRequest,
    ) -> Result<History, HistoryError> {
        check(self, &request.of, 1, request.samples)?;
        if !(0.0 < request.until && request.until.is_finite()) {
            return Err(OutOfDomain::Duration(Given::of(request.until)).into());
        }
        let (x, v) = &request.from;
        let (run, units) = self.free(friction, (x, v))?;
        let mut history = History {
            cycle: request.until,
            ..History::new(0, 1, request.samples, &request.of)
        };
        let mut follower = Follower {
            run,
            of: &request.of,
            units,
        };
        let cycles = request.until * units.rate / TAU;
        if MOST_SAMPLES as f64 <= cycles {
            return Err(HistoryError::TooManyEvents);
        }
        follower.fill(&mut history, |index| {
            let cycles = cycles * (index + 1) as f64 / f64::from(request.samples);
            (cycles as u64, cycles.fract())
        })?;
        Ok(history)
    }

    /// Starts a free vibration, and returns it with its units.
    fn free(
        &self,
        friction: f64,
        (x, v): (&[f64], &[f64]),
    ) -> Result<(SystemSimulation<'_>, RunUnits), OutOfDomain> {
        let (stiffness, rate) = (self.scene().first_stiffness(), self.angular_frequency(1.0));
        if !(0.0 <= friction && friction.is_finite()) {
            return Err(OutOfDomain::Friction(Given::of(friction)));
        }
        // A power of two, so that the conversion of a state loses no digit.
        let size = x.iter().map(|x| x.abs());
        let size = size.chain(v.iter().map(|v| v.abs() / rate));
        let size = size.fold(friction / stiffness, f64::max);
        let length = if f64::MIN_POSITIVE <= size && size.is_finite() {
            size.log2().floor().exp2()
        } else {
            1.0
        };
        let units = RunUnits {
            length,
            force: stiffness * length,
            rate,
        };
        let divided = |values: &[f64], unit: f64| -> Vec<f64> {
            values.iter().map(|value| value / unit).collect()
        };
        let (x, v) = (divided(x, length), divided(v, length * rate));
        let run = self.simulation_without_load(friction / units.force, length * rate, (&x, &v))?;
        Ok((run, units))
    }
}

/// Units of a run, in which its history is: of displacements, of forces, and of 1/time.
#[derive(Clone, Copy, Debug)]
struct RunUnits {
    length: f64,
    force: f64,
    /// Angular frequency, by which the run divides 1/time.
    rate: f64,
}

impl RunUnits {
    /// The history has the non-dimensional groups of the run.
    const GROUPS: Self = Self {
        length: 1.0,
        force: 1.0,
        rate: 1.0,
    };
}

/// A run in time, with the list of motions that the history contains.
struct Follower<'a, 'o> {
    run: SystemSimulation<'a>,
    of: &'o [Of],
    units: RunUnits,
}

impl Follower<'_, '_> {
    /// Takes all samples of a history, with the events between them. `instant` returns the instant at the end of the
    /// interval between two samples, as [`pass`](Self::pass) expects it.
    fn fill(
        &mut self,
        history: &mut History,
        instant: impl Fn(u64) -> (u64, f64),
    ) -> Result<(), HistoryError> {
        self.sample(history);
        for index in 0..u64::from(history.samples) * u64::from(history.cycles) {
            let events = &mut history.events;
            self.pass(instant(index), |follower, event| {
                if MOST_EVENTS <= events.len() {
                    return Err(HistoryError::TooManyEvents);
                }
                events.push(follower.event(event));
                Ok(())
            })?;
            self.sample(history);
        }
        Ok(())
    }

    /// Advances the run to an instant, event by event. The instant is the fraction `part` of the cycle with the number
    /// `cycle`. Fails if the run has too many events.
    fn pass(
        &mut self,
        (cycle, part): (u64, f64),
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
        let (value, slope) = self.run.motion_of(of).unwrap_or_default();
        let unit = match of.is_force() {
            true => self.units.force,
            false => self.units.length,
        };
        (unit * value, unit * self.units.rate * slope)
    }

    fn sample(&self, history: &mut History) {
        let motions = self.of.iter().map(|of| self.motion(*of));
        let friction = self.units.force * self.run.friction();
        history.push(motions, (self.run.contact(), friction));
    }

    fn event(&self, event: Event) -> HistoryEvent {
        HistoryEvent {
            tau: (TAU * (self.run.cycles() as f64) + self.run.phase()) / self.units.rate,
            event,
            contact: self.run.contact(),
            displacements: self.of.iter().map(|of| self.motion(*of).0).collect(),
        }
    }
}
