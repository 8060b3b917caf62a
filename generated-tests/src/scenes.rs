//! Eight of the 38 scenes of `reference/closed_form.json`, emitted by the macro in both precisions. They have every
//! kind of contact, load and damping, one to eight masses, and springs to the wall.
//!
//! Each text is the reference's own `description` of the scene. A test compares the texts with the reference.

use frictiongen::{FrictionSystem, MotionAt, StuckAt};

/// A receiver of scenes: `visit` passes every scene to its method `see`.
pub trait Visitor {
    /// Receives a scene and its name, which includes the precision.
    fn see<F>(&mut self, name: &'static str, system: F)
    where
        F: FrictionSystem + 'static,
        for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar> + StuckAt<Scalar = F::Scalar>;
}

/// Numbers of the scenes in the reference, counted from 1.
pub const NUMBERS: [usize; 8] = [2, 4, 7, 10, 23, 30, 33, 34];

/// Emits every scene in both precisions, and lists the texts.
macro_rules! scenes {
    ($(struct $name:ident { $($body:tt)* })*) => {
        /// Scenes in double precision.
        pub mod double {
            $(::frictiongen::friction_system! {
                pub struct $name { $($body)* provide: [limits, motion, stuck], }
            })*
        }
        /// Scenes in single precision.
        pub mod single {
            $(::frictiongen::friction_system! {
                pub struct $name { $($body)* provide: [limits, motion, stuck], scalar: f32, }
            })*
        }
        /// Compares every emitted scene in double precision with its reference, in the order of [`NUMBERS`].
        pub fn compare_double(references: &[serde_json::Value]) -> Vec<crate::reference::Worst> {
            assert_eq!(references.len(), TEXTS.len());
            let mut references = references.iter();
            vec![$(crate::reference::compare(&double::$name, references.next().expect(stringify!($name)))),*]
        }
        /// Compares every emitted scene in single precision with its reference, in the order of [`NUMBERS`].
        pub fn compare_single(references: &[serde_json::Value]) -> Vec<crate::reference::Worst> {
            assert_eq!(references.len(), TEXTS.len());
            let mut references = references.iter();
            vec![$(crate::reference::compare(&single::$name, references.next().expect(stringify!($name)))),*]
        }
        /// Passes every scene to a visitor, in both precisions.
        pub fn visit(visitor: &mut impl Visitor) {
            $(visitor.see(concat!(stringify!($name), " in f64"), double::$name);
            visitor.see(concat!(stringify!($name), " in f32"), single::$name);)*
        }
        /// Texts of the scenes, as the macro received them.
        pub const TEXTS: &[&str] = &[$(stringify!(struct $name { $($body)* })),*];
    };
}

scenes! {
    struct Scene02 {
        masses: { m1: 1.0, m2: 0.145026, m3: 0.375388 },
        springs: { base - m1: 1.0, m1 - m2: 0.157074, m2 - m3: 0.105433 },
        contact: m2 - m3,
        excitation: base,
        damping: modal[0.06829, 0.003695, 0.004776],
        stiction: 1.2,
    }
    struct Scene04 {
        masses: { m1: 1.0, m2: 4.07705, m3: 1.4159, m4: 3.40136 },
        springs: { base - m1: 1.0, m1 - m2: 4.32777, m2 - m3: 8.42268, m3 - m4: 1.11284 },
        contact: m1 - base,
        excitation: base,
        stiction: 2.0,
    }
    struct Scene07 {
        masses: { m1: 1.0, m2: 6.98138, m3: 0.232326, m4: 0.710482, m5: 2.85725, m6: 7.59059, m7: 1.98197, m8: 6.40512 },
        springs: { base - m1: 1.0, m1 - m2: 0.549867, m2 - m3: 0.245004, m3 - m4: 5.16743, m4 - m5: 0.196208, m5 - m6: 6.80709, m6 - m7: 0.152875, m7 - m8: 0.798842 },
        contact: m2 - m5,
        excitation: m4,
        damping: modal[0.004668, 0.04752, 0.1072, 0.3821, 0.06381, 0.05195, 0.002617, 0.007019],
        stiction: 2.0,
    }
    struct Scene10 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - base,
        excitation: base,
    }
    struct Scene23 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: m1,
        damping: modal[0.3802],
        stiction: 1.5,
    }
    struct Scene30 {
        masses: { m1: 1.0, m2: 0.471709, m3: 2.28218, m4: 7.01113, m5: 6.56272 },
        springs: { base - m1: 1.0, m1 - m2: 4.95123, m2 - m3: 8.04369, m3 - m4: 2.164, m4 - m5: 1.23829 },
        contact: m2 - m4,
        excitation: m3,
        stiction: 1.2,
    }
    struct Scene33 {
        masses: { m1: 1.0, m2: 1.8382, m3: 4.69902 },
        springs: { base - m1: 1.0, m1 - m2: 0.237105, m2 - m3: 0.555802, m3 - wall: 0.217023, m1 - m3: 1.285, base - m2: 0.527209 },
        contact: m1 - wall,
        excitation: base,
        damping: rayleigh(0.04554, 0.04244),
        stiction: 1.3,
    }
    struct Scene34 {
        masses: { m1: 1.0, m2: 0.786919, m3: 2.19896, m4: 1.13685, m5: 3.40795 },
        springs: { base - m1: 1.0, m1 - m2: 1.64879, m2 - m3: 0.563143, m3 - m4: 0.312131, m4 - m5: 0.246616, m1 - wall: 2.03401, m1 - m5: 1.79837 },
        contact: m4 - wall,
        excitation: m2,
    }
}
