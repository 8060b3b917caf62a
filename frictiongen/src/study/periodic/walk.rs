//! Advances the motion under a periodic load, step by step.

use super::error::PeriodicError;
use super::load::Sampled;
use crate::study::System;
use crate::study::stepper::{SystemStepSaved, SystemStepper};
use frictiongen_kernel::motion::Contact;
use frictiongen_kernel::stepper::{Sample, Stepped};
use nalgebra::Complex;
use std::ops::DerefMut;

/// A motion under a periodic load.
pub(super) struct Walk<'a> {
    pub stepper: SystemStepper<'a>,
    load: &'a Sampled,
    friction: f64,
    /// Index of the next step in the period of the load.
    pub at: usize,
    /// Force on each mass, with the excited mass first. Only the force on the excited mass can be different from 0.
    forces: Vec<f64>,
    slopes: Vec<[f64; 2]>,
}

/// A state of the motion, and the index of the next step in the period of the load.
#[derive(Clone)]
pub(super) struct StepState {
    saved: SystemStepSaved,
    at: usize,
}

/// The numbers of a motion's state. Two states can be compared number by number only if the contact sticks in both
/// states, or slides in the same direction in both states.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct StateNumbers {
    pub contact: Contact,
    pub values: Vec<f64>,
}

impl StateNumbers {
    /// Returns the largest difference between the numbers of two states. It is infinite if the contact sticks in only
    /// one of the states, or slides in opposite directions.
    pub fn away(&self, other: &Self) -> f64 {
        if self.contact != other.contact || self.values.len() != other.values.len() {
            return f64::INFINITY;
        }
        let pairs = self.values.iter().zip(&other.values);
        pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
    }

    /// Returns the largest absolute value among the numbers of a state.
    pub fn size(&self) -> f64 {
        let values = self.values.iter();
        values.fold(0.0, |most, value| most.max(value.abs()))
    }
}

impl<'a> Walk<'a> {
    /// Creates the motion from rest at the beginning of the load's period.
    pub fn new(
        system: &'a System,
        load: &'a Sampled,
        friction: f64,
    ) -> Result<Self, PeriodicError> {
        let masses = system.scene().masses.len();
        let mut walk = Self {
            stepper: system.stepper(load.step)?,
            load,
            friction,
            at: 0,
            forces: vec![0.0; masses],
            slopes: vec![[0.0; 2]; masses],
        };
        let first = load.at(0);
        walk.set(first.force, [0.0; 2]);
        let sample = Sample {
            base: first.base,
            forces: &walk.forces,
            friction,
        };
        walk.stepper.deref_mut().begin(sample)?;
        Ok(walk)
    }

    fn set(&mut self, force: f64, slopes: [f64; 2]) {
        if let Some(first) = self.forces.first_mut() {
            *first = force;
        }
        if let Some(first) = self.slopes.first_mut() {
            *first = slopes;
        }
    }

    /// Advances the motion by one step of the stepper.
    pub fn step(&mut self) -> Result<Stepped<f64>, PeriodicError> {
        let (from, to) = (self.load.at(self.at), self.load.at(self.at + 1));
        let end = if self.load.hold { from } else { to };
        self.set(end.force, [from.slope, to.slope]);
        let sample = Sample {
            base: end.base,
            forces: &self.forces,
            friction: self.friction,
        };
        let stepper = self.stepper.deref_mut();
        let stepped = match self.load.cubic {
            true => stepper.advance_cubic(sample, &self.slopes)?,
            false => stepper.advance(sample)?,
        };
        self.at = (self.at + 1)
            .checked_rem(self.load.points.len())
            .unwrap_or(0);
        Ok(stepped)
    }

    /// Advances the motion by a number of periods of the load.
    pub fn periods(&mut self, count: usize) -> Result<(), PeriodicError> {
        for _ in 0..count * self.load.points.len() {
            self.step()?;
        }
        Ok(())
    }

    /// Advances the motion by one period of the load, and then to the middle of the longest sequence of steps without
    /// an event.
    pub fn reach_quiet(&mut self) -> Result<(), PeriodicError> {
        let count = self.load.points.len();
        let mut eventful = Vec::with_capacity(count);
        for _ in 0..count {
            eventful.push(self.step()?.events > 0);
        }
        let (mut best, mut middle, mut run) = (0, 0, 0);
        // The sequence of steps without an event may continue beyond the end of the period. The loop therefore covers
        // two periods.
        for place in 0..2 * count {
            let event = eventful.get(place % count.max(1)).copied().unwrap_or(true);
            run = if event { 0 } else { run + 1 };
            if best < run.min(count) {
                best = run;
                middle = place + 1 - run / 2;
            }
        }
        for _ in 0..middle.checked_rem(count).unwrap_or(0) {
            self.step()?;
        }
        Ok(())
    }

    /// Returns the present state of the motion.
    pub fn place(&self) -> StepState {
        StepState {
            saved: self.stepper.save(),
            at: self.at,
        }
    }

    /// Restores an earlier state of the motion.
    pub fn go(&mut self, place: &StepState) -> Result<(), PeriodicError> {
        self.at = place.at;
        Ok(self.stepper.restore(&place.saved)?)
    }

    /// Returns the numbers of the present state.
    pub fn numbers(&mut self) -> StateNumbers {
        let mut values = Vec::new();
        self.stepper.visit_state(|value| values.push(*value));
        StateNumbers {
            contact: self.stepper.contact().contact(),
            values,
        }
    }

    /// Adds `changes` to the numbers of the present state.
    pub fn add(&mut self, changes: &[f64]) {
        let mut changes = changes.iter();
        self.stepper
            .visit_state(|value| *value += changes.next().copied().unwrap_or(0.0));
    }
}

/// A state that repeats after a period, with the Floquet multipliers of the period.
pub(super) struct FixedPoint {
    pub place: StepState,
    pub numbers: StateNumbers,
    pub period: usize,
    pub multipliers: Vec<Complex<f64>>,
    /// Difference between the states before and after a period, divided by the size of the motion.
    pub residual: f64,
}

impl FixedPoint {
    /// Returns the largest modulus of the Floquet multipliers.
    pub fn largest(&self) -> f64 {
        self.multipliers
            .iter()
            .fold(0.0, |most, value| most.max(value.norm()))
    }
}
