//! Scenes that are measured on bare metal, and the calls to them.
#![no_std]
// The expansion of no-panic contains unsafe code.
#![cfg_attr(not(feature = "prove"), forbid(unsafe_code))]

pub mod calls;
pub mod joined;
pub mod steps;
pub mod tabled;

/// Scenes that each provide the functions of one kind of call. A function that a scene does not provide is not in the
/// image.
pub mod least {
    /// A scene with limits only.
    pub mod limits {
        frictiongen::friction_system! {
            /// Two masses of which the upper one rubs on a wall.
            pub struct Pair {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                scalar: f32,
                provide: [limits],
            }
        }
    }
    /// A scene with limits and the motion of one mass.
    pub mod motion {
        frictiongen::friction_system! {
            /// Two masses of which the upper one rubs on a wall.
            pub struct Pair {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                scalar: f32,
                provide: [motion(upper)],
            }
        }
    }
}

/// Scenes that provide steady states with stops of the contact.
pub mod stopping {
    frictiongen::friction_system! {
        /// One mass that rubs on a wall.
        pub struct Sdof {
            masses: { mass_1: 1.0 },
            springs: { base - mass_1: 1.0 },
            contact: mass_1 - wall,
            excitation: mass_1,
            scalar: f32,
            provide: [orbit],
        }
    }

    frictiongen::friction_system! {
        /// Two masses of which the upper one rubs on a wall.
        pub struct Pair {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            scalar: f32,
            provide: [orbit],
        }
    }

    frictiongen::friction_system! {
        /// Five damped masses of which the third one rubs on the moving base.
        pub struct Five {
            masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, upper: 0.5 },
            springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - upper: 1.0 },
            contact: m3 - base,
            excitation: base,
            damping: modal(0.02),
            scalar: f32,
            provide: [orbit],
        }
    }

    frictiongen::friction_system! {
        /// One mass with an elastic contact.
        pub struct SdofElastic {
            masses: { mass_1: 1.0 },
            springs: { base - mass_1: 1.0 },
            contact: mass_1 - wall,
            stiffness: 5.0,
            excitation: mass_1,
            scalar: f32,
            provide: [stuck, orbit],
        }
    }

    frictiongen::friction_system! {
        /// Five damped masses with an elastic contact between the third one and the moving base.
        pub struct FiveElastic {
            masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, upper: 0.5 },
            springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - upper: 1.0 },
            contact: m3 - base,
            stiffness: 5.0,
            excitation: base,
            damping: modal(0.02),
            scalar: f32,
            provide: [orbit],
        }
    }
}

frictiongen::friction_system! {
    /// One mass that rubs on a wall.
    pub struct Sdof {
        masses: { mass_1: 1.0 },
        springs: { base - mass_1: 1.0 },
        contact: mass_1 - wall,
        excitation: mass_1,
        scalar: f32,
        provide: [limits, motion, stuck],
    }
}

frictiongen::friction_system! {
    /// Two masses of which the upper one rubs on a wall.
    pub struct Pair {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        scalar: f32,
        provide: [limits, motion, stuck],
    }
}

frictiongen::friction_system! {
    /// Two masses of which the upper one rubs on a wall, in double precision.
    pub struct PairDouble {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        provide: [limits, motion, stuck],
    }
}

frictiongen::friction_system! {
    /// Five damped masses of which the third one rubs on the moving base.
    pub struct Five {
        masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, upper: 0.5 },
        springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - upper: 1.0 },
        contact: m3 - base,
        excitation: base,
        damping: modal(0.02),
        scalar: f32,
        provide: [limits, motion, stuck],
    }
}
