//! Result of a search for the best friction over a band of frequencies.

use crate::Regime;
use crate::study::parameter::Parameter;

/// The reason why the amplitude at the optimum cannot be lower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumKind {
    /// Two peaks have the same height. More friction raises one peak, and less friction raises the other.
    EqualPeaks,
    /// One peak is at its own minimum with respect to friction.
    SinglePeak,
    /// Any friction increases the largest amplitude.
    NoFriction,
    /// The smallest amplitude is that of the stuck contact. More friction does not change it.
    Stuck,
    /// The requested quantity is 0, so that the result is trivial. Either the contact is stuck over the whole band, or
    /// the quantity is the contact force and there is no friction.
    Trivial,
    /// A bound on another quantity excludes frictions with a smaller amplitude.
    Bounded,
    /// Several quantities, each divided by its value, are equally large. With more friction one of them rises and
    /// another falls.
    Balanced,
}

/// A frequency at which the amplitude reaches its maximum over the band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumPeak {
    /// Frequency ratio r of the peak.
    pub r: f64,
    /// Amplitude at this frequency, in the unit of [`Optimum::amplitude`].
    pub amplitude: f64,
    /// Regime of the contact at the frequency of the peak.
    pub regime: Regime,
    /// True if the frequency is a bound of the band.
    pub at_end: bool,
    /// Derivative of this peak's amplitude with respect to β. `None` if the contact is stuck or the peak has no
    /// derivative.
    pub slope: Option<f64>,
}

/// The interval of friction around the optimum in which the amplitude exceeds the best amplitude by at most a given
/// fraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest excess of the amplitude over the best amplitude, as a fraction of the best amplitude.
    pub excess: f64,
    /// Lower bound of the interval, as friction ratio β.
    pub from: f64,
    /// Upper bound of the interval, as friction ratio β. It is infinite if the amplitude stays acceptable for any
    /// larger friction.
    pub to: f64,
}

/// The event that ended the search for an optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumEnd {
    /// The search converged to a minimum. For two equal peaks the friction ratio is exact to rounding. For a single
    /// peak half of the digits of the friction ratio are exact.
    Converged,
    /// The search ended at a friction at which the amplitude jumps. On one side of the jump the motion reaches another
    /// steady state with a larger amplitude.
    Jump,
    /// The search reached its bound on work. The result is the best friction up to that point.
    WorkSpent,
    /// The caller stopped the search. The result is the best friction up to that point.
    Stopped,
}

/// The best friction, for which the largest amplitude over a band of frequencies is smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// Best friction ratio β. Under a load whose amplitude depends on frequency it is the ratio at r = 1.
    pub beta: f64,
    /// Largest value of the requested quantity over the band with this friction.
    ///
    /// For a displacement the unit is P/k₁ (Y for base motion). For a velocity it is that unit times ω₁ = √(k₁/m₁), for
    /// an acceleration times ω₁². For a force it is P (k₁Y for base motion). A load whose amplitude depends on
    /// frequency is taken at r = 1.
    pub amplitude: f64,
    /// Angular frequency at r = 1, rad/s.
    #[doc(hidden)]
    pub reference: f64,
    /// The reason why no other friction gives a smaller amplitude.
    pub kind: OptimumKind,
    /// The event that ended the search.
    pub end: OptimumEnd,
    /// Interval of β that contains the best friction. It is the narrowest interval that the search has found. If the
    /// search did not refine its scan, the bounds are the neighbours of the best point.
    pub bracket: [f64; 2],
    /// Largest amplitude over the band just beyond the jump at which the search ended, from the known peaks. `None` if
    /// the search did not end at a jump.
    pub beyond_jump: Option<f64>,
    /// Frequencies at which the amplitude has its largest value.
    pub peaks: Vec<OptimumPeak>,
    /// Friction ratio up to which the amplitude at an undamped resonance of the band is unbounded. It is 0 without
    /// such a resonance.
    pub unbounded_to: f64,
    /// Friction ratio up to which the contact never stops anywhere in the band.
    pub free_of_sticking: f64,
    /// Friction ratio from which on a stuck state exists over the whole band. It is infinite if the band contains a
    /// resonance of the chain with its contact stuck at which no friction keeps the contact stuck.
    pub locked: f64,
    /// Largest amplitude over the band without friction. It is infinite on an undamped resonance.
    pub without_friction: f64,
    /// Largest amplitude over the band with the contact stuck at every frequency.
    pub with_contact_locked: f64,
    /// Intervals of friction in which the amplitude is at most 1, 5 and 10 per cent above the best amplitude. They
    /// show how flat the optimum is. The list is empty if the bound on work ended the search.
    pub tolerances: Vec<Tolerance>,
    /// Relative derivatives d ln X/d ln p of the best amplitude X, while friction stays optimal. The list has one for
    /// each parameter p except friction and frequency. It is empty without a load, and if no derivatives exist.
    pub sensitivities: Vec<(Parameter, f64)>,
    /// Number of amplitudes that the search computed.
    pub evaluations: usize,
    /// Number of amplitudes without a result. The motion has too many stops in a cycle, or the solvers found no motion.
    pub unanswered: usize,
}
