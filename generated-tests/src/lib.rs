//! Scenes whose emitted code is compiled here, compared with its snapshot, and run; and the
//! reference values that emitted solvers and the run-time system are checked against.

pub mod data;
pub mod reference;
pub mod scenes;
pub mod shown;
pub mod wedges;

/// The larger of two; NaN if either is, so that a NaN does not vanish in a maximum.
#[must_use]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// The Rust of `docs/desk.md` is compiled as it stands there.
#[cfg(doctest)]
#[doc = include_str!("../../docs/desk.md")]
pub struct DeskPage;

/// And that of `docs/measure.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/measure.md")]
pub struct MeasurePage;

/// And that of `docs/stepper.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/stepper.md")]
pub struct StepperPage;

/// And that of `docs/start.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/start.md")]
pub struct StartPage;

/// And that of `docs/features.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/features.md")]
pub struct FeaturesPage;
