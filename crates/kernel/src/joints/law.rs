//! Kinetic friction of rigid contacts as a function of the sliding speed (Stribeck's law).
//!
//! The law consists of straight lines between points. On one line, the force of a sliding contact is a linear function
//! of its relative velocity, so that the equations of motion stay linear. A stretch (time interval of one power
//! series) therefore ends where a contact leaves its line. The solver then finds the new line from the velocity.

use super::model::{Contact, Model};
use super::poly::{Poly, angle_of};
use super::roots::first_negative_within;
use super::run::Motion;
use super::series::Series;
use super::size::{Size, add, at, sign};
use super::state::{FREE, STUCK, State};
use super::wave::Wave;
use crate::errors::Halt;
use crate::motion::{KineticLine, line, line_at};
use crate::{Float, Scalar};

/// Excess of the sliding speed over the end of a line of the friction law at which a contact leaves the line, in
/// rounding units of the velocities. The excess is larger than the rounding error of a velocity. A contact therefore
/// does not return at once to the line that it has just left.
const BEYOND: f64 = 64.0;

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns true if the kinetic friction of a contact depends on its sliding speed.
    pub(super) fn has_lines(&self, contact: &Contact<S>) -> bool {
        contact.is_rigid() && !self.law.as_ref().is_empty()
    }

    /// Returns true if the energy of the difference between two motions under the same loads cannot grow. The energy
    /// cannot grow if static and kinetic friction are equal, and if the kinetic friction does not depend on the speed.
    pub(super) fn is_contraction(&self) -> bool {
        let one = S::constant(1.0);
        let mut contacts = self.contacts().iter();
        !self.has_stops()
            && contacts.all(|contact| contact.stiction == one && !self.has_lines(contact))
    }

    /// Returns the line of the friction law that contains the sliding speed of a contact.
    pub(super) fn line(&self, contact: &Contact<S>, velocity: S) -> KineticLine<S> {
        if !self.has_lines(contact) {
            return line(&[], 0);
        }
        let points = self.law.as_ref();
        line(points, line_at(points, velocity.abs()))
    }

    /// Returns the kinetic friction force of a contact at a relative velocity.
    pub(super) fn kinetic(&self, contact: &Contact<S>, time: S, velocity: S) -> S {
        let level = contact.level.value(time, 0);
        if !self.has_lines(contact) {
            return level;
        }
        let line = self.line(contact, velocity);
        level * (line.level + line.slope * velocity.abs())
    }

    /// Returns the derivative of a sliding contact's force with respect to its relative velocity.
    pub(super) fn drag(&self, contact: &Contact<S>, state: &State<S, Z>, time: S) -> S {
        if !self.has_lines(contact) {
            return S::constant(0.0);
        }
        let (_, v) = state.nodes(self, time);
        let line = self.line(contact, self.slip(contact, v.as_ref()));
        contact.level.value(time, 0) * line.slope
    }

    /// Returns one coefficient in the power series of a sliding contact's force, on a line of the friction law. `side`
    /// is the direction of sliding. `time` contains the start of the time interval and its length. `speeds` has the
    /// coefficients of the relative velocity, and `order` is the index of the coefficient.
    pub(super) fn force_term(
        &self,
        contact: &Contact<S>,
        (line, side): (&KineticLine<S>, i8),
        time: (S, S),
        (speeds, order): (&Poly<S>, usize),
    ) -> S {
        let level = contact.level.terms(time.0, time.1, 0);
        let products = level.iter().zip(speeds.iter().take(order + 1).rev());
        let product = products.fold(S::constant(0.0), |sum, (level, speed)| {
            sum + *level * *speed
        });
        sign::<S>(side) * line.level * at(&level, order) + line.slope * product
    }

    /// Returns an upper bound on the rate, in 1/time, at which the slope of the friction law alone makes the relative
    /// velocity of a sliding contact grow or decay.
    fn steepness(&self, contact: &Contact<S>, velocity: S, time: S) -> S {
        let level = largest(&contact.level, time, self.stretch);
        let slope = self.line(contact, velocity).slope.abs();
        slope * level * (self.inverse_mass(contact.plus) + self.inverse_mass(contact.minus))
    }
}

/// Returns an upper bound on the absolute value of a level (kinetic friction force) from the instant `time` on, for
/// the duration `length`.
fn largest<S: Float>(level: &Wave<S>, time: S, length: S) -> S {
    let line = level.constant + level.slope * time;
    line.abs() + level.slope.abs() * length + level.amplitude.abs()
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Returns the duration of the longest stretch (time interval of one power series) from the present instant.
    pub(super) fn longest_stretch(&self) -> S {
        if self.model.law.as_ref().is_empty() {
            return self.model.stretch;
        }
        let (_, v) = self.nodes();
        let angle = S::constant(angle_of::<S>());
        let rates = self.sliding().map(|(contact, _)| {
            let velocity = self.model.slip(contact, v.as_ref());
            self.model.steepness(contact, velocity, self.time)
        });
        angle / rates.fold(angle / self.model.stretch, |sum, rate| sum + rate)
    }

    /// Returns the fraction of the time interval after which a contact first leaves its line of the friction law, or
    /// `None` if no contact does.
    ///
    /// # Errors
    ///
    /// [`Halt::Stretches`] if a search reaches its limit.
    pub(super) fn line_end(
        &self,
        series: &Series<S, Z>,
        divisions: &mut u32,
    ) -> Result<Option<S>, Halt> {
        let mut first = None;
        for (contact, side) in self.sliding() {
            let ends = (contact.plus, contact.minus);
            let speed = series.slip_terms(contact.sides());
            let speed = speed.map(|term| sign::<S>(side) * term);
            let line = self.model.line(contact, at(&speed, 0));
            let sizes = series.speed_at_start(ends.0).abs() + series.speed_at_start(ends.1).abs();
            let beyond = |end: S| S::constant(BEYOND * S::EPSILON) * (end + sizes);
            let rises = line.high.map(|high| {
                let mut left = speed.map(|term| -term);
                add(&mut left, 0, high + beyond(high));
                left
            });
            let falls = (!line.low.is_zero()).then(|| {
                let mut left = speed;
                add(&mut left, 0, beyond(line.low) - line.low);
                left
            });
            for left in rises.into_iter().chain(falls) {
                let end = first_negative_within(&left, 0, divisions)?;
                first = first.into_iter().chain(end).reduce(Scalar::min);
            }
        }
        Ok(first)
    }

    /// Returns the sliding contacts whose friction depends on the speed, each with its direction.
    fn sliding(&self) -> impl Iterator<Item = (&Contact<S>, i8)> {
        let contacts = self.model.contacts().iter().enumerate();
        contacts.filter_map(|(j, contact)| {
            let phase = self.state.phase(j);
            let slides = ![STUCK, FREE].contains(&phase) && self.model.has_lines(contact);
            slides.then_some((contact, phase))
        })
    }
}
