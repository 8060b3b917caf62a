//! Finds the steady state of a chain with several contacts if this state attracts every motion.

use super::run::Motion;
use super::size::{Size, set};
use super::slid::LargestDisplacement;
use super::state::FREE;
use super::steady::{Search, Steady, modulus};
use super::tangent::ShotSpan;
use crate::errors::Halt;
use crate::{Float, Scalar};

/// Number of cycles that the motion runs before the first search for the steady state of a chain with μ = 1.
const SOON: usize = 4;
/// Largest number of searches for the steady state of a chain with μ = 1.
const SEARCHES: usize = 4;
/// Number of cycles that the motion runs between two searches.
const WAIT: usize = 8;

impl<S: Float, Z: Size> Search<S, Z> {
    /// Returns the steady state of a chain with μ = 1 and constant kinetic friction, under a load that has the opposite
    /// sign half a cycle later.
    ///
    /// If all contacts have μ = 1 and a constant kinetic friction, the energy of the difference between two motions
    /// under the same loads never grows. A steady state that attracts neighbouring motions therefore attracts every
    /// motion, and repeats with the opposite sign after half a cycle. The start of the search does not matter. Only the
    /// position of a contact that never slides depends on the earlier motion. In the result, the contact is in the
    /// middle of the interval in which it can stick.
    ///
    /// `near` is a steady state of a similar chain, if one is known. Newton's method then starts from it.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub(super) fn only(
        &mut self,
        motion: &Motion<S, Z>,
        near: Option<&Steady<S, Z>>,
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let model = motion.model();
        if !model.is_contraction() || !self.is_odd(model) {
            return Ok(None);
        }
        if let Some(steady) = self.stuck(motion)? {
            return Ok(Some(steady));
        }
        // A guess whose motion exceeds a bound leads to no state.
        if let Some(near) = near
            && let Ok(Some(found)) = self.beside(motion, near)
        {
            return Ok(Some(found));
        }
        let mut trial = motion.clone();
        self.advance(&mut trial, SOON - 1, &mut ())?;
        let mut reach = LargestDisplacement(S::constant(0.0));
        self.advance(&mut trial, 1, &mut reach)?;
        self.place = positive(reach.0);
        for _ in 0..SEARCHES {
            let Some(found) = self.scaled(&trial)? else {
                self.advance(&mut trial, WAIT, &mut ())?;
                continue;
            };
            return Ok(self.attracts(&found).then_some(found));
        }
        Ok(None)
    }

    /// Returns the steady state that Newton's method finds from a steady state of a similar chain, if it attracts
    /// neighbouring motions.
    fn beside(
        &mut self,
        motion: &Motion<S, Z>,
        near: &Steady<S, Z>,
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        // A contact without friction in one of the two chains alone has no state there that fits the other.
        let is_free = |phase: &i8| *phase == FREE;
        let (own, other) = (&motion.state().phases, &near.state.phases);
        let mut pairs = own.as_ref().iter().zip(other.as_ref());
        if pairs.any(|(own, other)| is_free(own) != is_free(other)) {
            return Ok(None);
        }
        self.place = positive(largest(near));
        let mut trial = motion.clone();
        trial.restart(near.state.clone());
        let found = self.scaled(&trial)?;
        Ok(found.filter(|found| self.attracts(found)))
    }

    /// Returns true if all deviations from a steady state decay.
    fn attracts(&self, steady: &Steady<S, Z>) -> bool {
        let most = S::constant(1.0) - self.tolerances.attracts;
        steady.multipliers().iter().all(|m| modulus(m) < most)
    }

    /// Returns the steady state in which no contact slides, if the friction forces permit it.
    pub(super) fn stuck(&mut self, motion: &Motion<S, Z>) -> Result<Option<Steady<S, Z>>, Halt> {
        let model = motion.model();
        let Some(response) = model.stuck(self.omega) else {
            return Ok(None);
        };
        if response
            .limit
            .is_none_or(|(limit, _)| limit > S::constant(1.0))
        {
            return Ok(None);
        }
        let mut state = motion.state().clone();
        let zero = S::constant(0.0);
        self.place = zero;
        for (mass, shape) in response.displacements.as_ref().iter().enumerate() {
            self.place = Scalar::max(self.place, modulus(shape));
            set(state.x.as_mut(), mass, shape.re);
            // x = Re X exp(iωt), so that the velocity at t = 0 is −ω Im X.
            set(state.v.as_mut(), mass, -self.omega * shape.im);
        }
        self.place = positive(self.place);
        let mut held = motion.clone();
        state.stick(model);
        held.restart(state);
        let found = self.newton(&held, ShotSpan::Half)?;
        let slides = self.moving.as_ref().contains(&true);
        Ok(found.filter(|_| !slides))
    }

    /// Searches for a periodic motion near a state. The displacements in the first cycles may be much larger than those
    /// in the steady state. The search then starts again with the size of the steady state.
    fn scaled(&mut self, motion: &Motion<S, Z>) -> Result<Option<Steady<S, Z>>, Halt> {
        let Some(found) = self.newton(motion, ShotSpan::Half)? else {
            return Ok(None);
        };
        let place = largest(&found);
        if place >= S::constant(0.5) * self.place || place <= S::constant(0.0) {
            return Ok(Some(found));
        }
        self.place = place;
        let mut near = motion.clone();
        near.restart(found.state);
        self.newton(&near, ShotSpan::Half)
    }
}

/// Returns the largest amplitude of a mass.
fn largest<S: Float, Z: Size>(steady: &Steady<S, Z>) -> S {
    let amplitudes = steady.cycle.amplitudes.as_ref().iter().copied();
    amplitudes.fold(S::constant(0.0), Scalar::max)
}

/// Returns a size of displacements, or 1 if nothing moves. The size is then arbitrary.
fn positive<S: Float>(size: S) -> S {
    if size > S::constant(0.0) {
        size
    } else {
        S::constant(1.0)
    }
}
