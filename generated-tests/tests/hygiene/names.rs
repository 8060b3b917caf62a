//! Scenes in modules that define the names that emitted code uses.

mod facade {
    pub(crate) use ::frictiongen as renamed;
}

mod with_a_renamed_facade {
    crate::names::facade::renamed::friction_system! {
        /// A scene whose facade has another path.
        pub(super) struct Frame {
            crate: crate::names::facade::renamed,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

#[test]
fn the_facade_has_another_name() {
    same_as_frame!(with_a_renamed_facade::Frame, upper);
}

mod without_a_prelude {
    #![no_implicit_prelude]

    ::frictiongen::friction_system! {
        /// A scene in a module without prelude and imports.
        pub(super) struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }

    ::frictiongen::friction_system! {
        /// A scene that is emitted as loops over the modes ("passes").
        pub(super) struct Five {
            masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
            springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
            contact: e - wall,
            excitation: base,
            damping: modal(0.01),
            scalar: f32,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

#[test]
fn nothing_is_in_scope() {
    same_as_frame!(without_a_prelude::Frame, upper);
    let at = without_a_prelude::Five::at(0.5).expect("in the domain");
    assert!(at.continuous_limit() > 0.0);
    assert!(at.motion(0.01).expect("continuous").a().amplitude() > 0.0);
}

mod among_types_of_the_same_names {
    #![allow(dead_code, non_camel_case_types, reason = "they only stand in the way")]

    /// Defines types whose names emitted code uses.
    macro_rules! in_the_way {
        ($($name:ident)*) => { $(#[derive(Clone, Copy, Debug)] pub(super) struct $name {})* };
    }
    in_the_way! {
        Result Option Ok Err Some None Box Vec String Default Error Copied Into From
        Scalar Float Mode Modes ModeAt ModeResponse Kind Chain ContactAt Damped Undamped Decay
        Fundamental Friction ModalCoefficients Motion Wave Complex Regime NotContinuous OutOfDomain StuckResonance
        Orbit OrbitMotion NoOrbit Simulation Segment Moment Part Dynamics HeldMode
        Iterator IntoIterator Steady LimitsAt FrictionSystem Of f32 usize str bool u8
    }

    /// Defines modules whose names emitted code uses.
    pub(super) mod core {}
    pub(super) mod std {}
    pub(super) mod kernel {}
    pub(super) mod regime {}
    pub(super) mod steady {}
    pub(super) mod orbit {}
    pub(super) mod simulation {}
    pub(super) mod frictiongen {}

    ::frictiongen::friction_system! {
        /// A scene in a module that defines every name which its code uses.
        pub(super) struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

#[test]
fn types_have_the_names_that_emitted_code_uses() {
    same_as_frame!(among_types_of_the_same_names::Frame, upper);
}

mod among_macros_of_the_same_names {
    #![allow(unused_macros, reason = "they only stand in the way")]

    macro_rules! concat {
        () => {};
    }
    macro_rules! env {
        () => {};
    }
    macro_rules! include_bytes {
        () => {};
    }
    macro_rules! compile_error {
        () => {};
    }

    frictiongen::friction_system!("scenes/braced.friction");
}

#[test]
fn macros_have_the_names_that_emitted_code_uses() {
    let at = among_macros_of_the_same_names::BracedFile::at(0.9).expect("in the domain");
    assert!(at.sliding_limit() > 0.0);
}

mod with_masses_called_like_variables {
    frictiongen::friction_system! {
        /// A scene that is emitted as straight-line code.
        pub(super) struct Frame {
            masses: { x: 3.27, r: 3.25 },
            springs: { base - x: 1190.0, x - r: 1323.0 },
            contact: r - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }

    frictiongen::friction_system! {
        /// A scene that is emitted as straight-line code.
        pub(super) struct Four {
            masses: { mode_1: 1.0, inverse_r: 1.0, limit: 1.0, friction: 1.0 },
            springs: {
                base - mode_1: 1.0, mode_1 - inverse_r: 1.0, inverse_r - limit: 1.0, limit - friction: 1.0,
            },
            contact: mode_1 - limit,
            excitation: inverse_r,
            damping: modal(0.01),
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }

    frictiongen::friction_system! {
        /// A scene that is emitted as loops over the modes ("passes").
        pub(super) struct Many {
            masses: {
                u: 1.0, beta: 1.0, modes: 1.0, fundamental: 1.0, scale: 1.0, mode: 1.0, response: 1.0,
                responses: 1.0, sum: 1.0, others: 1.0, waves: 1.0, constraint: 1.0, index: 1.0,
                question: 1.0, of: 1.0, rs: 1.0, v: 1.0, g: 1.0, h: 1.0, ask: 1.0, map: 1.0, get: 1.0,
                stuck_mass: 1.0, masses: 1.0, springs: 1.0, modal: 1.0, limited: 1.0, name: 1.0,
            },
            springs: {
                base - u: 1.0, u - beta: 1.0, beta - modes: 1.0, modes - fundamental: 1.0,
                fundamental - scale: 1.0, scale - mode: 1.0, mode - response: 1.0,
                response - responses: 1.0, responses - sum: 1.0, sum - others: 1.0,
                others - waves: 1.0, waves - constraint: 1.0, constraint - index: 1.0,
                index - question: 1.0, question - of: 1.0, of - rs: 1.0, rs - v: 1.0, v - g: 1.0,
                g - h: 1.0, h - ask: 1.0, ask - map: 1.0, map - get: 1.0, get - stuck_mass: 1.0,
                stuck_mass - masses: 1.0, masses - springs: 1.0, springs - modal: 1.0,
                modal - limited: 1.0, limited - name: 1.0,
            },
            contact: name - wall,
            excitation: u,
            damping: modal(0.01),
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }
}

#[test]
fn masses_have_the_names_of_variables() {
    use with_masses_called_like_variables::{Four, Frame as Renamed, Many};
    same_as_frame!(Renamed, r);
    let at = Four::at(0.7).expect("in the domain");
    assert!(at.motion(1e-3).expect("continuous").friction().amplitude() > 0.0);
    let at = Many::at(0.1).expect("in the domain");
    assert!(at.motion(1e-9).expect("continuous").modes().amplitude() > 0.0);
    assert!(at.stuck().expect("damped").beta().re.is_finite());
    assert!(at.orbit(1e-9).expect("steady").map().amplitude() > 0.0);
    let run = Many::simulation(0.1, 1e-9).expect("in the domain");
    assert!(run.map().displacement() == 0.0);
}
