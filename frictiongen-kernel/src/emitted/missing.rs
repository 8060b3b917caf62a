//! Compiler messages for a method that a scene does not provide.
//!
//! Emitted code has a method of that name all the same, which requires one of the traits below. No type implements
//! them. The compiler message therefore names what to add, and the field to add it to.

/// The methods that need `limits` require this trait, if the scene provides only its motion in time.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `limits`",
    label = "add `limits` to the scene's `provide: [...]`"
)]
pub trait AddLimitsToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The method `motion` requires this trait, if the scene does not list `motion` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `motion`",
    label = "add `motion` to the scene's `provide: [...]`"
)]
pub trait AddMotionToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The orbit methods require this trait, if the scene does not list `orbit` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `orbit`",
    label = "add `orbit` to the scene's `provide: [...]`"
)]
pub trait AddOrbitToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The simulation methods require this trait, if the scene does not list `simulation` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `simulation`",
    label = "add `simulation` to the scene's `provide: [...]`"
)]
pub trait AddSimulationToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The stepper methods require this trait, if the scene does not list `stepper` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stepper`",
    label = "add `stepper` to the scene's `provide: [...]`"
)]
pub trait AddStepperToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The method `stuck` requires this trait, if the scene does not list `stuck` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stuck`",
    label = "add `stuck` to the scene's `provide: [...]`"
)]
pub trait AddStuckToProvide {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// The method for the motion of a mass requires this trait, if the scene's `motion(…)` leaves out this mass.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide the motion of this mass",
    label = "add the mass to `motion(...)` in the scene's `provide: [...]`"
)]
pub trait AddMassToMotion {
    /// Never used.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

/// Writes methods of an emitted type that fail to compile when called. A method with a number as its argument requires
/// the trait of that number type, and the compiler then prints the trait's message. For the other methods the compiler
/// prints the trait's name.
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

/// Writes methods of an emitted motion for the masses that its scene leaves out. They fail to compile when called.
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
