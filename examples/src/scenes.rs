//! Emitted scenes that more than one program asks.

use frictiongen::friction_system;

/// Five equal masses.
macro_rules! five {
    ($name:ident, $contact:ident, $zeta:literal) => {
        friction_system! {
            /// Five damped masses.
            pub struct $name {
                masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 },
                springs: {
                    base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0
                },
                contact: $contact - wall,
                excitation: m1,
                damping: modal($zeta),
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        crate::scene!($name);
    };
}

five!(Low001, m1, 0.01);
five!(Low01, m1, 0.1);
five!(Middle001, m3, 0.01);
five!(Middle01, m3, 0.1);
