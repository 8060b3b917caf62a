//! The chain while its contact slides under a constant friction force.

use super::law::{ContactChain, Law, SlideStart};
use super::state::{Contact, ContactState};
use crate::motion::clock::phase;
use crate::motion::dynamics::rotated;
use crate::motion::oscillator::Part;
use crate::motion::series::OscillatorSum;
use crate::motion::setting::MotionSetting;
use crate::number::complex::{self, Complex};
use crate::number::pairs::pairs_mut;
use crate::number::scalar::Float;

/// Bound on the rounding error of a velocity near zero, as a multiple of the rounding unit times the sum of the
/// absolute values of its terms.
const ROUNDINGS: f64 = 8.0;

impl<S: Float, K: ContactChain<S>> MotionSetting<'_, S, K> {
    /// Returns the law of the contact, with forces divided by P, the amplitude of the load.
    #[inline]
    pub(crate) fn law(&self) -> K::Law {
        self.law_at(self.beta)
    }

    /// Returns the law of the contact at another friction ratio β, with forces divided by P, the amplitude of the load.
    #[inline]
    pub(crate) fn law_at(&self, beta: S) -> K::Law {
        self.dynamics.chain.law(beta)
    }

    /// Returns the state of a contact that starts to slide from zero relative velocity at the phase `t`.
    pub(crate) fn sliding_away(&self, t: S, slide: SlideStart<S>) -> ContactState<S> {
        ContactState {
            t,
            contact: slide.contact,
            memory: Some(self.acceleration(slide.excess)),
            wedged: false,
        }
    }

    /// Returns the state of a contact that starts to slide in a given direction at the phase `t`. At this phase the
    /// velocity of the contact is zero.
    pub(crate) fn sliding_off(&self, parts: &[Part<S>], t: S, contact: Contact) -> ContactState<S> {
        let force = self.holding(parts, phase(t));
        self.sliding_away(t, self.law().slide(contact, force))
    }

    /// Derives the state of the contact (stuck, or its direction of sliding) from the state of the modes at the phase
    /// `t`.
    pub(crate) fn contact_state(&self, parts: &[Part<S>], t: S) -> ContactState<S> {
        K::contact_state(self, parts, t)
    }

    /// Returns the direction in which the contact slides, or `None` if its velocity is zero except for rounding.
    pub(super) fn direction(&self, parts: &[Part<S>], at: (S, S)) -> Option<Contact> {
        let (velocity, size) = self.relative_velocity(parts, at);
        let moves = !(velocity.abs() <= size * S::constant(ROUNDINGS * S::EPSILON));
        moves.then(|| Contact::along(velocity))
    }

    /// Sets the oscillators of the modes for sliding. Returns the function in which a search finds the next event. This
    /// function is the relative velocity z̄′, times the sign of the sliding direction.
    pub(crate) fn start_sliding<'p>(
        &self,
        modes: &'p mut [Part<S>],
        contact_state: &ContactState<S>,
        reach: S,
    ) -> OscillatorSum<'p, S> {
        let at = phase(contact_state.t);
        let sign: S = contact_state.contact.sign();
        let force = self.law().kinetic(contact_state.contact);
        let zero = S::constant(0.0);
        let mut fundamental = Complex::new(zero, -(self.base * sign));
        for (part, mode) in modes.iter_mut().zip(self.dynamics.driven()) {
            let lambda = mode.resonance * mode.resonance;
            part.centre = -(force * mode.contact / lambda);
            part.start(at);
            part.weight = [zero, sign * mode.contact * part.x];
            part.aim();
            fundamental = complex::add(fundamental, part.fundamental());
        }
        let driven = self.dynamics.in_contact().min(modes.len());
        let (modes, others) = modes.split_at_mut(driven);
        for part in others {
            part.start(at);
        }
        let (sine, cosine) = at;
        let cosines = rotated(fundamental, sine, cosine);
        let sines = -(fundamental.re * sine) - fundamental.im * cosine;
        OscillatorSum::new(modes, zero, (cosines, sines), at, reach)
    }

    /// Changes the velocities in `column`, a small deviation of the modes, at an event. The contact force falls by
    /// `jump` at this event. The deviation delays the event by the time `later`, in rad of the excitation.
    pub(super) fn delay(&self, jump: S, later: S, column: &mut [S]) {
        for (mode, state) in self.dynamics.driven().iter().zip(pairs_mut(column)) {
            if let [_, u] = state {
                *u = *u - jump * mode.contact / (self.r * mode.resonance) * later;
            }
        }
    }
}
