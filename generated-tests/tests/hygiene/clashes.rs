//! Scenes in modules with items whose names clash with emitted names.
#![deny(warnings)]
#![no_std]

/// Constants with the names of local variables in emitted code. The emitted code must not refer to these constants.
pub mod values {
    #![allow(non_upper_case_globals, dead_code)]

    macro_rules! constants {
        ($($name:ident)*) => { $(pub const $name: u8 = 0;)* };
    }
    constants! {
        r inverse_r contact modes scale mode response beta friction others fundamental
        amplitude phase limit constraint index stuck mode_1 mode_2 rs
        continuous sliding load of question omega at u g v x
        excitation in_phase lag unscale waves velocity_share ratio product sum state run orbit
    }

    friction::friction_system! {
        /// A scene that is emitted as straight-line code.
        pub struct Frame {
            crate: ::friction,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }

    friction::friction_system! {
        /// A scene that is emitted as loops over the modes ("passes").
        pub struct Five {
            crate: ::friction,
            masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
            springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
            contact: b - d,
            excitation: c,
            damping: modal(0.01),
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

/// Statics and unit structs with the names of local variables in emitted code, which must not refer to them.
pub mod more_values {
    #![allow(non_upper_case_globals, non_camel_case_types, dead_code)]

    pub static r: u8 = 0;
    pub static contact: u8 = 0;
    pub static beta: u8 = 0;
    pub static scale: u8 = 0;
    pub struct mode_1;
    pub struct friction;
    pub struct u;
    pub struct modes;

    ::friction::friction_system! {
        /// A scene that is emitted as straight-line code.
        pub struct Frame {
            crate: ::friction,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

/// A type with the name of a number type.
pub mod types {
    #![allow(non_camel_case_types)]

    pub struct f64;

    friction::friction_system! {
        /// A scene that is emitted as straight-line code.
        pub struct Frame {
            crate: ::friction,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

macro_rules! scenes {
    ($($module:ident $name:ident)*) => {
        $(
            /// A scene with the name of a type that emitted code uses.
            pub mod $module {
                friction::friction_system! {
                    /// A scene.
                    pub struct $name {
                        crate: ::friction,
                        masses: { lower: 3.27, upper: 3.25 },
                        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                        contact: upper - wall,
                        excitation: base,
                        damping: modal[0.010, 0.012],
                        provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
                    }
                }
            }
        )*
    };
}

scenes! {
    chain Chain  motion Motion  complex Complex  contact Contact  option Option  ok Ok  self_ Scene  of Of
}

/// A deprecated scene. Its own code must not cause a warning.
pub mod deprecated {
    friction::friction_system! {
        /// A scene.
        #[deprecated(note = "use another")]
        pub struct Frame {
            crate: ::friction,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

/// Masses with capitals as in a textbook, and a scene in lower case whose lint is allowed.
pub mod spelling {
    friction::friction_system! {
        /// A scene.
        #[allow(non_camel_case_types)]
        pub struct frame {
            crate: ::friction,
            masses: { M1: 3.27, M2: 3.25 },
            springs: { base - M1: 1190.0, M1 - M2: 1323.0 },
            contact: M2 - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

#[test]
fn answers() {
    assert!(values::Frame::at(0.9).is_ok_and(|at| at.continuous_limit() > 0.0));
    assert!(types::Frame::at(0.9).is_ok_and(|at| at.continuous_limit() > 0.0));
    assert!(chain::Chain::at(0.9).is_ok_and(|at| at.continuous_limit() > 0.0));
    assert!(complex::Complex::at(0.9).is_ok_and(|at| at.motion(0.3).is_ok()));
}
