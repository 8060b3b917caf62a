//! What is asked of a scene, and the formulas' answer in whatever scalar.

use frictiongen_kernel::{Complex, Float};
use generated_tests::data::{DataAt, DataMotion};

/// Whose motion is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    Contact,
    Mass(usize),
}

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    ContinuousLimit,
    WithoutSearch,
    PerMode,
    SlidingLimit,
    Stuck(usize),
    Amplitude(Of),
    /// The lag: of a mass, that it stands still there.
    Phase(Of),
    /// That a mass is at its largest where its lag says.
    Height(usize),
    Estimate(usize),
    Displacement(Of),
    Velocity(Of),
    Harmonic(Of, u32),
}

impl Asked {
    /// The name of the kind, by which answers are tallied.
    pub fn kind(self) -> &'static str {
        match self {
            Self::ContinuousLimit => "continuous limit",
            Self::WithoutSearch => "without search",
            Self::PerMode => "per mode",
            Self::SlidingLimit => "sliding limit",
            Self::Stuck(_) => "stuck",
            Self::Amplitude(Of::Contact) => "contact amplitude",
            Self::Amplitude(Of::Mass(_)) => "amplitude",
            Self::Phase(Of::Contact) => "contact phase",
            Self::Phase(Of::Mass(_)) => "phase",
            Self::Height(_) => "height at the phase",
            Self::Estimate(_) => "estimate",
            Self::Displacement(Of::Contact) => "contact displacement",
            Self::Displacement(Of::Mass(_)) => "displacement",
            Self::Velocity(Of::Contact) => "contact velocity",
            Self::Velocity(Of::Mass(_)) => "velocity",
            Self::Harmonic(Of::Contact, _) => "contact harmonic",
            Self::Harmonic(Of::Mass(_), _) => "harmonic",
        }
    }

    pub fn is_complex(self) -> bool {
        matches!(self, Self::Stuck(_) | Self::Harmonic(..))
    }

    pub fn is_limit(self) -> bool {
        matches!(
            self,
            Self::ContinuousLimit | Self::WithoutSearch | Self::PerMode | Self::SlidingLimit
        )
    }

    pub fn is_angle(self) -> bool {
        matches!(self, Self::Phase(Of::Contact))
    }

    /// Whose continuous motion the answer is of.
    pub fn of(self) -> Option<Of> {
        match self {
            Self::Amplitude(of)
            | Self::Phase(of)
            | Self::Displacement(of)
            | Self::Velocity(of)
            | Self::Harmonic(of, _) => Some(of),
            Self::Height(mass) | Self::Estimate(mass) => Some(Of::Mass(mass)),
            _ => None,
        }
    }
}

/// Where it is asked.
#[derive(Clone, Copy, Debug)]
pub struct Place<S> {
    pub r: S,
    pub beta: S,
    pub tau: S,
}

impl<S: Float> Place<S> {
    pub fn read<T>(&self, to: impl Fn(S) -> T) -> Place<T> {
        Place {
            r: to(self.r),
            beta: to(self.beta),
            tau: to(self.tau),
        }
    }
}

/// A question as it can be differentiated: a largest value is looked at where it is taken, since it moves with the
/// inputs as the value there does.
#[derive(Clone, Copy, Debug)]
pub struct Watched<S> {
    pub asked: Asked,
    /// The instant of the largest value.
    pub instant: Option<S>,
    /// The lag that was told, whose velocity is watched.
    pub lag: Option<S>,
}

impl<S: Float> Watched<S> {
    pub fn read<T>(&self, to: impl Fn(S) -> T) -> Watched<T> {
        Watched {
            asked: self.asked,
            instant: self.instant.map(&to),
            lag: self.lag.map(&to),
        }
    }
}

/// The answers to questions of one place.  A motion is put together once for all questions that it is asked.
pub fn answers<S: Float>(
    at: &DataAt<'_, S>,
    place: &Place<S>,
    questions: &[Watched<S>],
) -> Vec<Complex<S>> {
    let mut motions: Vec<(Of, DataMotion<'_, S>)> = Vec::new();
    questions
        .iter()
        .map(|question| {
            let motion = question.asked.of().map(|of| {
                let known = motions.iter().position(|(known, _)| *known == of);
                known.unwrap_or_else(|| {
                    motions.push((of, motion(at, of, place.beta)));
                    motions.len() - 1
                })
            });
            match motion {
                Some(index) => moving(at, place, question, &motions[index].1),
                None => at_rest(at, question),
            }
        })
        .collect()
}

/// The motion of the contact or of a mass.
pub fn motion<'a, S: Float>(at: &DataAt<'a, S>, of: Of, beta: S) -> DataMotion<'a, S> {
    match of {
        Of::Contact => at.contact(beta),
        Of::Mass(mass) => at.mass(mass, beta),
    }
}

fn real<S: Float>(value: S) -> Complex<S> {
    Complex::new(value, S::constant(0.0))
}

/// What depends on r alone.
fn at_rest<S: Float>(at: &DataAt<'_, S>, question: &Watched<S>) -> Complex<S> {
    match (question.asked, question.instant) {
        (Asked::ContinuousLimit, Some(tau)) => real(at.continuous_limit_at(tau)),
        (Asked::PerMode, _) => real(at.continuous_limit_per_mode()),
        (Asked::SlidingLimit, _) => real(at.sliding_limit()),
        (Asked::Stuck(mass), _) => at.stuck_amplitude(mass),
        _ => real(at.continuous_limit_without_search()),
    }
}

fn moving<S: Float>(
    at: &DataAt<'_, S>,
    place: &Place<S>,
    question: &Watched<S>,
    motion: &DataMotion<'_, S>,
) -> Complex<S> {
    let zero = S::constant(0.0);
    let told = question.lag.unwrap_or(zero);
    let since = || told - at.contact(place.beta).phase();
    let largest = || motion.displacement(question.instant.unwrap_or(zero)).abs();
    real(match question.asked {
        Asked::Amplitude(Of::Contact) => motion.amplitude(),
        Asked::Amplitude(Of::Mass(_)) => largest(),
        Asked::Phase(Of::Contact) => motion.phase(),
        Asked::Phase(Of::Mass(_)) => motion.velocity(since()),
        Asked::Height(_) => motion.displacement(since()) - largest(),
        Asked::Estimate(_) => motion.amplitude_monoharmonic(),
        Asked::Displacement(_) => motion.displacement(place.tau),
        Asked::Velocity(_) => motion.velocity(place.tau),
        Asked::Harmonic(_, n) => return motion.harmonic(n),
        _ => zero,
    })
}
