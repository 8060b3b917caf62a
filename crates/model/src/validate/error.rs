//! Messages of invalid scenes. Each message says what is wrong, in the terms of an engineer, and what to write instead.

use super::path::Path;
use crate::table::FINEST_PROVEN;
use core::fmt;

/// Defines the errors. Each error has a name, its fields besides the path, and a message. The crate uses no derive
/// macro, because every build of the library would then wait for syn.
macro_rules! scene_errors {
    ($($name:ident { $($field:ident: $kind:ty),* } => $message:literal,)*) => {
        /// An error in a scene that makes no physical sense.
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        #[allow(
            missing_docs,
            reason = "each message says what its variant and fields mean"
        )]
        pub enum SceneError {
            $($name { path: Path, $($field: $kind),* },)*
        }

        impl fmt::Display for SceneError {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Self::$name { path: _, $($field),* } => write!(f, $message),)*
                }
            }
        }

        impl SceneError {
            /// Returns the item of the scene that causes the error.
            #[must_use]
            pub fn path(&self) -> Path {
                match self {
                    $(Self::$name { path, .. } => *path,)*
                }
            }
        }
    };
}

impl core::error::Error for SceneError {}

scene_errors! {
    NoMasses {} =>
        "a scene needs at least one mass: write, for example, `m1: 1.0`",
    TooManyMasses { count: usize, limit: usize } =>
        "the scene has {count} masses, but at most {limit} are possible here; lump neighbouring masses together",
    RawName { plain: String } =>
        "`r#{plain}` cannot name a mass: leave the `r#` out; for the macro, choose a name that is not a keyword of Rust",
    Keyword { name: String } =>
        "`{name}` is a keyword of Rust, and the macro emits a method with the name of each mass; write, for example, `{name}_1`",
    Reserved { name: String } =>
        "`{name}` already means something else in a scene or in its results and cannot name a mass; write, for example, `{name}_1`",
    NotAName { name: String } =>
        "`{name}` cannot name a mass: a name is made of letters, digits and `_`, and does not begin with a digit",
    DuplicateName { name: String } =>
        "two masses are called `{name}`; give this one a name of its own",
    NotFinite { what: String, value: f64 } =>
        "{what} is {value}, which is not a finite number; write a finite one",
    MassNotPositive { name: String, value: f64 } =>
        "the mass `{name}` is {value:?}: a mass must be greater than zero; write a positive number, or leave the mass out",
    OutOfScale { what: String, value: f64 } =>
        "{what} is {value:?}, which is not between 1e-60 and 1e60; choose other units, or another number",
    MassesSpan { ratio: f64, limit: f64 } =>
        "the largest mass is {ratio:.0e} times the smallest, more than {limit:.0e}, so that the small masses would have no effect; lump this mass with its neighbour, or leave it out",
    StiffnessesSpan { ratio: f64, limit: f64 } =>
        "the largest stiffness is {ratio:.0e} times the smallest, more than {limit:.0e}, so that the soft springs would have no effect; join the two ends of this spring into one mass, or leave the soft springs out",
    ModesTooClose { first: usize, second: usize, gap: f64 } =>
        "the natural frequencies {first} and {second} have a relative difference of {gap:.0e}, too small for `f32`; write `scalar: f64`, or change a mass or a stiffness",
    NoSprings {} =>
        "with `contact`, a scene needs at least one spring to hold its masses: write, for example, `base - m1: 1.0`; for masses that nothing holds, write the contact as `contacts: {{ contact: m1 - wall }}`",
    NoSuchMass { index: usize, count: usize } =>
        "there is no mass with the index {index}; the scene has {count}, and the first has the index 0",
    SpringToItself { name: String } =>
        "this spring joins `{name}` to itself and never stretches; join it to another mass, to `base` or to `wall`",
    SpringWithoutMass {} =>
        "this spring joins two supports and touches no mass; leave it out, or join one of its ends to a mass",
    ParallelSprings { from: String, to: String, sum: String } =>
        "there is already a spring between `{from}` and `{to}`; parallel springs act as one, so add their stiffnesses and write a single spring{sum}",
    StiffnessNotPositive { from: String, to: String, value: f64 } =>
        "the spring `{from} - {to}` has the stiffness {value:?}: a stiffness must be greater than zero; write a positive number, or leave the spring out",
    NotHeld { name: String, contact: String } =>
        "nothing holds the mass `{name}`: no springs lead from it to `base` or `wall`, so it would drift away; add, for example, `base - {name}: 1.0`; if it is free to drift, write the contact as `contacts: {{ {contact} }}`",
    GroupNotHeld { name: String, others: String, contact: String } =>
        "nothing holds the mass `{name}` and those joined to it ({others}): no springs lead from them to `base` or `wall`, so they would drift away; add, for example, `base - {name}: 1.0`; if they are free to drift, write the contact as `contacts: {{ {contact} }}`",
    ContactWithItself { name: String } =>
        "the contact rubs `{name}` on itself; name two different sides, for example `{name} - wall`",
    ContactWithoutMass {} =>
        "the contact lies between two supports; one of its sides must be a mass",
    IdleBase {} =>
        "the base moves, but no spring joins a mass to it, so nothing is excited; join a spring to `base`, or put a force on a mass",
    NeverSlides { load: String, contact: String } =>
        "the contact `{contact}` can never slide: no springs lead to it from {load} except through a support; join them by a spring, or move the contact or the excitation",
    DampingCount { found: usize, masses: usize } =>
        "a damping list needs one ratio for each mode, here {masses}, not {found}; write `modal(0.01)` for the same ratio in every mode",
    DampingNegative { what: String, value: f64 } =>
        "{what} is {value:?}: negative damping would feed energy in; write zero or more",
    NoMovingBase { load: String } =>
        "`damping_from: base` needs a base that moves, but here a force acts on `{load}` and the base is at rest; write `excitation: base`, or leave `damping_from` out",
    ContactStiffnessNotPositive { value: f64 } =>
        "the stiffness of the contact is {value:?}: it must be greater than zero; write a positive number, or leave `stiffness` out for a rigid contact",
    StiffnessInfinite {} =>
        "an infinite stiffness is a rigid contact; leave `stiffness` out",
    StiffnessLosesDigits { value: f64, most: f64, kept: u32 } =>
        "the stiffness {value:?} of the contact leaves fewer than {kept} correct digits of its force; write at most {most:.1e}, or leave `stiffness` out for a rigid contact",
    ElasticStribeck {} =>
        "`stiffness` and `stribeck` exclude each other: the force of an elastic contact cannot depend on the speed; leave one of the two out",
    ElasticWithoutMotion {} =>
        "an elastic contact sticks after each reversal, so that it has no β_lim and no closed form; write `provide: [orbit, simulation]`, or leave `stiffness` out for a rigid contact",
    NotElastic { item: String } =>
        "`{item}` is not possible with `stiffness`; write `orbit`, `simulation`, `stepper` or `stuck` instead, or leave `stiffness` out for a rigid contact",
    TooManyContacts { count: usize, limit: usize } =>
        "the scene has {count} contacts, but at most {limit} are possible; join neighbouring contacts into one with the sum of their shares",
    ContactKeyword { name: String } =>
        "`{name}` is a keyword of Rust, and the macro emits a method with the name of each contact; write, for example, `{name}_1`",
    ContactReserved { name: String } =>
        "`{name}` already means something else in a scene or in its results and cannot name a contact; write, for example, `{name}_1`",
    ContactNotAName { name: String } =>
        "`{name}` cannot name a contact: a name is made of letters, digits and `_`, and does not begin with a digit",
    DuplicateContact { name: String } =>
        "two contacts are called `{name}`; give this one a name of its own",
    ContactNamedAsMass { name: String } =>
        "a mass is called `{name}`, and a contact cannot have the same name; give the contact a name of its own",
    ParallelContacts { from: String, to: String, sum: String } =>
        "there is already a rigid contact between `{from}` and `{to}`; two rigid contacts side by side act as one, so add their shares and write a single contact{sum}",
    ShareNotPositive { name: String, value: f64 } =>
        "the share of the contact `{name}` is {value:?}: a share must be greater than zero; write a positive number, or leave the contact out",
    JointStiffnessNotPositive { name: String, value: f64 } =>
        "the stiffness of the contact `{name}` is {value:?}: it must be greater than zero; write a positive number, or leave `stiffness` out for a rigid contact",
    RedundantContacts { names: String } =>
        "the rigid contacts {names} close a loop, so that their forces are not determined while all of them stick; give one of them a `stiffness`, or leave one out",
    DamperToItself { name: String } =>
        "this dashpot joins `{name}` to itself and never moves; join it to another mass, to `base` or to `wall`",
    DamperWithoutMass {} =>
        "this dashpot joins two supports and touches no mass; leave it out, or join one of its ends to a mass",
    ParallelDampers { from: String, to: String, sum: String } =>
        "there is already a dashpot between `{from}` and `{to}`; parallel dashpots act as one, so add their coefficients and write a single dashpot{sum}",
    DamperNotPositive { from: String, to: String, value: f64 } =>
        "the dashpot `{from} - {to}` has the coefficient {value:?}: a coefficient must be greater than zero; write a positive number, or leave the dashpot out",
    StopKeyword { name: String } =>
        "`{name}` is a keyword of Rust, and the macro emits a method with the name of each stop; write, for example, `{name}_1`",
    StopReserved { name: String } =>
        "`{name}` already means something else in a scene or in its results and cannot name a stop; write, for example, `{name}_1`",
    StopNotAName { name: String } =>
        "`{name}` cannot name a stop: a name is made of letters, digits and `_`, and does not begin with a digit",
    DuplicateStop { name: String } =>
        "two stops are called `{name}`; give this one a name of its own",
    StopNamedAsMass { name: String } =>
        "a mass is called `{name}`, and a stop cannot have the same name; give the stop a name of its own",
    StopNamedAsContact { name: String } =>
        "a contact is called `{name}`, and a stop cannot have the same name; give the stop a name of its own",
    StopToItself { name: String } =>
        "this stop joins `{name}` to itself and never acts; name two different sides, for example `{name} - wall`",
    StopWithoutMass {} =>
        "this stop lies between two supports; leave it out, or name a mass as one of its sides",
    StopStiffnessNotPositive { name: String, value: f64 } =>
        "the stiffness of the stop `{name}` is {value:?}: it must be greater than zero; write a positive number, or leave the stop out",
    RestitutionOutside { name: String, value: f64 } =>
        "the restitution of the stop `{name}` is {value:?}: it is the speed after an impact over the speed before it; write a number from 0 to 1",
    ParallelRigidStops { from: String, to: String } =>
        "there is already a stop with `restitution` on `{from} - {to}`, and only the stop with the smaller gap can act; leave one of the two out",
    ConstantTwice { name: String, sum: String } =>
        "there is already a constant force on the mass `{name}`; constant forces on one mass act as one, so add them and write a single force{sum}",
    Untouched { name: String } =>
        "neither a spring nor a dashpot nor a contact nor a stop touches the mass `{name}`; join it to another mass or to a support, or leave it out",
    IdleJoinedBase {} =>
        "the base moves, but no spring, dashpot, contact or stop joins a mass to it, so nothing is excited; join a mass to `base`, or put a force on a mass",
    LawOfEachContact { field: String, example: String } =>
        "with `contacts`, each contact has its own `{field}`; write it in braces after the sides of a contact, for example `m1 - wall {{ {field}: {example} }}`",
    StribeckAllElastic {} =>
        "`stribeck` acts on rigid contacts, but every contact of this scene has a `stiffness`; leave the `stiffness` of a contact out, or write `friction: coulomb`",
    NoTables { cause: String, fields: String } =>
        "tables are not possible with {cause}; leave {fields} out",
    StictionBelowOne { value: f64 } =>
        "the stiction μ is {value:?}, but static friction is never smaller than kinetic; write 1 or more",
    NothingProvided {} =>
        "an empty list provides nothing; write, for example, `[limits, motion]`",
    ProvidedTwice { item: String } =>
        "`{item}` is asked for twice; name it once",
    ChecksNothing {} =>
        "`self_check` compares the constants and answers of what a scene provides, and this list has nothing else; write, for example, `[limits, self_check]`",
    MotionOfNothing {} =>
        "`motion()` names no mass; write `motion` for all masses, or name some in the parentheses",
    AccuracyOutside { value: f64, finest: f64 } =>
        "an accuracy is a relative error from {finest:?} to 0.1, not {value:?}; write, for example, `accuracy: 1e-4`, or `exact`",
    AccuracyWithoutRange {} =>
        "an accuracy or a budget needs a range of frequency ratios; add, for example, `range: {{ r: 0.2..2.5 }}`",
    AccuracyAndBudget {} =>
        "`accuracy` and `budget` exclude each other: keep one of the two",
    BudgetOutside { value: f64 } =>
        "a budget must be a whole number of bytes, 1 or more, not {value:?}; write, for example, `budget: 4096`",
    WithoutAccuracy { field: String } =>
        "`{field}` has an effect only with an accuracy or a budget; add, for example, `accuracy: 1e-4`, or leave the field out",
    TooFineForProof { value: f64 } =>
        "β_lim can be proven to an accuracy of {FINEST_PROVEN:e} or coarser, not {value:e}; write `accuracy: {FINEST_PROVEN:e}`, or leave `proof` out, so that the finer table is checked but not proven",
    RangeOfRatio { low: f64, high: f64 } =>
        "a range a..b of frequency ratios needs 0 < a < b, both finite, not {low:?}..{high:?}; write, for example, `r: 0.2..2.5`",
    RangeOfFriction { low: f64, high: f64 } =>
        "a range a..b of friction ratios needs 0 ≤ a < b, not {low:?}..{high:?}; write, for example, `beta: 0..1.5`",
    WithoutStepper { field: String } =>
        "`{field}` belongs to the stepper: add `stepper` to `provide`, or leave the field out",
    StribeckWithoutMotion {} =>
        "`stribeck` works only in the stepper and the simulation, because the exact continuous response needs a constant kinetic level; write `provide: [simulation]`, or `friction: coulomb`",
    NeedsConstantLevel { item: String } =>
        "`{item}` is not possible with `stribeck`, because it needs a constant kinetic level; leave it out, or write `friction: coulomb`",
    OrbitNeedsAmplitude {} =>
        "`orbit` is not possible with `stribeck`, because emitted steady states take ratios without the amplitude of the load; leave it out, or use `frictiongen orbit`",
    NothingToTabulate { field: String } =>
        "`{field}` is for limits and motion, which are not provided; add `limits` to `provide`, or leave the field out",
    StribeckWithoutPoints {} =>
        "`stribeck()` has no point; write, for example, `stribeck(0.1: 0.8)` for 0.8·F from the speed 0.1 on, or `coulomb`",
    StribeckNotAscending { value: f64, before: f64 } =>
        "the speeds of `stribeck` must be above zero and ascending, but {value:?} follows {before:?}; write the points in ascending order, and none at zero speed, where the level is 1",
    StribeckNegative { value: f64 } =>
        "the kinetic level is {value:?}: negative friction would feed energy in; write zero or more",
    StribeckAboveStatic { value: f64, stiction: f64 } =>
        "the kinetic level {value:?} is above μ = {stiction:?}, but static friction is never smaller than kinetic; write at most μ",
    StepNotPositive { value: f64 } =>
        "the step is {value:?}: it must be greater than zero; write it in seconds, for example `step: 1e-3`",
    ForceOnExcitation { name: String } =>
        "the mass `{name}` is already loaded by the excitation; leave it out of `force`",
    ForceTwice { name: String } =>
        "`force` names `{name}` twice; name it once",
}
