//! Motions in time of scenes with several contacts, from event to event.

use super::error::{JoinedError, UnknownContact};
use super::scene::Joined;
use super::slides::Slides;
use super::units::AnswerUnits;
use crate::answer::Event;
use crate::study::error::UnknownMass;
use crate::study::joints::{Motion, Transition};
use crate::{Given, OutOfDomain};
use frictiongen_kernel::joints::STUCK;
use frictiongen_kernel::simulation::Contact;

/// An event of one contact.
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedEvent {
    /// Phase τ = ωt of the load at the event, or the time in s for a free vibration.
    pub tau: f64,
    /// Index of the contact in the scene description.
    pub contact: usize,
    /// Name of the contact in the scene description.
    pub name: String,
    /// Kind of the event: a stop, a break-away or a reversal. A stop of the scene that shuts has [`Event::Stop`], one that
    /// opens [`Event::Slip`], and an impact [`Event::Reversal`].
    pub event: Event,
    /// True for a stop of the scene.
    pub is_of_stop: bool,
    /// Displacement of each mass at the event, in the unit of length of the results.
    pub displacements: Vec<f64>,
}

impl JoinedEvent {
    /// Returns the word for the event in a table.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self.event {
            Event::Stop if self.is_of_stop => "shut",
            Event::Slip if self.is_of_stop => "open",
            Event::Reversal if self.is_of_stop => "impact",
            Event::Stop => "stop",
            Event::Slip => "slip",
            Event::Reversal => "reversal",
        }
    }
}

/// State of one contact at one instant of a motion. The numbers are in the units of the results of this motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinedContactNow {
    /// Relative displacement of the contact's two sides, in the unit of length of the results.
    pub displacement: f64,
    /// Relative velocity of the contact's two sides, in the unit of velocity of the results.
    pub velocity: f64,
    /// Force in the contact at this instant, in the unit of force of the results.
    pub force: f64,
    /// Distance that the slider has travelled since the start, added over both directions, in the unit of length of
    /// the results.
    pub slip: f64,
    /// Energy that friction has dissipated in the contact since the start, in the unit of force times the unit of
    /// length of the results.
    pub energy: f64,
    /// True if the contact sticks at this instant.
    pub is_sticking: bool,
}

impl JoinedContactNow {
    /// Returns the state with displacement, velocity and force multiplied by `sign`, which is 1 or −1.
    #[must_use]
    pub fn signed(self, sign: f64) -> Self {
        // The sum replaces −0 by 0.
        let signed = |value: f64| sign * value + 0.0;
        Self {
            displacement: signed(self.displacement),
            velocity: signed(self.velocity),
            force: signed(self.force),
            ..self
        }
    }

    /// Returns the direction in which the contact slides at this instant, or that it sticks.
    #[must_use]
    pub fn contact(&self) -> Contact {
        // The friction of a sliding contact has the sign of its slip, also at a break-away, where the velocity is 0.
        let direction = match self.force {
            0.0 => self.velocity,
            force => force,
        };
        if self.is_sticking || direction == 0.0 {
            Contact::Stuck
        } else if 0.0 < direction {
            Contact::Forward
        } else {
            Contact::Backward
        }
    }
}

/// An exact motion in time of a scene with several contacts.
#[derive(Clone, Debug)]
pub struct JoinedSimulation<'a> {
    joined: Joined<'a>,
    motion: Motion,
    omega: f64,
    units: AnswerUnits,
    /// For each contact, the distance that the slider has travelled, and the energy that friction has dissipated.
    slides: Slides,
}

impl<'a> JoinedSimulation<'a> {
    pub(super) fn new(
        joined: Joined<'a>,
        motion: Motion,
        (omega, units): (f64, AnswerUnits),
    ) -> Self {
        let slides = Slides::new(motion.model());
        Self {
            joined,
            motion,
            omega,
            units,
            slides,
        }
    }

    /// Returns the phase τ = ωt of the load since the start.
    #[must_use]
    pub fn tau(&self) -> f64 {
        self.omega * self.motion.time()
    }

    /// Returns displacements and velocities of all masses at the present instant.
    #[must_use]
    pub fn state(&self) -> (Vec<f64>, Vec<f64>) {
        let state = self.motion.state();
        let x = state.x.iter().map(|x| x / self.units.length);
        let v = state.v.iter().map(|v| v / self.units.speed);
        (x.collect(), v.collect())
    }

    /// Returns displacement and velocity of the mass called `name` at the present instant.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<(f64, f64), UnknownMass> {
        let mass = self.joined.mass_index(name)?;
        let (x, v) = self.state();
        let of = |values: &[f64]| values.get(mass).copied().unwrap_or_default();
        Ok((of(&x), of(&v)))
    }

    /// Returns the state of every contact at the present instant, in the order of the scene description.
    #[must_use]
    pub fn contacts(&self) -> Vec<JoinedContactNow> {
        let forces = self.motion.forces().into_iter();
        let forces = forces.zip(self.slides.contacts());
        let contacts = forces.enumerate().map(|(index, (force, slide))| {
            let (velocity, displacement) = self.motion.relative(index);
            JoinedContactNow {
                displacement: displacement / self.units.length,
                velocity: velocity / self.units.speed,
                force: force / self.units.force,
                slip: slide.slip / self.units.length,
                energy: slide.energy / self.units.energy(),
                is_sticking: self.motion.state().phase(index) == STUCK,
            }
        });
        contacts.collect()
    }

    /// Returns the state of the contact called `name` at the present instant.
    ///
    /// # Errors
    /// [`UnknownContact`] if no contact has this name.
    pub fn contact_named(&self, name: &str) -> Result<JoinedContactNow, UnknownContact> {
        let index = self.joined.contact_index(name)?;
        let found = self.contacts().get(index).copied();
        found.ok_or_else(|| UnknownContact {
            name: name.to_owned(),
            known: self.joined.contact_names(),
        })
    }

    /// Advances the motion until the phase τ = ωt of the load has increased by `reach`, in rad. Returns the events in
    /// this interval. Several contacts may have an event at the same instant.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a reach that is negative or not finite. [`JoinedError::Engine`] if the motion has too many
    /// events or leaves the range of numbers.
    pub fn advance(&mut self, reach: f64) -> Result<Vec<JoinedEvent>, JoinedError> {
        if !(reach >= 0.0 && reach.is_finite()) {
            return Err(OutOfDomain::Duration(Given::of(reach)).into());
        }
        self.advance_to(self.motion.time() + reach / self.omega)
    }

    /// Advances the motion to a time in seconds, and returns the events until this time.
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the motion has too many events or leaves the range of numbers.
    pub fn advance_to(&mut self, time: f64) -> Result<Vec<JoinedEvent>, JoinedError> {
        let followed = self.motion.run_with(time, &mut self.slides);
        let events = self.slides.take_events();
        followed?;
        Ok(self.events(&events))
    }

    fn events(&self, transitions: &[(Transition, Vec<f64>)]) -> Vec<JoinedEvent> {
        let tau = |time: f64| self.omega * time;
        self.joined.events(transitions, &tau, self.units.length)
    }
}

impl Joined<'_> {
    /// Returns one event for each contact that changes its state. `tau` converts the time of an event to its phase.
    pub(super) fn events(
        &self,
        transitions: &[(Transition, Vec<f64>)],
        tau: &dyn Fn(f64) -> f64,
        length: f64,
    ) -> Vec<JoinedEvent> {
        let names = self.contact_names();
        let contacts = names.len() - self.scene().joints.stops.len();
        let mut events = Vec::new();
        for (transition, places) in transitions {
            let phases = transition.before.iter().zip(&transition.after);
            for ((contact, (before, after)), name) in phases.enumerate().zip(&names) {
                let event = match (*before, *after) {
                    (before, after) if before == after => continue,
                    (_, STUCK) => Event::Stop,
                    (STUCK, _) => Event::Slip,
                    _ => Event::Reversal,
                };
                events.push(JoinedEvent {
                    tau: tau(transition.time),
                    contact,
                    name: name.clone(),
                    event,
                    is_of_stop: contact >= contacts,
                    displacements: places.iter().map(|x| x / length).collect(),
                });
            }
        }
        events
    }
}
