//! Data of a stepper during one sub-interval of a step.

use super::drive::shift;
use super::scene::StepScene;
use super::state::{Status, StoreMut};
use super::table::View;
use crate::motion::ContactChain;
use crate::number::scalar::Float;

/// Bound on the rounding error of a sum over modes, divided by the rounding unit and by the sum of the absolute values
/// of its terms.
pub(super) const ROUNDINGS: f64 = 8.0;
/// Factor 1/8 in the bound on the distance of a function from its chord over a unit of time. The distance is at most
/// 1/8 of the largest absolute value of the function's second derivative.
pub(super) const OFF_CHORD: f64 = 0.125;

/// Data of a stepper during one sub-interval of a step. The unit of time is one sub-interval.
pub struct StepInterval<'t, 'a, S, const D: usize, K> {
    pub scene: &'t StepScene<'a, S, K>,
    pub table: View<'t, S, D>,
    pub store: StoreMut<'t, S, D>,
    pub status: &'t mut Status<S>,
    /// Displacement of the base in the sub-interval, as a polynomial. The stepper uses this polynomial only if the
    /// contact rubs on the moving base, or if damping acts relative to the base.
    pub base: [S; 4],
    /// Elapsed fraction of the sub-interval, from 0 to 1. The polynomials of the inputs have their origin at this
    /// instant.
    pub progress: S,
    /// Number of events that the stepper has followed in the sub-interval so far.
    pub events: u32,
    /// True if the number of events or of pieces of motion in the sub-interval has reached its bound.
    pub exceeded: bool,
    /// Start and length of the sub-interval, as fractions of the step.
    #[cfg(feature = "event-times")]
    pub(super) stretch: super::drive::SubInterval<S>,
}

/// State of a contact that starts to slide from zero velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure<S> {
    /// Relative acceleration of the contact in its direction of sliding.
    pub slope: S,
    /// Displacement at which the contact has been stuck until this instant, or `None` if the contact did not stick.
    pub stuck: Option<S>,
}

impl<S: Float, const D: usize, K: ContactChain<S>> StepInterval<'_, '_, S, D, K> {
    pub(super) fn driven(&self) -> usize {
        self.scene.dynamics.in_contact().min(self.store.modes.len())
    }

    /// Returns the law of the contact. The forces of this law are divided by k₁.
    #[inline]
    pub(super) fn law(&self) -> K::Law {
        self.status.law(self.scene)
    }

    pub(super) fn terms(&self) -> usize {
        self.scene.terms(self.table.pace.terms)
    }

    /// Returns the acceleration of the contact. `excess` is the contact force minus the force at which the velocity of
    /// the contact would stay constant.
    pub(super) fn acceleration(&self, excess: S) -> S {
        self.scene.acceleration(&self.table.pace, excess)
    }

    pub(super) fn take_modes(&mut self) {
        let driven = self.driven();
        let modes = self.store.modes.iter_mut().take(driven);
        for (state, next) in modes.zip(&*self.store.scratch) {
            *state = *next;
        }
    }

    pub(super) fn account(&mut self, load: S, friction: S) {
        self.status.load = self.status.load.plus(load);
        self.status.dissipated = self.status.dissipated.plus(friction);
    }

    /// Counts an event at the present instant.
    #[inline]
    pub(super) fn count_event(&mut self) {
        self.events += 1;
        #[cfg(feature = "event-times")]
        {
            let within = self.stretch.length * self.progress;
            self.status.last_event = Some(self.stretch.start + within);
        }
    }

    /// Advances the present instant by `tau`. Moves the origin of the inputs' polynomials to the new instant.
    pub(super) fn shift_inputs(&mut self, tau: S) {
        let one = S::constant(1.0);
        let end = one - self.progress <= tau;
        self.progress = if end { one } else { self.progress + tau };
        for drive in &mut *self.store.drive {
            shift(drive, tau);
        }
        shift(&mut self.base, tau);
    }
}

/// Returns the integral of the product of the polynomials `a` and `b` from 0 to the instant `place`.
pub(super) fn product<S: Float>(a: &[S], b: &[S], place: S) -> S {
    let one = S::constant(1.0);
    let mut sum = S::constant(0.0);
    let (mut order, mut power) = (one, place);
    for a in a {
        let (mut n, mut p) = (order, power);
        for b in b {
            sum = sum + *a * *b * p / n;
            (n, p) = (n + one, p * place);
        }
        (order, power) = (order + one, power * place);
    }
    sum
}

/// Returns the integral of the power series `terms` from 0 to the instant `place`.
pub(super) fn integral<S: Float>(terms: &[S], place: S) -> S {
    product(terms, &[S::constant(1.0)], place)
}
