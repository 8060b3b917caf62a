//! The best friction over a band.

use crate::Regime;
use crate::study::parameter::Parameter;

/// What limits the amplitude at the optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumKind {
    /// Peaks of the same height: with more friction one rises, with less another.
    EqualPeaks,
    /// One peak at its own minimum.
    SinglePeak,
    /// Any friction makes it worse.
    NoFriction,
    /// The contact is best stuck: more friction changes nothing.
    Stuck,
}

/// A frequency at which the largest amplitude is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumPeak {
    /// r.
    pub r: f64,
    /// Over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What the contact does there.
    pub regime: Regime,
    /// Whether it is an end of the band.
    pub at_end: bool,
    /// dX/dβ of this peak; none where it is stuck or has no derivative.
    pub slope: Option<f64>,
}

/// How far friction may be from the optimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// By which share the largest amplitude is above the best at most.
    pub excess: f64,
    /// β from here,
    pub from: f64,
    /// to here; infinite where more friction never does harm.
    pub to: f64,
}

/// How the search for an optimum ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumEnd {
    /// At a least: friction is found to rounding where two peaks cross, to half of the digits where one is at its least.
    Converged,
    /// At a jump: on one side of the bracket another steady state is reached, with a larger amplitude.
    Jump,
    /// The work that one search may take was done before: this is the best so far.
    WorkSpent,
}

/// The friction that keeps the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// β.
    pub beta: f64,
    /// The largest amplitude of the band over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What limits it.
    pub kind: OptimumKind,
    /// How the search ended.
    pub end: OptimumEnd,
    /// β between which the least lies, as far as it was looked for: neighbours of the scan where it was not looked for
    /// between them.
    pub bracket: [f64; 2],
    /// Where it is reached.
    pub peaks: Vec<OptimumPeak>,
    /// Up to this β the amplitude at an undamped resonance of the band is unbounded; 0 where there is none.
    pub unbounded_to: f64,
    /// Up to this β nothing sticks anywhere in the band.
    pub free_of_sticking: f64,
    /// From this β on a stuck state exists all over the band; infinite if nothing holds the contact on a resonance of the
    /// stuck chain.
    pub locked: f64,
    /// The largest amplitude without friction; infinite on an undamped resonance.
    pub without_friction: f64,
    /// The largest amplitude with the contact stuck all over the band.
    pub with_contact_locked: f64,
    /// How flat the optimum is: 1, 5 and 10 per cent above the best.
    pub tolerances: Vec<Tolerance>,
    /// d ln X/d ln p of the amplitude at the optimum, which friction follows: for each parameter but friction and frequency.
    /// Empty without a load and where there are no derivatives.
    pub sensitivities: Vec<(Parameter, f64)>,
    /// How many amplitudes were computed.
    pub evaluations: usize,
    /// How many of them had no answer: a motion with too many stops in a cycle, or none that was found.
    pub unanswered: usize,
}
