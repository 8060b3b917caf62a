//! Computes responses of scenes with several contacts, with dashpots, or with masses that no path of springs connects
//! to a support.
//!
//! [`System::joined`](crate::study::System::joined) returns a solver for these scenes. For such a scene, the methods
//! of `System` for a single contact return an error that names the fields. The module [`joints`](super::joints)
//! contains the computations.
//!
//! ```
//! use frictiongen::{Regime, System};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let frame: System = "struct Frame {
//!     masses: { lower: 2000, upper: 2000 },                  // kg
//!     springs: { base - lower: 1.5e6, lower - upper: 1.5e6 },  // N/m
//!     contacts: {
//!         brace: base - lower { stiffness: 5.0e6 },
//!         pads: lower - upper { share: 0.6, stiction: 1.2 },
//!     },
//!     dampers: { lower - upper: 1200.0 },                    // N·s/m
//!     excitation: base,
//! }"
//! .parse()?;
//! let joined = frame.joined()?;
//! let at = joined.at(0.6)?;
//! let stuck = at.stuck()?;
//! assert_eq!(stuck.first(), "brace");
//! let orbit = at.orbit(0.5 * stuck.limit())?;
//! assert_eq!(orbit.regime(), Regime::StickSlip);
//! assert_eq!(orbit.contact("brace")?.stops(), 2);
//! assert!(orbit.contact("pads")?.energy() > 0.0);
//! # Ok(())
//! # }
//! ```

mod answers;
mod at;
mod branch;
mod combination;
mod error;
mod history;
mod limit;
mod modes;
mod orbit;
mod parameter;
mod peaks;
mod scene;
mod sensitivity;
mod simulation;
mod slides;
mod states;
mod stepper;
mod units;
mod varied;
mod waveform;

#[cfg(test)]
mod tests;

pub use crate::study::joints::{BranchEnd, BranchEvent};
pub use answers::{LinearResponse, StuckState};
pub use at::JoinedAt;
pub use branch::{BranchRequest, JoinedBranch, JoinedBranchPoint, Parent};
pub(in crate::study) use combination::Combination;
pub use error::{JoinedError, UnknownContact};
pub use history::JoinedHistory;
pub use modes::{DampedMode, DampedModes};
pub use orbit::{ContactOrbit, FoundBy, JoinedOrbit};
pub use parameter::JoinedParameter;
pub use peaks::Peak;
pub use scene::Joined;
pub use sensitivity::{ContactSensitivity, JoinedSensitivities, JoinedSensitivity};
pub use simulation::{JoinedContactNow, JoinedEvent, JoinedSimulation};
pub use stepper::{JoinedInput, JoinedSpan, JoinedStepper};
pub use units::AnswerUnits;
pub(in crate::study) use waveform::Course;
pub use waveform::Waveform;
