//! Errors for arguments outside their domain, with one variant for each cause.

use super::halt::Halt;
use crate::number::scalar::Float;
use core::fmt;

/// An argument outside its domain, or a request that the scene does not support. Each variant names the argument or the
/// request.
///
/// A variant with a [`Given`] names one argument. The [`Given`] says what kind of number the caller gave.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum OutOfDomain {
    /// The frequency ratio r of a steady response is outside its domain.
    FrequencyRatio(Given),
    /// The frequency ratio r of a motion in time is outside its domain. r must be positive, and not too close to 0 or
    /// ∞.
    FrequencyRatioInTime(Given),
    /// The friction ratio β is outside its domain.
    FrictionRatio(Given),
    /// The frequency ratio or friction ratio is outside the range for which the scene's tables were made.
    OutsideTables(Ratio),
    /// The frequency ratio or friction ratio differs from that of the orbit (steady state). An orbit has derivatives
    /// only at the ratios for which it was computed.
    OtherPoint(Ratio),
    /// The initial state of the masses (displacements and velocities) is invalid.
    State,
    /// The initial state of an orbit (steady state) contains a number that is not finite.
    Start,
    /// In the initial state of an orbit (steady state) the contact sticks, but at the friction ratio β it cannot stick.
    StuckStart,
    /// The duration by which a simulation is to advance is outside its domain.
    Duration(Given),
    /// A slice of numbers that the caller passes has a wrong length.
    Length(Slice),
    /// The range of frequency ratios is invalid. The upper bound of the range must exceed the lower bound.
    Range,
    /// The number of intervals into which a search divides its range is 0.
    Intervals,
    /// No mass of the scene has the given index.
    Mass,
    /// The time step dt of a stepper, in s, is outside its domain.
    Step(Given),
    /// The force on a mass in one step of a stepper is outside its domain.
    Force(Given),
    /// An input of a stepper has a wrong number of forces. It must have one force for each mass that may be loaded,
    /// and no force on another mass.
    Forces,
    /// The displacement or velocity of the base in one step of a stepper is outside its domain.
    BaseMotion(Given),
    /// The input contains a base motion, but the base of the scene does not move.
    BaseAtRest,
    /// The kinetic friction force F in one step of a stepper is outside its domain.
    Friction(Given),
    /// The stiction μ, the ratio of the static to the kinetic friction force, is outside its domain.
    Stiction(Given),
    /// The caller called `begin`, which sets the input at the start of a stepper, after the first step. `begin` is
    /// possible only before the first step.
    Begun,
    /// The saved state comes from a stepper with another scene, another time step dt or another number type.
    Saved,
    /// The image (bytes) of a stepper's state is too short, has a wrong checksum, or contains numbers that no stepper
    /// writes.
    ImageDamaged,
    /// Another version of this library wrote the image (bytes) of a stepper's state.
    ImageVersion,
    /// The work of the load on the chain since the start is very large. One more step might make the work overflow the
    /// number type.
    Work,
    /// The amplitude of the load in a simulation is outside its domain. A simulation needs this amplitude if the
    /// kinetic friction of the scene depends on the speed.
    LoadAmplitude(Given),
    /// The slope of a speed-dependent friction law is too steep for a simulation.
    Steepness,
    /// The slope of a speed-dependent friction law is too steep for one step of a stepper.
    StepSteepness,
    /// The solver of scenes with several contacts cannot continue the motion. The field gives the reason.
    Motion(Halt),
    /// The scene does not support the request. The field gives the reason.
    Unsupported(Unsupported),
}

/// Kind of the number (NaN, negative, zero, positive or infinite) that the caller gave for an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Given {
    /// The caller gave NaN (not a number).
    NotANumber,
    /// The caller gave a number below zero, or −∞.
    Negative,
    /// The caller gave the number 0.
    Zero,
    /// The caller gave a finite number above zero.
    Positive,
    /// The caller gave +∞.
    Infinite,
}

/// The frequency ratio or the friction ratio of an operating point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Ratio {
    /// The frequency ratio r.
    Frequency,
    /// The friction ratio β.
    Friction,
}

/// A slice with a wrong length, which the caller passed for results or as working storage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Slice {
    /// Slice for the limits of continuous motion β_lim, one for each frequency ratio.
    Continuous,
    /// Slice for the limits of sliding β*_lim, one for each frequency ratio.
    Sliding,
    /// Slice in which a simulation or an orbit stores its oscillators, one for each mode.
    Oscillators,
    /// Slice for the working storage of an orbit.
    Storage,
    /// Slice for the Floquet multipliers of an orbit.
    Multipliers,
    /// Slice for the tables of a stepper.
    StepTables,
}

/// A request that the scene does not support.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Unsupported {
    /// The method computes no motion in time for a scene with many modes at or beyond critical damping. In this number
    /// type, rounding errors would mix the modes of the sliding chain with those of the stuck chain.
    CriticalDamping,
    /// The method has no result for a scene whose kinetic friction depends on the sliding speed.
    FrictionLaw,
    /// The method has no result for a scene with an elastic contact.
    ElasticContact,
    /// The method does not support a scene with several contacts or dashpots.
    SeveralContacts,
    /// The method needs a load, but the scene has no excitation.
    NoExcitation,
}

impl Given {
    /// Returns the kind of the number `value`.
    pub fn of<S: Float>(value: S) -> Self {
        let zero = S::constant(0.0);
        if value < zero {
            Self::Negative
        } else if value.is_finite() {
            if value > zero {
                Self::Positive
            } else {
                Self::Zero
            }
        } else if value > zero {
            Self::Infinite
        } else {
            Self::NotANumber
        }
    }
}

impl fmt::Display for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotANumber => "NaN",
            Self::Negative => "negative",
            Self::Zero => "zero",
            Self::Positive => "positive",
            Self::Infinite => "infinite",
        })
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Frequency => "frequency ratio r",
            Self::Friction => "friction ratio beta",
        })
    }
}

impl fmt::Display for Slice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Continuous => {
                "slice `continuous` has another length than the slice of r; give one element for each r"
            }
            Self::Sliding => {
                "slice `sliding` has another length than the slice of r; give one element for each r"
            }
            Self::Oscillators => {
                "slice of oscillators has the wrong length; it needs one for each mode of the sliding and of the stuck chain"
            }
            Self::Storage => "working storage of an orbit has the wrong length",
            Self::Multipliers => {
                "slice of multipliers has the wrong length; it needs two for each mode that the contact drives"
            }
            Self::StepTables => "tables of a stepper have the wrong length for this scene",
        })
    }
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::CriticalDamping => {
                "with this number of modes at or beyond critical damping, the modes of the stuck and of the sliding chain cannot be separated in this scalar: fewer than half of the digits would be correct"
            }
            Self::FrictionLaw => {
                "the exact continuous response needs a constant kinetic level, but this scene has `friction: stribeck`; ask for its motion in time, under a load with its amplitude in units"
            }
            Self::SeveralContacts => {
                "this answer needs a single contact without dashpots, but this scene has `contacts` or `dampers`; ask for its steady state (`orbit`, in Python `by_contact`), its stuck state or its motion in time"
            }
            Self::NoExcitation => {
                "this answer needs a load, but the description has no `excitation`; add the name of a mass or `base`, as in `excitation: base`"
            }
            Self::ElasticContact => {
                "this answer needs a rigid contact, but this scene has `stiffness`; ask for its steady state (`orbit`), its stuck state or its motion in time"
            }
        })
    }
}

impl OutOfDomain {
    /// Returns three texts for the message about a number outside its domain. The texts are the name of the argument,
    /// the kind of the given number, and the condition for the argument. Returns `None` if the error is not about a
    /// single number.
    fn number(self) -> Option<(&'static str, Given, &'static str)> {
        const RATIO: &str = "the frequency ratio r";
        Some(match self {
            Self::FrequencyRatio(given @ Given::Infinite) => {
                (RATIO, given, "it must be finite here")
            }
            Self::FrequencyRatio(given) => (RATIO, given, "it must be a number, not negative"),
            Self::FrequencyRatioInTime(given) => (
                RATIO,
                given,
                "a motion in time needs a positive number that is not too close to 0 or infinity",
            ),
            Self::FrictionRatio(given) => (
                "the friction ratio beta",
                given,
                "it must be a finite number, not negative",
            ),
            Self::Duration(given) => (
                "the time to advance",
                given,
                "it must be a finite number, not negative",
            ),
            Self::Step(given) => (
                "the step dt",
                given,
                "it must be greater than zero, and so short that no oscillator turns by more than 1024 rad in it",
            ),
            Self::Force(given) => (
                "a force",
                given,
                "it must be finite, and its square within the range of the scalar; use `f64`, or larger units",
            ),
            Self::BaseMotion(given) => (
                "the displacement or velocity of the base",
                given,
                "both must be finite, and their squares within the range of the scalar; use `f64`, or larger units",
            ),
            Self::Friction(given) => (
                "the friction force F",
                given,
                "it must be a finite number, not negative, and its square within the range of the scalar; use `f64`, or larger units",
            ),
            Self::Stiction(given) => (
                "the stiction mu",
                given,
                "it must be a finite number, 1 or more",
            ),
            Self::LoadAmplitude(given) => (
                "the amplitude of the load",
                given,
                "it must be positive and finite, and so large that the speeds of the friction law stay distinct when they are divided by the speed of the load",
            ),
            _ => return None,
        })
    }

    /// Returns the error in a finite number of the right sign, or `None` for any other number.
    fn extreme(self) -> Option<&'static str> {
        Some(match self {
            Self::Force(Given::Positive | Given::Negative)
            | Self::BaseMotion(Given::Positive | Given::Negative)
            | Self::Friction(Given::Positive) => "too large",
            Self::Step(Given::Positive) => "too long or too short",
            Self::FrequencyRatioInTime(Given::Positive) => "too close to 0 or infinity",
            Self::LoadAmplitude(Given::Positive) => "too small",
            _ => return None,
        })
    }
}

impl fmt::Display for OutOfDomain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((number, given, needed)) = self.number() {
            return match self.extreme() {
                Some(extreme) => write!(f, "{number} is {extreme}; {needed}"),
                None => write!(f, "{number} is {given}; {needed}"),
            };
        }
        f.write_str(match self {
            Self::OutsideTables(ratio) => return write!(
                f,
                "the {ratio} is outside the declared range of the tables; declare a wider `range`, or `beyond: exact` for the formulas outside it"
            ),
            Self::OtherPoint(ratio) => return write!(
                f,
                "the {ratio} differs from that of the orbit; derivatives need the r and beta of the orbit"
            ),
            Self::Length(slice) => return write!(f, "the {slice}"),
            Self::Unsupported(unsupported) => return unsupported.fmt(f),
            Self::Motion(halt) => return halt.fmt(f),
            Self::State => {
                "the state must have one finite displacement and one finite velocity for each mass"
            }
            Self::Start => {
                "the state at the start of the orbit leaves the range of the scalar; start nearer to rest"
            }
            Self::StuckStart => {
                "the contact cannot stick at this beta, so that no orbit starts stuck; start from rest, or above the sliding limit"
            }
            Self::Range => {
                "the range of frequency ratios must have two finite ends, not negative, the lower one first"
            }
            Self::Intervals => "the search has 0 intervals; it needs one at least",
            Self::Mass => "the scene has no mass with this index; the first mass has the index 0",
            Self::Forces => {
                "the sample needs one force for each mass that may be loaded, and none for another mass; the field `force` of the description names these masses"
            }
            Self::BaseAtRest => {
                "the base of this scene rests, because a force on a mass excites it; leave out the motion of the base"
            }
            Self::Begun => {
                "the stepper has advanced already; call `begin` before the first step, or make a new stepper"
            }
            Self::Saved => {
                "the saved state belongs to another scene, to another step dt or to another scalar type; restore it in the stepper that saved it"
            }
            Self::ImageDamaged => {
                "the image of a stepper is too short, or some of its bytes have changed, so that the run cannot continue"
            }
            Self::ImageVersion => {
                "the image of a stepper has a form that this version of frictiongen does not read; write it anew, or read it with the version that wrote it"
            }
            Self::Work => {
                "another step could make the work too large for the scalar; reduce the force, or make a new stepper"
            }
            Self::Steepness => {
                "the slope of the friction law acts more than 4096 times as fast as the fastest mode; use a flatter law, or a smaller friction force"
            }
            Self::StepSteepness => {
                "the friction law would change the contact's velocity by more than 16 times that velocity within a step; use a shorter step, a flatter law or a smaller friction force"
            }
            // `number` returns the message of each of these variants.
            Self::FrequencyRatio(_)
            | Self::FrequencyRatioInTime(_)
            | Self::FrictionRatio(_)
            | Self::Duration(_)
            | Self::Step(_)
            | Self::Force(_)
            | Self::BaseMotion(_)
            | Self::Friction(_)
            | Self::Stiction(_)
            | Self::LoadAmplitude(_) => "",
        })
    }
}

impl core::error::Error for OutOfDomain {}

impl From<Unsupported> for OutOfDomain {
    fn from(unsupported: Unsupported) -> Self {
        Self::Unsupported(unsupported)
    }
}
