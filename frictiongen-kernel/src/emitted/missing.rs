//! What is told of a method that a scene does not provide.
//!
//! Emitted code has a method of that name all the same, which asks for one of these traits.  Nothing implements
//! them, and the compiler says what to add to which field.

/// Of a scene that provides its `stepper` alone.
#[diagnostic::on_unimplemented(
    message = "this scene provides its stepper alone",
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
    ($type:ident: $($method:ident),*) => {
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
        impl $type {
            #[doc(hidden)]
            pub fn at<'a, T>(
                _: T,
            ) -> <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddLimitsToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::answer()
            }

            #[doc(hidden)]
            pub fn limits_without_search<'a, T>(
                _: T,
            ) -> <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddLimitsToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::answer()
            }

            #[doc(hidden)]
            pub fn limits_into<'a, T, U, V>(
                _: T,
                _: U,
                _: V,
            ) -> <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddLimitsToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddLimitsToProvide>::answer()
            }
        }
    };
    (@ $type:ident stepper) => {
        impl $type {
            #[doc(hidden)]
            pub fn stepper<'a, T>(
                _: T,
            ) -> <&'a Self as $crate::emitted::missing::AddStepperToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddStepperToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddStepperToProvide>::answer()
            }

            #[doc(hidden)]
            pub fn stepper_from<'a, T, U>(
                _: T,
                _: U,
            ) -> <&'a Self as $crate::emitted::missing::AddStepperToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddStepperToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddStepperToProvide>::answer()
            }
        }
    };
    (@ $type:ident simulation) => {
        impl $type {
            #[doc(hidden)]
            pub fn simulation<'a, T>(
                _: T,
                _: T,
            ) -> <&'a Self as $crate::emitted::missing::AddSimulationToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddSimulationToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddSimulationToProvide>::answer()
            }

            #[doc(hidden)]
            pub fn simulation_from<'a, T, U>(
                _: T,
                _: T,
                _: U,
            ) -> <&'a Self as $crate::emitted::missing::AddSimulationToProvide>::Answer
            where
                &'a Self: $crate::emitted::missing::AddSimulationToProvide,
            {
                <&'a Self as $crate::emitted::missing::AddSimulationToProvide>::answer()
            }
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
