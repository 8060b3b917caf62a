//! The friction that keeps the largest amplitude over a band of frequencies smallest, over all regimes.

mod amplitude;
mod flat;
mod line;
pub(in crate::study) mod peaks;
mod search;

use super::error::UnknownMass;
use super::parameter::{OperatingPoint, Parameter};
use super::system::System;
use super::units::{Load, angular_frequency};
use crate::{Of, Regime};
pub(in crate::study) use amplitude::Friction;
use peaks::Band;
pub(in crate::study) use peaks::PLACE as PEAK_PLACE;
use search::Kind;

/// A band of frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrequencyBand {
    /// Frequency ratios r of the scene as it is described.
    Ratio(f64, f64),
    /// Hz.
    Hertz(f64, f64),
}

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumRequest {
    /// Whose amplitude.
    pub of: Of,
    /// Over which frequencies, both ends included; above 0 and finite.
    pub band: FrequencyBand,
    /// The load, where forces in N and lengths in m are wanted.
    pub load: Option<Load>,
}

/// Why there is no optimum.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OptimumError {
    /// An end of the band is not above 0 and finite.
    Band,
    /// The band has no width, or its end is below its start.
    Width,
    /// There is no such mass.
    UnknownMass(UnknownMass),
    /// The load does not fit.
    Load(super::LoadError),
    /// Nothing damps this mode, counted from 0: the contact does not touch it, and the load drives it.
    Undamped(usize),
    /// At every friction a resonance within the band is unbounded.
    Unbounded,
    /// The motion does not depend on friction and is at rest.
    AtRest,
    /// It takes more amplitudes than [`System::optimum`] computes.
    TooLong,
}

impl std::fmt::Display for OptimumError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Band => "the ends of the band are above 0 and finite",
            Self::Width => "the end of the band is above its start",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::Load(error) => return error.fmt(f),
            Self::Undamped(mode) => {
                return write!(
                    f,
                    "no friction bounds the motion: nothing damps mode {}, which the load drives and the contact does not touch",
                    mode + 1
                );
            }
            Self::Unbounded => {
                "no friction bounds the amplitude over this band: it contains an undamped resonance"
            }
            Self::AtRest => "it does not move over this band",
            Self::TooLong => {
                "250000 amplitudes do not suffice, of which one that does not settle counts as 100 for each mass; a narrower \
                 band needs fewer"
            }
        })
    }
}

impl std::error::Error for OptimumError {}

impl From<UnknownMass> for OptimumError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<super::LoadError> for OptimumError {
    fn from(error: super::LoadError) -> Self {
        Self::Load(error)
    }
}

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

/// The friction that keeps the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// β.
    pub beta: f64,
    /// The largest amplitude of the band over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What limits it.
    pub kind: OptimumKind,
    /// Where it is reached.
    pub peaks: Vec<OptimumPeak>,
    /// Up to this β the amplitude at an undamped resonance of the band is unbounded; 0 where there is none.
    pub unbounded_to: f64,
    /// Up to this β nothing sticks anywhere in the band.
    pub free_of_sticking: f64,
    /// From this β on the contact is stuck all over the band; infinite if nothing holds it on a resonance of the stuck
    /// chain.
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

/// How much above the best.
const EXCESSES: [f64; 3] = [0.01, 0.05, 0.1];
/// Peaks within this share of the largest count as equal.
const EQUAL: f64 = 1e-9;

impl System {
    /// The friction that keeps the largest amplitude of a motion over a band of frequencies smallest, over all regimes: the
    /// closed form where the contact slides all the time, steady states where it stops, the stuck response.
    ///
    /// The largest amplitude over the band is looked for about every resonance, of the chain and of the chain with its
    /// contact stuck, their sub-harmonics, on both sides of changes of regime and on a grid between, the least over friction by
    /// a scan between none and so much that nothing slides.
    ///
    /// It computes at most 250000 amplitudes and stops with [`OptimumError::TooLong`] beyond; one whose motion does not settle,
    /// or that has no answer, takes longer and counts as 100 for each mass.  For two masses it takes about 30000.
    ///
    /// ```
    /// use frictiongen::study::{FrequencyBand, Load, OptimumKind, OptimumRequest, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { lower: 3.27, upper: 3.25 },                     // kg
    ///     springs: { base - lower: 1190.0, lower - upper: 1323.0 }, // N/m
    ///     contact: upper - wall,
    ///     excitation: base,
    ///     damping: modal[0.010, 0.012],
    /// }"
    /// .parse()?;
    /// let request = OptimumRequest {
    ///     of: frame.motion_named("upper")?,
    ///     band: FrequencyBand::Hertz(1.5, 3.0),
    ///     load: Some(Load::Base(0.003)), // m
    /// };
    /// let optimum = frame.optimum(&request)?;
    /// assert!(optimum.amplitude < 0.5 * optimum.without_friction);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OptimumError`]: for a band, a motion, a load or a quantity that makes no sense, and where no friction bounds the
    /// amplitude.
    pub fn optimum(&self, request: &OptimumRequest) -> Result<Optimum, OptimumError> {
        Problem::new(self, request)?.solved()
    }
}

/// A question that makes sense.
struct Problem<'s> {
    system: &'s System,
    request: &'s OptimumRequest,
    /// r.
    ends: [f64; 2],
}

impl<'s> Problem<'s> {
    fn new(system: &'s System, request: &'s OptimumRequest) -> Result<Self, OptimumError> {
        let ends = match request.band {
            FrequencyBand::Ratio(from, to) => [from, to],
            FrequencyBand::Hertz(from, to) => {
                [from, to].map(|hertz| system.frequency_ratio(angular_frequency(hertz)))
            }
        };
        let [from, to] = ends;
        if !(ends.iter().all(|end| 0.0 < *end && end.is_finite())) {
            return Err(OptimumError::Band);
        }
        if !(from < to) {
            return Err(OptimumError::Width);
        }
        if let Of::Mass(index) = request.of
            && index >= system.scene.masses.len()
        {
            return Err(system.unknown(&index.to_string()).into());
        }
        let modal = system.modal();
        let constants = modal.damping_ratios.iter().zip(&modal.loads);
        let mut constants = constants.zip(&modal.contacts);
        let lost = constants.position(|((zeta, load), contact)| {
            zeta.is_zero() && contact.is_zero() && !load.is_zero()
        });
        if let Some(mode) = lost {
            return Err(OptimumError::Undamped(mode));
        }
        if let Some(load) = request.load {
            system.load_scale(load)?;
        }
        Ok(Self {
            system,
            request,
            ends,
        })
    }

    fn solved(&self) -> Result<Optimum, OptimumError> {
        let band = Band::new(self.system, self.request.of, self.ends);
        let largest = |friction: Friction| {
            let peaks = band.peaks(friction);
            peaks.first().map_or(f64::NAN, |peak| peak.value)
        };
        let least = search::least(&band);
        if band.amplitude.is_spent() {
            return Err(OptimumError::TooLong);
        }
        let least = least.ok_or(OptimumError::Unbounded)?;
        let without_friction = largest(Friction::Ratio(0.0));
        if without_friction == 0.0 {
            return Err(OptimumError::AtRest);
        }
        let beta = least.at.beta;
        let friction = if least.kind == Kind::Held && least.locked_from <= beta {
            Friction::Locked
        } else {
            Friction::Ratio(beta)
        };
        let equal = least.at.peaks.iter();
        // Where the contact is stuck it may move with the base over a whole range.
        let most = if least.kind == Kind::Held { 1 } else { 8 };
        let equal = equal.filter(|peak| least.at.value * (1.0 - EQUAL) <= peak.value);
        let equal = equal.take(most);
        let peaks: Vec<OptimumPeak> = equal
            .map(|peak| {
                let regime = band.amplitude.regime(peak.r, friction);
                let slope = search::slope(&band, beta, peak);
                OptimumPeak {
                    r: peak.r,
                    amplitude: peak.value,
                    regime,
                    at_end: peak.edge,
                    slope: (slope.is_finite() && regime != Regime::Stuck).then_some(slope),
                }
            })
            .collect();
        let sensitivities = self.sensitivities(beta, &peaks).unwrap_or_default();
        let tolerances = EXCESSES
            .iter()
            .map(|excess| flat::tolerance(&band, &least, *excess))
            .collect();
        let with_contact_locked = largest(Friction::Locked);
        if band.amplitude.is_spent() {
            return Err(OptimumError::TooLong);
        }
        Ok(Optimum {
            beta,
            amplitude: least.at.value,
            kind: match least.kind {
                Kind::Crossing => OptimumKind::EqualPeaks,
                Kind::Smooth => OptimumKind::SinglePeak,
                Kind::Without => OptimumKind::NoFriction,
                Kind::Held => OptimumKind::Stuck,
            },
            tolerances,
            peaks,
            unbounded_to: search::unbounded_to(self.system, self.ends),
            free_of_sticking: least.free_to,
            locked: least.locked_from,
            without_friction,
            with_contact_locked,
            sensitivities,
            evaluations: band.amplitude.asked.get(),
            unanswered: band.amplitude.silent.get(),
        })
    }

    /// d ln X/d ln p at the optimum: of one peak its own; of two equal ones what both agree on as friction follows.
    fn sensitivities(&self, beta: f64, peaks: &[OptimumPeak]) -> Option<Vec<(Parameter, f64)>> {
        let (system, load) = (self.system, self.request.load?);
        let scale = system.load_scale(load).ok()?;
        let all: Vec<_> = peaks
            .iter()
            .map(|peak| {
                let point = OperatingPoint::Physical {
                    hertz: system.hertz(peak.r),
                    friction: scale.friction(beta),
                    load,
                };
                system.response_sensitivities(point, self.request.of).ok()
            })
            .collect::<Option<_>>()?;
        let slope = |which: usize, parameter: Parameter| {
            let all = all.get(which)?;
            let found = all.parameters.iter().find(|of| of.parameter == parameter)?;
            found.amplitude.relative(found.value)
        };
        let weights: Vec<f64> = match peaks.len() {
            1 => vec![1.0],
            2 => {
                let of = |which: usize| slope(which, Parameter::Friction);
                let (a, b) = (of(0)?, of(1)?);
                vec![b / (b - a), -a / (b - a)]
            }
            _ => return None,
        };
        let parameters = all.first()?.parameters.iter().map(|of| of.parameter);
        let kept = parameters
            .filter(|parameter| !matches!(parameter, Parameter::Friction | Parameter::Frequency));
        kept.map(|parameter| {
            let parts = weights.iter().enumerate();
            let parts = parts.map(|(which, weight)| Some(weight * slope(which, parameter)?));
            Some((parameter, parts.sum::<Option<f64>>()?))
        })
        .collect()
    }
}
