//! Features of a scene's response: thresholds, limits for r → 0 and r → ∞, invariant points, inversions, resonances of
//! the chain with its contact stuck, sliding ranges, regimes over frequency, and peaks.
//!
//! Interval arithmetic finds the zeros of functions in closed form ([`Certainty::Proven`]). Other features depend on a
//! search over the half period, or on steady states with stops. The code samples these other features in steps of a
//! stated length, and refines them ([`Certainty::Sampled`]).

mod functions;
mod invariant;
mod isolate;
mod joined;
mod peaks;
mod places;
mod regimes;
mod sensed;
mod sliding;

use super::error::UnknownMass;
use super::joined::JoinedError;
use super::system::System;
use super::units::{Load, LoadError};
use crate::Of;
use frictiongen_kernel::number::dd::Dd;
pub use invariant::{Antiresonance, Condition, Edge, InvariantPoint, InvariantQuantity, Inversion};
pub use joined::StuckLimit;
pub use peaks::{Crossing, ResonantPeak, TruePeak};
pub use regimes::{RegimeEnd, RegimeRange};
use sensed::Variations;
pub use sensed::{ParameterSlope, Sensed};
pub use sliding::{HeldResonance, SlidingRange};

/// Completeness of a list of features: proven complete, or found from samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Certainty {
    /// The list contains every feature in the range, found by a closed form or by interval arithmetic. If the relative
    /// distance of two features is below 1e-9, the list may contain one feature instead of two. A feature within 1e-13
    /// of a pole does not appear.
    Proven,
    /// The search samples the range in `steps` steps of equal length in 1/r, and refines each change between two
    /// samples. The search finds every interval that is longer than one step.
    ///
    /// The search finds a shorter interval in two cases only. In the first case, three neighbouring samples are on the
    /// same side of the value at which the feature begins, and the middle sample is closest to this value. In the
    /// second case, the interval is next to a resonance or to an odd sub-harmonic of a resonance.
    Sampled {
        /// Number of steps of equal length in 1/r into which the search divides the range.
        steps: u32,
    },
}

impl Certainty {
    /// Number of steps into which a search by samples divides the range.
    pub const STEPS: u32 = 8192;

    /// The certainty of every list that a search by samples finds.
    pub const SAMPLED: Self = Self::Sampled { steps: Self::STEPS };
}

/// The reason why a search for features fails.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FeatureError {
    /// The range of frequency ratios r does not begin above 0, or does not end at a larger, finite r.
    Range,
    /// A requested friction ratio is negative, infinite or NaN.
    Friction,
    /// The scene has no mass with the requested name.
    UnknownMass(UnknownMass),
    /// The requested motion is neither that of the contact nor that of a mass.
    Combination,
    /// The chain is damped. The requested points exist only without damping.
    Damped,
    /// The range contains more poles or zeros than the search can examine. Towards the frequency ratio r = 0, poles
    /// and zeros become infinitely close.
    Crowded,
    /// The solver for several contacts returns no result.
    Joined(JoinedError),
}

impl std::fmt::Display for FeatureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Range => "a range of frequencies must begin above 0, and end above its start and below infinity",
            Self::Friction => "a friction must be finite and not negative",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::Joined(error) => return error.fmt(f),
            Self::Combination => {
                "features exist for the contact and for masses; ask `curve` for a relative motion or a force"
            }
            Self::Damped => "a damped chain has no frequency at which the amplitude is the same for every friction",
            Self::Crowded => {
                "this range contains more than 20000 sub-harmonics, which crowd towards r = 0; begin the range at a higher frequency"
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

impl From<JoinedError> for FeatureError {
    fn from(error: JoinedError) -> Self {
        Self::Joined(error)
    }
}

impl From<isolate::Crowded> for FeatureError {
    fn from(_: isolate::Crowded) -> Self {
        Self::Crowded
    }
}

/// Features of a system's response, in non-dimensional form or under a load: see [`System::features`].
///
/// The methods take frequencies as r and frictions as β. Every result has r and a [`Sensed`] number, which is a number
/// in its unit with derivatives. Under a load the units are Hz, N and m. The derivatives then keep the forces and
/// lengths constant. Without a load the results are r, β, and displacements divided by P/k₁ (by Y for base motion). The
/// derivatives then keep the non-dimensional groups constant.
pub struct Features<'s> {
    system: &'s System,
    variations: Variations,
}

/// A resonance of the chain, with its frequency, its damping, and its threshold of friction.
#[derive(Clone, Debug, PartialEq)]
pub struct Resonance {
    /// Frequency ratio r = √λ_i of the resonance.
    pub r: f64,
    /// Frequency of the resonance, in Hz under a load.
    pub frequency: Sensed,
    /// Modal damping ratio ζ_i of the mode at the resonance.
    pub damping_ratio: f64,
    /// Threshold β_n,i (6.2, 6.26), in N under a load. Without damping, the amplitude is unbounded if the friction is
    /// less than the threshold. `None` for a mode that the contact does not drive.
    pub threshold: Option<Sensed>,
    /// Limit of continuous motion β_lim at the resonance, in N under a load. Without damping β_lim equals the
    /// threshold. With damping, (7.62) is an estimate of β_lim. An elastic contact has β_lim = 0.
    pub continuous_limit: f64,
}

/// The limits β_lim and β*_lim for r → 0 or for r → ∞.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitsAtEnd {
    /// Limit of continuous motion β_lim, in N under a load.
    pub continuous: Sensed,
    /// Limit of sliding β*_lim, in N under a load.
    pub sliding: Sensed,
}

/// Lower bound of the default range, divided by the lowest resonance. The range never begins at less than `FAR_BELOW`
/// times the highest resonance. The range ends at `ABOVE` times the highest resonance.
const BELOW: f64 = 0.55;
/// Upper bound of the default range, divided by the highest resonance.
const ABOVE: f64 = 1.5;
/// Least lower bound of the default range, divided by the highest resonance.
const FAR_BELOW: f64 = 0.02;

impl System {
    /// Returns the default range of the frequency ratio r, from below the lowest resonance to above the highest. If
    /// the highest resonance is far above the lowest, the range begins at a higher r. At low r the sub-harmonics of
    /// the highest resonance would be too close together. For a scene with several contacts or dashpots, the range
    /// includes the resonances of the chain with each set of stuck contacts.
    #[must_use]
    pub fn about_resonances(&self) -> [f64; 2] {
        let joined = self.joined().ok().filter(|_| self.scene.is_joined());
        let all: Vec<f64> = match joined {
            Some(joined) => joined.resonances().iter().map(|mode| mode[0]).collect(),
            None => self.resonances().to_vec(),
        };
        let lowest = all.iter().copied().reduce(f64::min).unwrap_or(1.0);
        let highest = all.iter().copied().reduce(f64::max).unwrap_or(1.0);
        [(BELOW * lowest).max(FAR_BELOW * highest), ABOVE * highest]
    }

    /// Returns an object whose methods find the features of the response. Under a load the results are in Hz, N and m.
    ///
    /// ```
    /// use frictiongen::Of;
    /// use frictiongen::study::{System, features::InvariantQuantity};
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
    /// // No friction changes the contact's amplitude at these two frequencies.
    /// let points = features.invariant_points(Of::Contact, InvariantQuantity::Amplitude, [0.55, 3.0])?;
    /// let places: Vec<f64> = points.iter().map(|point| point.r).collect();
    /// assert!((places[0] - 5_f64.sqrt() / 4.0).abs() < 1e-15);
    /// assert!((places[1] - 5_f64.sqrt() / 2.0).abs() < 1e-15);
    /// // With a stuck contact, the chain is one mass on one spring.
    /// assert!((features.held_resonances()[0].r - 1.0).abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// An elastic contact sticks after each reversal, and therefore has no features of continuous motion. Its limit
    /// β_lim is 0. Its lists of invariant points, inversions and crossings are empty, and it has no quasi-static
    /// start.
    ///
    /// # Errors
    /// [`LoadError`] for a load that does not fit the scene. [`LoadError::SeveralContacts`] for a scene with several
    /// contacts or dashpots. [`damped_modes`](System::damped_modes) has the resonances of such a scene, and
    /// `frictiongen features` lists its features.
    pub fn features(&self, load: Option<Load>) -> Result<Features<'_>, LoadError> {
        self.single().map_err(|_| LoadError::SeveralContacts)?;
        Ok(Features {
            system: self,
            variations: Variations::new(self, load)?,
        })
    }
}

impl Features<'_> {
    /// Returns the system of these features.
    #[must_use]
    pub fn system(&self) -> &System {
        self.system
    }

    /// Returns every resonance of the chain with its threshold, in ascending order.
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

    /// Returns the displacement x̄ of every mass for the frequency ratio r → 0 at the friction ratio β (6.5), with
    /// derivatives. Returns `None` if the contact is stuck at r = 0, and for an elastic contact.
    ///
    /// # Errors
    /// [`FeatureError::Friction`] for a friction ratio that is negative, NaN or infinite.
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

    /// Returns the limits for the frequency ratio r → 0: β_lim, which is 0, and β*_lim.
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

    /// Returns β_∞ and β*_∞ (6.28): the limits β_lim and β*_lim for the frequency ratio r → ∞. Both are infinite for a
    /// contact on a moving base.
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

    /// Returns the index of the mass of a motion. Returns `None` for the contact, and for a mass that moves exactly as
    /// the contact does.
    fn mass_of(&self, of: Of) -> Result<Option<usize>, FeatureError> {
        let modal = self.system.modal();
        match of {
            Of::Contact => Ok(None),
            Of::Mass(mass) if mass < self.system.scene().masses.len() => {
                let as_contact = modal.rubbing() == Some(mass) && !modal.on_moving_base;
                Ok((!as_contact).then_some(mass))
            }
            Of::Mass(mass) => Err(self.system.unknown(&mass.to_string()).into()),
            _ => Err(FeatureError::Combination),
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

/// Converts a friction ratio to double-double precision.
fn exact(beta: f64) -> Dd {
    Dd::from(beta)
}
