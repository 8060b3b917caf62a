//! Scenes of a declared accuracy: limits, the contact's motion and stuck responses from tables.

/// Defines the same two scenes with different `provide` lists.
macro_rules! scenes {
    ($($provide:ident),*) => {
        frictiongen::friction_system! {
            /// Two masses, the upper rubbing on a wall.
            pub struct Pair {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                scalar: f32,
                provide: [$($provide),*],
                accuracy: 1e-4,
                range: { r: 0.2..2.5 },
            }
        }
        frictiongen::friction_system! {
            /// Five damped masses, the third rubbing on the moving base.
            pub struct Five {
                masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, upper: 0.5 },
                springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - upper: 1.0 },
                contact: m3 - base,
                excitation: base,
                damping: modal(0.02),
                scalar: f32,
                provide: [$($provide),*],
                accuracy: 1e-4,
                range: { r: 0.2..2.5 },
            }
        }
    };
}

/// Scenes with limits only.
pub mod limits {
    scenes!(limits);
}
/// Scenes with limits and the motion of the contact.
pub mod motion {
    scenes!(limits, motion);
}
/// Scenes with the response while the contact is stuck.
pub mod stuck {
    scenes!(stuck);
}

/// Typical scenes of `docs/firmware.md`: equal masses and springs, limits only.
pub mod typical {
    frictiongen::friction_system! {
        /// One damped mass on a wall.
        pub struct One {
            masses: { m1: 1 },
            springs: { base - m1: 1 },
            contact: m1 - wall,
            excitation: m1,
            damping: modal(0.02),
            scalar: f32,
            provide: [limits],
            accuracy: 1e-4,
            range: { r: 0.2..2.5 },
        }
    }
    frictiongen::friction_system! {
        /// Two masses, the first rubbing on the moving base.
        pub struct Two {
            masses: { m1: 1, m2: 1 },
            springs: { base - m1: 1, m1 - m2: 1 },
            contact: m1 - base,
            excitation: base,
            scalar: f32,
            provide: [limits],
            accuracy: 1e-4,
            range: { r: 0.2..2.5 },
        }
    }
    frictiongen::friction_system! {
        /// Five damped masses, the first two rubbing on each other.
        pub struct Five {
            masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
            springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
            contact: m1 - m2,
            excitation: m5,
            damping: modal(0.02),
            scalar: f32,
            provide: [limits],
            accuracy: 1e-4,
            range: { r: 0.2..2.5 },
        }
    }
    frictiongen::friction_system! {
        /// Ten damped masses, the last on a wall.
        pub struct Ten {
            masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
            springs: {
                base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 - m7: 1, m7 - m8: 1,
                m8 - m9: 1, m9 - m10: 1,
            },
            contact: m10 - wall,
            excitation: m1,
            damping: modal(0.02),
            scalar: f32,
            provide: [limits],
            accuracy: 1e-4,
            range: { r: 0.2..2.5 },
        }
    }
}
