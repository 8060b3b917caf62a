//! The scenes of chapter 6.

use frictiongen::friction_system;
use frictiongen_examples::scene;

friction_system! {
    /// Three equal storeys, the middle one in contact (6.2).
    pub struct Three {
        masses: { m1: 1.0, m2: 1.0, m3: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

/// Two equal storeys, loaded below.
macro_rules! two {
    ($name:ident, $contact:ident, $stiction:literal) => {
        friction_system! {
            /// Two equal storeys.
            pub struct $name {
                masses: { m1: 1.0, m2: 1.0 },
                springs: { base - m1: 1.0, m1 - m2: 1.0 },
                contact: $contact - wall,
                excitation: m1,
                stiction: $stiction,
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

two!(Lower, m1, 1.0);
two!(Lower12, m1, 1.2);
two!(Lower15, m1, 1.5);
two!(Upper, m2, 1.0);
two!(Upper12, m2, 1.2);
two!(Upper15, m2, 1.5);

/// Five equal storeys, loaded below.
macro_rules! five {
    ($name:ident, $contact:ident) => {
        friction_system! {
            /// Five equal storeys.
            pub struct $name {
                masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 },
                springs: {
                    base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0
                },
                contact: $contact - wall,
                excitation: m1,
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

five!(FiveLow, m1);
five!(FiveMiddle, m3);

/// The rig of 6.4: r₁ = 0.3419 s ω, γ = 0.9772, κ = 1.1119, in units of m₁ and k₁.
macro_rules! rig {
    ($name:ident, $contact:ident - $other:ident) => {
        friction_system! {
            /// The two-storey frame of the rig.
            pub struct $name {
                masses: { m1: 1.0, m2: 0.9772 },
                springs: { base - m1: 1.0, m1 - m2: 1.1119 },
                contact: $contact - $other,
                excitation: base,
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

rig!(RigLower, m1 - wall);
rig!(RigUpper, m2 - wall);
rig!(RigBase, m1 - base);

friction_system! {
    /// Friction between the two masses, γ = κ = 0.5 (6.23).
    pub struct Between {
        masses: { m1: 1.0, m2: 0.5 },
        springs: { base - m1: 1.0, m1 - m2: 0.5 },
        contact: m1 - m2,
        excitation: m1,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

friction_system! {
    /// The wall moves with the base (6.25).
    pub struct Joined {
        masses: { m1: 1.0, m2: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0 },
        contact: m1 - base,
        excitation: base,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

scene!(Three, Between, Joined);
