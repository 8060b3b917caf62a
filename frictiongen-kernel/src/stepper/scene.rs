//! What a stepper is told of a scene.

use super::cost::{Cost, Extent};
use super::input::Input;
use super::pace::Pace;
use crate::number::scalar::Float;
use crate::simulation::{Dynamics, TERMS};

/// What takes the groups of a scene to the units that it is written in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units<S> {
    /// k₁, force over displacement.
    pub stiffness: S,
    /// √(k₁/m₁), in rad/s.
    pub rate: S,
    /// The sum of the springs between masses and base, over k₁.
    pub support: S,
}

/// A scene as a stepper needs it.
#[derive(Clone, Copy, Debug)]
pub struct StepScene<'a, S> {
    /// The modes, and those of the chain with its contact held.
    pub dynamics: Dynamics<'a, S>,
    /// The units.
    pub units: Units<S>,
    /// Whether the base moves.
    pub on_base: bool,
    /// The masses that a force acts on, by their places in the description: the excited one first.
    pub forces: &'a [usize],
    /// What the input does between two samples.
    pub input: Input,
    /// Stribeck's law: points (v, f), speed and kinetic level over that at rest, v ascending.  Empty for Coulomb's.
    pub law: &'a [[S; 2]],
}

impl<S: Float> StepScene<'_, S> {
    /// How many inputs there are: the base's motion, and a force for each loaded mass.
    #[must_use]
    pub fn channels(&self) -> usize {
        usize::from(self.on_base) + self.forces.len()
    }

    /// The angle by which the fastest oscillator turns in a second, its damping included, in rad: a step dt is cut into
    /// as many parts as this times dt.
    #[must_use]
    pub fn fastest(&self) -> S {
        self.turning() * self.units.rate
    }

    /// The same in the time t√(k₁/m₁).
    pub(super) fn turning(&self) -> S {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let turned = |frequency: S, zeta: S| frequency * (one + two * zeta);
        let modes = self.dynamics.modes.iter();
        let modes = modes.map(|mode| turned(mode.resonance, mode.zeta));
        let held = self.dynamics.held.iter();
        let held = held.map(|mode| turned(mode.frequency, mode.zeta));
        modes.chain(held).fold(S::constant(0.0), S::max)
    }

    /// How many coefficients the input has over a step: those of emitted tables, where a system's have room for more.
    fn coefficients(&self) -> usize {
        match (self.input, self.on_base) {
            (Input::Hold, false) => 1,
            (Input::Hold, true) | (Input::Linear, false) => 2,
            (Input::Linear, true) => 4,
        }
    }

    /// How many terms of a power series are formed, if so many reach the end of a part.
    pub(super) fn terms(&self, enough: u32) -> usize {
        let terms = if self.law.is_empty() {
            usize::try_from(enough).unwrap_or(TERMS)
        } else {
            TERMS
        };
        // The input's last coefficient starts a series of its own, so many terms later.
        (terms + self.coefficients()).clamp(5, TERMS)
    }

    /// What a step costs at most that is cut into so many parts, from how many coefficients an input has and how many
    /// terms of a power series reach the end of a part ([`series_terms`](super::series_terms)).
    #[must_use]
    pub fn cost(&self, coefficients: usize, parts: u32, terms: u32) -> Cost {
        let count = |size: usize| u64::try_from(size).unwrap_or(u64::MAX);
        Cost::of(&Extent {
            modes: count(self.dynamics.modes.len()),
            driven: count(self.dynamics.in_contact()),
            inputs: count(self.channels()),
            coefficients: count(coefficients),
            terms: count(self.terms(terms)),
            parts: u64::from(parts),
            on_moving_base: self.rubs_on_base(),
            lines: !self.law.is_empty(),
        })
    }

    /// How strongly an input drives a mode.
    pub(super) fn load(&self, channel: usize, mode: usize) -> S {
        let zero = S::constant(0.0);
        if self.on_base && channel == 0 {
            let mode = self.dynamics.modes.get(mode);
            return mode.map_or(zero, |mode| mode.load);
        }
        let place = channel.wrapping_sub(usize::from(self.on_base));
        let mass = self.forces.get(place).copied();
        let shape = mass.map_or(&[][..], |mass| self.dynamics.shape(mass));
        shape.get(mode).copied().unwrap_or(zero)
    }

    /// The contact's acceleration, in lengths a part squared, under this force.
    pub(super) fn acceleration(&self, pace: &Pace<S>, force: S) -> S {
        self.dynamics.chain.inverse_mass * force * pace.span * pace.span
    }

    /// Whether the contact rubs on the moving base.
    pub(super) fn rubs_on_base(&self) -> bool {
        self.on_base && self.dynamics.chain.on_moving_base.is_some()
    }
}
