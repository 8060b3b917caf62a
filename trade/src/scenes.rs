//! The scenes: chains of 1, 2, 5 and 10 equal masses and springs, each contact, undamped and with
//! ζ = 0.02 in every mode, in both precisions.

/// Emits every scene four times and lists them.
macro_rules! scenes {
    ($($orbit:ident struct $name:ident $masses:literal $watched:literal $body:tt $provide:tt)*) => {
        /// Undamped.
        pub mod undamped {
            scenes!(@precisions [none]; $(struct $name $body $provide)*);
        }
        /// ζ = 0.02 in every mode.
        pub mod damped {
            scenes!(@precisions [modal(0.02)]; $(struct $name $body $provide)*);
        }

        /// Hands every scene to `visitor`.
        pub fn visit(visitor: &mut impl Visitor) {
            $(
                scenes!(@each visitor, undamped, "none", 0.0, $orbit $name $masses $watched $body $provide);
                scenes!(@each visitor, damped, "modal(0.02)", 0.02, $orbit $name $masses $watched $body $provide);
            )*
        }
    };
    (@precisions $damping:tt; $(struct $name:ident $body:tt $provide:tt)*) => {
        /// In double precision.
        pub mod double {
            $(scenes!(@emit $name, f64, $damping, $body, $provide);)*
        }
        /// In single precision.
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

/// What a scene is called, and its text.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// Contact and number of masses.
    pub name: &'static str,
    /// How many masses.
    pub masses: usize,
    /// The mass whose motion is asked for, by its place.
    pub watched: usize,
    /// The damping ratio of every mode.
    pub zeta: f64,
    /// The description, in double precision.
    pub text: &'static str,
}

/// The steady state's amplitude in the contact, if the scene provides one: (r, β) to |z̄|.
pub type Orbit<S> = Option<fn(S, S) -> Option<S>>;

/// Takes the emitted scenes, whose types differ, one by one.
pub trait Visitor {
    /// One scene, in double and in single precision.
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
