//! Chains with several contacts, rigid and elastic, dashpots, and masses that no spring holds, at run time.
//!
//! All quantities are in the units of the description. A contact of the nodes `later - earlier` has the relative
//! displacement z, which is that of the later mass minus that of the earlier one, or that of the mass minus that of
//! the base or the wall. Its force f acts against z on the later mass.
//!
//! * A rigid contact with ż = 0 sticks while |f| is at most μF. Otherwise f = F sgn ż.
//! * An elastic contact (Jenkins element) is a spring in series with a slider: f follows the spring until |f| is μF.
//!   Then f is F, until ż = 0.
//! * A contact of level 0 has no force.
//!
//! Between two events the equations are linear. A power series solves them over stretches of at most one radian of a
//! bound on the fastest frequency. Events are roots of polynomials. Contacts that stick are not constraints with a
//! residual: the masses that they join have one acceleration, so that the relative velocity of a contact that sticks is
//! exactly 0 and its relative displacement one number.

mod cycle;
mod damping;
mod decide;
mod events;
mod model;
mod neutral;
mod roots;
mod run;
mod series;
mod steady;
mod stuck;
mod tree;

#[cfg(test)]
mod tests;

pub use cycle::{ContactCycle, Cycle, Watch};
pub use decide::{Decision, MAX_PATTERNS};
pub use model::Model;
pub use run::{MAX_EVENTS, MAX_STRETCHES, Motion, State, Transition};
pub use series::Series;
pub use steady::{MAX_PERIOD, Steady, steady_state, steady_state_of};
pub use stuck::{StuckResponse, stuck_response};

use frictiongen_model::scene::Node;
use std::fmt;

/// Largest number of contacts.
pub const MAX_CONTACTS: usize = 16;
/// Largest number of masses.
pub const MAX_MASSES: usize = 64;

/// A straight line plus one harmonic: c + bt + a cos(ωt + φ).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Wave {
    /// The constant c.
    pub constant: f64,
    /// The slope b, per unit of time.
    pub slope: f64,
    /// The amplitude a.
    pub amplitude: f64,
    /// The frequency ω in rad per unit of time.
    pub omega: f64,
    /// The phase φ in rad.
    pub phase: f64,
}

impl Wave {
    /// Returns a value that does not change.
    pub fn constant(constant: f64) -> Self {
        Self {
            constant,
            ..Self::default()
        }
    }

    /// Returns a cos ωt.
    pub fn harmonic(amplitude: f64, omega: f64) -> Self {
        Self {
            amplitude,
            omega,
            ..Self::default()
        }
    }

    /// Returns the straight line through two samples (time, value).
    pub fn line((start, first): (f64, f64), (end, last): (f64, f64)) -> Self {
        let slope = (last - first) / (end - start);
        Self {
            constant: first - slope * start,
            slope,
            ..Self::default()
        }
    }

    /// Returns true if the value is 0 at every instant.
    pub fn is_zero(&self) -> bool {
        self.constant == 0.0 && self.slope == 0.0 && self.amplitude == 0.0
    }

    /// Returns true if all numbers of the function are finite.
    fn is_finite(&self) -> bool {
        let numbers = [
            self.constant,
            self.slope,
            self.amplitude,
            self.omega,
            self.phase,
        ];
        numbers.iter().all(|number| number.is_finite())
    }
}

/// A contact of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The two sides.
    pub ends: (Node, Node),
    /// Level F of the kinetic friction. It may vary in time for a rigid contact, and must then stay positive.
    pub level: Wave,
    /// Static over kinetic friction μ, at least 1.
    pub stiction: f64,
    /// Stiffness of the spring in series with the slider; `None` for a rigid contact.
    pub stiffness: Option<f64>,
}

/// A chain with its joints and its loads.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Chain {
    /// The masses.
    pub masses: Vec<f64>,
    /// The springs: two ends and a stiffness.
    pub springs: Vec<(Node, Node, f64)>,
    /// The dashpots: two ends and a coefficient.
    pub dashpots: Vec<(Node, Node, f64)>,
    /// The matrix of modal or Rayleigh damping by rows, or no rows.
    pub damping: Vec<Vec<f64>>,
    /// True if this matrix acts on velocities relative to the base. False if it acts on absolute velocities.
    pub damping_from_base: bool,
    /// The contacts.
    pub contacts: Vec<Joint>,
    /// Forces on masses.
    pub loads: Vec<(usize, Wave)>,
    /// The displacement of the base.
    pub base: Wave,
}

/// A reason why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum JointError {
    /// There is no mass, or there are more masses or contacts than fit.
    Size,
    /// A number is not finite, or has a sign that it cannot have.
    Number(&'static str),
    /// A spring, a dashpot, a contact or a load names a mass that does not exist, or one node twice.
    Ends(&'static str),
    /// Rigid contacts that can stick together and whose forces are then not determined, by index.
    Redundant(Vec<usize>),
    /// The decision which contacts stick needs more than [`MAX_PATTERNS`] patterns.
    Patterns,
    /// More than [`MAX_EVENTS`] events.
    Events,
    /// More than [`MAX_STRETCHES`] stretches.
    Stretches,
    /// Events follow each other without any time between them.
    Stalled,
    /// The motion exceeds the range of numbers.
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
