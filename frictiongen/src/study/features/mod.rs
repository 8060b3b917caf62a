//! The features of a scene's response: thresholds, ends, invariant points, inversions, resonances of the stuck chain,
//! sliding ranges, regimes along frequency, peaks.
//!
//! Zeros of functions in closed form are found by intervals ([`Certainty::Proven`]); what rests on a search over the half
//! period, or on steady states with stops, is sampled in steps of a stated length and refined ([`Certainty::Sampled`]).

mod functions;
mod invariant;
mod isolate;
mod peaks;
mod places;
mod regimes;
mod sensed;
mod sliding;

use super::error::UnknownMass;
use super::system::System;
use super::units::{Load, LoadError};
use crate::Of;
use frictiongen_kernel::number::dd::Dd;
pub use invariant::{Antiresonance, Condition, Edge, InvariantPoint, Inversion, Measured};
pub use peaks::{Crossing, ResonantPeak, TruePeak};
pub use regimes::{RegimeEnd, RegimeRange};
use sensed::Variations;
pub use sensed::{ParameterSlope, Sensed};
pub use sliding::{HeldResonance, SlidingRange};

/// What stands behind a list of features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Certainty {
    /// Every one in the range is found, by a closed form or by intervals: two nearer to each other than 1e-9 of their
    /// place may count as one, and one within 1e-13 of a pole does not show.
    Proven,
    /// Sampled and refined: every stretch that is longer than one of so many equal parts of the range, over 1/r, is found.  Of
    /// shorter ones those are found that lie where the function comes near to its level between three samples, or beside a
    /// resonance or an odd sub-harmonic of one.
    Sampled {
        /// The parts.
        steps: u32,
    },
}

impl Certainty {
    /// The parts of a range that is sampled.
    pub const STEPS: u32 = 8192;

    /// What stands behind a list that is sampled.
    pub const SAMPLED: Self = Self::Sampled { steps: Self::STEPS };
}

/// Why there are no features.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FeatureError {
    /// The range of r is not from above 0 to a larger, finite r.
    Range,
    /// A friction ratio is negative, not finite or NaN.
    Friction,
    /// There is no such mass.
    UnknownMass(UnknownMass),
    /// With damping there are no such points: whatever the friction, something moves them.
    Damped,
    /// Towards r = 0 they crowd: the range holds more than can be listed.
    Crowded,
}

impl std::fmt::Display for FeatureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Range => "a range of frequencies begins above 0 and ends above its start, below infinity",
            Self::Friction => "a friction is finite and not negative",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::Damped => "with damping no frequency has an amplitude that is the same for every friction",
            Self::Crowded => {
                "towards r = 0 sub-harmonics crowd, and this range holds more than 20000 of them: let it begin higher"
            }
        })
    }
}

impl std::error::Error for FeatureError {}

impl From<UnknownMass> for FeatureError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<isolate::Crowded> for FeatureError {
    fn from(_: isolate::Crowded) -> Self {
        Self::Crowded
    }
}

/// The features of a system, in groups or under a load: see [`System::features`].
///
/// Frequencies are asked for as r and frictions as β.  Every answer has r, and as [`Sensed`] the number in its unit with
/// its derivatives: under a load Hz, N and m at constant forces and lengths, otherwise r, β and multiples of P/k₁ (for base
/// motion Y) at constant groups.
pub struct Features<'s> {
    system: &'s System,
    variations: Variations,
}

/// A resonance of the chain, and the friction below which it is not bounded.
#[derive(Clone, Debug, PartialEq)]
pub struct Resonance {
    /// √λ_i.
    pub r: f64,
    /// In Hz under a load.
    pub frequency: Sensed,
    /// ζ_i.
    pub damping_ratio: f64,
    /// β_n,i (6.2, 6.26), of the chain without its damping; none for a mode that the contact does not drive.
    pub threshold: Option<Sensed>,
    /// β_lim there: without damping the same, with damping what (7.62) estimates.
    pub continuous_limit: f64,
}

/// Both limits at an end of the frequency range.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitsAtEnd {
    /// β_lim.
    pub continuous: Sensed,
    /// β*_lim.
    pub sliding: Sensed,
}

/// The range about the resonances: from this share of the lowest, to this multiple of the highest, and no more below that than
/// this.
const BELOW: f64 = 0.55;
const ABOVE: f64 = 1.5;
const FAR_BELOW: f64 = 0.02;

impl System {
    /// The range of r from below the lowest resonance to above the highest: where nothing else is asked for.  Far below the
    /// highest, where its sub-harmonics crowd, it begins later.
    #[must_use]
    pub fn about_resonances(&self) -> [f64; 2] {
        let all = self.resonances();
        let lowest = all.first().copied().unwrap_or(1.0);
        let highest = all.last().copied().unwrap_or(1.0);
        [(BELOW * lowest).max(FAR_BELOW * highest), ABOVE * highest]
    }

    /// The features of the response, under a load with their numbers in Hz, N and m.
    ///
    /// ```
    /// use frictiongen::Of;
    /// use frictiongen::study::{Measured, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let chain: System = "struct Chain {
    ///     masses: { first: 1, second: 1 },
    ///     springs: { base - first: 1, first - second: 1 },
    ///     contact: first - wall,
    ///     excitation: first,
    /// }"
    /// .parse()?;
    /// let features = chain.features(None)?;
    /// // Two frequencies at which no friction changes the amplitude in the contact.
    /// let points = features.invariant_points(Of::Contact, Measured::Amplitude, [0.55, 3.0])?;
    /// let places: Vec<f64> = points.iter().map(|point| point.r).collect();
    /// assert!((places[0] - 5_f64.sqrt() / 4.0).abs() < 1e-15);
    /// assert!((places[1] - 5_f64.sqrt() / 2.0).abs() < 1e-15);
    /// // Stuck, it is one mass on one spring.
    /// assert!((features.held_resonances()[0].r - 1.0).abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`LoadError`] for a load that does not fit the scene.
    pub fn features(&self, load: Option<Load>) -> Result<Features<'_>, LoadError> {
        Ok(Features {
            system: self,
            variations: Variations::new(self, load)?,
        })
    }
}

impl Features<'_> {
    /// The system.
    #[must_use]
    pub fn system(&self) -> &System {
        self.system
    }

    /// Every resonance of the chain with its threshold, ascending.
    #[must_use]
    pub fn resonances(&self) -> Vec<Resonance> {
        let modal = self.system.modal();
        let thresholds = modal.resonance_thresholds();
        let each = modal.resonances.iter().zip(&modal.damping_ratios);
        let each = each.zip(thresholds).enumerate();
        each.map(|(index, ((resonance, zeta), threshold))| {
            let r = resonance.to_f64();
            let frequency = self.variations.of_frequency(r, None, |variation| {
                let modal = variation.varied.modal();
                Some(modal.resonances.get(index)?.slope)
            });
            let threshold = threshold.map(|value| {
                self.variations.of_friction(value.to_f64(), |modal| {
                    modal.resonance_thresholds().get(index).copied().flatten()
                })
            });
            Resonance {
                r,
                frequency,
                damping_ratio: zeta.to_f64(),
                threshold,
                continuous_limit: self.variations.friction(self.continuous_limit(r)),
            }
        })
        .collect()
    }

    /// x̄ of every mass for r → 0 at β (6.5), with its derivatives; none where the contact is stuck there.
    ///
    /// # Errors
    /// [`FeatureError::Friction`].
    pub fn quasi_static_start(&self, beta: f64) -> Result<Option<Vec<Sensed>>, FeatureError> {
        check_friction(beta)?;
        let Some(start) = self.system.quasi_static_start(beta) else {
            return Ok(None);
        };
        let scale = self.variations.scale;
        let each = start.into_iter().enumerate().map(|(mass, value)| {
            let value = self.variations.length(value);
            self.variations.sensed(value, Some(beta), |variation| {
                let modal = variation.varied.modal();
                let start = modal.quasi_static_start(variation.beta(beta, scale))?;
                Some(*start.get(mass)? * variation.length)
            })
        });
        Ok(Some(each.collect()))
    }

    /// Both limits for r → 0: β_lim is 0 there.
    #[must_use]
    pub fn limits_at_rest(&self) -> LimitsAtEnd {
        let ends = self.system.modal().ends();
        LimitsAtEnd {
            continuous: Sensed {
                value: 0.0,
                slopes: Vec::new(),
            },
            sliding: self
                .variations
                .of_friction(ends.sliding_at_rest.to_f64(), |modal| {
                    Some(modal.ends().sliding_at_rest)
                }),
        }
    }

    /// β_∞ and β*_∞ (6.28): both limits for r → ∞, infinite on a moving base.
    #[must_use]
    pub fn limits_at_infinity(&self) -> LimitsAtEnd {
        let ends = self.system.modal().ends();
        LimitsAtEnd {
            continuous: self
                .variations
                .of_friction(ends.continuous_at_infinity.to_f64(), |modal| {
                    Some(modal.ends().continuous_at_infinity)
                }),
            sliding: self
                .variations
                .of_friction(ends.sliding_at_infinity.to_f64(), |modal| {
                    Some(modal.ends().sliding_at_infinity)
                }),
        }
    }

    fn continuous_limit(&self, r: f64) -> f64 {
        let at = self.system.at(r);
        at.map_or(f64::NAN, |at| at.continuous_limit())
    }

    fn sliding_limit(&self, r: f64) -> f64 {
        let at = self.system.at(r);
        at.map_or(f64::NAN, |at| at.sliding_limit())
    }

    /// The mass of a motion; none for the contact and for the mass that moves as the contact does.
    fn mass_of(&self, of: Of) -> Result<Option<usize>, FeatureError> {
        let modal = self.system.modal();
        match of {
            Of::Contact => Ok(None),
            Of::Mass(mass) if mass < self.system.scene().masses.len() => {
                let as_contact = modal.rubbing() == Some(mass) && !modal.on_moving_base;
                Ok((!as_contact).then_some(mass))
            }
            Of::Mass(mass) => Err(self.system.unknown(&mass.to_string()).into()),
        }
    }
}

fn check_range([from, to]: [f64; 2]) -> Result<(), FeatureError> {
    if 0.0 < from && from < to && to.is_finite() {
        Ok(())
    } else {
        Err(FeatureError::Range)
    }
}

fn check_friction(beta: f64) -> Result<(), FeatureError> {
    if 0.0 <= beta && beta.is_finite() {
        Ok(())
    } else {
        Err(FeatureError::Friction)
    }
}

/// β as the functions take it.
fn exact(beta: f64) -> Dd {
    Dd::from(beta)
}
