//! Exact solvers for mass-spring chains with one Coulomb friction contact.
//!
//! A description of masses, springs, one contact and an excitation becomes a solver: the exact
//! steady response, and the boundaries between continuous, stick-slip and stuck motion.
//!
//! * [`friction_system!`] does the modal analysis at compile time and emits specialised Rust:
//!   `no_std`, without allocation, without `unsafe`, everything of fixed size.
//! * `System` (feature `study`) reads the same text at run time.
//! * `measure` (feature `measure`) reads the friction force from recordings, and [`watch`] from samples on a device.
//! * The command `frictiongen` reads it from a file.
//!
//! ```
//! use frictiongen::{Regime, friction_system};
//!
//! friction_system! {
//!     /// Two-storey shear frame; a brass disc rubs on the upper floor.
//!     pub struct Frame {
//!         masses: { lower: 3.27, upper: 3.25 },                     // kg; the first is m₁
//!         springs: { base - lower: 1190.0, lower - upper: 1323.0 }, // N/m; the first is k₁
//!         contact: upper - wall,
//!         excitation: base,
//!         damping: modal[0.010, 0.012],
//!         stiction: 1.2,
//!     }
//! }
//!
//! fn main() -> Result<(), frictiongen::Error> {
//!     let at = Frame::at(0.9)?;
//!     assert_eq!(at.regime(0.3)?, Regime::Continuous);
//!     let motion = at.motion(0.3)?;
//!     println!("{} lags by {} rad", motion.upper().amplitude(), motion.upper().phase());
//!     Ok(())
//! }
//! ```
//!
//! # What the macro gives
//!
//! For `struct Frame`, with S the scene's scalar, and N masses:
//!
//! | item | meaning |
//! |---|---|
//! | `Frame::NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES` | ω_i in rad/s, the ratios r of them, φ by mode and mass with φᵀΓφ = 1 |
//! | `Frame::frequency_ratio(omega)`, `friction_ratio(friction, load)` | r = ω√(m₁/k₁), β = F/P |
//! | `Frame::at(r)` | the scene at one frequency ratio, `FrameAt`, or [`OutOfDomain`] |
//! | `at.limits()`, `at.limits_searched()` | both limits by one search, [`Limits`], which answers for every β; with the search's [`Effort`] |
//! | `at.continuous_limit()`, `.continuous_limit_without_search()`, `.continuous_limit_per_mode()` | β_lim exact; with S at τ → 0; as the thesis prints it |
//! | `at.sliding_limit()` | β*_lim |
//! | `at.regime(beta)`, `at.margin(beta)` | [`Regime`]; β/min(β_lim, β*_lim) − 1 |
//! | `at.motion(beta)` | the exact continuous motion, `FrameMotion`, or [`NotContinuous`] |
//! | `motion.contact()`, `motion.upper()` | a [`Motion`](kernel::response::motion::Motion): `largest` (both of them by one search), `largest_near` (the same in a sweep, led by a [`Neighbour`]), `amplitude`, `phase`, `amplitude_monoharmonic`, `displacement`, `velocity`, `harmonic` |
//! | `at.stuck()` | the response with the contact stuck, or [`StuckResonance`] |
//! | `at.orbit(beta)`, `at.orbit_from(beta, state)` | the steady state in any regime, `FrameOrbit`, or [`NoOrbit`]: `period` (1, or up to 64 cycles if it is subharmonic), `stops`, `reversals`, `stuck_fraction`, `sticking_intervals`, `intervals`, `friction`, `is_symmetric`, `multipliers`, `is_stable`, `is_marginal`, and an [`OrbitMotion`](kernel::orbit::OrbitMotion) for `contact()`, `upper()` |
//! | `at.orbit_or_last_cycles(beta)` | the same; where the motion does not settle, its last 64 cycles, with `is_settled()` false |
//! | `Frame::simulation(r, beta)`, `simulation_from(r, beta, state)` | the exact motion in time, `FrameSimulation`: `next` and `advance` give its [`Segment`](kernel::simulation::Segment)s, `upper()` where a mass is |
//! | `Frame::simulation_under(r, beta, amplitude)`, `simulation_under_from(r, beta, amplitude, state)` | the same where `friction: stribeck`, under a load of that amplitude in the scene's units: P, or for base motion Y |
//! | `Frame::stepper(dt)`, `stepper_from(dt, state)` | the motion by steps of one length in s under any input, `FrameStepper`, in the scene's units: `advance(FrameInput)` gives what the contact does, its force and its events, a [`Stepped`](kernel::stepper::Stepped); `upper()`, `contact()`, `work()`, `steps()`, `exceeded()`, `begin`, `set_stiction`, `save`, `restore` |
//! | `FrameInput { force, friction }`, `{ displacement, velocity, friction }` | what acts at the end of a step (`input: linear`) or over it (`hold`): a force on the excited mass, or the base's motion; a field more for each mass of `force`, by its name; and F |
//! | `Frame::STEP` | the declared step, whose tables are constants |
//! | `Frame::limits_without_search(r)` | β_lim with S at τ → 0, and β*_lim: the shortest way, where nothing else is asked of r |
//! | `Frame::limits_into(&rs, &mut continuous, &mut sliding)` | both limits over a slice |
//! | `Frame.limits_without_search_into(&rs, &mut continuous, &mut sliding)` | both without search over a slice, several r at once ([`FrictionSystem`]) |
//!
//! # Fields of a description
//!
//! | field | forms | default |
//! |---|---|---|
//! | `masses` | `{ name: number, … }`, the first is m₁ | required |
//! | `springs` | `{ node - node: number, … }`, node = a mass, `base` or `wall`; the first is k₁ | required |
//! | `contact` | `mass - wall`, `mass - mass`, `mass - base` | required |
//! | `excitation` | a mass, or `base` | required |
//! | `damping` | `none`, `modal(ζ)`, `modal[ζ₁, …]`, `rayleigh(a, b)` | `none` |
//! | `stiction` | μ = static over kinetic friction, at least 1 | 1 |
//! | `scalar` | `f64`, `f32` | `f64` |
//! | `provide` | a list of `limits`, `motion`, `motion(name, …)`, `stuck`, `orbit`, `simulation`, `stepper`; with `stepper` alone, and with `simulation` where `friction: stribeck`, nothing answers at a frequency | `[limits, motion]` |
//! | `accuracy` | `exact`, or the largest relative error of an answer from tables: `1e-4` | `exact` |
//! | `range` | where that holds: `{ r: 0.2..2.5 }`, also `beta: 0..1.5` | |
//! | `side` | `near`, or `safe`: β_lim never above, β*_lim never below the exact one | `near` |
//! | `budget` | in place of an accuracy, bytes: the best one that fits | |
//! | `beyond` | outside the range: `error`, or `exact` for the formulas | `error` |
//! | `friction` | `coulomb`, or `stribeck(v: f, …)`: the kinetic level over F at speeds, straight from 1 at rest and constant beyond the last; for `simulation` and `stepper` alone | `coulomb` |
//! | `step` | the stepper's step in s, if it is known: its tables are then constants | |
//! | `input` | `linear`, or `hold`: the stepper's input between samples | `linear` |
//! | `force` | `{ name, … }`: masses that the stepper may load besides `excitation` | |
//! | `crate` | path of this crate, when it is renamed | `::frictiongen` |
//!
//! # What a call can cost
//!
//! Nothing allocates, and everything that searches is bounded:
//!
//! | call | bound |
//! |---|---|
//! | `at`, `continuous_limit_without_search`, `continuous_limit_per_mode` in passes, `sliding_limit`, `stuck` | operations, listed with each emitted function |
//! | `continuous_limit`, `limits`, `regime`, `margin` | one search; `motion` one or two |
//! | `amplitude`, `phase`, `largest` of a mass | one search |
//! | a search | [`at.most_evaluations()`](kernel::response::At::most_evaluations) evaluations of a sum over the modes, by the scene and the least r: 256 or 1024 and some, where half the searches take 2 or 8; [`Effort`] tells if they did not do, and then the answer is the best seen: a limit on the unsafe side, an amplitude too small |
//! | `simulation`'s `advance` | two segments of [`MAX_STEPS`](kernel::simulation::MAX_STEPS) steps each; with `friction: stribeck` [`MAX_STRETCHES`](kernel::simulation::MAX_STRETCHES) stretches of at most 128 steps, where the level is constant of `MAX_STEPS` |
//! | `stepper`'s `advance` | for each part, of which a step has as many as stand with the emitted method: one product with the tables, or [`MAX_EVENTS`](kernel::stepper::MAX_EVENTS) events in [`MAX_STRETCHES`](kernel::stepper::MAX_STRETCHES) stretches; beyond, the contact is held for the rest of the part, and `exceeded` counts the step |
//! | `orbit` | about [`MAX_CYCLES`](kernel::orbit::MAX_CYCLES) cycles, and [`orbit::MAX_STEPS`](kernel::orbit::MAX_STEPS) steps in all, else [`NoOrbit`] |
//!
//! # Conventions
//!
//! x̄ = x/(P/k₁), for base motion x/Y; β = F/P, r = ω√(m₁/k₁), τ = ωt.  Phases are lags, in
//! (−π, π].  Equation numbers are those of L. Marino, *Dynamic analysis of mechanical systems with
//! Coulomb friction*, DPhil thesis, Oxford, 2021.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod features;
mod in_time;
#[cfg(feature = "measure")]
pub mod measure;
mod runs;
mod steady;
mod stepping;
pub mod sweep;
pub mod system;
mod targets;
pub mod watch;

#[cfg(feature = "study")]
pub mod study;

pub use frictiongen_kernel as kernel;
pub use frictiongen_kernel::Complex;
pub use frictiongen_kernel::contact::regime::Limits;
pub use frictiongen_kernel::errors::{
    Error, NoOrbit, NotContinuous, OutOfDomain, Regime, StuckResonance,
};
pub use frictiongen_kernel::modal_sum::search::{Effort, Neighbour};
pub use frictiongen_kernel::response::motion::Largest;
/// Turns the description of a scene into its solver; see the [crate's documentation](crate).
pub use frictiongen_macros::friction_system;
pub use in_time::{OrbitAt, Periodic, SteadyState};
pub use runs::{Run, Simulates, SimulatesUnder};
pub use stepping::{StepLoad, Stepping, Steps};
#[cfg(feature = "study")]
pub use study::System;
pub use system::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StuckAt};
