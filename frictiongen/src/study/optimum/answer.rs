//! Result of a search for the best friction over a band of frequencies.

use super::number::Tunable;
use crate::Regime;
use crate::study::parameter::Parameter;

/// The reason why a friction is the best one, such as two equal peaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumKind {
    /// The largest amplitude is that of two peaks of the same height. More friction raises one peak, and less friction
    /// raises the other.
    EqualPeaks,
    /// The largest amplitude is that of one peak. More friction and less friction both raise the largest amplitude.
    SinglePeak,
    /// The best friction is 0, because any friction increases the largest amplitude.
    NoFriction,
    /// The amplitude is smallest while the contacts are stuck at every frequency of the band. More friction does not
    /// change anything.
    Stuck,
    /// The largest amplitude is the same over an interval of friction, because no contact slides at the frequency of
    /// the peak. [`Optimum::bracket`] contains the interval, whose upper bound may be infinite. The best friction is its
    /// lower bound.
    Flat,
    /// The requested quantity is 0, so that the result is trivial. Either the contact is stuck over the whole band, or
    /// the quantity is the contact force and there is no friction.
    Trivial,
    /// A bound on another quantity excludes the frictions with a smaller amplitude.
    Bounded,
    /// Several quantities, each divided by its reference value, are equally large. With more friction one of these
    /// quotients increases, and another quotient decreases.
    Balanced,
}

/// A frequency at which the amplitude has its largest value over the band.
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
    /// Derivative of this peak's amplitude with respect to β. `None` if the contact is stuck, or if the peak has no
    /// derivative.
    pub slope: Option<f64>,
}

/// An interval of friction around the best friction. In this interval, the amplitude exceeds the best amplitude by at
/// most a given fraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest value of (amplitude − best amplitude)/best amplitude in the interval.
    pub excess: f64,
    /// Lower bound of the interval of friction ratios β.
    pub from: f64,
    /// Upper bound of the interval, as friction ratio β. It is infinite if the amplitude stays within the tolerance for
    /// any larger friction.
    pub to: f64,
}

/// The event that ended the search for an optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumEnd {
    /// The search converged to a minimum. For two equal peaks the friction ratio is exact to rounding. For a single
    /// peak about half of the digits of the friction ratio are exact.
    Converged,
    /// The search ended at a friction at which the amplitude jumps. On one side of the jump the motion reaches another
    /// steady state, which has a larger amplitude.
    Jump,
    /// Every check on a finer grid of frequencies found a higher peak, up to the largest number of checks. The amplitude
    /// of the result is the largest found.
    Unconfirmed,
    /// The search reached its bound on work. The result is the best friction that the search found before.
    WorkSpent,
    /// The caller stopped the search. The result is the best friction that the search found before.
    Stopped,
}

/// The best friction, which makes the largest amplitude over a band of frequencies smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// Best friction ratio β. If the amplitude of the load depends on frequency, β is the friction ratio at the
    /// frequency ratio r = 1.
    pub beta: f64,
    /// Largest value of the requested quantity over the band with this friction.
    ///
    /// The unit of a displacement is P/k₁ (Y for base motion). The unit of a velocity is the unit of displacement times
    /// ω₁ = √(k₁/m₁). The unit of an acceleration is the unit of displacement times ω₁². The unit of a force is P (k₁Y
    /// for base motion). If the amplitude of the load depends on frequency, P and Y are those at r = 1.
    pub amplitude: f64,
    /// Angular frequency √(k₁/m₁) at the frequency ratio r = 1, in rad/s.
    #[doc(hidden)]
    pub reference: f64,
    /// The reason why this friction is the best one, such as two equal peaks.
    pub kind: OptimumKind,
    /// The event that ended the search.
    pub end: OptimumEnd,
    /// Interval of β that contains the best friction. It is the narrowest interval that the search has found. For
    /// [`OptimumKind::Flat`] it is the interval of friction with the best amplitude.
    pub bracket: [f64; 2],
    /// Largest amplitude over the band just beyond the jump at which the search ended. The search evaluates this
    /// amplitude at only some frequencies of the band. `None` if the search did not end at a jump.
    pub beyond_jump: Option<f64>,
    /// Frequencies at which the amplitude has its largest value.
    pub peaks: Vec<OptimumPeak>,
    /// Friction ratio up to which the amplitude at an undamped resonance of the band is unbounded. It is 0 if the band
    /// contains no undamped resonance.
    pub unbounded_to: f64,
    /// Smallest value of the limits β_lim and β*_lim over the band, as friction ratio. At less friction, no stuck
    /// state exists in the band, and the contact can slide all the time at every frequency. NaN for several contacts.
    pub free_of_sticking: f64,
    /// Smallest friction ratio at which a stuck state exists at every frequency of the band. It is infinite if at some
    /// frequency of the band no friction keeps the contact stuck. Such a frequency is a resonance of the chain with
    /// its contact stuck.
    pub locked: f64,
    /// Largest amplitude over the band without friction. It is infinite if the band contains an undamped resonance.
    pub without_friction: f64,
    /// Largest amplitude over the band with the contact stuck at every frequency.
    pub with_contact_locked: f64,
    /// Three intervals of friction: the amplitude is at most 1, 5 and 10 per cent above the best amplitude. Wide
    /// intervals mean that the optimum is flat. The list is empty if the bound on work ended the search.
    pub tolerances: Vec<Tolerance>,
    /// Relative derivatives d ln X/d ln p of the best amplitude X, while the friction stays the best. The list has one
    /// entry for each parameter p except friction and frequency. It is empty without a load, and if no derivatives
    /// exist.
    pub sensitivities: Vec<(Parameter, f64)>,
    /// Number of amplitudes that the search has computed.
    pub evaluations: usize,
    /// Frequency ratios of the band at which the motion does not settle with the best friction. The search takes the
    /// largest value of its last cycles there.
    pub unsettled: Vec<f64>,
    /// Number of amplitudes that the search could not compute, because the motion has too many stops in a cycle or the
    /// solvers found no motion.
    pub unanswered: usize,
    /// Largest value over the band of each of several quantities with a divisor, or else of each quantity with a bound,
    /// in the order of the request.
    pub largest: Vec<f64>,
    /// Index of the quantity with the largest quotient, if the request has several quantities. The amplitude and the
    /// peaks belong to this quantity.
    pub decisive: usize,
    /// The best value of each varied number. The list is empty if no number varies. For several shares it has the share
    /// of every contact. With a varied number, the groups r, β and x̄ of the result refer to m₁ and k₁ of the original
    /// scene description.
    pub tuned: Vec<TunedNumber>,
    /// The best friction at all scanned values of a varied number, in ascending order of the values. The list shows the
    /// influence of the number. It is empty for shares.
    pub scan: Vec<TunedPoint>,
    /// Largest amplitude over the band with the best common friction and the shares of the scene description. `None`
    /// if no share varies, or if no friction satisfies the bounds with these shares.
    pub before: Option<f64>,
}

/// A varied number of the scene description with its best value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedNumber {
    /// The number of the scene description, such as a mass or the share of a contact.
    pub of: Tunable,
    /// The best value of the number.
    pub value: f64,
    /// True if the best value is a bound of its interval. A value outside the interval may then be better.
    pub at_end: bool,
}

/// The best friction at one value of the varied number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedPoint {
    /// Value of the varied number at this point.
    pub value: f64,
    /// The best friction ratio β, with m₁ and k₁ of the scene description. NaN if no best friction exists.
    pub beta: f64,
    /// The largest amplitude over the band with this friction, divided by P/k₁ (by Y for base motion), with k₁ of the
    /// scene description. The amplitude is infinite if no friction bounds it. The amplitude is NaN if the search
    /// reached its bound on work or was stopped before it found any friction.
    pub amplitude: f64,
}
