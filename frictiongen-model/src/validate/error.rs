//! Messages of invalid scenes. Each message says what is wrong, in the terms of an engineer, and what to write instead.

use super::path::Path;
use crate::table::FINEST_PROVEN;

/// Reason why a scene makes no physical sense.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(
    missing_docs,
    reason = "each message says what its variant and fields mean"
)]
pub enum SceneError {
    #[error("a scene needs at least one mass: write, for example, `m1: 1.0`")]
    NoMasses { path: Path },
    #[error(
        "the scene has {count} masses, but at most {limit} are possible here; lump neighbouring masses together"
    )]
    TooManyMasses {
        path: Path,
        count: usize,
        limit: usize,
    },
    #[error(
        "`r#{plain}` cannot name a mass: leave the `r#` out, and choose a name that is not a keyword of Rust"
    )]
    RawName { path: Path, plain: String },
    #[error("`{name}` is a keyword of Rust and cannot name a mass; write, for example, `{name}_1`")]
    Keyword { path: Path, name: String },
    #[error(
        "`{name}` already means something else in a scene or in its results and cannot name a mass; write, for example, `{name}_1`"
    )]
    Reserved { path: Path, name: String },
    #[error(
        "`{name}` cannot name a mass: a name is made of letters, digits and `_`, and does not begin with a digit"
    )]
    NotAName { path: Path, name: String },
    #[error("two masses are called `{name}`; give this one a name of its own")]
    DuplicateName { path: Path, name: String },
    #[error("{what} is {value}, which is not a finite number; write a finite one")]
    NotFinite {
        path: Path,
        what: String,
        value: f64,
    },
    #[error(
        "the mass `{name}` is {value:?}: a mass must be greater than zero; write a positive number, or leave the mass out"
    )]
    MassNotPositive {
        path: Path,
        name: String,
        value: f64,
    },
    #[error(
        "{what} is {value:?}, which is not between 1e-60 and 1e60; choose other units, or another number"
    )]
    OutOfScale {
        path: Path,
        what: String,
        value: f64,
    },
    #[error(
        "the largest mass is {ratio:.0e} times the smallest, more than {limit:.0e}, so that the small masses would have no effect; lump this mass with its neighbour, or leave it out"
    )]
    MassesSpan { path: Path, ratio: f64, limit: f64 },
    #[error(
        "the largest stiffness is {ratio:.0e} times the smallest, more than {limit:.0e}, so that the soft springs would have no effect; join the two ends of this spring into one mass, or leave the soft springs out"
    )]
    StiffnessesSpan { path: Path, ratio: f64, limit: f64 },
    #[error(
        "the natural frequencies {first} and {second} have a relative difference of {gap:.0e}, too small for `f32`; write `scalar: f64`, or change a mass or a stiffness"
    )]
    ModesTooClose {
        path: Path,
        first: usize,
        second: usize,
        gap: f64,
    },
    #[error(
        "a scene needs at least one spring to hold its masses: write, for example, `base - m1: 1.0`"
    )]
    NoSprings { path: Path },
    #[error(
        "there is no mass with the index {index}; the scene has {count}, and the first has the index 0"
    )]
    NoSuchMass {
        path: Path,
        index: usize,
        count: usize,
    },
    #[error(
        "this spring joins `{name}` to itself and never stretches; join it to another mass, to `base` or to `wall`"
    )]
    SpringToItself { path: Path, name: String },
    #[error(
        "this spring joins two supports and touches no mass; leave it out, or join one of its ends to a mass"
    )]
    SpringWithoutMass { path: Path },
    #[error(
        "there is already a spring between `{from}` and `{to}`; parallel springs act as one, so add their stiffnesses and write a single spring{sum}"
    )]
    ParallelSprings {
        path: Path,
        from: String,
        to: String,
        sum: String,
    },
    #[error(
        "the spring `{from} - {to}` has the stiffness {value:?}: a stiffness must be greater than zero; write a positive number, or leave the spring out"
    )]
    StiffnessNotPositive {
        path: Path,
        from: String,
        to: String,
        value: f64,
    },
    #[error(
        "nothing holds the mass `{name}`: no springs lead from it to `base` or `wall`, so it would drift away; add, for example, `base - {name}: 1.0`"
    )]
    NotHeld { path: Path, name: String },
    #[error(
        "nothing holds the mass `{name}` and those joined to it ({others}): no springs lead from them to `base` or `wall`, so they would drift away; add, for example, `base - {name}: 1.0`"
    )]
    GroupNotHeld {
        path: Path,
        name: String,
        others: String,
    },
    #[error(
        "the contact rubs `{name}` on itself; name two different sides, for example `{name} - wall`"
    )]
    ContactWithItself { path: Path, name: String },
    #[error("the contact lies between two supports; one of its sides must be a mass")]
    ContactWithoutMass { path: Path },
    #[error(
        "the base moves, but no spring joins a mass to it, so nothing is excited; join a spring to `base`, or put a force on a mass"
    )]
    IdleBase { path: Path },
    #[error(
        "the contact `{contact}` can never slide: no springs lead to it from {load} except through a support; join them by a spring, or move the contact or the excitation"
    )]
    NeverSlides {
        path: Path,
        load: String,
        contact: String,
    },
    #[error(
        "a damping list needs one ratio for each mode, here {masses}, not {found}; write `modal(0.01)` for the same ratio in every mode"
    )]
    DampingCount {
        path: Path,
        found: usize,
        masses: usize,
    },
    #[error("{what} is {value:?}: negative damping would feed energy in; write zero or more")]
    DampingNegative {
        path: Path,
        what: String,
        value: f64,
    },
    #[error(
        "the stiction μ is {value:?}, but static friction is never smaller than kinetic; write 1 or more"
    )]
    StictionBelowOne { path: Path, value: f64 },
    #[error("an empty list provides nothing; write, for example, `[limits, motion]`")]
    NothingProvided { path: Path },
    #[error("`{item}` is asked for twice; name it once")]
    ProvidedTwice { path: Path, item: String },
    #[error(
        "`motion()` names no mass; write `motion` for all masses, or name some in the parentheses"
    )]
    MotionOfNothing { path: Path },
    #[error(
        "an accuracy is a relative error from {finest:?} to 0.1, not {value:?}; write, for example, `accuracy: 1e-4`, or `exact`"
    )]
    AccuracyOutside { path: Path, value: f64, finest: f64 },
    #[error(
        "an accuracy or a budget needs a range of frequency ratios; add, for example, `range: {{ r: 0.2..2.5 }}`"
    )]
    AccuracyWithoutRange { path: Path },
    #[error("`accuracy` and `budget` exclude each other: keep one of the two")]
    AccuracyAndBudget { path: Path },
    #[error(
        "a budget must be a whole number of bytes, 1 or more, not {value:?}; write, for example, `budget: 4096`"
    )]
    BudgetOutside { path: Path, value: f64 },
    #[error(
        "`{field}` has an effect only with an accuracy or a budget; add, for example, `accuracy: 1e-4`, or leave the field out"
    )]
    WithoutAccuracy { path: Path, field: String },
    #[error(
        "β_lim can be proven to an accuracy of {FINEST_PROVEN:e} or coarser, not {value:e}; write `accuracy: {FINEST_PROVEN:e}`, or leave `proof` out, so that the finer table is checked but not proven"
    )]
    TooFineForProof { path: Path, value: f64 },
    #[error(
        "a range a..b of frequency ratios needs 0 < a < b, both finite, not {low:?}..{high:?}; write, for example, `r: 0.2..2.5`"
    )]
    RangeOfRatio { path: Path, low: f64, high: f64 },
    #[error(
        "a range a..b of friction ratios needs 0 ≤ a < b, not {low:?}..{high:?}; write, for example, `beta: 0..1.5`"
    )]
    RangeOfFriction { path: Path, low: f64, high: f64 },
    #[error("`{field}` belongs to the stepper: add `stepper` to `provide`, or leave the field out")]
    WithoutStepper { path: Path, field: String },
    #[error(
        "`stribeck` works only in the stepper and the simulation, because the exact continuous response needs a constant kinetic level; write `provide: [simulation]`, or `friction: coulomb`"
    )]
    StribeckWithoutMotion { path: Path },
    #[error(
        "`{item}` is not possible with `stribeck`, because it needs a constant kinetic level; leave it out, or write `friction: coulomb`"
    )]
    NeedsConstantLevel { path: Path, item: String },
    #[error(
        "`{field}` is for limits and motion, which are not provided; add `limits` to `provide`, or leave the field out"
    )]
    NothingToTabulate { path: Path, field: String },
    #[error(
        "`stribeck()` has no point; write, for example, `stribeck(0.1: 0.8)` for 0.8·F from the speed 0.1 on, or `coulomb`"
    )]
    StribeckWithoutPoints { path: Path },
    #[error(
        "the speeds of `stribeck` must be above zero and ascending, but {value:?} follows {before:?}; write the points in ascending order, and none at zero speed, where the level is 1"
    )]
    StribeckNotAscending { path: Path, value: f64, before: f64 },
    #[error(
        "the kinetic level is {value:?}: negative friction would feed energy in; write zero or more"
    )]
    StribeckNegative { path: Path, value: f64 },
    #[error(
        "the kinetic level {value:?} is above μ = {stiction:?}, but static friction is never smaller than kinetic; write at most μ"
    )]
    StribeckAboveStatic {
        path: Path,
        value: f64,
        stiction: f64,
    },
    #[error(
        "the step is {value:?}: it must be greater than zero; write it in seconds, for example `step: 1e-3`"
    )]
    StepNotPositive { path: Path, value: f64 },
    #[error("the mass `{name}` is already loaded by the excitation; leave it out of `force`")]
    ForceOnExcitation { path: Path, name: String },
    #[error("`force` names `{name}` twice; name it once")]
    ForceTwice { path: Path, name: String },
}

impl SceneError {
    /// Returns the item of the scene that causes the error.
    #[must_use]
    pub fn path(&self) -> Path {
        match self {
            Self::NoMasses { path }
            | Self::MassesSpan { path, .. }
            | Self::StiffnessesSpan { path, .. }
            | Self::ModesTooClose { path, .. }
            | Self::TooManyMasses { path, .. }
            | Self::RawName { path, .. }
            | Self::Keyword { path, .. }
            | Self::Reserved { path, .. }
            | Self::NotAName { path, .. }
            | Self::DuplicateName { path, .. }
            | Self::NotFinite { path, .. }
            | Self::MassNotPositive { path, .. }
            | Self::OutOfScale { path, .. }
            | Self::NoSprings { path }
            | Self::NoSuchMass { path, .. }
            | Self::SpringToItself { path, .. }
            | Self::SpringWithoutMass { path }
            | Self::ParallelSprings { path, .. }
            | Self::StiffnessNotPositive { path, .. }
            | Self::NotHeld { path, .. }
            | Self::GroupNotHeld { path, .. }
            | Self::ContactWithItself { path, .. }
            | Self::ContactWithoutMass { path }
            | Self::IdleBase { path }
            | Self::NeverSlides { path, .. }
            | Self::DampingCount { path, .. }
            | Self::DampingNegative { path, .. }
            | Self::StictionBelowOne { path, .. }
            | Self::NothingProvided { path }
            | Self::ProvidedTwice { path, .. }
            | Self::MotionOfNothing { path }
            | Self::AccuracyOutside { path, .. }
            | Self::AccuracyWithoutRange { path }
            | Self::AccuracyAndBudget { path }
            | Self::BudgetOutside { path, .. }
            | Self::WithoutAccuracy { path, .. }
            | Self::TooFineForProof { path, .. }
            | Self::RangeOfRatio { path, .. }
            | Self::RangeOfFriction { path, .. }
            | Self::WithoutStepper { path, .. }
            | Self::StribeckWithoutMotion { path }
            | Self::NeedsConstantLevel { path, .. }
            | Self::NothingToTabulate { path, .. }
            | Self::StribeckWithoutPoints { path }
            | Self::StribeckNotAscending { path, .. }
            | Self::StribeckNegative { path, .. }
            | Self::StribeckAboveStatic { path, .. }
            | Self::StepNotPositive { path, .. }
            | Self::ForceOnExcitation { path, .. }
            | Self::ForceTwice { path, .. } => *path,
        }
    }
}
