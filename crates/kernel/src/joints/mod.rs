//! Chains with several rigid and elastic contacts, with dashpots, and with masses that no spring supports.
//!
//! All quantities have the units of the scene description. A contact of the nodes `plus - minus` has the relative
//! displacement z: the displacement of the node `plus` minus that of the node `minus`. A positive force f of the
//! contact acts on the node `plus` in the negative direction.
//!
//! * A rigid contact with ż = 0 sticks while |f| is at most μF, where F is its kinetic friction force. While it slides,
//!   f = F sgn ż. Under Stribeck's law, f = F φ(|ż|) sgn ż, where φ consists of straight lines.
//! * An elastic contact (Jenkins element) is a spring in series with a slider. The force f is that of the spring until
//!   |f| reaches μF. Then |f| is F, until ż = 0.
//! * The *level* of a contact is its kinetic friction force F. A contact with the level 0 has no force.
//!
//! At an event a contact starts to stick, starts to slide, or reverses. Between two events the equations are linear.
//! The solver divides this time into intervals, and computes one power series in each. Such a time interval is called
//! a *stretch*. The duration of a stretch, times an upper bound on the fastest angular frequency, is at most 1.5 rad
//! (1 rad in `f32`).
//!
//! The instant of an event is a root of a polynomial.
//!
//! Two masses with a sticking rigid contact between them have the same acceleration. The relative velocity of this
//! contact is therefore exactly 0, and its relative displacement is constant.
//!
//! The type parameter [`Size`] selects the arrays: arrays of fixed length in emitted code ([`Fixed`]), or vectors at
//! run time. The code is the same for both.

mod attractor;
mod base;
mod cycle;
mod decide;
mod events;
mod grip;
#[cfg(any(test, feature = "std"))]
mod heap;
mod jolt;
mod law;
mod least;
mod model;
mod neutral;
mod now;
mod orbit;
#[cfg(any(test, feature = "std"))]
mod period;
mod poly;
mod rates;
mod roots;
mod run;
#[cfg(any(test, feature = "std"))]
mod sensitivity;
mod series;
mod shooting;
mod shot;
mod simulation;
mod size;
mod slid;
mod state;
mod steady;
mod stepper;
mod stops;
mod stuck;
mod table;
mod tangent;
mod tolerances;
mod tree;
mod unknowns;
#[cfg(any(test, feature = "std"))]
mod wander;
mod wave;
mod waveform;

#[cfg(test)]
mod tangent_tests;
#[cfg(test)]
mod tests;

pub use crate::errors::Halt;
pub use base::Curve;
pub use cycle::{ContactCycle, Cycle, Watch};
pub use decide::{Decision, MAX_PATTERNS};
#[cfg(any(test, feature = "std"))]
pub use heap::{
    Heap, KeptTables, SharedTables, Short, refine, refine_symmetric, settle_or_other, settle_soon,
};
pub use model::{Contact, Link, Model, Stop};
pub use now::{ContactState, MassState};
pub use orbit::{At, ContactOrbit, MassOrbit, Orbit, StuckState};
#[cfg(any(test, feature = "std"))]
pub use period::{Mapped, Period};
pub use poly::{Poly, TERMS, slope, value};
pub use roots::{carried, first_negative};
pub use run::{Bounds, Motion, Observe};
#[cfg(any(test, feature = "std"))]
pub use sensitivity::vary;
pub use series::Series;
pub use simulation::{MAX_EVENTS, MAX_STRETCHES, Reference, Simulation};
pub use size::{Array, Fixed, Rows, Size, Value, add, at, set};
pub use state::{FREE, IMPACT, STUCK, State};
pub use steady::{Approach, MAX_PERIOD, Place, Soon, Steady};
pub use stepper::{
    Layout, MAX_STEP, MAX_STEP_EVENTS, MAX_TABLE_CONTACTS, MAX_TABLE_ENTRIES, Pace, Sample, Saved,
    Span, Stepped, Stepper, fill, image_bytes, image_step,
};
pub use stuck::StuckResponse;
pub use table::{Leap, NoTables, Table, Tables, table_sizes};
pub use tree::Tree;
pub use wave::Wave;
pub use waveform::{Piece, Pieces, Replay, Waveform, extremes};
