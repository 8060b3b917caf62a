//! Result of an identification of the friction force.

use super::observation::Observation;
use super::request::Unknown;
use crate::measure::statistics::is_chance;
use crate::study::System;
use crate::{Complex, Regime};

/// An estimated quantity: a number with its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Best estimate of the quantity.
    pub value: f64,
    /// Lower bound of the estimate's 95 % interval.
    pub from: f64,
    /// Upper bound of the estimate's 95 % interval. It is infinite if every larger value fits as well.
    pub to: f64,
}

impl Estimate {
    /// Returns true if a number is within the interval of the estimate.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        self.from <= value && value <= self.to
    }
}

/// The conclusion that a measurement allows about the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The scene does not explain the measurement, because its description is wrong or incomplete. If the description
    /// were right, noise with the given standard deviations would cause such residuals in fewer than one of 1000
    /// recordings. The force and its interval belong to the best fit, and may be far from the force of the real
    /// contact.
    NotExplained,
    /// The measurement determines one friction force.
    Determined,
    /// Several friction forces give the measured response. [`Identified::levels`] lists them.
    SeveralLevels,
    /// The contact is stuck. Any friction force above the lower bound of the interval gives the measured response.
    Stuck,
    /// The measurement does not determine the friction force. Either the response hardly changes with friction at this
    /// frequency, as at an invariant point, or friction is too small to exceed the noise.
    NotDetermined,
    /// Amplitudes without phases allow two conclusions. Either the contact almost sticks, or a unit is wrong by a
    /// factor of 1000 or a million. The scene description would also explain the motion if the amplitudes were larger
    /// by this factor.
    AlmostStuck,
}

impl Verdict {
    /// Returns the key of the verdict, for programs.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::NotExplained => "not_explained",
            Self::Determined => "determined",
            Self::SeveralLevels => "several_levels",
            Self::Stuck => "stuck",
            Self::NotDetermined => "not_determined",
            Self::AlmostStuck => "almost_stuck",
        }
    }

    /// Returns the verdict in one or two words.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::NotExplained => "not explained",
            Self::Determined => "determined",
            Self::SeveralLevels => "several levels",
            Self::Stuck => "stuck",
            Self::NotDetermined => "not determined",
            Self::AlmostStuck => "almost stuck",
        }
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NotExplained => "the description does not explain the measurement: residuals exceed the noise; check damping, stiction, masses and springs, and delays between the channels, before you use the force below",
            Self::Determined => "the measurement determines the friction force",
            Self::SeveralLevels => "several friction forces give this response; to find the right one, measure at another frequency, or use amplitude and phase together",
            Self::Stuck => "the contact is stuck: the measurement gives only the least friction force that holds it",
            Self::NotDetermined => "the measurement does not determine the friction force: compared with the noise, the response hardly changes with the force here; measure at another frequency or another mass",
            Self::AlmostStuck => "the motion is very small: either the contact is almost stuck, or a unit is wrong by 1000 or a million; amplitudes alone do not show which, but phases would",
        })
    }
}

/// One observation and the response of the fitted scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// Friction ratio β = F/P (F/(k₁Y) for base motion) at this observation.
    pub beta: f64,
    /// Frequency ratio r of the observation.
    pub r: f64,
    /// Regime of the contact in the fitted scene at this observation.
    pub regime: Regime,
    /// Computed motions, divided by the amplitude of the load, in the order of the observation's motions.
    pub model: Vec<Complex<f64>>,
}

/// Result of an identification from measurements.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Friction force F in the contact, in N, with its interval.
    pub friction: Estimate,
    /// All friction forces in N that explain the measurements equally well, with their intervals, in ascending order.
    /// If the verdict is [`Verdict::Determined`], the list has one force.
    pub levels: Vec<Estimate>,
    /// The conclusion about the friction force.
    pub verdict: Verdict,
    /// The unknowns that were fitted besides the friction force, with their estimates, in the order of the request.
    /// [`Identified::undetermined`] lists the unknowns with an infinite interval.
    pub unknowns: Vec<(Unknown, Estimate)>,
    /// Sum of the squared residuals, each over its variance, divided by the degrees of freedom. `None` without degrees
    /// of freedom. If this number exceeds 1 by more than chance explains, the verdict is [`Verdict::NotExplained`].
    /// The intervals are then wider by the square root of this number.
    pub misfit: Option<f64>,
    /// Degrees of freedom of the fit: the number of data minus the number of unknowns that the data determine.
    pub freedom: usize,
    /// Condition number of the fit: the largest factor by which a relative error of the data grows in a fitted value.
    pub condition: f64,
    /// Number of derivatives that the fit took by finite differences, because no exact derivative exists. This is the
    /// case if a stop or reversal of the contact is about to appear or disappear.
    pub differences: usize,
    /// Each observation with the response of the scene.
    pub explained: Vec<Explained>,
    /// The scene with the values that the fit has found.
    pub system: System,
}

impl Identified {
    /// Returns true if noise explains the residuals. Without degrees of freedom the result is true, because nothing
    /// contradicts the fit.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        is_chance(self.misfit, self.freedom)
    }

    /// Returns the unknowns that the measurements do not determine. Either the response does not change with the
    /// unknown, or two unknowns change the response in the same way. The estimates of all other unknowns are valid for
    /// any values of the undetermined unknowns.
    #[must_use]
    pub fn undetermined(&self) -> Vec<Unknown> {
        let all = self.unknowns.iter();
        let open = all.filter(|(_, estimate)| estimate.to.is_infinite());
        open.map(|(unknown, _)| *unknown).collect()
    }

    /// Returns the residuals of an observation: measured minus computed motions, each divided by the amplitude of the
    /// load.
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
