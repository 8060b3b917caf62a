//! The best friction of a motion, exact or the best of some.

use frictiongen::Regime;
use frictiongen::study::{Optimum, OptimumKind};

/// A frequency at which the largest amplitude is reached.
#[derive(Clone, Debug)]
pub struct Peak {
    /// r.
    pub r: f64,
    /// Over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What the contact does there.
    pub regime: Regime,
    /// Whether it is an end of the range.
    pub at_end: bool,
}

/// The best friction of a motion.
#[derive(Clone, Debug)]
pub struct Answer {
    /// β.
    pub beta: f64,
    /// The largest amplitude with it.
    pub amplitude: f64,
    /// What limits it, if that is known.
    pub kind: Option<OptimumKind>,
    /// Where it is reached.
    pub peaks: Vec<Peak>,
    /// The largest amplitude without friction.
    pub without_friction: f64,
    /// And with the contact stuck.
    pub with_contact_locked: f64,
    /// Between these frictions the largest amplitude is at most a tenth above the best.
    pub within: Option<(f64, f64)>,
    /// Up to this friction a resonance is without bound.
    pub unbounded_to: f64,
    /// How many frictions were tried at how many frequencies; none of an exact answer.
    pub tried: Option<(usize, usize)>,
    /// The exact answer.
    pub exact: Option<Box<Optimum>>,
}

impl Answer {
    pub fn exact(optimum: Optimum) -> Self {
        let peaks = optimum.peaks.iter().map(|peak| Peak {
            r: peak.r,
            amplitude: peak.amplitude,
            regime: peak.regime,
            at_end: peak.at_end,
        });
        Self {
            beta: optimum.beta,
            amplitude: optimum.amplitude,
            kind: Some(optimum.kind),
            peaks: peaks.collect(),
            without_friction: optimum.without_friction,
            with_contact_locked: optimum.with_contact_locked,
            within: optimum
                .tolerances
                .last()
                .map(|widest| (widest.from, widest.to)),
            unbounded_to: optimum.unbounded_to,
            tried: None,
            exact: Some(Box::new(optimum)),
        }
    }
}
