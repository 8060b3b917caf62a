//! Design studies at run time. The module reads the same descriptions and uses the same closed forms as the macro, but
//! allocates memory.

mod at;
mod builder;
pub mod columns;
mod compiled;
mod compiled_stuck;
#[cfg(feature = "desk")]
mod curve;
mod error;
mod features;
mod few;
mod held;
#[cfg(feature = "desk")]
mod history;
mod large;
#[cfg(feature = "desk")]
mod map;
mod motion;
mod optimum;
mod orbit;
mod parameter;
mod physical;
mod response;
mod sensitivity;
mod settled;
mod simulation;
mod stepper;
mod system;
pub mod units;
pub mod words;
mod work;

pub use at::SystemAt;
pub use builder::Builder;
pub use compiled::{CompiledAt, CompiledContact, CompiledMotion, CompiledSystem};
pub use compiled_stuck::CompiledStuck;
#[cfg(feature = "desk")]
pub use curve::{
    Curve, CurveError, CurvePoint, CurveRequest, CurveStart, End, Gap, Movement, Piece,
};
pub use error::{InvalidScene, StudyError, UnknownMass};
pub use features::{
    Antiresonance, Certainty, Condition, Crossing, Edge, FeatureError, Features, HeldResonance,
    InvariantPoint, Inversion, LimitsAtEnd, Measured, ParameterSlope, RegimeEnd, RegimeRange,
    Resonance, ResonantPeak, Sensed, SlidingRange, TruePeak,
};
pub use frictiongen_kernel::orbit::NoDerivative;
pub use frictiongen_syntax::{Diagnostic, Diagnostics};
pub use held::SystemHeld;
#[cfg(feature = "desk")]
pub use history::{
    History, HistoryError, HistoryEvent, HistoryRequest, MOST_SAMPLES, SpectralLine, Spectrum,
    Track,
};
#[cfg(feature = "desk")]
pub use map::{Boundary, LimitLines, Map, MapColumn, MapPoint, MapRequest, Pattern};
pub use motion::{SystemMotion, SystemSteady, SystemStuck};
pub use optimum::{
    FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumKind, OptimumPeak, OptimumRequest,
    Tolerance, Tunable, TunedOptimum, TunedPoint, Tuning, UnknownTunable,
};
pub use orbit::{SystemOrbit, SystemOrbitMotion, SystemOrbitState};
pub use parameter::{OperatingPoint, Parameter, Slope};
pub use physical::{ParameterSensitivity, ResponseSensitivities};
pub use response::{Size, Swing, SystemResponse};
pub use sensitivity::{Sensitive, Varied};
pub use simulation::SystemSimulation;
pub use stepper::{SystemInput, SystemStepSaved, SystemStepStore, SystemStepTables, SystemStepper};
pub use system::System;
pub use units::{Load, LoadError, LoadScale};

/// The parts of a description: masses, springs, contact, excitation and damping.
pub use frictiongen_model::scene::{self, Damping};
pub use frictiongen_model::sensitivity::Quantity;
/// Tables of the response with a declared accuracy.
pub use frictiongen_model::table;
pub use frictiongen_model::validate::SceneError;
