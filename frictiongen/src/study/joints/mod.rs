//! Computes motions and steady states of chains at run time. The chains may have several contacts (rigid or elastic),
//! dashpots, and masses that no path of springs connects to a support.
//!
//! All quantities are in the units of the scene description. z is the relative displacement of a contact. Between two
//! masses, z is the displacement of the later mass minus that of the earlier mass, by their order in the chain. On the
//! base or the wall, z is the displacement of the mass minus that of the base or the wall. A positive force f of the
//! contact acts on the later mass, or on the only mass, against the direction of positive z.
//!
//! [`frictiongen_kernel::joints`] computes the motion from event to event, the closed form of the stuck state, and the
//! steady states. Emitted code uses the same functions. This module checks a chain, and computes its damping matrix.

mod branch;
mod damping;
mod limit_cycle;
mod model;
mod run;
mod steady;
mod stuck;

#[cfg(test)]
mod tests;

pub(super) use branch::Follower;
pub use branch::{Branch, BranchEnd, BranchEvent, BranchPoint};
pub use frictiongen_kernel::joints::Heap;
pub use limit_cycle::limit_cycle;
pub use run::{MAX_EVENTS, MAX_STRETCHES, Motion, Transition};
pub use steady::{
    Approach, MAX_PERIOD, Place, Steady, mirror_image, steady_state, steady_state_soon,
    steady_states_near,
};
pub use stuck::{StuckResponse, stuck_response};

use frictiongen_kernel::joints::{self, Halt, MAX_PATTERNS};
use frictiongen_model::scene::{Node, StopLaw};
use std::fmt;

/// A checked chain with numbered nodes, stored in `Vec`s.
pub type Model = joints::Model<f64, Heap>;
/// The state of a chain with several contacts, stored in `Vec`s.
pub type State = joints::State<f64, Heap>;
/// The motion of a chain over one stretch (time interval of a power series), stored in `Vec`s.
pub type Series = joints::Series<f64, Heap>;
/// Collects the results of a period while the motion advances, one stretch (time interval of a power series) after the
/// other.
pub type Watch = joints::Watch<f64, Heap>;
/// Amplitudes of the masses, and results of each contact, over a period.
pub type Cycle = joints::Cycle<f64, Heap>;
/// Stops, reversals, slip, force and energy of one contact in a period.
pub type ContactCycle = joints::ContactCycle<f64>;
/// A function of the time t that is a straight line plus one harmonic: c + bt + a cos(ωt + φ).
pub type Wave = joints::Wave<f64>;

/// Largest number of contacts that a chain may have.
pub const MAX_CONTACTS: usize = 16;
/// Largest number of masses that a chain may have.
pub const MAX_MASSES: usize = 1000;

/// A contact of a chain with several contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The two nodes between which the contact acts.
    pub ends: (Node, Node),
    /// Kinetic friction force F of the contact. The force of a rigid contact may vary in time, and must then stay
    /// positive.
    pub level: Wave,
    /// Ratio μ of the static to the kinetic friction force, at least 1.
    pub stiction: f64,
    /// Stiffness of the spring in series with the slider. `None` for a rigid contact.
    pub stiffness: Option<f64>,
    /// Velocity of the surface of the second side relative to its node, for a belt.
    pub speed: f64,
}

/// A stop of a chain, which acts while x_a − x_b > g for its ends a and b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndStop {
    /// The two nodes a and b between which the stop acts.
    pub ends: (Node, Node),
    /// Gap g and impact of the stop.
    pub law: StopLaw,
}

/// A chain with its contacts and its loads, in the units of the scene description.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Chain {
    /// Masses of the chain.
    pub masses: Vec<f64>,
    /// Springs of the chain, each with its two nodes and its stiffness.
    pub springs: Vec<(Node, Node, f64)>,
    /// Dashpots of the chain, each with its two nodes and its damping coefficient.
    pub dashpots: Vec<(Node, Node, f64)>,
    /// Rows of the matrix of modal or Rayleigh damping. The list is empty if the scene has neither modal nor Rayleigh
    /// damping.
    pub damping: Vec<Vec<f64>>,
    /// True if the damping matrix acts on velocities relative to the base. False if it acts on absolute velocities.
    pub damping_from_base: bool,
    /// Contacts of the chain.
    pub contacts: Vec<Joint>,
    /// Points (v, φ) of the friction law of the rigid contacts. At the sliding speed v, the kinetic friction force is
    /// φ times the force `level` of the contact. The list is empty if the kinetic friction does not depend on the
    /// speed.
    pub law: Vec<[f64; 2]>,
    /// Stops of the chain.
    pub stops: Vec<EndStop>,
    /// Constant forces on masses, each with the index of the mass.
    pub constant: Vec<(usize, f64)>,
    /// Forces on masses, each with the index of the mass.
    pub loads: Vec<(usize, Wave)>,
    /// Displacement of the base as a function of time.
    pub base: Wave,
}

/// Reason why the solver returns no result for a chain.
#[derive(Clone, Debug, PartialEq)]
pub enum JointError {
    /// The chain has no mass, or it has more masses or contacts than the solver supports.
    Size,
    /// A number of the chain is not finite, or has an invalid sign. The field names the number.
    Number(&'static str),
    /// A spring, dashpot, contact or load names a mass that does not exist. Also if a spring, dashpot or contact has
    /// the same node, or two supports, on its two sides. The field names the kind of element.
    Ends(&'static str),
    /// Several rigid contacts, given by their indices, form a closed loop and can all stick at the same time. Their
    /// forces are then not determined.
    Redundant(Vec<usize>),
    /// The solver would need more than [`MAX_PATTERNS`] patterns to decide which contacts stick. A pattern says for
    /// each contact whether it sticks or in which direction it slides.
    Patterns,
    /// The motion has more than [`MAX_EVENTS`] events.
    Events,
    /// The motion needs more than [`MAX_STRETCHES`] stretches (time intervals of a power series).
    Stretches,
    /// The solver finds event after event at the same instant, so that the motion does not advance.
    Stalled,
    /// The motion exceeds the range of the number type.
    NotFinite,
    /// The motion does not settle on a period of at most [`MAX_PERIOD`] cycles.
    NotSteady,
}

impl fmt::Display for JointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size => write!(
                f,
                "the chain must have 1 to {MAX_MASSES} masses and at most {MAX_CONTACTS} contacts"
            ),
            Self::Number(what) => write!(f, "{what} is not a number that it can be"),
            Self::Ends(what) => write!(f, "the ends of {what} are not two nodes of the chain"),
            Self::Redundant(contacts) => write!(
                f,
                "the forces of the rigid contacts {contacts:?} are not determined if all of them stick; give one of \
                 them a stiffness"
            ),
            Self::Patterns => write!(
                f,
                "the decision which contacts stick needs more than {MAX_PATTERNS} patterns"
            ),
            Self::Events => write!(f, "the motion has more than {MAX_EVENTS} events"),
            Self::Stretches => write!(f, "the motion needs more than {MAX_STRETCHES} stretches"),
            Self::Stalled => write!(f, "events follow each other without any time between them"),
            Self::NotSteady => write!(
                f,
                "the motion does not settle on a period of at most {MAX_PERIOD} cycles"
            ),
            Self::NotFinite => write!(f, "the motion exceeds the range of numbers"),
        }
    }
}

impl std::error::Error for JointError {}

impl From<Halt> for JointError {
    fn from(halt: Halt) -> Self {
        match halt {
            Halt::Level => Self::Number("the level of a contact"),
            Halt::Load => Self::Number("a load"),
            Halt::Patterns => Self::Patterns,
            Halt::Events => Self::Events,
            Halt::Stretches => Self::Stretches,
            Halt::Stalled => Self::Stalled,
            Halt::NotFinite => Self::NotFinite,
        }
    }
}
