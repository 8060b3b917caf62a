//! The questions that the tests ask about a scene, and the answers of the formulas in any scalar type.

use frictiongen_kernel::{Complex, Float};
use generated_tests::data::{DataAt, DataMotion};

/// Selects whose motion is asked for: that of the contact, or that of a mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    Contact,
    Mass(usize),
}

/// A question about a scene. The tests judge its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    ContinuousLimit,
    WithoutSearch,
    PerMode,
    SlidingLimit,
    Stuck(usize),
    Amplitude(Of),
    /// Lag of a motion, rad. For a mass the tests judge the velocity at the lag, which must be zero.
    Phase(Of),
    /// Displacement of a mass at its lag, which must be the largest displacement.
    Height(usize),
    Estimate(usize),
    Displacement(Of),
    Velocity(Of),
    Harmonic(Of, u32),
}

impl Asked {
    /// Returns the name of the kind of question. The tally counts the answers of each kind.
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

    /// Returns the motion (contact or mass) that the answer describes, or `None` if the answer describes no motion.
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

/// The point (r, β, τ) of a question.
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

/// A question in a form that has derivatives. A maximum is replaced by the value at the instant of the maximum. This
/// value has the derivative of the maximum, because the motion is stationary at that instant.
#[derive(Clone, Copy, Debug)]
pub struct Watched<S> {
    pub asked: Asked,
    /// Instant of the maximum.
    pub instant: Option<S>,
    /// The lag that the system returned. The tests judge the velocity at this lag.
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

/// Returns the answers to all questions at one point. The function computes each motion only once.
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

/// Returns the motion of the contact or of a mass.
pub fn motion<'a, S: Float>(at: &DataAt<'a, S>, of: Of, beta: S) -> DataMotion<'a, S> {
    match of {
        Of::Contact => at.contact(beta),
        Of::Mass(mass) => at.mass(mass, beta),
    }
}

fn real<S: Float>(value: S) -> Complex<S> {
    Complex::new(value, S::constant(0.0))
}

/// Returns the answer to a question that depends on r but not on β.
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
