//! The best friction over a band.

use crate::Regime;
use crate::study::parameter::Parameter;

/// The reason why the amplitude at the optimum cannot be lower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumKind {
    /// Two peaks have the same height. More friction raises one of them, less friction the other.
    EqualPeaks,
    /// One peak is at its own minimum.
    SinglePeak,
    /// Any friction increases the amplitude.
    NoFriction,
    /// The contact is best stuck, and more friction changes nothing.
    Stuck,
}

/// A frequency at which the largest amplitude is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumPeak {
    /// Frequency ratio r.
    pub r: f64,
    /// Amplitude over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// Regime at this frequency.
    pub regime: Regime,
    /// True if the frequency is a bound of the band.
    pub at_end: bool,
    /// Derivative dX/dβ of this peak. `None` where the contact is stuck or the peak has no derivative.
    pub slope: Option<f64>,
}

/// The interval of friction around the optimum for a given excess of the amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest excess of the amplitude over the best, as a fraction.
    pub excess: f64,
    /// Lower bound of β.
    pub from: f64,
    /// Upper bound of β. It is infinite where more friction never exceeds this amplitude.
    pub to: f64,
}

/// The cause that ended the search for an optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumEnd {
    /// The search converged to a minimum. Friction is found to rounding where two peaks cross, and to half of the
    /// digits where one peak is at its minimum.
    Converged,
    /// The search ended at a jump. On one side of the bracket the motion reaches another steady state with a larger
    /// amplitude.
    Jump,
    /// The search met its bound on work. The result is the best so far.
    WorkSpent,
}

/// The friction that keeps the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// Best friction ratio β.
    pub beta: f64,
    /// Largest amplitude of the band at this friction, over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// The reason why the amplitude cannot be lower.
    pub kind: OptimumKind,
    /// The cause that ended the search.
    pub end: OptimumEnd,
    /// Interval of β that contains the least, as far as the search went. Where the search did not refine between points
    /// of the scan, the bounds are the neighbours of the best one.
    pub bracket: [f64; 2],
    /// Frequencies at which the largest amplitude is reached.
    pub peaks: Vec<OptimumPeak>,
    /// β up to which the amplitude at an undamped resonance of the band is unbounded. It is 0 without such a resonance.
    pub unbounded_to: f64,
    /// β up to which the contact never stops anywhere in the band.
    pub free_of_sticking: f64,
    /// β from which a stuck state exists over the whole band. It is infinite if no friction keeps the contact stuck on
    /// a resonance of the stuck chain.
    pub locked: f64,
    /// Largest amplitude without friction. It is infinite on an undamped resonance.
    pub without_friction: f64,
    /// Largest amplitude with the contact stuck over the whole band.
    pub with_contact_locked: f64,
    /// Intervals of friction for 1, 5 and 10 per cent above the best amplitude. They show how flat the optimum is.
    pub tolerances: Vec<Tolerance>,
    /// Relative derivatives d ln X/d ln p of the optimum's amplitude X, while friction stays optimal. The list has each
    /// parameter p except friction and frequency. It is empty without a load, and where there are no derivatives.
    pub sensitivities: Vec<(Parameter, f64)>,
    /// Number of amplitudes that were computed.
    pub evaluations: usize,
    /// Number of amplitudes without a result. Either the motion has too many stops in a cycle, or no motion was found.
    pub unanswered: usize,
}
