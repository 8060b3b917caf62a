//! What is told of a method that a scene does not provide.
//!
//! Emitted code has a method of that name all the same, which asks for one of these traits.  Nothing implements
//! them, and the compiler says what to add to which field.

/// Of a scene without `motion` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `motion`",
    label = "add `motion` to the scene's `provide: [...]`"
)]
pub trait AddMotionToProvide {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// Of a scene without `orbit` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `orbit`",
    label = "add `orbit` to the scene's `provide: [...]`"
)]
pub trait AddOrbitToProvide {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// Of a scene without `simulation` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `simulation`",
    label = "add `simulation` to the scene's `provide: [...]`"
)]
pub trait AddSimulationToProvide {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// Of a scene without `stuck` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stuck`",
    label = "add `stuck` to the scene's `provide: [...]`"
)]
pub trait AddStuckToProvide {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// Of a scene whose `motion(…)` leaves a mass out.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide the motion of this mass",
    label = "add the mass to `motion(...)` in the scene's `provide: [...]`"
)]
pub trait AddMassToMotion {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}
