//! A run in time, segment by segment.

use super::segment::{self, Stance, leap};
use super::{Contact, Dynamics, Event, Part, Setting};
use crate::errors::OutOfDomain;
use crate::scalar::{Float, Plain};

/// A segment of the motion: the contact sticks, or slides one way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment<S> {
    /// τ at its start, within the excitation's cycle: [0, 2π).
    pub start: S,
    /// Its length in τ.
    pub length: S,
    /// What the contact does.
    pub contact: Contact,
    /// What ends it; none if it goes on.
    pub event: Option<Event>,
}

/// A mass at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment<S> {
    displacement: S,
    velocity: S,
}

impl<S: Float> Moment<S> {
    /// x̄.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// dx̄/dτ.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// An exact run in time, from event to event.  An iterator over its segments; one in which nothing
/// happens for a cycle is given in pieces of a cycle.
///
/// `P` holds the parts: an array in emitted code, a vector at run time.
#[derive(Clone, Debug)]
pub struct Simulation<'a, S, P> {
    setting: Setting<'a, S>,
    parts: P,
    stance: Stance<S>,
    cycles: u64,
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>> Simulation<'a, S, P> {
    /// From a state at a maximum of the excitation, τ = 0: the displacements x̄ of the masses and
    /// their velocities dx̄/dτ.  From rest where there are none.  `parts` has one
    /// [`Part::empty`] for each mode and each held mode.
    ///
    /// # Errors
    /// [`OutOfDomain`] for r that is not positive and finite, for β as everywhere, and for a state
    /// that is not finite.
    pub fn new(
        dynamics: Dynamics<'a, S>,
        r: S,
        beta: S,
        state: Option<(&[S], &[S])>,
        mut parts: P,
    ) -> Result<Self, OutOfDomain>
    where
        S: Plain,
    {
        let setting = Setting::new(dynamics, r, beta, parts.as_mut())?;
        if let Some((displacements, velocities)) = state {
            let finite = |values: &[S]| values.iter().all(|value| value.is_finite());
            if !(finite(displacements) && finite(velocities)) {
                return Err(OutOfDomain { argument: "state" });
            }
            setting.load_state(displacements, velocities, parts.as_mut());
        }
        let stance = setting.stance(parts.as_ref(), S::constant(0.0));
        Ok(Self {
            setting,
            parts,
            stance,
            cycles: 0,
        })
    }

    /// How many cycles of the excitation are over.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.cycles
    }

    /// τ within the excitation's cycle, [0, 2π).
    #[must_use]
    pub fn phase(&self) -> S {
        self.stance.t * S::pi()
    }

    /// What the contact does from now on.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.stance.contact
    }

    /// A mass now, by its place in the description; at rest if there is no such mass.
    #[must_use]
    pub fn mass(&self, index: usize) -> Moment<S> {
        let shape = self.setting.dynamics.shape(index);
        Moment {
            displacement: self.sum(shape, |part| part.y),
            velocity: self.sum(shape, |part| part.x * part.u),
        }
    }

    /// z̄ and dz̄/dτ, the relative motion in the contact, now.
    #[must_use]
    pub fn relative(&self) -> (S, S) {
        let at = segment::phase(self.stance.t);
        let velocity = if self.stance.contact == Contact::Stuck {
            S::constant(0.0)
        } else {
            self.setting.relative_velocity(self.parts.as_ref(), at).0
        };
        (self.setting.relative(self.parts.as_ref(), at), velocity)
    }

    /// The friction force in the contact now, over P: β while it slides, what holds it while it
    /// sticks; positive against positive sliding.
    #[must_use]
    pub fn friction(&self) -> S {
        match self.stance.contact {
            Contact::Stuck => self
                .setting
                .holding(self.parts.as_ref(), segment::phase(self.stance.t)),
            sliding => sliding.sign::<S>() * self.setting.beta,
        }
    }

    fn sum(&self, shape: &[S], of: impl Fn(&Part<S>) -> S) -> S {
        let parts = self.parts.as_ref().iter().zip(shape);
        parts.fold(S::constant(0.0), |sum, (part, component)| {
            sum + *component * of(part)
        })
    }

    /// Moves on to the next event, at most by `reach` in τ.
    pub fn advance(&mut self, reach: S) -> Segment<S> {
        let (start, mut contact) = (self.stance.t, self.stance.contact);
        let (modes, held) = self.setting.split(self.parts.as_mut());
        let mut end = leap(&self.setting, modes, held, self.stance, reach);
        if end.stance.wedged {
            // The contact could not leave after all: it goes on sticking.
            contact = Contact::Stuck;
            end = leap(&self.setting, modes, held, end.stance, reach);
        }
        // The phase is reduced at every event, so that no count of cycles takes digits from it.
        let turns = start + end.tau * S::inverse_pi();
        let whole = (turns * S::constant(0.5)).floor().to_f64();
        let lapped = if whole < 1.0 && end.stance.t < start && S::constant(1.0) < turns {
            1.0
        } else {
            whole
        };
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "few cycles"
        )]
        {
            self.cycles = self.cycles.wrapping_add(lapped as u64);
        }
        self.stance = end.stance;
        Segment {
            start: start * S::pi(),
            length: end.tau,
            contact,
            event: end.event,
        }
    }
}

impl<S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>> Iterator for Simulation<'_, S, P> {
    type Item = Segment<S>;

    fn next(&mut self) -> Option<Segment<S>> {
        Some(self.advance(S::pi() + S::pi()))
    }
}

impl<S: Float> Setting<'_, S> {
    /// The modes' state for displacements and velocities of the masses.
    pub(crate) fn load_state(&self, displacements: &[S], velocities: &[S], parts: &mut [Part<S>]) {
        let masses = displacements.len().max(1);
        let weights = self.dynamics.weights.chunks(masses);
        for (part, weights) in parts.iter_mut().zip(weights) {
            let product = |values: &[S]| {
                let terms = weights.iter().zip(values);
                terms.fold(S::constant(0.0), |sum, (weight, value)| {
                    sum + *weight * *value
                })
            };
            part.y = product(displacements);
            part.u = product(velocities) / part.x;
        }
    }
}
