//! Scenes that are assembled from macro fragments.

use frictiongen as facade;
use frictiongen::friction_system;

/// Defines a scene from the fragments of a macro.
macro_rules! scene {
    ($visibility:vis $name:ident { $lower:ident: $mass:expr, $upper:ident: $number:literal } $spring:tt $facade:path) => {
        friction_system! {
            /// Made of fragments.
            $visibility struct $name {
                crate: $facade,
                masses: { $lower: $mass, $upper: $number },
                springs: { base - $lower: 2 * $spring, $lower - $upper: 1323.0 },
                contact: $upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
            }
        }
    };
}

/// Defines a scene that finds the facade through `$crate`.
macro_rules! through_own_crate {
    ($name:ident) => {
        friction_system! {
            struct $name {
                crate: $crate::fragments::facade,
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
            }
        }
    };
}

/// Passes a whole description, as tokens, to `friction_system!`.
macro_rules! handed_on {
    ($($tokens:tt)*) => { friction_system! { $($tokens)* } };
}

scene! { pub(crate) Fragments { below: 3.0 + 0.27, above: 3.25 } (500.0 + 95.0) ::frictiongen }
through_own_crate! { ThroughOwnCrate }
handed_on! {
    struct HandedOn {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
    }
}

#[test]
fn scenes_come_out_of_macros() {
    same_as_frame!(Fragments, above);
    same_as_frame!(ThroughOwnCrate, upper);
    same_as_frame!(HandedOn, upper);
}
