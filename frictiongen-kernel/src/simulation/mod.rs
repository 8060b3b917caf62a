//! The motion in time, exact: closed forms between events, events located to rounding.
//!
//! While the contact slides, every mode moves for itself under a constant friction force; while it
//! sticks, every mode of the chain with its contact held does.  Nothing is stepped through: what is
//! searched is the next event, the relative velocity's zero or the instant at which the contact
//! force reaches μβ.

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

/// A run in arrays: of an emitted solver.
pub type FixedSimulation<S, const PARTS: usize> = Simulation<'static, S, [Part<S>; PARTS]>;
/// The same with a kinetic level that changes with the speed.
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

/// A mode of the chain with its contact held: an oscillator (y, u), u = ẏ/ω in the time t√(k₁/m₁).
#[derive(Clone, Copy, Debug)]
pub struct HeldMode<S> {
    /// Which closed form applies.
    pub kind: Kind,
    /// ω, the frequency ratio r at which it resonates undamped.
    pub frequency: S,
    /// Its damping ratio.
    pub zeta: S,
    /// √|1 − ζ²|.
    pub q: S,
    /// −(contact force)/y.
    pub force: S,
    /// What takes the products of a motion with the mode's two states to y and u: the symmetric
    /// matrix [m₁₁, m₁₂, m₂₂].
    pub inverse: [S; 3],
}

/// Everything that the motion in time of a scene rests on; nothing of it depends on r or β.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics<'a, S> {
    /// What the scene says beyond its modes.
    pub chain: Chain<S>,
    /// All modes, those that the contact drives first.
    pub modes: &'a [Mode<S>],
    /// The modes of the chain with its contact held: one fewer than the contact drives.
    pub held: &'a [HeldMode<S>],
    /// For each held mode and each mode that the contact drives, how far it takes part in y and u.
    pub participations: &'a [[S; 2]],
    /// φ, mass after mass.
    pub shapes: &'a [S],
    /// φᵀΓ, mode after mode.
    pub weights: &'a [S],
    /// The mass that rubs on a support; none where two masses rub on each other.
    pub rubbing: Option<usize>,
}

impl<'a, S: Float> Dynamics<'a, S> {
    /// How many modes the contact drives.
    #[must_use]
    pub fn in_contact(&self) -> usize {
        self.held.len() + 1
    }

    /// The modes that the contact drives.
    pub(crate) fn driven(&self) -> &'a [Mode<S>] {
        self.modes.get(..self.in_contact()).unwrap_or_default()
    }

    /// The shape of a mass, one component a mode; empty if there is no such mass.
    pub(crate) fn shape(&self, mass: usize) -> &'a [S] {
        let modes = self.modes.len();
        let mut shapes = self.shapes.chunks_exact(modes.max(1));
        shapes.nth(mass).unwrap_or_default()
    }

    /// Whether the motion of this mass is the contact's: it rubs on a support at rest.
    pub(crate) fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// The held modes, each with the participations of all modes that the contact drives.
    pub(crate) fn held_modes(&self) -> impl Iterator<Item = (&'a HeldMode<S>, &'a [[S; 2]])> {
        // By ranges: an iterator over chunks could panic where the compiler loses their size.
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

/// Whether the contact sticks, or which way it slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Contact {
    /// It sticks.
    Stuck,
    /// The relative velocity is positive.
    Forward,
    /// The relative velocity is negative.
    Backward,
}

impl Contact {
    /// 1, −1, or 0 while it sticks.
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

    /// The other direction.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Stuck => Self::Stuck,
            Self::Forward => Self::Backward,
            Self::Backward => Self::Forward,
        }
    }
}

/// What ends a segment of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Event {
    /// The contact stops.
    Stop,
    /// The contact, stuck, breaks away.
    Slip,
    /// The direction of sliding changes without a stop.
    Reversal,
}

/// Re(a·e^{iτ_e}) where the excitation's sine and cosine are these.
#[inline]
pub(crate) fn rotated<S: Float>(a: Complex<S>, sine: S, cosine: S) -> S {
    a.re * cosine - a.im * sine
}
