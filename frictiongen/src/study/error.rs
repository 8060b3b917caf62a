//! Errors of run-time systems and of scenes that are built in code.

use crate::{Error, NoOrbit, NotContinuous, Of, OutOfDomain, StuckResonance};
use frictiongen_kernel::orbit::NoDerivative;
use frictiongen_model::validate::SceneError;
use frictiongen_syntax::Diagnostics;

/// The scene has no mass with the requested name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMass {
    /// The requested name, which no mass has.
    pub name: String,
    /// The names of all masses of the scene.
    pub known: Vec<String>,
}

impl std::fmt::Display for UnknownMass {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "there is no mass `{}`; the masses are {}",
            self.name,
            self.known.join(", ")
        )
    }
}

impl std::error::Error for UnknownMass {}

/// The reason why a name does not denote a motion of the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnknownMotion {
    /// The expression contains a name that no mass has.
    Mass(UnknownMass),
    /// The expression means the motion of a mass relative to itself, which is zero. The field is the name of the mass.
    Itself(String),
    /// The base is the first of two names. It must be the second: `roof-base`, not `base-roof`. The field is the name
    /// of the mass.
    BaseFirst(String),
    /// No spring connects the two nodes. The first field names these nodes, and the second lists the springs of the
    /// scene.
    Spring(String, Vec<String>),
    /// The scene has no spring between a mass and the base, so that there is no base shear.
    NoShear,
    /// The name in front of the brackets is not that of a known function. The field is this name.
    Function(String),
    /// The expression means the velocity or the acceleration of a force, and a force has neither. The field is the
    /// name of the force.
    Rate(String),
    /// The brackets of `slip(…)`, `force(…)` or `energy(…)` do not contain the name of the contact. The first field is
    /// the name of the function, the second field is the text in its brackets, and the third has the names of the contacts.
    Slip(String, String, Vec<String>),
    /// The closing bracket is missing, or text follows it. The field is the whole expression.
    Brackets(String),
}

impl std::fmt::Display for UnknownMotion {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Mass(error) => error.fmt(f),
            Self::Itself(name) => write!(
                f,
                "`{name}` does not move relative to itself; write two different masses, or one mass and `base`"
            ),
            Self::BaseFirst(mass) => {
                write!(f, "the base is the reference; write `{mass}-base`")
            }
            Self::Spring(name, known) => write!(
                f,
                "there is no spring `{name}`; the springs are {}",
                known.join(", ")
            ),
            Self::NoShear => write!(
                f,
                "no spring connects a mass with the base, so there is no base shear"
            ),
            Self::Function(name) => write!(
                f,
                "there is no quantity `{name}(…)`; write the name of a mass, `contact`, `mass-base`, `mass-mass`, `spring(a-b)`, `shear`, `vel(…)`, `accel(…)`, `slip(contact)`, `force(contact)`, `energy(contact)`, `zeta_eq` or `zeta_eq(a-b)`"
            ),
            Self::Rate(name) => write!(
                f,
                "`{name}` is a force, which has neither a velocity nor an acceleration"
            ),
            Self::Slip(function, name, contacts) => {
                let forms = contacts
                    .iter()
                    .map(|contact| format!("`{function}({contact})`"));
                let forms: Vec<String> = forms.collect();
                write!(f, "`{name}` is no contact; write {}", forms.join(" or "))
            }
            Self::Brackets(text) => {
                write!(f, "`{text}`: write one closing bracket, at the end")
            }
        }
    }
}

impl std::error::Error for UnknownMotion {}

impl From<UnknownMass> for UnknownMotion {
    fn from(error: UnknownMass) -> Self {
        Self::Mass(error)
    }
}

/// A scene built in code is invalid. The error lists all its faults.
#[derive(Clone, Debug, PartialEq)]
pub struct InvalidScene {
    /// Messages about missing nodes or fields, and about names that are not defined.
    pub unknown: Vec<String>,
    /// Messages about values that make no physical sense.
    pub errors: Vec<SceneError>,
}

impl std::fmt::Display for InvalidScene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let unknown = self
            .unknown
            .iter()
            .map(|text| text as &dyn std::fmt::Display);
        let errors = self
            .errors
            .iter()
            .map(|error| error as &dyn std::fmt::Display);
        for (index, line) in unknown.chain(errors).enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            line.fmt(f)?;
        }
        Ok(())
    }
}

impl std::error::Error for InvalidScene {}

/// The reason why a load does not fit a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LoadError {
    /// The given load is a force, but the scene is excited by its moving base.
    DrivenByBase,
    /// The load is a base motion, but a force drives the mass of this name.
    DrivenByForce(String),
    /// The amplitude of the load is 0, negative, infinite or NaN.
    Amplitude,
    /// The units of force (P or k₁Y) or of length (P/k₁ or Y) are too small or too large for the number type.
    OutOfRange,
    /// The method needs a single contact and no dashpots, but the scene has `contacts` or `dampers`.
    SeveralContacts,
    /// The request needs a load of constant amplitude, but the amplitude of this load depends on frequency.
    Varies,
}

impl std::fmt::Display for LoadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::DrivenByBase => write!(f, "the scene is driven by its base"),
            Self::DrivenByForce(mass) => write!(f, "the scene is driven by a force on `{mass}`"),
            Self::Amplitude => write!(f, "the amplitude of a load must be above 0 and finite"),
            Self::OutOfRange => write!(
                f,
                "with the stiffness of the first spring, this load makes a length or a force too small or too large to compute with"
            ),
            Self::SeveralContacts => crate::Unsupported::SeveralContacts.fmt(f),
            Self::Varies => write!(
                f,
                "the amplitude of this load depends on frequency, but this answer needs a constant amplitude; give a base motion in m, or a force in N"
            ),
        }
    }
}

impl std::error::Error for LoadError {}

/// Any error of a run-time system. A function with this error type can use `?` on every call of a system.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StudyError {
    /// The text of a description does not define a valid scene. The field lists its faults.
    Description(Diagnostics),
    /// A scene that is built in code is invalid. The field lists its faults.
    Scene(InvalidScene),
    /// A solver rejects the request.
    Solver(Error),
    /// The scene has no mass with the requested name.
    UnknownMass(UnknownMass),
    /// A given name does not denote a motion of the scene.
    UnknownMotion(UnknownMotion),
    /// The request contains the motion of a mass or the force of a spring that the scene does not have.
    NoSuchMotion(Of),
    /// Derivatives of spring forces are not available.
    ForceHasNoDerivative,
    /// The load does not fit the scene. The field gives the reason.
    Load(LoadError),
    /// The steady state has no derivative.
    NoDerivative(NoDerivative),
}

impl std::fmt::Display for StudyError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Description(error) => error.fmt(f),
            Self::Scene(error) => error.fmt(f),
            Self::Solver(error) => error.fmt(f),
            Self::UnknownMass(error) => error.fmt(f),
            Self::UnknownMotion(error) => error.fmt(f),
            Self::NoSuchMotion(of) => no_such_motion(f, *of),
            Self::ForceHasNoDerivative => write!(
                f,
                "a spring force has no derivatives here; ask for the relative displacement of the spring's ends"
            ),
            Self::Load(error) => error.fmt(f),
            Self::NoDerivative(error) => error.fmt(f),
        }
    }
}

/// Writes the message that the scene does not have the motion `of`.
pub(crate) fn no_such_motion(f: &mut std::fmt::Formatter<'_>, of: Of) -> std::fmt::Result {
    match of {
        Of::Mass(index) | Of::FromBase(index) => {
            write!(f, "the scene has no mass with the index {index}")
        }
        Of::Relative(a, b) if a == b => write!(f, "a mass does not move relative to itself"),
        Of::Relative(a, b) => write!(
            f,
            "the scene has no two masses with the indices {a} and {b}"
        ),
        Of::Spring(index) => write!(f, "the scene has no spring with the index {index}"),
        Of::ContactAt(index) => write!(f, "the scene has no contact with the index {index}"),
        Of::Contact | Of::Shear => write!(f, "the scene has no such motion"),
    }
}

impl std::error::Error for StudyError {}

impl From<Diagnostics> for StudyError {
    fn from(error: Diagnostics) -> Self {
        Self::Description(error)
    }
}

impl From<InvalidScene> for StudyError {
    fn from(error: InvalidScene) -> Self {
        Self::Scene(error)
    }
}

impl From<UnknownMotion> for StudyError {
    fn from(error: UnknownMotion) -> Self {
        Self::UnknownMotion(error)
    }
}

impl From<UnknownMass> for StudyError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<LoadError> for StudyError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

impl From<NoDerivative> for StudyError {
    fn from(error: NoDerivative) -> Self {
        match error {
            NoDerivative::NoOrbit(error) => error.into(),
            error => Self::NoDerivative(error),
        }
    }
}

impl From<Error> for StudyError {
    fn from(error: Error) -> Self {
        Self::Solver(error)
    }
}

impl From<OutOfDomain> for StudyError {
    fn from(error: OutOfDomain) -> Self {
        Self::Solver(error.into())
    }
}

impl From<NotContinuous> for StudyError {
    fn from(error: NotContinuous) -> Self {
        Self::Solver(error.into())
    }
}

impl From<StuckResonance> for StudyError {
    fn from(error: StuckResonance) -> Self {
        Self::Solver(error.into())
    }
}

impl From<NoOrbit> for StudyError {
    fn from(error: NoOrbit) -> Self {
        Self::Solver(error.into())
    }
}
