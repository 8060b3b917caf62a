//! What is told of a method that a scene does not provide.
//!
//! Emitted code has a method of that name all the same, which asks for one of these traits.  Nothing implements
//! them, and the compiler says what to add to which field.

/// Of a scene that provides its motion in time alone.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `limits`",
    label = "add `limits` to the scene's `provide: [...]`"
)]
pub trait AddLimitsToProvide {
    /// Nothing.
    type Answer;
    /// Never called.
    fn answer() -> Self::Answer;
}

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

/// Of a scene without `stepper` under `provide`.
#[diagnostic::on_unimplemented(
    message = "this scene does not provide `stepper`",
    label = "add `stepper` to the scene's `provide: [...]`"
)]
pub trait AddStepperToProvide {
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

/// Methods of an emitted type that cannot be called.  A method of a number asks for the trait of the number: the
/// compiler then tells what the trait says.  Of the others it tells the trait's name.
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

/// Methods of an emitted motion for the masses that its scene leaves out.
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
