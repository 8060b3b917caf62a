//! What measurements tell of the friction force.

use super::observation::Observation;
use super::request::Unknown;
use crate::measure::statistics::is_chance;
use crate::study::System;
use crate::{Complex, Regime};

/// A number with its interval of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The best one.
    pub value: f64,
    /// From here.
    pub from: f64,
    /// To here; infinite where every larger one fits as well.
    pub to: f64,
}

impl Estimate {
    /// Whether a number lies within.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        self.from <= value && value <= self.to
    }
}

/// What a measurement tells of the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The description does not explain the measurement: residuals exceed what noise of the given deviations makes once in
    /// 1000 recordings.  Force and interval are those of the best fit, and may be far from the rig's.
    NotExplained,
    /// It does.
    Told,
    /// Several forces give this response: see [`Identified::levels`].
    SeveralLevels,
    /// The contact is stuck: any force from the lower end of the interval on gives this response.
    Stuck,
    /// It does not: the response hardly changes with friction there, as at an invariant point, or friction is too small
    /// to stand out of the noise.
    NotTold,
    /// Of amplitudes without phases: friction all but holds the contact, or a unit is wrong by 1000 or a million, as a motion
    /// that many times as large is explained as well.
    AllButStuck,
}

impl Verdict {
    /// In a word or two.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::NotExplained => "not explained",
            Self::Told => "told",
            Self::SeveralLevels => "several levels",
            Self::Stuck => "stuck",
            Self::NotTold => "not told",
            Self::AllButStuck => "all but stuck",
        }
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NotExplained => "the description does not explain the measurement: residuals exceed the noise; check damping, stiction, masses and springs, and delays between the channels, before you use the force below",
            Self::Told => "the measurement tells the friction force",
            Self::SeveralLevels => "several friction forces give this response; another frequency, or amplitude and phase together, would tell which",
            Self::Stuck => "the contact is stuck: this tells only the least force that holds it",
            Self::NotTold => "the measurement cannot tell the friction force: the response hardly changes with it here, beside the noise; measure at another frequency or another mass",
            Self::AllButStuck => "the motion is so small that friction all but holds the contact, or a unit is wrong by 1000 or a million: amplitudes alone do not tell which, and phases would",
        })
    }
}

/// One observation as the answer has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// β = F/P, for base motion F/(k₁Y).
    pub beta: f64,
    /// r.
    pub r: f64,
    /// The regime.
    pub regime: Regime,
    /// What the scene does, in the order of the observation's motions.
    pub model: Vec<Complex<f64>>,
}

/// What measurements say.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The friction force F, N.
    pub friction: Estimate,
    /// All forces that explain the measurements as well, with their intervals, ascending; one where it is told.
    pub levels: Vec<Estimate>,
    /// What the measurements tell.
    pub verdict: Verdict,
    /// The other unknowns, in the order of the request.  An infinite interval: see [`Identified::undetermined`].
    pub unknowns: Vec<(Unknown, Estimate)>,
    /// The sum of squares of the residuals over their deviations, over the degrees of freedom; none where there are none.
    /// Above 1 by more than chance the verdict is [`Verdict::NotExplained`], and the intervals are that much wider.
    pub misfit: Option<f64>,
    /// The degrees of freedom: data less the unknowns that they determine.
    pub freedom: usize,
    /// The largest factor on a relative error of the data, between determined parameters: the condition of the fit.
    pub condition: f64,
    /// Each observation beside the scene's answer.
    pub explained: Vec<Explained>,
    /// The scene with what was found.
    pub system: System,
}

impl Identified {
    /// Whether noise explains the residuals.  Without freedom there is nothing to judge by, and this is true.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        is_chance(self.misfit, self.freedom)
    }

    /// The unknowns that the measurements do not determine: the response does not change with them, or two of them change it
    /// alike.  The other estimates hold whatever their values are.
    #[must_use]
    pub fn undetermined(&self) -> Vec<Unknown> {
        let all = self.unknowns.iter();
        let open = all.filter(|(_, estimate)| estimate.to.is_infinite());
        open.map(|(unknown, _)| *unknown).collect()
    }

    /// Residuals of an observation: measured less computed, over the load.
    #[must_use]
    pub fn residuals(&self, observations: &[Observation], index: usize) -> Vec<Complex<f64>> {
        let (Some(seen), Some(explained)) = (observations.get(index), self.explained.get(index))
        else {
            return Vec::new();
        };
        let pairs = seen.motions.iter().zip(&explained.model);
        pairs.map(|(datum, model)| datum.value - model).collect()
    }
}
