//! Computes responses, limits and best friction of a scene at run time. The module reads the same scene descriptions
//! as the macro `friction_system!`, and evaluates the same closed forms. Unlike the code that the macro emits, the
//! module allocates memory.

mod at;
mod builder;
#[doc(hidden)]
pub mod columns;
mod combined;
pub mod compiled;
#[cfg(feature = "desk")]
pub mod curve;
mod error;
pub mod features;
mod few;
pub(crate) mod golden;
mod held;
#[cfg(feature = "desk")]
pub mod history;
pub mod joined;
#[doc(hidden)]
pub mod joints;
mod large;
#[cfg(feature = "desk")]
pub mod map;
mod motion;
mod naming;
pub mod optimum;
pub mod orbit;
mod parameter;
pub mod periodic;
mod physical;
mod quantity;
mod rates;
pub mod response;
pub mod sensitivity;
mod settled;
pub mod simulation;
mod start;
mod steady_state;
pub mod stepper;
mod system;
pub mod units;
mod varied;
mod varied_steps;
#[doc(hidden)]
pub mod words;
mod work;

pub use at::SystemAt;
pub use builder::Builder;
pub use error::{InvalidScene, StudyError, UnknownMass, UnknownMotion};
/// The parts of a scene description: masses, springs, contact, excitation and damping.
pub use frictiongen_model::scene;
/// Tables of the response with a declared accuracy.
pub mod table {
    /// Types and constants that describe a table and its report. The commands `compile` and `report` use them.
    #[doc(hidden)]
    pub use frictiongen_model::table::{
        COARSEST, Evidence, FINEST, FINEST_PROVEN, FINEST_SINGLE, FRICTION_SHARES, Fitted, Held,
        HeldForm, Index, Product, Proof, ProofWork, Reach, Tables, Worst,
    };
    pub use frictiongen_model::table::{Request, TableError, TableReport};
}
pub use frictiongen_model::validate::SceneError;
pub use frictiongen_syntax::{Diagnostic, Diagnostics};
pub use start::InitialState;
pub use stepper::SystemInput;
pub use system::System;
