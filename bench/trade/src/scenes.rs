//! The scenes: chains of 1, 2, 5 and 10 equal masses and springs with each contact, undamped and with ζ = 0.02 in every
//! mode, in both precisions.

/// Emits every scene four times: undamped and damped, in double and in single precision. Lists the scenes in a
/// function `visit`.
macro_rules! scenes {
    ($($orbit:ident struct $name:ident $masses:literal $watched:literal $body:tt $provide:tt)*) => {
        /// Undamped scenes.
        pub mod undamped {
            scenes!(@precisions [none]; $(struct $name $body $provide)*);
        }
        /// Scenes with ζ = 0.02 in every mode.
        pub mod damped {
            scenes!(@precisions [modal(0.02)]; $(struct $name $body $provide)*);
        }

        /// Passes every scene to `visitor`.
        pub fn visit(visitor: &mut impl Visitor) {
            $(
                scenes!(@each visitor, undamped, "none", 0.0, $orbit $name $masses $watched $body $provide);
                scenes!(@each visitor, damped, "modal(0.02)", 0.02, $orbit $name $masses $watched $body $provide);
            )*
        }
    };
    (@precisions $damping:tt; $(struct $name:ident $body:tt $provide:tt)*) => {
        /// Scenes in double precision.
        pub mod double {
            $(scenes!(@emit $name, f64, $damping, $body, $provide);)*
        }
        /// Scenes in single precision.
        pub mod single {
            $(scenes!(@emit $name, f32, $damping, $body, $provide);)*
        }
    };
    (@emit $name:ident, $scalar:ident, [$($damping:tt)*], { $($body:tt)* }, $provide:tt) => {
        ::frictiongen::friction_system! {
            /// One of the scenes.
            pub struct $name { $($body)* provide: $provide, damping: $($damping)*, scalar: $scalar, }
        }
    };
    (@each $visitor:ident, $damping:ident, $text:literal, $zeta:literal,
     $orbit:ident $name:ident $masses:literal $watched:literal { $($body:tt)* } $provide:tt) => {
        $visitor.scene(
            Label {
                name: stringify!($name),
                masses: $masses,
                watched: $watched,
                zeta: $zeta,
                text: concat!("struct ", stringify!($name), " { ", $(stringify!($body), " ",)*
                    "provide: ", stringify!($provide), ", damping: ", $text, " }"),
            },
            $damping::double::$name,
            $damping::single::$name,
            scenes!(@orbit $orbit $damping double $name),
            scenes!(@orbit $orbit $damping single $name),
        )
    };
    (@orbit orbit $damping:ident $precision:ident $name:ident) => {
        Some(|r, beta| Some($damping::$precision::$name::at(r).ok()?.orbit(beta).ok()?.contact().amplitude()))
    };
    (@orbit plain $damping:ident $precision:ident $name:ident) => {
        None
    };
}

/// Name and description of a scene that is measured.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// Name of the scene: the kind of its contact, and its number of masses.
    pub name: &'static str,
    /// Number of masses.
    pub masses: usize,
    /// Index of the observed mass, whose amplitude is measured.
    pub watched: usize,
    /// Damping ratio of every mode.
    pub zeta: f64,
    /// Description of the scene in double precision, in the scene language.
    pub text: &'static str,
}

/// Function from the point (r, β) to the amplitude |z̄| of the contact in the steady state. `None` if the scene has
/// no steady states with stops.
pub type Orbit<S> = Option<fn(S, S) -> Option<S>>;

/// An operation that is applied to every emitted scene. The scenes have different types, so that a list cannot
/// contain them.
pub trait Visitor {
    /// Receives one scene, in double and in single precision.
    fn scene<D, S>(
        &mut self,
        label: Label,
        double: D,
        single: S,
        orbit: Orbit<f64>,
        orbit_single: Orbit<f32>,
    ) where
        D: frictiongen::FrictionSystem<Scalar = f64> + 'static,
        S: frictiongen::FrictionSystem<Scalar = f32> + 'static,
        for<'a> D::At<'a>: frictiongen::MotionAt<Scalar = f64>,
        for<'a> S::At<'a>: frictiongen::MotionAt<Scalar = f32>;
}

chains!(scenes);
