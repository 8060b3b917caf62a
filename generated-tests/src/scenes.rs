//! The scenes of `reference/closed_form.json`, emitted by the macro in both precisions.
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
        /// Compares every emitted scene in double precision with its reference.
        pub fn compare_double(references: &[serde_json::Value]) -> Vec<crate::reference::Worst> {
            assert_eq!(references.len(), TEXTS.len());
            let mut references = references.iter();
            vec![$(crate::reference::compare(&double::$name, references.next().expect(stringify!($name)))),*]
        }
        /// Compares every emitted scene in single precision with its reference.
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
    struct Scene01 {
        masses: { m1: 1.0, m2: 1.96968 },
        springs: { base - m1: 1.0, m1 - m2: 8.05195 },
        contact: m1 - wall,
        excitation: m2,
        stiction: 2.0,
    }
    struct Scene02 {
        masses: { m1: 1.0, m2: 0.145026, m3: 0.375388 },
        springs: { base - m1: 1.0, m1 - m2: 0.157074, m2 - m3: 0.105433 },
        contact: m2 - m3,
        excitation: base,
        damping: modal[0.06829, 0.003695, 0.004776],
        stiction: 1.2,
    }
    struct Scene03 {
        masses: { m1: 1.0, m2: 1.1916, m3: 0.376014, m4: 0.191327, m5: 1.94801 },
        springs: { base - m1: 1.0, m1 - m2: 2.70914, m2 - m3: 0.414952, m3 - m4: 4.96122, m4 - m5: 0.546625 },
        contact: m4 - wall,
        excitation: m4,
        damping: modal[0.001757, 0.2545, 0.03141, 0.2195, 0.01408],
        stiction: 2.0,
    }
    struct Scene04 {
        masses: { m1: 1.0, m2: 4.07705, m3: 1.4159, m4: 3.40136 },
        springs: { base - m1: 1.0, m1 - m2: 4.32777, m2 - m3: 8.42268, m3 - m4: 1.11284 },
        contact: m1 - base,
        excitation: base,
        stiction: 2.0,
    }
    struct Scene05 {
        masses: { m1: 1.0, m2: 0.868584, m3: 7.22652, m4: 9.42869, m5: 1.23386 },
        springs: { base - m1: 1.0, m1 - m2: 1.31702, m2 - m3: 2.18528, m3 - m4: 0.412339, m4 - m5: 3.97744 },
        contact: m5 - wall,
        excitation: m4,
        damping: modal[0.149, 0.01217, 0.003522, 0.1762, 0.001059],
    }
    struct Scene06 {
        masses: { m1: 1.0, m2: 0.3313, m3: 0.935704 },
        springs: { base - m1: 1.0, m1 - m2: 1.05326, m2 - m3: 4.49104 },
        contact: m1 - m2,
        excitation: m2,
        stiction: 1.2,
    }
    struct Scene07 {
        masses: { m1: 1.0, m2: 6.98138, m3: 0.232326, m4: 0.710482, m5: 2.85725, m6: 7.59059, m7: 1.98197, m8: 6.40512 },
        springs: { base - m1: 1.0, m1 - m2: 0.549867, m2 - m3: 0.245004, m3 - m4: 5.16743, m4 - m5: 0.196208, m5 - m6: 6.80709, m6 - m7: 0.152875, m7 - m8: 0.798842 },
        contact: m2 - m5,
        excitation: m4,
        damping: modal[0.004668, 0.04752, 0.1072, 0.3821, 0.06381, 0.05195, 0.002617, 0.007019],
        stiction: 2.0,
    }
    struct Scene08 {
        masses: { m1: 1.0, m2: 0.883013, m3: 0.182992, m4: 1.57135, m5: 2.42713 },
        springs: { base - m1: 1.0, m1 - m2: 0.381382, m2 - m3: 0.684791, m3 - m4: 0.209047, m4 - m5: 0.186506 },
        contact: m3 - m5,
        excitation: base,
        stiction: 2.0,
    }
    struct Scene09 {
        masses: { m1: 1.0, m2: 0.600753, m3: 0.140238 },
        springs: { base - m1: 1.0, m1 - m2: 4.65157, m2 - m3: 1.9613 },
        contact: m1 - wall,
        excitation: base,
    }
    struct Scene10 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - base,
        excitation: base,
    }
    struct Scene11 {
        masses: { m1: 1.0, m2: 0.137726, m3: 0.628513, m4: 0.24603 },
        springs: { base - m1: 1.0, m1 - m2: 6.96484, m2 - m3: 0.123161, m3 - m4: 1.22895 },
        contact: m1 - base,
        excitation: base,
        stiction: 1.5,
    }
    struct Scene12 {
        masses: { m1: 1.0, m2: 5.82549, m3: 6.15505, m4: 0.188557, m5: 2.1011 },
        springs: { base - m1: 1.0, m1 - m2: 0.235511, m2 - m3: 0.351248, m3 - m4: 1.16418, m4 - m5: 5.44618 },
        contact: m4 - wall,
        excitation: m3,
        damping: modal[0.003202, 0.002963, 0.01789, 0.4988, 0.1587],
        stiction: 1.2,
    }
    struct Scene13 {
        masses: { m1: 1.0, m2: 4.28849, m3: 4.96295, m4: 0.290181 },
        springs: { base - m1: 1.0, m1 - m2: 8.07882, m2 - m3: 5.71797, m3 - m4: 1.95595 },
        contact: m4 - wall,
        excitation: m2,
    }
    struct Scene14 {
        masses: { m1: 1.0, m2: 1.74409, m3: 0.363869, m4: 3.18048, m5: 2.89695, m6: 1.37934, m7: 1.33556, m8: 2.19086 },
        springs: { base - m1: 1.0, m1 - m2: 0.184177, m2 - m3: 3.65663, m3 - m4: 0.155906, m4 - m5: 0.744913, m5 - m6: 0.162956, m6 - m7: 0.132085, m7 - m8: 0.51583 },
        contact: m3 - m6,
        excitation: m2,
        damping: modal[0.02333, 0.005589, 0.1824, 0.006107, 0.00707, 0.005062, 0.001478, 0.01293],
        stiction: 1.2,
    }
    struct Scene15 {
        masses: { m1: 1.0, m2: 1.32543 },
        springs: { base - m1: 1.0, m1 - m2: 9.46584 },
        contact: m2 - wall,
        excitation: base,
        damping: modal[0.007086, 0.01703],
        stiction: 2.0,
    }
    struct Scene16 {
        masses: { m1: 1.0, m2: 5.71224, m3: 2.36008 },
        springs: { base - m1: 1.0, m1 - m2: 5.27961, m2 - m3: 2.30572 },
        contact: m2 - m3,
        excitation: m2,
        stiction: 1.2,
    }
    struct Scene17 {
        masses: { m1: 1.0, m2: 8.25218, m3: 3.9782, m4: 0.175643, m5: 3.43389 },
        springs: { base - m1: 1.0, m1 - m2: 0.434275, m2 - m3: 6.39618, m3 - m4: 1.21427, m4 - m5: 0.484136 },
        contact: m5 - base,
        excitation: base,
        damping: modal[0.001418, 0.4923, 0.00274, 0.002144, 0.001261],
        stiction: 2.0,
    }
    struct Scene18 {
        masses: { m1: 1.0, m2: 0.677012, m3: 0.568021 },
        springs: { base - m1: 1.0, m1 - m2: 3.57436, m2 - m3: 2.11439 },
        contact: m1 - wall,
        excitation: m1,
        damping: modal[0.02923, 0.06113, 0.3339],
        stiction: 2.0,
    }
    struct Scene19 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: m1,
        stiction: 1.2,
    }
    struct Scene20 {
        masses: { m1: 1.0, m2: 8.3678, m3: 1.06683, m4: 0.339192 },
        springs: { base - m1: 1.0, m1 - m2: 1.84507, m2 - m3: 3.22897, m3 - m4: 0.431515 },
        contact: m1 - wall,
        excitation: base,
    }
    struct Scene21 {
        masses: { m1: 1.0, m2: 0.524641, m3: 3.80476, m4: 1.32795, m5: 0.356061 },
        springs: { base - m1: 1.0, m1 - m2: 5.27747, m2 - m3: 0.561634, m3 - m4: 0.828964, m4 - m5: 0.822471 },
        contact: m4 - wall,
        excitation: m5,
        stiction: 1.2,
    }
    struct Scene22 {
        masses: { m1: 1.0, m2: 3.89702 },
        springs: { base - m1: 1.0, m1 - m2: 1.89772 },
        contact: m1 - wall,
        excitation: m2,
        stiction: 1.2,
    }
    struct Scene23 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: m1,
        damping: modal[0.3802],
        stiction: 1.5,
    }
    struct Scene24 {
        masses: { m1: 1.0, m2: 0.192214 },
        springs: { base - m1: 1.0, m1 - m2: 0.600376 },
        contact: m1 - m2,
        excitation: m1,
        damping: modal[0.0979, 0.06139],
    }
    struct Scene25 {
        masses: { m1: 1.0, m2: 3.11893 },
        springs: { base - m1: 1.0, m1 - m2: 0.104447 },
        contact: m2 - base,
        excitation: base,
        damping: modal[0.3435, 0.009126],
        stiction: 2.0,
    }
    struct Scene26 {
        masses: { m1: 1.0, m2: 0.171157 },
        springs: { base - m1: 1.0, m1 - m2: 2.16474 },
        contact: m1 - m2,
        excitation: base,
        damping: modal[0.001485, 0.006564],
        stiction: 2.0,
    }
    struct Scene27 {
        masses: { m1: 1.0, m2: 2.83954, m3: 0.578625 },
        springs: { base - m1: 1.0, m1 - m2: 1.7136, m2 - m3: 1.97284 },
        contact: m2 - base,
        excitation: base,
        stiction: 1.5,
    }
    struct Scene28 {
        masses: { m1: 1.0, m2: 0.490047, m3: 0.137426, m4: 8.93117, m5: 4.13845 },
        springs: { base - m1: 1.0, m1 - m2: 3.59685, m2 - m3: 0.339319, m3 - m4: 2.10968, m4 - m5: 0.217112 },
        contact: m4 - base,
        excitation: base,
        stiction: 2.0,
    }
    struct Scene29 {
        masses: { m1: 1.0, m2: 0.225677, m3: 4.09973, m4: 0.27564, m5: 2.38958, m6: 0.497844, m7: 3.75291, m8: 0.659781 },
        springs: { base - m1: 1.0, m1 - m2: 4.04091, m2 - m3: 0.579769, m3 - m4: 0.20359, m4 - m5: 3.06238, m5 - m6: 2.05912, m6 - m7: 0.179957, m7 - m8: 0.342971 },
        contact: m2 - m3,
        excitation: m5,
        damping: modal[0.1867, 0.01585, 0.002469, 0.04927, 0.004291, 0.4218, 0.03277, 0.002151],
        stiction: 1.2,
    }
    struct Scene30 {
        masses: { m1: 1.0, m2: 0.471709, m3: 2.28218, m4: 7.01113, m5: 6.56272 },
        springs: { base - m1: 1.0, m1 - m2: 4.95123, m2 - m3: 8.04369, m3 - m4: 2.164, m4 - m5: 1.23829 },
        contact: m2 - m4,
        excitation: m3,
        stiction: 1.2,
    }
    struct Scene31 {
        masses: { m1: 1.0, m2: 0.582257, m3: 4.89374, m4: 3.65433, m5: 0.691642 },
        springs: { base - m1: 1.0, m1 - m2: 3.58903, m2 - m3: 0.497555, m3 - m4: 0.486968, m4 - m5: 3.10992, m5 - wall: 0.205617, m1 - m5: 0.445348 },
        contact: m2 - wall,
        excitation: base,
        stiction: 1.3,
    }
    struct Scene32 {
        masses: { m1: 1.0, m2: 0.293593 },
        springs: { base - m1: 1.0, m1 - m2: 1.32696, m2 - wall: 3.26324 },
        contact: m2 - wall,
        excitation: base,
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
    struct Scene35 {
        masses: { m1: 1.0, m2: 0.406306, m3: 0.643392 },
        springs: { base - m1: 1.0, m1 - m2: 0.878034, m2 - m3: 2.04573, m2 - wall: 0.260729, m1 - m3: 1.72168 },
        contact: m2 - m3,
        excitation: base,
        stiction: 1.3,
    }
    struct Scene36 {
        masses: { m1: 1.0, m2: 0.398147 },
        springs: { base - m1: 1.0, m1 - m2: 0.338808, m1 - wall: 0.412824, base - m2: 0.245534 },
        contact: m2 - wall,
        excitation: m1,
        damping: rayleigh(0.003723, 0.1703),
    }
    struct Scene37 {
        masses: { m1: 1.0, m2: 1.18461, m3: 0.992992 },
        springs: { base - m1: 1.0, m1 - m2: 4.55996, m2 - m3: 3.55802, m2 - wall: 0.219675, m1 - m3: 1.3345 },
        contact: m1 - m3,
        excitation: base,
        damping: rayleigh(0.2702, 1.489),
    }
    struct Scene38 {
        masses: { m1: 1.0, m2: 3.89677, m3: 3.70404, m4: 0.538117, m5: 0.325432 },
        springs: { base - m1: 1.0, m1 - m2: 3.12973, m2 - m3: 1.43467, m3 - m4: 2.89284, m4 - m5: 3.28471, m3 - wall: 1.48044, m1 - m5: 0.764305, base - m5: 1.85432 },
        contact: m4 - wall,
        excitation: base,
        damping: rayleigh(0.003825, 0.004001),
        stiction: 1.3,
    }
}
