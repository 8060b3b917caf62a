//! What is asked of a scene, and the formulas' answer.

use frictiongen_kernel::{Complex, Float};
use generated_tests::data::DataAt;

/// What is asked of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Asked {
    ContinuousLimit,
    WithoutSearch,
    SlidingLimit,
    /// V, the response with friction left out.
    Free,
    ContactAmplitude,
    ContactPhase,
    Amplitude(usize),
    Phase(usize),
    Displacement(usize),
    Stuck(usize),
}

impl Asked {
    pub fn is_angle(self) -> bool {
        matches!(self, Self::ContactPhase | Self::Phase(_))
    }
    pub fn is_motion(self) -> bool {
        !matches!(
            self,
            Self::ContinuousLimit
                | Self::WithoutSearch
                | Self::SlidingLimit
                | Self::Free
                | Self::Stuck(_)
        )
    }
    /// The mass that is asked about.
    pub fn mass(self) -> Option<usize> {
        match self {
            Self::Amplitude(mass)
            | Self::Phase(mass)
            | Self::Displacement(mass)
            | Self::Stuck(mass) => Some(mass),
            _ => None,
        }
    }
    pub fn kind(self) -> &'static str {
        match self {
            Self::ContinuousLimit => "continuous limit",
            Self::WithoutSearch => "without search",
            Self::SlidingLimit => "sliding limit",
            Self::Free => "free",
            Self::ContactAmplitude => "contact amplitude",
            Self::ContactPhase => "contact phase",
            Self::Amplitude(_) => "amplitude",
            Self::Phase(_) => "phase",
            Self::Displacement(_) => "displacement",
            Self::Stuck(_) => "stuck",
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

/// The answer of the formulas, in whatever scalar.
pub fn answer<S: Float>(at: &DataAt<'_, S>, place: &Place<S>, asked: Asked) -> Complex<S> {
    let real = |value: S| Complex::new(value, S::constant(0.0));
    match asked {
        Asked::ContinuousLimit => real(at.continuous_limit()),
        Asked::WithoutSearch => real(at.continuous_limit_without_search()),
        Asked::SlidingLimit => real(at.sliding_limit()),
        Asked::Free => at.free(),
        Asked::ContactAmplitude => real(at.contact(place.beta).amplitude()),
        Asked::ContactPhase => real(at.contact(place.beta).phase()),
        Asked::Amplitude(mass) => real(at.mass(mass, place.beta).amplitude()),
        Asked::Phase(mass) => real(at.mass(mass, place.beta).phase()),
        Asked::Displacement(mass) => real(at.mass(mass, place.beta).displacement(place.tau)),
        Asked::Stuck(mass) => at.stuck(mass),
    }
}

/// The same without a search, at the instant where it ends: a largest value moves with the inputs as
/// the value there does.  A phase is the lag at which the mass stands still: its velocity there, which
/// moves through zero as the phase moves past the lag.
pub fn watched<S: Float>(
    at: &DataAt<'_, S>,
    place: &Place<S>,
    asked: Asked,
    instant: Option<S>,
) -> Complex<S> {
    let real = |value: S| Complex::new(value, S::constant(0.0));
    match (asked, instant) {
        (Asked::ContinuousLimit, Some(tau)) => real(at.continuous_limit_at(tau)),
        (Asked::ContinuousLimit, None) => real(at.continuous_limit_without_search()),
        (Asked::Amplitude(mass), Some(tau)) => {
            real(at.mass(mass, place.beta).displacement(tau).abs())
        }
        (Asked::Phase(mass), Some(lag)) => {
            let tau = lag - at.contact(place.beta).phase();
            real(at.mass(mass, place.beta).velocity(tau))
        }
        _ => answer(at, place, asked),
    }
}
