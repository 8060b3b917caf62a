//! State of a stepper, and its storage.

use super::scene::StepScene;
use crate::motion::{Contact, ContactChain, Total};
use crate::number::scalar::Float;

/// Mutable view of all numbers of a stepper.
#[derive(Debug)]
pub struct StoreMut<'s, S, const D: usize> {
    /// Displacement y and scaled velocity u of each mode of the chain. u is the velocity divided by the natural
    /// frequency. While the contact sticks, only the numbers of modes that the contact does not drive are valid.
    pub modes: &'s mut [[S; 2]],
    /// Displacement y and scaled velocity u of each mode of the chain with its contact stuck. These numbers are valid
    /// only while the contact sticks.
    pub held: &'s mut [[S; 2]],
    /// Working memory with one entry for each mode.
    pub scratch: &'s mut [[S; 2]],
    /// Polynomials of the inputs over the present sub-interval.
    pub drive: &'s mut [[S; D]],
    /// Forces of the input at the last sample, divided by k₁.
    pub last: &'s mut [S],
}

impl<S: Float, const D: usize> StoreMut<'_, S, D> {
    /// Computes the state of the modes that the contact drives, when the contact stops sticking. The code computes
    /// this state from the modes of the chain with its contact stuck. `lifted` contains the displacement and the
    /// velocity of the stuck contact.
    pub(super) fn release<K: ContactChain<S>>(
        &mut self,
        scene: &StepScene<'_, S, K>,
        receptance: S,
        lifted: (S, S),
    ) {
        let held = self.held.iter().copied();
        let modes = self.modes.iter_mut().map(|[y, u]| (y, u));
        scene.dynamics.release(receptance, held, lifted, modes);
    }
}

/// Read-only view of the numbers that define a stepper's state.
#[derive(Clone, Copy, Debug)]
pub struct StoreRef<'s, S> {
    /// Displacement y and scaled velocity u of each mode of the chain. u is the velocity divided by the natural
    /// frequency.
    pub modes: &'s [[S; 2]],
    /// Displacement y and scaled velocity u of each mode of the chain with its contact stuck.
    pub held: &'s [[S; 2]],
    /// Forces of the input at the last sample, divided by k₁.
    pub last: &'s [S],
}

#[cfg(feature = "serde")]
impl<S: Float> StoreRef<'_, S> {
    /// Returns true if all numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let oscillators = self.modes.iter().chain(self.held).flatten();
        oscillators
            .chain(self.last)
            .all(|number| number.is_finite())
    }
}

/// Storage of a stepper's numbers, in arrays or vectors.
pub trait Store<S, const D: usize> {
    /// Returns all numbers as mutable slices.
    fn change(&mut self) -> StoreMut<'_, S, D>;
    /// Returns the numbers that define the stepper's state.
    fn read(&self) -> StoreRef<'_, S>;
}

/// All numbers of a stepper, stored in arrays.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedStore<S, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
{
    modes: [[S; 2]; MODES],
    held: [[S; 2]; HELD],
    scratch: [[S; 2]; MODES],
    drive: [[S; D]; INPUTS],
    last: [S; INPUTS],
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    FixedStore<S, D, MODES, HELD, INPUTS>
{
    /// Creates the numbers of a stepper at rest.
    #[must_use]
    pub fn new() -> Self {
        Self::of(S::constant(0.0))
    }

    /// Creates the numbers of a stepper at rest, in a constant expression. `zero` is the number 0.
    pub(super) const fn of(zero: S) -> Self {
        Self {
            modes: [[zero; 2]; MODES],
            held: [[zero; 2]; HELD],
            scratch: [[zero; 2]; MODES],
            drive: [[zero; D]; INPUTS],
            last: [zero; INPUTS],
        }
    }
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize> Default
    for FixedStore<S, D, MODES, HELD, INPUTS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    Store<S, D> for FixedStore<S, D, MODES, HELD, INPUTS>
{
    #[inline]
    fn change(&mut self) -> StoreMut<'_, S, D> {
        StoreMut {
            modes: &mut self.modes,
            held: &mut self.held,
            scratch: &mut self.scratch,
            drive: &mut self.drive,
            last: &mut self.last,
        }
    }

    #[inline]
    fn read(&self) -> StoreRef<'_, S> {
        StoreRef {
            modes: &self.modes,
            held: &self.held,
            last: &self.last,
        }
    }
}

/// Number of scalars of a [`Status`] in an image or another saved state.
pub(super) const SCALARS: usize = 13;

/// State of a stepper, except for the states of its oscillators.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Status<S> {
    /// State of the contact: stuck, or its direction of sliding.
    pub contact: Contact,
    /// True if the stepper must still determine the state of the contact from its velocity and its force.
    pub unknown: bool,
    /// True if the contact has just failed to start sliding. A contact force that exceeds μF only by rounding must then
    /// not make the contact slide a second time.
    pub wedged: bool,
    /// True if a stepper with derivatives has met a graze: an event whose derivative is unreliable.
    pub grazed: bool,
    /// Event budget: number of events that the stepper follows in a step. 0 means that there is no budget.
    pub budget: u8,
    /// Number of events in the earlier sub-intervals of the present step. Between steps this number is 0.
    pub spent: u8,
    /// Relative displacement of the contact while it sticks. For an elastic contact, `stuck_at` is the displacement of
    /// the slider.
    pub stuck_at: S,
    /// Index of the straight line of the friction law that contains the contact's present speed.
    pub line: usize,
    /// Displacement and velocity of the base at the end of the last step.
    pub base: [S; 2],
    /// Kinetic friction force of the contact, divided by k₁.
    pub level: S,
    /// Ratio μ of the static to the kinetic friction force.
    pub stiction: S,
    pub steps: u64,
    /// Number of steps in which a sub-interval reached the bound on events or pieces of motion.
    pub exceeded: u64,
    /// Contact force at the end of the last step, divided by k₁, if the contact sticks or its state is unknown. For an
    /// elastic contact, `contact_force` is the force of the spring, even while the slider moves.
    pub contact_force: S,
    /// Work of the load since the start, divided by k₁.
    pub load: Total<S>,
    /// Energy that friction in the contact has dissipated since the start, divided by k₁.
    pub dissipated: Total<S>,
    /// Energy of the chain at the start of the first step, divided by k₁.
    pub energy: S,
    pub pull: S,
    /// Size of the contact's velocity in an initial state that the caller has given. The size is the sum of the
    /// absolute values of the terms in this velocity. The rounding error of the velocity is proportional to the size.
    /// After the first step the field is zero.
    pub given: S,
    /// Instant of the last event in the last step, as a fraction of the step from 0 to 1. `None` if the step had no
    /// event. Images and written states do not contain this instant.
    #[cfg(feature = "event-times")]
    pub last_event: Option<S>,
}

impl<S: Float> Status<S> {
    /// Returns the law of the contact. The forces of this law are divided by k₁.
    #[inline]
    pub(super) fn law<K: ContactChain<S>>(&self, scene: &StepScene<'_, S, K>) -> K::Law {
        scene.dynamics.chain.law_with(self.level, self.stiction)
    }

    /// Creates the status of a stepper at rest, in a constant expression. `zero` is the number 0, and `stiction` is μ,
    /// the ratio of static to kinetic friction.
    pub(super) const fn new(zero: S, stiction: S) -> Self {
        Self {
            contact: Contact::Stuck,
            unknown: true,
            wedged: false,
            grazed: false,
            budget: 0,
            spent: 0,
            stuck_at: zero,
            line: 0,
            base: [zero; 2],
            level: zero,
            stiction,
            steps: 0,
            exceeded: 0,
            contact_force: zero,
            load: Total::of_parts([zero; 2]),
            dissipated: Total::of_parts([zero; 2]),
            energy: zero,
            pull: zero,
            given: zero,
            #[cfg(feature = "event-times")]
            last_event: None,
        }
    }

    /// Returns the scalars of the status, in the order in which an image (saved state) contains them.
    pub(super) fn scalars(&self) -> [S; SCALARS] {
        let [base, velocity] = self.base;
        let ([load, load_low], [lost, lost_low]) = (self.load.parts(), self.dissipated.parts());
        [
            self.stuck_at,
            base,
            velocity,
            self.level,
            self.stiction,
            self.contact_force,
            load,
            load_low,
            lost,
            lost_low,
            self.energy,
            self.pull,
            self.given,
        ]
    }

    /// Creates a status from its scalars, in the order in which an image (saved state) contains them. The other fields
    /// are those of a stepper at rest.
    pub(super) fn of_scalars(scalars: [S; SCALARS]) -> Self {
        let [
            stuck_at,
            base,
            velocity,
            level,
            stiction,
            contact_force,
            load,
            load_low,
            lost,
            lost_low,
            energy,
            pull,
            given,
        ] = scalars;
        Self {
            stuck_at,
            base: [base, velocity],
            level,
            contact_force,
            load: Total::of_parts([load, load_low]),
            dissipated: Total::of_parts([lost, lost_low]),
            energy,
            pull,
            given,
            ..Self::new(S::constant(0.0), stiction)
        }
    }
}
