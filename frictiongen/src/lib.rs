//! Exact solvers for mass-spring chains with Coulomb friction contacts.
//!
//! The crate turns a description of masses, springs, one contact and an excitation into a solver. The solver gives the
//! exact steady response and the boundaries between continuous, stick-slip and stuck motion.
//!
//! * [`friction_system!`] does the modal analysis at compile time and emits specialised Rust code. The code is
//!   `no_std`, has a fixed size, and needs neither allocation nor `unsafe`.
//! * `System` (feature `study`) reads the same description at run time.
//! * `measure` (feature `measure`) finds the friction force in recordings. [`watch`] finds it in samples on a device.
//! * The command `frictiongen` reads the same description from a file.
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
//! The macro gives `struct Frame` these items:
//!
//! | item | meaning |
//! |---|---|
//! | `Frame::NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES` | ω_i in rad/s; the frequency ratios r of the resonances; φ by mode and mass with φᵀΓφ = 1 |
//! | `Frame::K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `SCENE_HASH` | k₁ and m₁ in the scene's units; ω_i/2π in Hz; the hash of the scene, which changes with every field of the scene description |
//! | `Frame::frequency_ratio(omega)`, `friction_ratio(friction, load)` | r = ω√(m₁/k₁), β = F/P |
//! | `Frame::at(r)` | the scene at one frequency ratio, `FrameAt`, or [`OutOfDomain`] |
//! | `at.limits()`, `at.limits_searched()` | β_lim and β*_lim by one search, as [`Limits`], which needs no further search for any β; `limits_searched` also returns the [`Effort`] of the search |
//! | `at.continuous_limit()`, `.continuous_limit_without_search()`, `.continuous_limit_per_mode()` | β_lim: exact; the upper bound with the velocity constraint S at τ → 0; the lower bound that the thesis prints |
//! | `at.sliding_limit()` | β*_lim |
//! | `at.regime(beta)`, `at.margin(beta)` | [`Regime`]; β/min(β_lim, β*_lim) − 1 |
//! | `at.motion(beta)` | the exact continuous motion, `FrameMotion`, or [`NotContinuous`] |
//! | `motion.contact()`, `motion.upper()` | a [`Motion`](answer::Motion): `largest` (amplitude and phase by one search), `largest_near` (as `largest`, in a sweep, from the result at a [`Neighbour`]), `amplitude`, `phase`, `amplitude_monoharmonic`, `displacement`, `velocity`, `harmonic` |
//! | `at.stuck()` | the response with the contact stuck, or [`StuckResonance`] |
//! | `at.orbit(beta)`, `at.orbit_from(beta, state)` | the steady state in any regime, `FrameOrbit`, or [`NoOrbit`]: `period` (1, or up to 64 cycles if it is subharmonic), `stops`, `reversals`, `stuck_fraction`, `sticking_intervals`, `intervals`, `friction`, `is_symmetric`, `multipliers`, `is_stable`, `is_marginal`, and an [`OrbitMotion`](answer::OrbitMotion) for `contact()`, `upper()` |
//! | `at.orbit_or_last_cycles(beta)` | like `at.orbit(beta)`. Where the motion does not settle, it returns the last 64 cycles, and `is_settled()` is false |
//! | `Frame::simulation(r, beta)`, `simulation_from(r, beta, state)` | the exact motion in time, `FrameSimulation`: `next` and `advance` return its [`Segment`](answer::Segment)s, `upper()` returns the present motion of the mass `upper` |
//! | `Frame::simulation_under(r, beta, amplitude)`, `simulation_under_from(r, beta, amplitude, state)` | the exact motion in time with `friction: stribeck`, under a load of the given amplitude in the scene's units: P, or Y for base motion |
//! | `Frame::stepper(dt)`, `stepper_from(dt, state)` | the motion in steps of equal length dt (s) under any input, `FrameStepper`, in the scene's units: `advance(FrameInput)` returns the contact's state, its force and its events, as [`Stepped`](answer::Stepped); `upper()`, `contact()`, `work()`, `steps()`, `exceeded()`, `begin`, `set_stiction`, `set_event_budget`, `all_masses()`, `save`, `restore`, `image` (bytes for a file or flash memory), from which `Frame::stepper_from_image(&bytes)` continues |
//! | `FrameInput { force, friction }`, `{ displacement, velocity, friction }` | the input at the end of a step (`input: linear`) or over the whole step (`hold`): the force on the excited mass or the motion of the base; one more field for each mass of `force`, by its name; and the friction force F |
//! | `Frame::self_check()` | with `self_check` under `provide`: compares checksums of all constants, and answers at ten frequencies with those of double-double arithmetic. The error names the first constant or method that is wrong |
//! | `Frame::STEP` | the declared step, whose tables are constants |
//! | `Frame::declared_stepper()` | `const`: a stepper of the declared step that borrows its tables, `FrameDeclaredStepper`, with the methods of `FrameStepper` |
//! | `Frame::limits_without_search(r)` | the upper bound on β_lim with S at τ → 0, and β*_lim: the fastest call if no other result is needed at r |
//! | `Frame::limits_into(&rs, &mut continuous, &mut sliding)` | β_lim and β*_lim for each r of a slice |
//! | `Frame.limits_without_search_into(&rs, &mut continuous, &mut sliding)` | the results of `limits_without_search` for each r of a slice, with several r in one pass ([`FrictionSystem`]) |
//!
//! # Fields of a description
//!
//! | field | forms | default |
//! |---|---|---|
//! | `masses` | `{ name: number, … }`, the first is m₁ | required |
//! | `springs` | `{ node - node: number, … }`, node = a mass, `base` or `wall`; the first is k₁ | required, except with `contacts` or `dampers` |
//! | `contact` | `mass - wall`, `mass - mass`, `mass - base` | required, or `contacts` |
//! | `contacts` | `{ name: node - node { stiffness: k, stiction: μ, share: s }, … }`: one contact with a name, or several. For several, the macro emits only `stepper`, `simulation`, `stuck` and `orbit` | |
//! | `dampers` | `{ node - node: c, … }`: dashpots in N·s/m. The macro then emits only `stepper`, `simulation`, `stuck` and `orbit` | |
//! | `stops` | `{ name: a - b { gap: g, stiffness: k, damping: c }, … }`, acts while x_a − x_b > g; `restitution: e` in place of `stiffness` | |
//! | `constant` | `{ mass: force, … }`: constant forces in N | |
//! | `excitation` | a mass, or `base` | required |
//! | `damping` | `none`, `modal(ζ)`, `modal[ζ₁, …]`, `rayleigh(a, b)` | `none` |
//! | `damping_from` | `rest` (damping acts on absolute velocities), `base` (on velocities relative to the moving base) | `rest` |
//! | `stiction` | μ, the static friction force divided by the kinetic one, at least 1 | 1 |
//! | `stiffness` | the stiffness of an elastic contact (Jenkins element), a spring in series with the slider | a rigid contact |
//! | `scalar` | `f64`, `f32` | `f64` |
//! | `provide` | a list of `limits`, `motion`, `motion(name, …)`, `stuck`, `orbit`, `simulation`, `stepper`, `self_check`. A scene with `stepper` alone, or with `simulation` and `friction: stribeck`, gives no answers at a frequency | `[limits, motion]` |
//! | `accuracy` | `exact`, or the largest relative error of an answer from tables: `1e-4` | `exact` |
//! | `range` | the range in which the accuracy is kept: `{ r: 0.2..2.5 }`, also `beta: 0..1.5` | |
//! | `side` | `near`; or `safe`: β_lim is never above the exact β_lim, and β*_lim never below the exact β*_lim | `near` |
//! | `budget` | size of the tables in bytes, instead of an accuracy: the tables have the best accuracy that fits into this size | |
//! | `beyond` | the answer outside the range: `error`, or `exact` for the exact formulas | `error` |
//! | `friction` | `coulomb`; or `stribeck(v: f, …)`: the kinetic friction divided by F at the speeds v, linear between the speeds, 1 at rest and constant beyond the last speed; for `simulation` and `stepper` alone | `coulomb` |
//! | `stribeck` | `exp(fs, vs)` in place of `friction`: the kinetic friction of rigid contacts is F(1 + (fs − 1)exp(−∣v∣/vs)), as straight lines with errors of at most 0.001 F; `exp(fs, vs, a)` with errors of at most aF | |
//! | `step` | the stepper's step in s, if it is known at compile time: its tables are then constants | |
//! | `input` | the stepper's input between samples: `linear`, or `hold` | `linear` |
//! | `force` | `{ name, … }`: masses that the stepper may load besides `excitation` | |
//! | `crate` | path of this crate, if it is renamed | `::frictiongen` |
//!
//! # Upper bounds on the work of a call
//!
//! No call allocates memory. The work of every call has an upper bound:
//!
//! | call | bound |
//! |---|---|
//! | `at`, `continuous_limit_without_search`, `sliding_limit`, `stuck`; `continuous_limit_per_mode` per pass | a number of operations, listed with each emitted function |
//! | `continuous_limit`, `limits`, `regime`, `margin` | one search; `motion` takes one or two |
//! | `amplitude`, `phase`, `largest` of a mass | one search |
//! | a search | [`at.most_evaluations()`](kernel::response::At::most_evaluations) evaluations of the modal sum: somewhat more than 256 or 1024, depending on the scene and the smallest r. If this number does not suffice, [`Effort`] reports it, and the answer is the best value found: a β_lim that is too large, or an amplitude that is too small |
//! | `simulation`'s `advance` | two segments of [`MAX_STEPS`](kernel::simulation::MAX_STEPS) steps each. With `friction: stribeck`, [`MAX_STRETCHES`](kernel::simulation::MAX_STRETCHES) stretches of at most 128 steps, or of `MAX_STEPS` where the kinetic friction is constant |
//! | `stepper`'s `advance` | for each part of a step: one product with the tables, or [`MAX_EVENTS`](kernel::stepper::MAX_EVENTS) events in [`MAX_STRETCHES`](kernel::stepper::MAX_STRETCHES) stretches. The emitted method's documentation gives the number of parts. If a part has more events, or the step more than `set_event_budget` allows, a rule without a search ends the step, and `exceeded` counts the step |
//! | `orbit` | about [`MAX_CYCLES`](kernel::orbit::MAX_CYCLES) cycles, and [`orbit::MAX_STEPS`](kernel::orbit::MAX_STEPS) steps in all. If the motion has not settled then, it returns [`NoOrbit`] |
//!
//! # Conventions
//!
//! Displacements are x̄ = x/(P/k₁), or x/Y for base motion. P is the amplitude of the load, Y that of the base, and F
//! the friction force. The friction ratio is β = F/P, the frequency ratio is r = ω√(m₁/k₁), and the phase of the
//! excitation is τ = ωt. The phase of a response is a lag in (−π, π]. Equation numbers refer to L. Marino, *Dynamic
//! analysis of mechanical systems with Coulomb friction*, DPhil thesis, Oxford, 2021.
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

/// Result types of emitted and of run-time systems.
pub mod answer {
    pub use frictiongen_kernel::orbit::OrbitMotion;
    pub use frictiongen_kernel::response::motion::Motion;
    pub use frictiongen_kernel::simulation::{Contact, Event, Moment, Segment};
    pub use frictiongen_kernel::stepper::{ContactNow, Cost, MassNow, Stepped, Work};
}

/// Number types, for functions that are generic over the precision.
pub mod scalar {
    #[doc(hidden)]
    pub use frictiongen_kernel::Plain;
    pub use frictiongen_kernel::number::dd::Dd;
    pub use frictiongen_kernel::{Float, Scalar};
}

/// Items that emitted code uses. They may change with every version.
#[doc(hidden)]
pub use frictiongen_kernel as kernel;
pub use frictiongen_kernel::Complex;
pub use frictiongen_kernel::contact::regime::Limits;
#[doc(hidden)]
pub use frictiongen_kernel::emitted::check::Fault;
pub use frictiongen_kernel::errors::{
    Error, Given, NoOrbit, NotContinuous, OutOfDomain, Ratio, Regime, Slice, StuckResonance,
    Unsupported,
};
pub use frictiongen_kernel::modal_sum::search::{Effort, Neighbour};
pub use frictiongen_kernel::response::motion::Largest;
pub use frictiongen_macros::friction_system;
pub use in_time::{OrbitAt, Periodic, SteadyState};
pub use runs::{Run, Simulates, SimulatesUnder};
pub use stepping::{StepLoad, Stepping, Steps};
#[cfg(feature = "study")]
pub use study::System;
pub use system::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StuckAt};
