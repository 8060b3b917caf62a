//! Chains of equal masses and springs. The last mass rubs on the wall, and the first mass is excited.

/// Rayleigh coefficients of the scenes below: of the mass matrix and of the stiffness matrix. With mass m and spring k
/// as units, each coefficient is 0.02.
pub const RAYLEIGH: [f64; 2] = [0.02, 0.02];

macro_rules! chains {
    ($($line:ident $hold:ident { $($body:tt)* })*) => {
        $(
            frictiongen::friction_system! {
                /// A chain whose force is linear within a step.
                pub struct $line { $($body)* damping: rayleigh(0.02, 0.02), provide: [orbit, stepper] }
            }
            frictiongen::friction_system! {
                /// A chain whose force is constant within a step.
                pub struct $hold {
                    $($body)* damping: rayleigh(0.02, 0.02), input: hold, provide: [stepper],
                }
            }
        )*
    };
}

chains! {
    Line1 Hold1 {
        masses: { m1: 1 }, springs: { base - m1: 1 }, contact: m1 - wall, excitation: m1,
    }
    Line2 Hold2 {
        masses: { m1: 1, m2: 1 }, springs: { base - m1: 1, m1 - m2: 1 }, contact: m2 - wall, excitation: m1,
    }
    Line5 Hold5 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
        contact: m5 - wall, excitation: m1,
    }
    Line10 Hold10 {
        masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
        springs: {
            base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 - m7: 1, m7 - m8: 1,
            m8 - m9: 1, m9 - m10: 1,
        },
        contact: m10 - wall, excitation: m1,
    }
}
