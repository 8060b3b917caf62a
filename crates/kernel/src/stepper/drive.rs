//! Input of a stepper between two samples, as one polynomial for each sub-interval of a step.

use super::input::Input;
use super::scene::StepScene;
use crate::errors::{Given, OutOfDomain};
use crate::motion::{ContactChain, Law};
use crate::number::scalar::Float;

/// Input of a stepper at one instant, in the units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sample<'i, S> {
    /// Displacement and velocity of the base. A scene whose base is at rest ignores these two numbers.
    pub base: [S; 2],
    /// Forces on the masses at this instant, one for each mass on which the input acts.
    pub forces: &'i [S],
    /// Kinetic friction force F, which is at least 0. With linear input, F acts during the step that ends at this
    /// sample. With zero-order hold, F acts during the step that starts at this sample.
    pub friction: S,
}

impl<S: Float> Sample<'_, S> {
    /// Returns an error if the sample has a wrong number of forces, or a number outside the permitted range.
    /// `stiction` is μ, the ratio of static to kinetic friction.
    pub(super) fn check<K: ContactChain<S>>(
        &self,
        scene: &StepScene<'_, S, K>,
        stiction: S,
    ) -> Result<(), OutOfDomain> {
        let sound = |value: S| is_sound(scene, value);
        if self.forces.len() != scene.forces.len() {
            return Err(OutOfDomain::Forces);
        }
        if let Some(force) = self.forces.iter().find(|force| !sound(**force)) {
            return Err(OutOfDomain::Force(Given::of(*force)));
        }
        check_base(scene, self.base)?;
        let friction = self.friction;
        let law = scene.dynamics.chain.law_with(friction, stiction);
        if !(S::constant(0.0) <= friction && sound(friction) && sound(law.grip())) {
            return Err(OutOfDomain::Friction(Given::of(friction)));
        }
        Ok(())
    }
}

/// Returns true if the square of a force, divided by k₁, stays far from the largest number.
fn is_sound<S: Float, K: ContactChain<S>>(scene: &StepScene<'_, S, K>, force: S) -> bool {
    let (_, limit) = S::inverse_ratio_range();
    let most = limit * scene.units.stiffness;
    let energy = limit * limit * scene.units.stiffness;
    let size = force.abs();
    // The work of an input in a step is a few times the square of the input divided by k₁. This work must stay finite,
    // too. The comparison is strict, because infinity is not less than infinity.
    size <= most && size * size < energy
}

/// Returns an error if the displacement or the velocity of a moving base is outside the permitted range.
pub(super) fn check_base<S: Float, K: ContactChain<S>>(
    scene: &StepScene<'_, S, K>,
    [place, velocity]: [S; 2],
) -> Result<(), OutOfDomain> {
    let (stiffness, rate) = (scene.units.stiffness, scene.units.rate);
    if scene.on_base && !is_sound(scene, place * stiffness) {
        return Err(OutOfDomain::BaseMotion(Given::of(place)));
    }
    if scene.on_base && !is_sound(scene, velocity / rate * stiffness) {
        return Err(OutOfDomain::BaseMotion(Given::of(velocity)));
    }
    Ok(())
}

/// A sub-interval of a step: its start and its length as fractions of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct SubInterval<S> {
    /// Start of the sub-interval, as a fraction of the step from 0 to 1.
    pub start: S,
    /// Length of the sub-interval, as a fraction of the step.
    pub length: S,
}

impl<S: Float> SubInterval<S> {
    pub(super) fn nth(place: u32, parts: u32) -> Self {
        let parts = S::constant(f64::from(parts));
        Self {
            start: S::constant(f64::from(place)) / parts,
            length: S::constant(1.0) / parts,
        }
    }

    /// Returns a straight line over the step as a polynomial over this sub-interval. The line has the value `from` at
    /// the start of the step, and `to` at its end.
    pub(super) fn line<const D: usize>(self, from: S, to: S) -> [S; D] {
        let rise = to - from;
        let mut terms = [S::constant(0.0); D];
        let line = [from + rise * self.start, rise * self.length];
        for (term, value) in terms.iter_mut().zip(line) {
            *term = value;
        }
        terms
    }

    /// Converts a cubic polynomial over the step to a polynomial over the sub-interval.
    pub(super) fn cubic(self, cubic: [S; 4]) -> [S; 4] {
        let mut terms = cubic;
        if self.length == S::constant(1.0) {
            return terms;
        }
        shift(&mut terms, self.start);
        let mut factor = S::constant(1.0);
        for term in &mut terms {
            *term = *term * factor;
            factor = factor * self.length;
        }
        terms
    }
}

/// Returns the displacement of the base during a step as a cubic polynomial. The unit of time is the step. With linear
/// input the polynomial has the given displacement and velocity at both ends of the step. With zero-order hold the
/// polynomial is a straight line from the displacement at the start of the step.
pub(super) fn base_motion<S: Float>(input: Input, from: [S; 2], to: [S; 2]) -> [S; 4] {
    let zero = S::constant(0.0);
    let (two, three) = (S::constant(2.0), S::constant(3.0));
    match input {
        Input::Hold => {
            let [place, velocity] = to;
            [place, velocity, zero, zero]
        }
        Input::Linear => {
            let ([y0, v0], [y1, v1]) = (from, to);
            let rise = y1 - y0;
            [y0, v0, three * rise - two * v0 - v1, v0 + v1 - two * rise]
        }
    }
}

/// Moves the origin of the polynomial's variable by `by`.
pub(super) fn shift<S: Float>(terms: &mut [S], by: S) {
    // Short polynomials need no loop. On a microcontroller a loop would cost more than the sums.
    match terms {
        [_] => return,
        [a, b] => {
            *a = *a + by * *b;
            return;
        }
        [a, b, c, d] => {
            *c = *c + by * *d;
            *b = *b + by * *c;
            *a = *a + by * *b;
            *c = *c + by * *d;
            *b = *b + by * *c;
            *c = *c + by * *d;
            return;
        }
        _ => {}
    }
    let count = terms.len();
    for start in 0..count {
        let mut above = S::constant(0.0);
        for term in terms.iter_mut().skip(start).rev() {
            *term = *term + by * above;
            above = *term;
        }
    }
}

/// Returns the coefficients of the derivative of a cubic polynomial.
pub(super) fn derived<S: Float>([_, b, c, d]: [S; 4]) -> [S; 4] {
    let (two, three) = (S::constant(2.0), S::constant(3.0));
    [b, two * c, three * d, S::constant(0.0)]
}

/// Returns the value of the polynomial `terms` at the instant `place`.
pub(super) fn at<S: Float>(terms: &[S], place: S) -> S {
    let terms = terms.iter().rev();
    terms.fold(S::constant(0.0), |sum, term| sum * place + *term)
}

/// Returns the value of the polynomial `terms` at the instant `place` minus its value at 0.
pub(super) fn growth<S: Float>(terms: &[S], place: S) -> S {
    at(terms.get(1..).unwrap_or_default(), place) * place
}
