//! Errors of scenes with several contacts.

use crate::study::error::{LoadError, UnknownMass};
use crate::study::joints::JointError;
use crate::study::sensitivity::NoDerivative;
use crate::{Given, OutOfDomain, Unsupported};
use std::fmt;

/// Error: the scene has no contact with the requested name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownContact {
    /// The requested name, which no contact has.
    pub name: String,
    /// The names of all contacts of the scene.
    pub known: Vec<String>,
}

impl fmt::Display for UnknownContact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "there is no contact `{}`; the contacts are {}",
            self.name,
            self.known.join(", ")
        )
    }
}

impl std::error::Error for UnknownContact {}

/// Reason why a method for scenes with several contacts returns no result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum JoinedError {
    /// A number of the request is outside its domain, or the scene does not support the request.
    OutOfDomain(OutOfDomain),
    /// The scene has more masses than the solver supports. The field is the number of masses.
    TooManyMasses(usize),
    /// The scene has no spring. The ratios r and β are not defined without the stiffness k₁ of a spring.
    NoSpring,
    /// The angular frequency is not positive and finite.
    Frequency(Given),
    /// The kinetic friction force of a contact is negative or not finite. The first field is the name of the contact.
    Friction(String, Given),
    /// The amplitude of the load is not positive and finite.
    Amplitude(Given),
    /// The load does not fit the scene. The field gives the reason.
    Load(LoadError),
    /// The scene has `friction: stribeck`, whose speeds have units. The load therefore needs an amplitude in units.
    NoAmplitude,
    /// The scene has stops, moving surfaces or constant forces, so that its stuck state has no closed form.
    NotLinear,
    /// The frequency is an undamped resonance of the linear chain, whose response is then unbounded.
    Resonance,
    /// The search for the eigenvalues of the damped chain does not converge.
    Modes,
    /// The quantity is one that only a single contact has, or one that no motion has.
    Quantity,
    /// The function `watch` of the caller stopped the search before it had a result.
    Stopped,
    /// The scene has no contact with the requested name.
    UnknownContact(UnknownContact),
    /// Neither the scene nor its operating point has a parameter with this name. The list has the names of all parameters.
    UnknownParameter(String, Vec<String>),
    /// The scene has no mass with the requested name.
    UnknownMass(UnknownMass),
    /// The steady state has no derivatives.
    NoDerivative(NoDerivative),
    /// The solver for several contacts found no result.
    Engine(JointError),
}

impl fmt::Display for JoinedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(f),
            Self::TooManyMasses(count) => write!(
                f,
                "the scene has {count} masses, but at most {} are possible here; lump neighbouring masses together",
                crate::study::joints::MAX_MASSES
            ),
            Self::NoSpring => write!(
                f,
                "the scene has no spring, so that r and beta have no k1; give the frequency in Hz or rad/s, the load in N or m and the friction in N"
            ),
            Self::Frequency(given) => write!(
                f,
                "the angular frequency must be above 0 and finite, but it is {given}"
            ),
            Self::Friction(contact, given) => write!(
                f,
                "the friction force of the contact `{contact}` is {given}; it must be a finite number, not negative"
            ),
            Self::Amplitude(given) => write!(
                f,
                "the amplitude of the load must be above 0 and finite, but it is {given}"
            ),
            Self::Load(error) => error.fmt(f),
            Self::NoAmplitude => write!(
                f,
                "the scene has lengths, speeds or constant forces, so that the amplitude of the load is needed; give the frequency in Hz or rad/s, the load in N or m and the friction in N"
            ),
            Self::NotLinear => write!(
                f,
                "with stops, moving surfaces or constant forces the stuck state and its limit have no closed form; compute the steady state"
            ),
            Self::Resonance => write!(
                f,
                "this frequency is an undamped resonance of the linear chain, so that its response is unbounded; choose another frequency, or add damping"
            ),
            Self::Modes => write!(
                f,
                "the search for the damped modes does not converge; change a coefficient of `dampers` slightly"
            ),
            Self::Quantity => write!(
                f,
                "of several contacts, a quantity is a displacement, a velocity, an acceleration or the force of a spring"
            ),
            Self::Stopped => write!(f, "the search stopped before it had compared two frictions"),
            Self::UnknownContact(error) => error.fmt(f),
            Self::UnknownParameter(name, known) => write!(
                f,
                "there is no parameter `{name}`; the parameters are {}",
                known.join(", ")
            ),
            Self::UnknownMass(error) => error.fmt(f),
            Self::NoDerivative(error) => error.fmt(f),
            Self::Engine(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for JoinedError {}

impl From<OutOfDomain> for JoinedError {
    fn from(error: OutOfDomain) -> Self {
        Self::OutOfDomain(error)
    }
}

impl From<Unsupported> for JoinedError {
    fn from(error: Unsupported) -> Self {
        Self::OutOfDomain(error.into())
    }
}

impl From<UnknownContact> for JoinedError {
    fn from(error: UnknownContact) -> Self {
        Self::UnknownContact(error)
    }
}

impl From<UnknownMass> for JoinedError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<NoDerivative> for JoinedError {
    fn from(error: NoDerivative) -> Self {
        Self::NoDerivative(error)
    }
}

impl From<JointError> for JoinedError {
    fn from(error: JointError) -> Self {
        Self::Engine(error)
    }
}
