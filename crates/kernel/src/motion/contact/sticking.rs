//! The chain with its contact stuck, at one frequency ratio: its state, and the force in the contact.

use super::law::{ContactChain, Law};
use super::state::ContactState;
use crate::motion::clock::phase;
use crate::motion::dynamics::{lift, rotated};
use crate::motion::oscillator::Part;
use crate::motion::series::OscillatorSum;
use crate::motion::setting::MotionSetting;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;

impl<S: Float, K: ContactChain<S>> MotionSetting<'_, S, K> {
    /// Computes the displacements y and scaled velocities u of the modes of the chain with its contact stuck, as
    /// [`Dynamics::project`] does.
    pub(crate) fn project(
        &self,
        states: impl Iterator<Item = [S; 2]> + Clone,
        lifted: (S, S),
        stuck_modes: &mut [Part<S>],
    ) {
        let stuck_modes = stuck_modes
            .iter_mut()
            .map(|part| (&mut part.y, &mut part.u));
        self.dynamics
            .project(self.receptance, states, lifted, stuck_modes);
    }

    /// Computes the state of the chain's modes from the modes of the chain with its contact stuck, as
    /// [`Dynamics::release`] does.
    pub(crate) fn release<'s>(
        &self,
        stuck_modes: &[Part<S>],
        lifted: (S, S),
        states: impl Iterator<Item = (&'s mut S, &'s mut S)>,
    ) {
        let stuck_modes = stuck_modes.iter().map(|part| [part.y, part.u]);
        self.dynamics
            .release(self.receptance, stuck_modes, lifted, states);
    }

    /// Sets the oscillators of the chain with its contact stuck, from the states of the chain's modes. Returns the
    /// contact force as a function of time, and the displacement that stays constant while the contact sticks. This
    /// displacement is z̄ for a rigid contact, and that of the slider for an elastic contact.
    pub(crate) fn start_sticking<'p>(
        &self,
        modes: &mut [Part<S>],
        stuck_modes: &'p mut [Part<S>],
        contact_state: &ContactState<S>,
        reach: S,
    ) -> (OscillatorSum<'p, S>, S) {
        let at = phase(contact_state.t);
        let (sine, cosine) = at;
        let offset = K::stuck_place(self, modes, contact_state, at);
        let lifted = self.lifted(offset, at);
        self.project(
            modes.iter().map(|part| [part.y, part.u]),
            lifted,
            stuck_modes,
        );
        K::adapt(self, stuck_modes, lifted.0, contact_state);
        let zero = S::constant(0.0);
        let (constant, mut fundamental) = K::steady_stuck_force(self, offset);
        for (part, mode) in stuck_modes.iter_mut().zip(self.dynamics.held) {
            part.start(at);
            part.weight = [-mode.force, zero];
            part.aim();
            fundamental = complex::add(fundamental, part.fundamental());
        }
        let driven = self.dynamics.in_contact();
        for part in modes.iter_mut().skip(driven) {
            part.start(at);
        }
        let cosines = rotated(fundamental, sine, cosine);
        let sines = -(fundamental.re * sine) - fundamental.im * cosine;
        (
            OscillatorSum::new(stuck_modes, constant, (cosines, sines), at, reach),
            offset,
        )
    }

    /// Returns the largest absolute relative displacement |z̄| at which the contact may stick for ever. `steady` is the
    /// amplitude of the contact force in the forced motion. The static friction force must balance the sum of this
    /// amplitude and the constant force that z̄ causes.
    pub(crate) fn offset_range(&self, steady: S) -> S {
        let receptance = self.receptance - self.dynamics.chain.compliance();
        (self.law().grip() - steady).max(S::constant(0.0)) * receptance
    }

    /// Returns the mean of the relative displacement z̄ while the contact sticks. `place` is the displacement of the
    /// slider. A rigid contact has the same displacement as its slider.
    pub(crate) fn mean_at(&self, place: S) -> S {
        let receptance = self.receptance - self.dynamics.chain.compliance();
        place * (receptance / self.receptance)
    }

    /// Returns the complex amplitude of the force in a contact that never slides, divided by P. [`MotionSetting::new`]
    /// prepares `parts`, the oscillators. Returns `None` on an undamped resonance of the stuck chain.
    pub fn stuck_force(&self, parts: &[Part<S>]) -> Option<Complex<S>> {
        let (_, start) = K::steady_stuck_force(self, S::constant(0.0));
        let stuck_modes = parts.iter().skip(self.dynamics.modes.len());
        stuck_modes
            .zip(self.dynamics.held)
            .try_fold(start, |sum, (part, mode)| {
                let [y, _] = part.steady_state()?;
                Some(complex::add(sum, complex::scale(y, -mode.force)))
            })
    }

    /// Returns the complex amplitude x̄ of the displacement of a mass while the contact never slides. The constant
    /// displacement of the contact, or of an elastic contact's slider, is 0. [`MotionSetting::new`] prepares `parts`,
    /// the oscillators. Returns `None` on an undamped resonance of the stuck chain.
    pub fn stuck_amplitude(&self, parts: &[Part<S>], mass: usize) -> Option<Complex<S>> {
        let zero = S::constant(0.0);
        let (dynamics, shape) = (&self.dynamics, self.dynamics.shape(mass));
        let mut sum = complex::real(zero);
        for (mode, component) in dynamics.driven().iter().zip(shape) {
            sum.re = sum.re + *component * lift(mode, self.receptance) * self.base;
        }
        let modes = parts.iter().take(dynamics.modes.len()).zip(shape);
        for (part, component) in modes.skip(dynamics.in_contact()) {
            let [y, _] = part.steady_state()?;
            sum = complex::add(sum, complex::scale(y, *component));
        }
        let stuck_modes = parts.iter().skip(dynamics.modes.len());
        for (part, (_, participations)) in stuck_modes.zip(dynamics.held_modes()) {
            for (amplitude, state) in part.steady_state()?.into_iter().zip(0..) {
                let weight = participations
                    .iter()
                    .zip(shape)
                    .fold(zero, |sum, (of, component)| {
                        sum + *component * of.get(state).copied().unwrap_or(zero)
                    });
                sum = complex::add(sum, complex::scale(amplitude, weight));
            }
        }
        Some(sum)
    }

    /// Returns the displacement of the stuck contact plus the displacement of the base, and the velocity of this sum.
    /// The velocity is the derivative with respect to the non-dimensional time t√(k₁/m₁).
    pub(crate) fn lifted(&self, offset: S, (sine, cosine): (S, S)) -> (S, S) {
        let z = Complex::new(self.base, S::constant(0.0));
        (
            offset + rotated(z, sine, cosine),
            -(self.base * sine) * self.r,
        )
    }
}
