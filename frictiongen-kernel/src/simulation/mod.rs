//! The exact motion in time: closed forms between events, and events located to rounding.
//!
//! While the contact slides, every mode moves independently under a constant friction force.  While the contact sticks,
//! every mode of the stuck chain does.  The motion is not integrated in time steps.  The simulation searches for the
//! next event, which is a zero of the relative velocity, or the instant at which the contact force reaches μβ.
//!
//! In this folder the *stuck chain* is the chain whose contact sticks.  Its modes are called `held` in the code.

mod clock;
mod coupled;
mod held;
pub(crate) mod law;
mod lines;
mod local;
mod part;
mod peak;
mod power;
mod run;
mod segment;
mod setting;
mod step;
mod sum;
mod walk;

pub use coupled::MAX_STEEPNESS;
pub use lines::{Constant, Level, Lines};
pub use part::Part;
pub use run::{MAX_STRETCHES, Moment, Segment, Simulation};

/// A simulation of an emitted solver, with its data in arrays.
pub type FixedSimulation<S, const PARTS: usize> = Simulation<'static, S, [Part<S>; PARTS]>;
/// A simulation of an emitted solver whose kinetic friction changes with the speed, with its data in arrays.
pub type FixedLinesSimulation<S, const PARTS: usize> =
    Simulation<'static, S, [Part<S>; PARTS], Lines<'static, S>>;
pub use setting::Setting;
pub use walk::MAX_STEPS;

pub(crate) use clock::Total;
pub(crate) use local::ROUNDINGS as SUM_ROUNDINGS;
pub(crate) use part::lift;
pub(crate) use power::{Power, TERMS, WALK};
pub(crate) use segment::{ContactState, End, leap, phase, span};
pub(crate) use sum::Sum;
pub(crate) use walk::{Start, Walk, first_reach, first_zero};

use crate::contact::sums::Chain;
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use crate::oscillator::mode::{Kind, Mode};

/// A mode of the chain whose contact sticks: an oscillator (y, u), u = ẏ/ω in the time t√(k₁/m₁).
#[derive(Clone, Copy, Debug)]
pub struct HeldMode<S> {
    /// Kind of the mode, which selects its closed form.
    pub kind: Kind,
    /// ω, the undamped natural frequency as a frequency ratio r.
    pub frequency: S,
    /// Modal damping ratio ζ.
    pub zeta: S,
    /// √|1 − ζ²|.
    pub q: S,
    /// −(contact force)/y: the contact force per unit of y, with the opposite sign.
    pub force: S,
    /// Symmetric matrix [m₁₁, m₁₂, m₂₂] that transforms the products of a motion with the mode's two states to y and u.
    pub inverse: [S; 3],
}

/// Data of a scene for its motion in time.  None of them depends on r or β.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics<'a, S> {
    /// Constants of the scene other than its modes.
    pub chain: Chain<S>,
    /// All modes, with those that the contact drives first.
    pub modes: &'a [Mode<S>],
    /// The modes of the stuck chain, one fewer than the contact drives.
    pub held: &'a [HeldMode<S>],
    /// Participation factors of each mode that the contact drives in each mode of the stuck chain, for y and for u.
    pub participations: &'a [[S; 2]],
    /// Mode shapes φ, mass after mass.
    pub shapes: &'a [S],
    /// Products φᵀΓ, mode after mode.
    pub weights: &'a [S],
    /// Index of the mass that rubs on a support, or `None` where two masses rub on each other.
    pub rubbing: Option<usize>,
}

impl<'a, S: Float> Dynamics<'a, S> {
    /// Number of modes that the contact drives.
    #[must_use]
    pub fn in_contact(&self) -> usize {
        self.held.len() + 1
    }

    /// The modes that the contact drives.
    pub(crate) fn driven(&self) -> &'a [Mode<S>] {
        self.modes.get(..self.in_contact()).unwrap_or_default()
    }

    /// Components of a mass in all mode shapes, or an empty slice if there is no such mass.
    pub(crate) fn shape(&self, mass: usize) -> &'a [S] {
        let modes = self.modes.len();
        let mut shapes = self.shapes.chunks_exact(modes.max(1));
        shapes.nth(mass).unwrap_or_default()
    }

    /// Returns true if this mass moves exactly as the contact does, because it rubs on a support at rest.
    pub(crate) fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// The modes of the stuck chain, each with the participation factors of all modes that the contact drives.
    pub(crate) fn held_modes(&self) -> impl Iterator<Item = (&'a HeldMode<S>, &'a [[S; 2]])> {
        // Ranges instead of an iterator over chunks, which could panic where the compiler does not know their size.
        let (participations, size) = (self.participations, self.in_contact());
        let held = self.held.iter().enumerate();
        held.map(move |(index, mode)| {
            let start = index * size;
            (
                mode,
                participations.get(start..start + size).unwrap_or_default(),
            )
        })
    }
}

/// State of the contact: stuck, or sliding in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Contact {
    /// The contact sticks.
    Stuck,
    /// The contact slides with positive relative velocity.
    Forward,
    /// The contact slides with negative relative velocity.
    Backward,
}

impl Contact {
    /// Sign of the relative velocity: 1, −1, or 0 while the contact sticks.
    pub(crate) fn sign<S: Float>(self) -> S {
        S::constant(match self {
            Self::Stuck => 0.0,
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        })
    }

    /// Sliding in the direction of a force.
    pub(crate) fn along<S: Float>(force: S) -> Self {
        if force < S::constant(0.0) {
            Self::Backward
        } else {
            Self::Forward
        }
    }

    /// Returns the opposite direction of sliding.  A stuck contact stays stuck.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Stuck => Self::Stuck,
            Self::Forward => Self::Backward,
            Self::Backward => Self::Forward,
        }
    }
}

/// Event that ends a segment of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Event {
    /// The contact stops and sticks.
    Stop,
    /// The stuck contact breaks away.
    Slip,
    /// The direction of sliding changes without a stop.
    Reversal,
}

/// Re(a·e^{iτ_e}), from the sine and the cosine of the excitation's angle τ_e.
#[inline]
pub(crate) fn rotated<S: Float>(a: Complex<S>, sine: S, cosine: S) -> S {
    a.re * cosine - a.im * sine
}
