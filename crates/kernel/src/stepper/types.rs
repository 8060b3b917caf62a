//! Types of a stepper, and of the results that it returns.

use super::law::StepContact;
use super::scene::StepScene;
use super::state::{FixedStore, Status};
use super::table::FixedTables;
use crate::contact::sums::Chain;
use crate::motion::Contact;
use crate::number::scalar::Float;
use core::marker::PhantomData;

/// Motion of a chain as a function of time, under an input that is known step by step.
///
/// `T` owns the tables and `V` the state. Tables and state are arrays or constants in emitted code, and vectors at run
/// time. An input is a polynomial over a step, and `D` is the number of its coefficients. `K` contains the constants
/// of the chain, and selects the law of the contact.
#[derive(Clone, Debug)]
pub struct Stepper<'a, S, const D: usize, T, V, K = Chain<S>> {
    pub(super) scene: StepScene<'a, S, K>,
    pub(super) tables: T,
    pub(super) store: V,
    pub(super) status: Status<S>,
    pub(super) inputs: PhantomData<[S; D]>,
}

/// A stepper in an emitted solver. All its data are in arrays.
pub type FixedStepper<
    S,
    const D: usize,
    const MODES: usize,
    const HELD: usize,
    const INPUTS: usize,
    K = Chain<S>,
> = Stepper<
    'static,
    S,
    D,
    FixedTables<S, D, MODES, HELD, INPUTS>,
    FixedStore<S, D, MODES, HELD, INPUTS>,
    K,
>;

/// A stepper in an emitted solver whose description declares the time step. The stepper borrows its tables, which are
/// constants of the program.
pub type DeclaredStepper<
    S,
    const D: usize,
    const MODES: usize,
    const HELD: usize,
    const INPUTS: usize,
    K = Chain<S>,
> = Stepper<
    'static,
    S,
    D,
    &'static FixedTables<S, D, MODES, HELD, INPUTS>,
    FixedStore<S, D, MODES, HELD, INPUTS>,
    K,
>;

impl<S, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize, K>
    DeclaredStepper<S, D, MODES, HELD, INPUTS, K>
where
    S: Float,
    K: StepContact<S>,
{
    /// Creates a stepper at rest without load, in a constant expression. `zero` is the number 0, and `stiction` is μ,
    /// the ratio of static to kinetic friction.
    #[doc(hidden)]
    #[must_use]
    pub const fn declared(
        scene: StepScene<'static, S, K>,
        tables: &'static FixedTables<S, D, MODES, HELD, INPUTS>,
        (zero, stiction): (S, S),
    ) -> Self {
        Self::of(scene, tables, FixedStore::of(zero), (zero, stiction))
    }
}

/// Result of one step of a stepper.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped<S> {
    /// State of the contact at the end of the step: stuck, or its direction of sliding.
    pub contact: Contact,
    /// Friction force in the contact at the end of the step, in the scene's unit of force.
    pub force: S,
    /// Number of stops, break-aways and reversals in the step.
    pub events: u32,
    /// True if the stepper has reached its bound on events, or on pieces of motion between events, in a sub-interval
    /// of the step. The stepper has then followed no further events in the rest of this sub-interval.
    pub exceeded: bool,
}

/// Displacement and velocity of a mass at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MassNow<S> {
    pub(super) displacement: S,
    pub(super) velocity: S,
}

/// Displacement, velocity and friction force of the contact at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ContactNow<S> {
    pub(super) motion: MassNow<S>,
    pub(super) contact: Contact,
    pub(super) force: S,
}

impl<S: Float> MassNow<S> {
    /// Returns the displacement of the mass at the end of the last step, in the scene's unit of length.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the velocity of the mass at the end of the last step, in the scene's unit of length per second.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

impl<S: Float> ContactNow<S> {
    /// Returns the relative displacement of the contact at the end of the last step, in the scene's unit of length.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.motion.displacement
    }

    /// Returns the relative velocity of the contact at the end of the last step, in the scene's unit of length per
    /// second. This velocity is 0 while a rigid contact sticks. An elastic contact can move with its spring while it
    /// sticks.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.motion.velocity
    }

    /// Returns the friction force in the contact at the end of the last step, in the scene's unit of force. While a
    /// rigid contact sticks, the friction force is the force that keeps the contact at rest. While an elastic contact
    /// sticks, it is the force of the contact's spring. A positive force opposes sliding in the positive direction.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Returns the state of the contact at the end of the last step: stuck, or its direction of sliding.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.contact
    }

    /// Returns true if the contact sticks at the end of the last step.
    #[must_use]
    pub fn is_sticking(&self) -> bool {
        self.contact == Contact::Stuck
    }
}
