//! The wedges of `reference/several_states.json`, emitted by the macro in double precision.
//!
//! A wedge is the range of friction ratios between β*_lim and β_lim. Each text is the reference's own `description`
//! of the scene. A test compares the texts with the reference.

/// Emits every scene, and lists them.
macro_rules! scenes {
    ($(struct $name:ident { $($body:tt)* })*) => {
        $(::frictiongen::friction_system! {
            pub struct $name { $($body)* provide: [limits, motion, stuck], }
        })*
        /// Compares every emitted scene with its reference.
        pub fn compare(references: &[serde_json::Value]) -> Vec<crate::reference::Worst> {
            assert_eq!(references.len(), TEXTS.len());
            let mut references = references.iter();
            vec![$(crate::reference::compare_wedge(&$name, references.next().expect(stringify!($name)))),*]
        }
        /// Texts of the scenes, as the macro received them.
        pub const TEXTS: &[&str] = &[$(stringify!(struct $name { $($body)* })),*];
    };
}

scenes! {
    struct Wedge01 {
        masses: { m1: 1.0, m2: 2.97396 },
        springs: { base - m1: 1.0, m1 - m2: 0.654111 },
        contact: m1 - wall,
        excitation: base,
        damping: modal[0.104, 0.0306],
        stiction: 3.0,
    }
    struct Wedge02 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: m1,
        damping: modal[0.0828],
        stiction: 2.0,
    }
    struct Wedge03 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - base,
        excitation: base,
        damping: modal[0.127],
        stiction: 2.0,
    }
    struct Wedge04 {
        masses: { m1: 1.0, m2: 1.40086 },
        springs: { base - m1: 1.0, m1 - m2: 0.820864 },
        contact: m2 - m1,
        excitation: m2,
        damping: modal[0.0172, 0.0766],
        stiction: 2.0,
    }
    struct Wedge05 {
        masses: { m1: 1.0, m2: 2.07506 },
        springs: { base - m1: 1.0, m1 - m2: 3.994 },
        contact: m2 - wall,
        excitation: base,
        damping: modal[0.0315, 0.0324],
        stiction: 3.0,
    }
    struct Wedge06 {
        masses: { m1: 1.0, m2: 1.16045 },
        springs: { base - m1: 1.0, m1 - m2: 2.61996 },
        contact: m2 - m1,
        excitation: base,
        damping: modal[0.0577, 0.0312],
        stiction: 1.5,
    }
    struct Wedge07 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: base,
        damping: modal[0.0192],
        stiction: 2.0,
    }
    struct Wedge08 {
        masses: { m1: 1.0, m2: 2.7926 },
        springs: { base - m1: 1.0, m1 - m2: 1.34671 },
        contact: m1 - wall,
        excitation: base,
        damping: modal[0.159, 0.0807],
        stiction: 3.0,
    }
    struct Wedge09 {
        masses: { m1: 1.0, m2: 1.52229 },
        springs: { base - m1: 1.0, m1 - m2: 0.23159 },
        contact: m1 - base,
        excitation: base,
        damping: modal[0.0255, 0.122],
        stiction: 3.0,
    }
    struct Wedge10 {
        masses: { m1: 1.0 },
        springs: { base - m1: 1.0 },
        contact: m1 - wall,
        excitation: base,
        damping: modal[0.0176],
        stiction: 3.0,
    }
    struct Wedge11 {
        masses: { m1: 1.0, m2: 0.330138, m3: 0.10339, m4: 0.180329 },
        springs: { base - m1: 1.0, m1 - m2: 7.84394, m2 - m3: 8.68915, m3 - m4: 0.528821 },
        contact: m4 - m3,
        excitation: base,
        damping: modal[0.186, 0.0186, 0.0148, 0.0602],
        stiction: 2.0,
    }
    struct Wedge12 {
        masses: { m1: 1.0, m2: 0.627185, m3: 1.20076, m4: 0.733349 },
        springs: { base - m1: 1.0, m1 - m2: 0.800563, m2 - m3: 0.404368, m3 - m4: 2.11452 },
        contact: m3 - wall,
        excitation: base,
        damping: modal[0.0187, 0.0247, 0.0113, 0.0321],
        stiction: 3.0,
    }
    struct Wedge13 {
        masses: { m1: 1.0, m2: 1.04177 },
        springs: { base - m1: 1.0, m1 - m2: 1.72754 },
        contact: m1 - wall,
        excitation: base,
        damping: modal[0.112, 0.0153],
        stiction: 3.0,
    }
    struct Wedge14 {
        masses: { m1: 1.0, m2: 0.365861 },
        springs: { base - m1: 1.0, m1 - m2: 2.51808 },
        contact: m2 - m1,
        excitation: m1,
        damping: modal[0.0337, 0.0511],
        stiction: 1.5,
    }
}
