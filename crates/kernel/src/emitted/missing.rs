//! Traits for methods that a scene does not provide. If a user calls a method that the scene does not provide, the
//! compiler's message says what to add to the scene.
//!
//! Emitted code contains a method even if the scene does not provide it, but the method then requires a trait of this
//! module. Because no type implements the trait, a call does not compile. The compiler's message names the text to add,
//! and the field of the scene that needs the text.

/// Trait that no type implements. Methods that need `limits` require this trait if the scene provides only its motion
/// in time. A call then does not compile, and the message says what to add to the scene.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `limits`",
    label = "add `limits` to the scene's `provide: [...]`"
)]
pub trait AddLimitsToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The method `motion` requires this trait if the scene does not list `motion` under
/// `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `motion`",
    label = "add `motion` to the scene's `provide: [...]`"
)]
pub trait AddMotionToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The orbit methods require this trait if the scene does not list `orbit` under
/// `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `orbit`",
    label = "add `orbit` to the scene's `provide: [...]`"
)]
pub trait AddOrbitToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The method `self_check` requires this trait if the scene does not list `self_check`
/// under `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `self_check`",
    label = "add `self_check` to the scene's `provide: [...]`"
)]
pub trait AddSelfCheckToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The simulation methods require this trait if the scene does not list `simulation`
/// under `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `simulation`",
    label = "add `simulation` to the scene's `provide: [...]`"
)]
pub trait AddSimulationToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The stepper methods require this trait if the scene does not list `stepper` under
/// `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stepper`",
    label = "add `stepper` to the scene's `provide: [...]`"
)]
pub trait AddStepperToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The method `stuck` requires this trait if the scene does not list `stuck` under
/// `provide`. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stuck`",
    label = "add `stuck` to the scene's `provide: [...]`"
)]
pub trait AddStuckToProvide {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Trait that no type implements. The method for the motion of a mass requires this trait if the scene's `motion(…)`
/// leaves out this mass. A call then does not compile, and the message says what to add.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide the motion of this mass",
    label = "add the mass to `motion(...)` in the scene's `provide: [...]`"
)]
pub trait AddMassToMotion {
    /// Result type of a method that requires this trait. No type implements the trait, so the type is never used.
    type Answer;
    /// Stands for the body of a method that requires this trait. The function is never called, because no type
    /// implements the trait.
    fn answer() -> Self::Answer;
}

/// Writes a placeholder for each method that a scene does not provide. A call to a placeholder does not compile,
/// because the placeholder requires a trait of this module that no type implements. If the method has a number as its
/// argument, the compiler prints the message of the trait. For other methods the compiler prints only the name of the
/// trait.
#[doc(hidden)]
#[macro_export]
macro_rules! not_provided {
    ($($type:ident: $($method:ident),*);*) => {
        $($crate::not_provided!(@ $type: $($method),*);)*
    };
    (@ $type:ident: $($method:ident),*) => {
        $($crate::not_provided!(@ $type $method);)*
    };
    (@ $type:ident motion) => {
        impl $type {
            #[doc(hidden)]
            pub fn motion<T: $crate::emitted::missing::AddMotionToProvide>(&self, _: T) -> T::Answer {
                T::answer()
            }
        }
    };
    (@ $type:ident orbit) => {
        impl $type {
            #[doc(hidden)]
            pub fn orbit<T: $crate::emitted::missing::AddOrbitToProvide>(&self, _: T) -> T::Answer {
                T::answer()
            }

            #[doc(hidden)]
            pub fn orbit_or_last_cycles<T: $crate::emitted::missing::AddOrbitToProvide>(
                &self,
                _: T,
            ) -> T::Answer {
                T::answer()
            }

            #[doc(hidden)]
            pub fn orbit_from<T: $crate::emitted::missing::AddOrbitToProvide, U>(
                &self,
                _: T,
                _: U,
            ) -> T::Answer {
                T::answer()
            }
        }
    };
    (@ $type:ident stuck) => {
        impl $type {
            #[doc(hidden)]
            pub fn stuck<'a>(&'a self) -> <&'a Self as $crate::emitted::missing::AddStuckToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddStuckToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddStuckToProvide>::answer()
            }
        }
    };
    (@ $type:ident limits) => {
        $crate::not_provided!(
            @ $type of AddLimitsToProvide: at(T), limits_without_search(T), limits_into(T, U, V)
        );
    };
    (@ $type:ident self_check) => {
        $crate::not_provided!(@ $type of AddSelfCheckToProvide: self_check());
    };
    (@ $type:ident stepper) => {
        $crate::not_provided!(@ $type of AddStepperToProvide: stepper(T), stepper_from(T, U));
    };
    (@ $type:ident simulation) => {
        $crate::not_provided!(
            @ $type of AddSimulationToProvide: simulation(T, U), simulation_from(T, U, V)
        );
    };
    (@ $type:ident of $missing:ident: $($function:ident($($argument:ident),*)),*) => {
        impl $type {
            $(
                #[doc(hidden)]
                pub fn $function<'a, $($argument),*>(
                    $(_: $argument),*
                ) -> <&'a Self as $crate::emitted::missing::$missing>::Answer
                where
                    &'a Self: $crate::emitted::missing::$missing,
                {
                    <&'a Self as $crate::emitted::missing::$missing>::answer()
                }
            )*
        }
    };
}

/// Writes a placeholder for the method of each mass whose motion the scene leaves out. A call to a placeholder does not
/// compile, and the compiler message says what to add to the scene.
#[doc(hidden)]
#[macro_export]
macro_rules! left_out {
    ($type:ident: $($mass:ident),*) => {
        impl $type {
            $(#[doc(hidden)]
            pub fn $mass<'a>(&'a self) -> <&'a Self as $crate::emitted::missing::AddMassToMotion>::Answer
            where
                &'a Self: $crate::emitted::missing::AddMassToMotion,
            {
                <&'a Self as $crate::emitted::missing::AddMassToMotion>::answer()
            })*
        }
    };
}
