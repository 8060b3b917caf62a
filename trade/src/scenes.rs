//! The scenes: chains of 1, 2, 5 and 10 equal masses and springs, each contact, undamped and with
//! ζ = 0.02 in every mode, in both precisions.
//!
//! Equal masses and springs, because one of the peers, `peers/stepper.c`, knows no others.  The
//! last mass that is named in `provide` is the one that is looked at.

/// Emits every scene four times and lists them.
macro_rules! scenes {
    ($($orbit:ident struct $name:ident $masses:literal $watched:literal $body:tt)*) => {
        /// Undamped.
        pub mod undamped {
            scenes!(@precisions [none]; $(struct $name $body)*);
        }
        /// ζ = 0.02 in every mode.
        pub mod damped {
            scenes!(@precisions [modal(0.02)]; $(struct $name $body)*);
        }

        /// Hands every scene to `visitor`.
        pub fn visit(visitor: &mut impl Visitor) {
            $(
                scenes!(@each visitor, undamped, "none", 0.0, $orbit $name $masses $watched $body);
                scenes!(@each visitor, damped, "modal(0.02)", 0.02, $orbit $name $masses $watched $body);
            )*
        }
    };
    (@precisions $damping:tt; $(struct $name:ident $body:tt)*) => {
        /// In double precision.
        pub mod double {
            $(scenes!(@emit $name, f64, $damping, $body);)*
        }
        /// In single precision.
        pub mod single {
            $(scenes!(@emit $name, f32, $damping, $body);)*
        }
    };
    (@emit $name:ident, $scalar:ident, [$($damping:tt)*], { $($body:tt)* }) => {
        ::frictiongen::friction_system! {
            /// One of the scenes.
            pub struct $name { $($body)* damping: $($damping)*, scalar: $scalar, }
        }
    };
    (@each $visitor:ident, $damping:ident, $text:literal, $zeta:literal,
     $orbit:ident $name:ident $masses:literal $watched:literal { $($body:tt)* }) => {
        $visitor.scene(
            Label {
                name: stringify!($name),
                masses: $masses,
                watched: $watched,
                zeta: $zeta,
                text: concat!("struct ", stringify!($name), " { ", $(stringify!($body), " ",)*
                    "damping: ", $text, " }"),
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

scenes! {
    orbit struct Wall1 1 0 {
        masses: { m1: 1 },
        springs: { base - m1: 1 },
        contact: m1 - wall,
        excitation: m1,
        provide: [limits, motion(m1), orbit],
    }
    orbit struct Base1 1 0 {
        masses: { m1: 1 },
        springs: { base - m1: 1 },
        contact: m1 - base,
        excitation: base,
        provide: [limits, motion(m1), orbit],
    }
    orbit struct Wall2 2 0 {
        masses: { m1: 1, m2: 1 },
        springs: { base - m1: 1, m1 - m2: 1 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, motion(m1), orbit],
    }
    plain struct Base2 2 1 {
        masses: { m1: 1, m2: 1 },
        springs: { base - m1: 1, m1 - m2: 1 },
        contact: m1 - base,
        excitation: base,
        provide: [limits, motion(m2)],
    }
    plain struct Pair2 2 1 {
        masses: { m1: 1, m2: 1 },
        springs: { base - m1: 1, m1 - m2: 1 },
        contact: m1 - m2,
        excitation: m2,
        provide: [limits, motion(m2)],
    }
    orbit struct Wall5 5 0 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
        contact: m5 - wall,
        excitation: m1,
        provide: [limits, motion(m1), orbit],
    }
    plain struct Base5 5 4 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
        contact: m1 - base,
        excitation: base,
        provide: [limits, motion(m5)],
    }
    plain struct Pair5 5 4 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
        contact: m1 - m2,
        excitation: m5,
        provide: [limits, motion(m5)],
    }
    plain struct Wall10 10 0 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
            m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
        contact: m10 - wall,
        excitation: m1,
        provide: [limits, motion(m1)],
    }
    plain struct Base10 10 9 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
            m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
        contact: m1 - base,
        excitation: base,
        provide: [limits, motion(m10)],
    }
    plain struct Pair10 10 9 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
            m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
        contact: m1 - m2,
        excitation: m10,
        provide: [limits, motion(m10)],
    }
}
